"""The verdicts on frames and values, as numbers in columns and as the words of the tables."""

from __future__ import annotations

VERDICTS = (
    "ok",
    # What a codec refuses, named as its errors name it.
    "wrong_mark",
    "not_hex",
    "wrong_length",
    "incomplete",
    "unknown_code",
    "wrong_const",
    "unknown_value",
    "wrong_measure",
    "wrong_checksum",
    # What a codec accepts and the manual does not print.
    "out_of_range",
    "unlisted_member",
    "unlisted_bits",
    "unlisted",
    "partial",
    # What shows only in the stream.
    "mismatch",
    "no_request",
    "no_frame",
)
"""All verdicts, by their numbers."""

VERDICT_NUMBERS = {word: number for number, word in enumerate(VERDICTS)}

OK = VERDICT_NUMBERS["ok"]
WRONG_MARK = VERDICT_NUMBERS["wrong_mark"]
WRONG_LENGTH = VERDICT_NUMBERS["wrong_length"]
INCOMPLETE = VERDICT_NUMBERS["incomplete"]
UNKNOWN_CODE = VERDICT_NUMBERS["unknown_code"]
WRONG_CONST = VERDICT_NUMBERS["wrong_const"]
UNKNOWN_VALUE = VERDICT_NUMBERS["unknown_value"]
WRONG_MEASURE = VERDICT_NUMBERS["wrong_measure"]
WRONG_CHECKSUM = VERDICT_NUMBERS["wrong_checksum"]
OUT_OF_RANGE = VERDICT_NUMBERS["out_of_range"]
UNLISTED_MEMBER = VERDICT_NUMBERS["unlisted_member"]
UNLISTED_BITS = VERDICT_NUMBERS["unlisted_bits"]
UNLISTED = VERDICT_NUMBERS["unlisted"]
PARTIAL = VERDICT_NUMBERS["partial"]
MISMATCH = VERDICT_NUMBERS["mismatch"]
NO_REQUEST = VERDICT_NUMBERS["no_request"]
NO_FRAME = VERDICT_NUMBERS["no_frame"]

REFUSED = frozenset((WRONG_CONST, UNKNOWN_VALUE))
"""The verdicts on a value for which a codec refuses the frame that carries it."""
