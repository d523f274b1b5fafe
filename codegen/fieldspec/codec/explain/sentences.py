"""The sentences of explanations, once for all explainers. A name in braces stands for what differs."""

from __future__ import annotations

WRONG = "wrong: {fault}"
SHOULD_BE = "wrong: should be {expected}"
IT = "It {statement}."

# Sizes

SINGLE_BYTE = "1 byte"
BYTES = "{count} bytes"
BYTE_MISSING = "{count} byte is missing for {names}"
BYTES_MISSING = "{count} bytes are missing for {names}"
TOO_MANY = "{bytes} too many"
CHARACTER_TOO_MANY = "1 character too many"
NOT_PAIRS = "not pairs of hexadecimal characters"
BOUNDS = "{low} to {high}"
OR_MORE = "{low} or more"

# Parts of frames

NOT_ESCAPED = "the byte at {offset} is not escaped, or its escape means nothing"
ANOTHER_LENGTH = "for another number of bytes"
CODE_REFUSED = "the code {code} is refused"
REQUEST_REFUSED = "a request is refused"
MESSAGE_REFUSED = "{message} is refused"
REFUSED_CODE = "{message}, refused"
SHARED_CODE = "that of {names}; only the request distinguishes them"
PERMITTED_NAMES = "one of {names}"
CODE_OF_NONE = "that of a message, and none has a {direction} here"
BROADCAST = "for all stations"
NO_CODE = "the frame carries no code, so its message is unknown"
UNKNOWN_DATA = "The data of an unknown message."

# Fields

WRONG_COUNT = "{count} is not a number of {name}, so it is unknown where they end"
UNDECIDED = "{selector} {number} does not decide the type of {name}"
UNDECIDED_TOO_LONG = "{selector} {number} does not decide the type of {name}, which is {count} bytes too long"
MORE_FOLLOW = "{name} has {count} bytes, and more follow"
MORE_ELEMENTS = "{name} has more than {count} elements"
MORE_THAN_BITS = "{name} has more bytes than its numbers of {bits} bits"
ELEMENTS_WITHOUT_END = "the elements of {name} do not end with their bytes: see {place}"
DECIDES_MORE = "{selector} decides that {name} has more bytes than there are"
SENT_WITHOUT_BYTES = "{count} says that {name} is sent, but its bytes are missing"
COUNTS_MORE = "{count} counts more {name} than there are"
WITHOUT_END = "{name} has no end"
FEWER_FOLLOW = "{name} has {count} bytes, but only {rest} follow"
WRONG_SIZE = "{count} is not a number of bytes of {name}"
SIZE_OF_LIST = "the bytes of {name}"
NUMBER_IF_SENT = "a number with which {name} is sent"
NUMBER_IF_ABSENT = "a number with which {name} is not sent"
PERCENTAGE = "{percent} % of {references}"

# Values, parameters and registers

TRUTH_NUMBERS = "0 or 1"
UNLISTED_BIT = "not listed"
UNLISTED_MEMBER = "{enum} does not list {number}."
PARAMETER = "parameter {number}"
READ_ONLY = "can only be read"
WRITE_ONLY = "can only be written"
PARTIAL = "The frame contains only some of its {unit}s."
PARTIAL_ATOMIC = "The frame contains only some of its {unit}s, which must be accessed in one request."
ABSENT_ELEMENT = "The device has no such element: {count} is {number}."
UNLISTED_REGISTER = "No register is listed here."
ELEMENTS_OF_TABLE = "Elements of {table} may be here: {register} has the address of the first one."

# Readings of a frame

UNKNOWN_MESSAGE = "an unknown message"
NOT_REPEATED = "does not repeat the request"
PART_NOT_REPEATED = "{path} does not repeat the request: {fault}"
ANOTHER_CODE = "{name} is {actual}, but {expected} answers {message}"
ANOTHER_NUMBER = "{name} is {actual}, but {expected} in the request"
ASKED_VALUES = "the request asks for {expected} {unit}s, but the response has {actual}"
ASKED_BITS = "the request asks for {expected} {unit}s, which take {size} bytes, but the response has {actual}"
CLOSEST = "this is not a valid frame of {device}; what is explained here comes closest"
ANSWERS = "this answers the request in line {line}"
DOES_NOT_ANSWER = "this does not answer the request in line {line}"
AMBIGUOUS = "ambiguous: explained as {explained}, it may also be {others}; {options}"
AMBIGUOUS_SIZE = "ambiguous: {count} bytes may be {names}; {options}"
OPTION_TELLS = "{options} tells"
OPTIONS_TELL = "{options} tell"
ON_LINK = " on {link}"
NAMED_MESSAGE = "{message} {direction}{place}"
NAMED_MESSAGES = "one of {count} {direction}{place} ({names})"
READING = "the {kind} {joint} {message}{place}"
READINGS = "a {kind} {joint} one of {count} messages{place} ({names})"
SIZE_OF_MESSAGE = "{message} has {size}"
SIZE_OF_FRAME = "the frame has {bytes}"
SIZE_WITHOUT = "without its {names}, the frame has {bytes}"
SIZE_OF_DATA = "the data of the frame have {bytes}"
SIZES = "{own}; {others}"

# Texts that are read

NOT_A_BYTE = "`{piece}` is not a byte in hexadecimal digits"
ODD_DIGITS = "`{piece}` has an odd number of digits"
SINGLE_DIGIT = "at byte {offset}, `{piece}` is one digit of two"
NO_BYTES = "there are no bytes in it"
TOO_LONG = "it has {count} characters or more"
END_ASSUMED = "{characters} is missing at the end of the text and is assumed to have been sent"
DIRECTION_WORDS = (
    ("request", ("tx", "send", "sending", "sent", "transmit", "transmitted", "request", "req")),
    ("response", ("rx", "recv", "receive", "received", "response", "resp", "rsp", "reply", "answer")),
)


def byte_count(count: int) -> str:
    """`1 byte` or `8 bytes`."""
    return SINGLE_BYTE if count == 1 else BYTES.format(count=count)


def missing_text(count: int, names: str) -> str:
    """How many bytes are missing for the fields or the part of these names."""
    return (BYTE_MISSING if count == 1 else BYTES_MISSING).format(count=count, names=names)
