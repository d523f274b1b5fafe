"""Reads the cells of a register list: accesses, answers, functions, numbers, ranges, orders of bytes."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable
from decimal import Decimal
from functools import lru_cache

from fieldspec.foundation.classes import dataclass
from fieldspec.tools.lists.brackets import without_brackets
from fieldspec.tools.lists.words import folded, meaning

COMMA, POINT = "comma", "point"
"""The signs before the fraction of a number."""

_NUMBER = re.compile(
    r"([-+]?) ?(?:0x([0-9a-f]{1,16})|([0-9a-f]{1,16})h|([0-9]{1,20}(?:\.[0-9]{1,20})?))", re.IGNORECASE
)
_BARE = re.compile(r"([-+]?)\.([0-9]{1,20})")
_POWER = re.compile(
    r"([-+]?)([0-9]{1,12}(?:\.[0-9]{1,12})?)?\s*(?:e|[*x\u00d7]?\s*10\s*(?:\^|\*\*))\s*\(?([-+]?[0-9]{1,2})\)?",
    re.IGNORECASE,
)
_RANGE = re.compile(
    r"\s*(?:\.\.+|~|\u2013|\u2014|至|…|(?<=[\w.,%°\s])\b(?:to|bis)\b|(?<=[\w.])\s?- ?(?=[-+0-9.])"
    r"|(?<=[\w.,%°])\s+[àa]\s+(?=[-+0-9])|(?<=[0-9])\s*÷\s*(?=[-+0-9]))\s*",
    re.IGNORECASE,
)
_CLOSED = re.compile(r"\[[^\[\],;]+,[^\[\],;]+\]")
_TRAILING = re.compile(r"(?<=[0-9])\s*[^\s0-9.,eExX()+*/^-][^0-9]*$")
_THOUSANDS = re.compile(r"[-+]?[0-9]{1,3}([,.' ])[0-9]{3}(?:\1[0-9]{3})*")
_COMMA = re.compile(r"(?<![0-9,.])[-+]?[0-9]+,(?:[0-9]{1,2}|0[0-9]{2,}|[0-9]{4,})(?![0-9,])")
_SMALL_COMMA = re.compile(r"(?<![0-9,.])[-+]?0,[0-9]+(?![0-9,])")
_POINTED = re.compile(r"(?<![0-9,.])[-+]?[0-9]+\.[0-9]+(?![0-9.,])")
_PIECES, _PARTS = re.compile(r"[\s/|-]+"), re.compile(r"[\s_]+")
_CODE = re.compile(r"(?:fc|f|func(?:tion)?|r(?:ead)?|w(?:rite)?|[:=]|\s)*(?:0x)?0*([0-9a-f]{1,2})h?", re.IGNORECASE)
_CODES = re.compile(r"[,;/&+|]|\band\b|(?<=[0-9h])\s(?=0|[rw]:)", re.IGNORECASE)
_WORDS_BEHIND = re.compile(r"(?<=[0-9a-fh])\s*(?:[-\u2013:]\s*|\s)(?:read|write|preset|force)\b[^0-9]*$", re.IGNORECASE)
"""The words after the code of a function that describe it."""

_VERB = re.compile("read(?:write)?|write(?:single|multiple)?")
_WRITING = {5: "coils", 15: "coils", 6: "registers", 16: "registers", 22: "registers", 23: "registers"}
_READING = {1: "coils", 2: "discrete_inputs", 3: "registers", 4: "input_registers"}


@dataclass(frozen=True, slots=True)
class Functions:
    """The meaning of function codes: the address space, and whether they read and write."""

    space: str
    reads: bool
    writes: bool


def access(text: str) -> str:
    """`ro`, `rw`, `wo`, or empty if the text is not an access."""
    if "?" in text:
        return ""
    bare = re.sub(r"[\[(].*|\*+$", "", without_brackets(text))
    return meaning("accesses", text) or (meaning("accesses", bare) if folded(bare) else "")


def answer(text: str) -> bool | None:
    """Whether a cell says yes; None if it says neither yes nor no."""
    return {"yes": True, "no": False}.get(meaning("answers", text))


def functions(text: str) -> Functions | None:
    """The meaning of `03`, `3/6`, `FC04`, `03H, 10H`, `Read_Input_Registers`; None if a text has other things, or codes
    of two spaces."""
    verb = _VERB.match(folded(text))
    if verb and (named_space := meaning("spaces", folded(text)[verb.end() :])):
        return Functions(named_space, "read" in verb[0], "write" in verb[0])
    codes = []
    for part in _CODES.split(without_brackets(unicodedata.normalize("NFKC", text)).strip()):
        match = _CODE.fullmatch(_WORDS_BEHIND.sub("", part.strip()))
        if match is None:
            return None
        codes.append(match[1])
    hexadecimal = [int(code, 16) for code in codes]
    numbers = [int(code) for code in codes if code.isdecimal()]
    known = {*_READING, *_WRITING}
    is_marked = re.search(r"h\b|0x", text, re.IGNORECASE)
    if is_marked or (not known.issuperset(numbers) and known.issuperset(hexadecimal)) or len(numbers) < len(codes):
        numbers = hexadecimal
    spaces = {_READING.get(number) or _WRITING.get(number) or "" for number in numbers}
    if len(spaces) != 1 or "" in spaces:
        return None
    return Functions(spaces.pop(), any(n in _READING for n in numbers), any(n in _WRITING for n in numbers))


def space(text: str) -> str:
    """The address space that a text names, perhaps in two languages or notations: `线圈 COIL`, `Coil (0x)`; empty for a
    text with `°C`."""
    if "°" in text:
        return ""
    bare = without_brackets(text)
    ending = " ".join(_PARTS.split(bare.strip())[-2:])
    for stated in (text, bare, _VERB.sub("", folded(bare), count=1), bare.partition("_")[2], ending):
        if meaning("spaces", stated):
            return meaning("spaces", stated)
    space_names = {meaning("spaces", piece) for piece in _PIECES.split(bare.strip())} or {""}
    return meaning("spaces", bare) or (space_names.pop() if len(space_names) == 1 else "")


@lru_cache(maxsize=20_000)  # rows have most texts in common, and each is read several times
def number(text: str, decimal: str = POINT) -> Decimal | None:
    """An exact number, decimal, or hexadecimal with a prefix or suffix; None if the text is not a number.

    With `decimal` as `comma`, a comma is before the fraction. If it is empty, `1.000` gives None: it has two readings.
    """
    text = unicodedata.normalize("NFKC", text).replace("\u2212", "-").strip().strip("`'").strip()
    text = f"-{text[1:]}" if text.startswith(("\u2013", "\u2014")) else text
    if decimal != POINT and _is_ambiguous(text):
        return None
    if decimal == COMMA or (not decimal and _SMALL_COMMA.fullmatch(text)):
        text = text.replace(",", ".") if text.count(",") == 1 and "." not in text else text
    elif "," in text:
        return None
    if bare := _BARE.fullmatch(text):
        text = f"{bare[1]}0.{bare[2]}"
    match = _NUMBER.fullmatch(text)
    if match is None:
        return _power(text)
    sign, marked, ended, digits = match.groups()
    magnitude = Decimal(digits) if digits else Decimal(int(marked or ended, 16))
    return -magnitude if sign == "-" else magnitude


def _power(text: str) -> Decimal | None:
    """A number with a power of ten: `1E-3`, `10^-1`, `2*10**3`."""
    match = _POWER.fullmatch(text)
    if match is None or abs(int(match[3])) > 18:
        return None
    magnitude = Decimal(match[2] or 1).scaleb(int(match[3]))
    number_text = Decimal(f"{magnitude:f}")
    return -number_text if match[1] == "-" else number_text


def _is_ambiguous(text: str) -> bool:
    """Whether a number may have a separator of thousands or a fraction of three digits: `1,000`."""
    return _THOUSANDS.fullmatch(text.strip()) is not None and not text.strip().startswith(("0", "-0"))


def decimal_sign(texts: Iterable[str]) -> tuple[str, str]:
    """`comma` or `point` for the numbers of some cells, and the cell that shows it; empty if none does, or both do."""
    comma = point = ""
    for text in map(str.strip, texts):
        if not comma and not _CLOSED.search(text) and (match := _SMALL_COMMA.search(text) or _COMMA.fullmatch(text)):
            comma = match[0]
        if not point and not _is_ambiguous(text) and (match := _POINTED.fullmatch(text)):
            point = match[0]
    if comma and not point:
        return COMMA, comma
    return (POINT, point) if point and not comma else ("", "")


def number_in_unit(text: str, decimal: str = POINT) -> Decimal | None:
    """An exact number, perhaps with a unit after it: `5 s`."""
    value = number(text, decimal)
    return value if value is not None else number(_TRAILING.sub("", text.strip()), decimal)


def whole(text: str, decimal: str = POINT) -> int | None:
    """A whole number, None for other texts."""
    value = number(text, decimal)
    return int(value) if value is not None and value == value.to_integral_value() else None


def bounds(text: str, decimal: str = POINT) -> tuple[Decimal, Decimal] | None:
    """The ends of a range such as `0~100`, `0-100 V`, `[-5, 5]`, `0..0FFh`; None if the text is not a range."""
    number_text = unicodedata.normalize("NFKC", text).replace("\u2212", "-").strip().strip("`[]").strip()
    parts = number_text.split(",") if _CLOSED.fullmatch(text.strip()) else _RANGE.split(number_text)
    ends = [number_in_unit(part, decimal) for part in parts]
    if len(ends) != 2 or ends[0] is None or ends[1] is None or ends[0] > ends[1]:
        return None
    return ends[0], ends[1]
