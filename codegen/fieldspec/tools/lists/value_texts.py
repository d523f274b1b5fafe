"""Reads cells with the meanings of values or of bits: `0: off; 1: on`, `{"0": "grid"}`, `bit 7 = relay failure`."""

from __future__ import annotations

import json
import re
import unicodedata
from functools import lru_cache
from typing import NamedTuple

from fieldspec.foundation.classes import dataclass
from fieldspec.tools.lists.words import folded, whole_words

_PART = re.compile(
    r"(?:(?<=^)|(?<=[\s,;/|\n.)]))(?P<bit>bits?\s*#?|b)?(?P<number>0x[0-9a-f]{1,16}|[0-9][0-9a-f]{0,15}h(?![a-z])|-?[0-9]{1,20})"
    r"(?(bit)(?:\s*(?:\.\.+|-|~)\s*(?:bits?|b)?(?P<last>[0-9]{1,2}))?)"
    r"(?P<end>\s*(?:=|:|・|\.(?=\s?[^\W\d])|->|=>|→|\u2013|\u2014|\)|\s-(?=\s)|-(?=[a-z])|-(?=\s+[^\W_]))\s*|(?(bit)\s+(?=[^\W\d])|(?!)))",
    re.IGNORECASE,
)
_LINE_END = re.compile(r"<br\s*/?>|\n", re.IGNORECASE)
_SIGNS = ("=", ":", "->", "→", "\u2013")
"""What stands between a value and its meaning where lines before the first value say something else."""

_ENDS = (",", ";", "/", "|", "\n")
"""What stands after the name of a bit that only a blank parts from its number: `b0 ready, b1 warn`."""

_NAME_BEFORE = re.compile(r"[^0-9=;,|]{1,40}\s")
"""The name before values that have equal signs: `Status 0=off 1=on`."""

_BEFORE = re.compile(r"[ \[(]*|[^0-9=;,|]{1,40}[:.][ \[(]*")
"""What may stand before the first value: `Condition: 0 = off`."""

_FURTHER = re.compile(
    r"[/;,|\n]\s*(?:[0-9]{1,4}\s?[.:=)]\s?[^\W\d]|-?[0-9]+\s*(?:-|\u2013|~|\.\.+|…|to\b|bis\b)\s*[0-9]*\s*(?:[=:]|$)"
    r"|-?[0-9]+\s*$|\.\.+|…)"
)
"""A further value in the text of one, with another sign after its number, or several values: `2: meter / 3.Dual-CT`,
`1: on, 2..5: reserved`, `2: Feb, ...`."""

_SIMPLE = re.compile(r"(0x[0-9a-f]{1,16}|-?[0-9]{1,20}|nan)\s+([^\s=:].*)", re.IGNORECASE)
_SEPARATOR = re.compile(r"[;\n·•]|(?:\s[/|]|,)(?=\s*-?[0-9]+\s)")
"""What stands between values: `0 off; 1 on`, `0 off / 1 on`, `0 off · 1 on`."""

_NEXT_NUMBER = re.compile(r"\s+(?=[0-9]+\s+[^\W\d])")
"""What stands between values that only blanks part: `0 off 1 on 2 auto`."""

_BESIDE = re.compile(r"[,/·•|]\s*[0-9]+[\s(]")
"""A further value in the text of one that only a blank parts from its number: `off · 1 on`."""

_BEHIND = re.compile(
    r"([^\W\d][^=:;,()\n]{0,40}?)\s*(?:[=:(]|=>|->)\s*(0x[0-9a-f]{1,16}|-?[0-9]{1,10})\)?", re.IGNORECASE
)
"""A value after its name: `off = 0`, `on (1)`."""

_BINARY = re.compile("[01]{2,8}")
_FEWEST_BINARY, _FEW = 3, 2
"""The values that show that their numbers are binary: `00`, `01`, `10`."""

_BIT = re.compile(r"([0-9]{1,2}(?:\.\.[0-9]{1,2})?(?:,[0-9]{1,2}(?:\.\.[0-9]{1,2})?)*)\s+(\S.*)")
_JSON_KEY = re.compile(r"(bit\s*|b)?(0x[0-9a-f]+|-?[0-9]+)", re.IGNORECASE)
_MOST = 1 << 16


class NamedBits(NamedTuple):
    """A bit or several, from `low` to `high`. Where they lie apart, `pieces` are they as specs write them."""

    low: int
    high: int
    name: str
    pieces: str = ""


@dataclass(frozen=True, slots=True)
class Meanings:
    """The texts of values, or the texts of bits by their numbers, in the order of the cell."""

    members: tuple[tuple[int, str], ...] = ()
    bits: tuple[NamedBits, ...] = ()


@lru_cache(maxsize=20_000)  # rows have most texts in common, and each is read several times
def value_meanings(text: str, single: bool = False) -> Meanings | None:
    """The meanings in a cell; None if the cell has anything else, or one number twice.

    `single` says that the column is one of meanings, so that `0 stop` alone is one.
    """
    text = unicodedata.normalize("NFKC", text).replace("`", "").strip()
    if text.startswith("{") and (of_json := _of_json(text)) is not None:
        return of_json
    text = text[1:-1] if text[:1] + text[-1:] in ("[]", "{}") else text
    text = _of_lines(_LINE_END.split(text))
    parts = list(_PART.finditer(text))
    parts = [part for part in parts if part["end"].strip() == parts[0]["end"].strip()]
    before = text[: parts[0].start()] if parts else ""
    is_named = len(parts) > 1 and parts[0]["end"].strip() == "=" and _NAME_BEFORE.fullmatch(before) is not None
    if parts and (is_named or _BEFORE.fullmatch(before)):
        ends = [*(part.start() for part in parts[1:]), len(text)]
        raw_texts = [text[part.end() : end] for part, end in zip(parts, ends, strict=True)]
        texts = [re.sub(r"\s[-\u2013]$", "", raw_text.strip(" ,;/|.]'\"")) for raw_text in raw_texts]
        are_parted = parts[0]["end"].strip() or all(raw_text.rstrip(" ").endswith(_ENDS) for raw_text in raw_texts[:-1])
        are_ends = parts[0]["end"].strip() == "-" and not all(any(map(str.isalpha, name)) for name in texts)
        is_point = parts[0]["end"].strip() == "." and len(parts) == 1
        are_values = are_parted and not are_ends and not is_point
        if all(texts) and are_values and not any(map(_FURTHER.search, raw_texts)):
            digits = [part["number"] for part in parts]
            are_binary = (
                len(digits) >= _FEWEST_BINARY and all(map(_BINARY.fullmatch, digits)) and len({*map(len, digits)}) == 1
            )
            return _sorted(
                [
                    (
                        bool(part["bit"]) and not (are_binary and part["bit"] in "bB"),
                        int(part["number"], 2)
                        if are_binary and (part["bit"] or "b") in "bB"
                        else _number(part["number"]),
                        name,
                        int(part["last"] or 0),
                    )
                    for part, name in zip(parts, texts, strict=True)
                ]
            )
    if single and not _SEPARATOR.search(text) and len(pieces := _NEXT_NUMBER.split(text)) > 1:
        text = "; ".join(pieces)
    simple = [_SIMPLE.fullmatch(piece.strip()) for piece in _SEPARATOR.split(text) if piece.strip()]
    if simple and all(simple) and (single or len(simple) > 1 or text.rstrip().endswith(";")):
        pairs = [(_number(piece[1]), piece[2].strip()) for piece in simple if piece and piece[1].lower() != "nan"]
        are_consecutive = (
            [number for number, _ in pairs] == list(range(pairs[0][0], pairs[0][0] + len(pairs))) if pairs else True
        )
        if (are_consecutive or ";" in text or "," not in text) and not any(_BESIDE.search(name) for _, name in pairs):
            return _sorted([(False, number, name, 0) for number, name in pairs])
        return None
    named_values = [_BEHIND.fullmatch(piece.strip()) for piece in re.split("[,;/\n]", text) if piece.strip()]
    names = [(_number(piece[2]), piece[1]) for piece in named_values if piece and folded(piece[1]) not in whole_words()]
    first = min((number for number, _ in names), default=0)
    if (
        len(names) == len(named_values) > 1
        and {number for number, _ in names} == {*range(first, first + len(names))}
        and first < _FEW
    ):
        return _sorted([(False, number, name, 0) for number, name in names])
    return None


def _of_lines(lines: list[str]) -> str:
    """The lines of a cell as one, from the first value on where several lines begin with one; lines between go on."""
    starts = [bool((part := _PART.match(line.strip())) and part["end"].strip() in _SIGNS) for line in lines]
    if sum(starts) < _FEW:
        return "; ".join(lines)
    text = ""
    for line, is_start in zip(lines, starts, strict=True):
        text += ("; " if text else "") + line.strip() if is_start else f" {line.strip()}" if text else ""
    return text


def _of_json(text: str) -> Meanings | None:
    try:
        data = json.loads(text.replace("'", '"') if '"' not in text else text)
    except (ValueError, RecursionError):
        return None
    pairs = []
    for key, value in data.items():
        match = _JSON_KEY.fullmatch(str(key).strip())
        if match is None or not isinstance(value, str | int | float):
            return None
        pairs.append((bool(match[1]), _number(match[2]), str(value), 0))
    return _sorted(pairs)


def _number(digits: str) -> int:
    digits = digits.casefold()
    return int(digits.removesuffix("h"), 16) if digits.endswith("h") else int(digits, 0 if "x" in digits else 10)


def _sorted(pairs: list[tuple[bool, int, str, int]]) -> Meanings | None:
    """The meanings of values, or of bits, each with the number of its last bit, which is 0 for a single one."""
    bits = tuple(NamedBits(number, last or number, text) for is_bit, number, text, last in pairs if is_bit)
    members = tuple((number, text) for is_bit, number, text, _ in pairs if not is_bit)
    if len({(is_bit, number) for is_bit, number, *_ in pairs}) < len(pairs) or len(pairs) > _MOST:
        return None
    if not pairs or (bits and members) or any(not 0 <= bit.low <= bit.high < 64 for bit in bits):
        return None
    return Meanings(members, bits)


def bit_names(text: str) -> tuple[NamedBits, ...] | None:
    """The bits in a cell of a column of bits: `0 ready; 8..15 hours; 4,1..2 part`. None for anything else."""
    meanings = value_meanings(text)
    if meanings is not None and meanings.bits:
        return meanings.bits
    bits = [_BIT.fullmatch(piece.strip()) for piece in text.split(";") if piece.strip()]
    if not bits:
        return None
    parts = [_named_bits(bit[1], bit[2]) for bit in bits if bit]
    return tuple(parts) if len(parts) == len(bits) and all(bit.low <= bit.high < 64 for bit in parts) else None


def _named_bits(text: str, name: str) -> NamedBits:
    pieces = [piece.partition("..") for piece in text.split(",")]
    ends = [(int(low), int(high or low)) for low, _, high in pieces]
    if len(ends) == 1:
        return NamedBits(*ends[0], name)
    return NamedBits(min(low for low, _ in ends), max(high for _, high in ends), name, text.replace(",", ", "))


def mask_bits(mask: int) -> tuple[int, int] | None:
    """The lowest and the highest bit of a mask of neighbouring bits; None for any other mask."""
    low, high = (mask & -mask).bit_length() - 1, mask.bit_length() - 1
    return (low, high) if 0 < mask < 1 << 64 and mask >> low == (1 << (high - low + 1)) - 1 else None
