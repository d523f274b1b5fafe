"""Reads the cells of one row of a list, each by its role. Unknown content stays a doubt, word for word."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction

from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.language.model.fact import Citation
from fieldspec.tools.lists import cells
from fieldspec.tools.lists.brackets import parted
from fieldspec.tools.lists.cells import COMMA, POINT, access, answer, bounds, functions, number, whole
from fieldspec.tools.lists.item import MESSAGES
from fieldspec.tools.lists.orders import joined_order, stated_order
from fieldspec.tools.lists.quantities import known_unit, scaled_unit, unit_cell
from fieldspec.tools.lists.remarks import special_states, spoken_access
from fieldspec.tools.lists.row_bounds import default_of, row_bounds
from fieldspec.tools.lists.row_quantity import FACTORS, example, named_places, open_factor, quantity_of
from fieldspec.tools.lists.type_words import Loose, Typed, described_order, typed
from fieldspec.tools.lists.value_texts import Meanings, bit_names, mask_bits, value_meanings
from fieldspec.tools.lists.words import folded, meaning

REGISTER, FIELD, PARAMETER, MESSAGE, SIGNAL = "register", "field", "parameter", "message", "signal"
"""The kinds of rows: exports and some formats also have fields of tables, parameters, and messages with signals."""

STATES = ("zero", "one")
"""The roles of columns with the meaning of 0, and of 1."""

_SIGNLESS = ("word", "dword", "uint", "byte", "short", "long", "int", "int16", "int32", "int64")
"""The types beside which another column may say that they have a sign, or none."""

_BIT = re.compile(r"bit\s*([0-9]{1,2})", re.IGNORECASE)
_DIGIT = re.compile("[0-9]")
_LENGTH_UNIT = re.compile(r"(?<=[0-9])\s*(words?|bytes?|bits?|registers?|reg|ワード|バイト)\.?$", re.IGNORECASE)
_VALUE_WORD = re.compile(r"^values?\s+(?=[-0-9])", re.IGNORECASE)
_HIGHEST_COUNT = 0xFFFFFFFF
_WORD_BITS = 16
_LAST_BIT, LAST_SUBINDEX = 63, 0xFF


@dataclass(frozen=True, slots=True)
class SignalPlace:
    """Where a signal is in the data of a message, or those data.

    Bits are counted from the most significant one of the first byte where `order` is `big`, else from the least
    significant one. `is_wide` says that the identifier of a message has 29 bits, `direction` who sends it.
    """

    first: int
    size: int
    order: str
    is_wide: bool = False
    direction: str = ""

    @property
    def first_byte(self) -> int:
        """The byte with the first bit."""
        return self.first // 8

    @property
    def last_byte(self) -> int:
        """The byte with the last bit."""
        return (self.first + self.size - 1) // 8


@dataclass(frozen=True, slots=True)
class ListRow:
    """A row of a list. `address` is that of the list, `row` is its number in the file.

    Cells that are empty, or cannot be understood, are None or empty. `texts` are the cells by role, `doubts` what
    could not be understood or contradicts something. `words` is the size that the list states, `gap` the distance
    to the next address. `special` are states that a list has apart from other values, `described` its descriptions,
    `scale_text` is its scale as written. `factor` is a number whose direction the list leaves open, after a
    multiplication sign if `is_times`. `scaled_by` is the text that has it, or the scale where no cell of scales has
    it. `bits` is the place of bits in the register. `kind` is what the row is, `subindices` the first and the last
    one of elements of the parameter at the address, `place` that of a signal in its message. `form` has the keys of
    how a value is sent beyond its type. `parts` are the numbers of rows with its other word or with its values,
    `cited` the section and the line of an exported row in its manual, and `is_verified` says that somebody has
    compared them.
    """

    row: int
    address: int = 0
    words: int | None = None
    names: tuple[str, ...] = ()
    type: Typed | None = None
    form: Mapping[str, str] = field(default_factory=dict)
    access: str = ""
    low: Decimal | None = None
    high: Decimal | None = None
    default: Decimal | None = None
    const: Decimal | None = None
    count: int = 1
    stride: int = 0
    texts: Mapping[str, str] = field(default_factory=dict)
    kind: str = REGISTER
    subindices: tuple[int, int] | None = None
    place: SignalPlace | None = None
    space: str = ""
    bits: tuple[int, int] | None = None
    scale: Fraction | None = None
    factor: Fraction | None = None
    is_times: bool = False
    scaled_by: str = ""
    offset: Decimal = Decimal(0)
    unit: str = ""
    order: str = ""
    meanings: Meanings = field(default_factory=Meanings)
    length: int | None = None
    gap: int = 0
    in_unit: bool = False
    is_own: bool = False
    scale_text: str = ""
    special: tuple[tuple[str, str], ...] = ()
    described: tuple[str, ...] = ()
    doubts: tuple[str, ...] = ()
    parts: tuple[int, ...] = ()
    cited: Citation | None = None
    is_verified: bool = False

    @property
    def message(self) -> str:
        """The name of the message of an exported field, empty for another row."""
        return self.texts.get("name", "").partition(".")[0] if self.is_own and self.space == MESSAGES else ""

    def source(self, section: str = "1 ") -> list[str]:
        """The keys that cite the row: its place in the manual, or in the list, whose `section` a holder may have."""
        place = f"{section}L{self.row}" if self.cited is None else self.cited.text()
        return [f"source: {place}", *([] if self.is_verified else ["unverified: true"])]


@dataclass(frozen=True, slots=True)
class Cells:
    """The cells of a row by role, the names in all its columns of names, and its notes by heading.

    `has_factors` says that the list has a column of scales: other texts state none then. `headings` are the
    headings of its numbers.
    """

    row: int
    texts: Mapping[str, str]
    names: tuple[str, ...]
    notes: tuple[tuple[str, str], ...]
    has_factors: bool = False
    headings: tuple[str, ...] = ()


def read_row(row: Cells, decimal: str, default_order: str) -> ListRow:
    """A row without its address. `decimal` is the sign before a fraction, `default_order` that of other rows."""
    doubts: list[str] = []
    texts = _rerouted(row.texts, doubts)
    described = [text for text in (texts.get("label", ""), *(note for _, note in row.notes)) if text]
    own_type = _type(texts, described, doubts)
    if own_type is not None and own_type.factor and not row.has_factors:
        texts = {**texts, "scale": own_type.factor}
    low, high, meanings = row_bounds(texts, described, decimal, doubts)
    meanings = _with_bits(texts, _meanings(texts, meanings, doubts), doubts)
    quantity = quantity_of(texts, row.names, row.notes, decimal, row.has_factors, row.headings, doubts)
    count = whole(texts.get("count", "")) or 1
    return ListRow(
        row=row.row,
        address=0,
        words=None,
        names=row.names,
        type=own_type,
        form={"digits": own_type.digits} if own_type is not None and own_type.digits else {},
        access=_access(texts, described, doubts),
        low=low,
        high=high,
        default=default_of(texts, meanings, decimal),
        const=number(texts.get("const", ""), decimal),
        count=count if 1 <= count <= _HIGHEST_COUNT else 1,
        stride=max(whole(texts.get("stride", "")) or 0, 0),
        texts=texts,
        space=_space(texts, doubts),
        bits=_bits_of_mask(texts, doubts) if "mask" in texts else bits(texts.get("bit", _bit_of_type(own_type))),
        scale=quantity.scale,
        factor=quantity.times or open_factor(texts, decimal),
        is_times=quantity.times is not None,
        scaled_by=quantity.evidence,
        offset=quantity.offset,
        unit=quantity.unit,
        order=_order(texts, own_type, default_order, doubts, [*row.names, *described, texts.get("type", "")]),
        meanings=meanings,
        length=whole(_LENGTH_UNIT.sub("", texts.get("words", ""))),
        special=special_states(texts, own_type, doubts),
        described=tuple(described),
        doubts=(*doubts, *(f"{heading} in the list: {text}." for heading, text in row.notes)),
    )


def _rerouted(texts: Mapping[str, str], doubts: list[str]) -> Mapping[str, str]:
    """The cells of a row; a cell under the heading of units or of types is one of values, a range or a unit, if it has
    these."""
    for role in ("unit", "type"):
        text = _VALUE_WORD.sub("", texts.get(role, ""))
        if not text or (role == "type" and typed(text) is not None):
            continue
        meanings = value_meanings(text)
        is_list = meanings is not None and len(meanings.members) + len(meanings.bits) > 1
        target = "values" if is_list or example(text, COMMA) else "range" if bounds(text) is not None else ""
        quantity = unit_cell(text, COMMA) if role == "type" and not target else None
        if quantity is not None and quantity.scale is not None and known_unit(quantity.unit):
            target = "unit"
            if "unit" in texts and unit_cell(texts["unit"], COMMA) is None:
                doubts.append(f"Unit in the list: {texts['unit']}.")
                texts = {key: cell for key, cell in texts.items() if key != "unit"}
        elif role == "type" and not target and named_places(text) is not None:
            target = "places"
        if target and target not in texts:
            texts = {**{key: cell for key, cell in texts.items() if key != role}, target: text}
    return texts


def _type(texts: Mapping[str, str], described: Sequence[str], doubts: list[str]) -> Typed | None:
    text = texts.get("type", "")
    own_type = typed(text)
    aside = own_type.aside if own_type is not None else ""
    if text and (own_type is None or (aside and scaled_unit(aside, POINT) is None and value_meanings(aside) is None)):
        doubts.append(f"Type in the list: {text}.")
    if not text:
        roles = (*FACTORS, "name", "label")
        unit = texts.get("unit", "")
        asides = (parted(texts.get(role, ""))[1] for role in roles)
        type_texts = ["" if known_unit(unit) else unit, *asides, *described]
        words_of_types = [word for side in type_texts if (word := typed(side)) is not None and not word.aside]
        pieces = [piece for text in described for piece in re.split(r"[,;]", text)]
        signs = (
            word
            for piece in pieces
            if (word := typed(piece)) is not None
            and (word.kind is Loose.WHOLE if meaning("loose_types", piece) else word.name and _DIGIT.search(piece))
        )
        own_type = next(iter((*words_of_types, *signs)), None)
    signed_text = texts.get("signed", "")
    if not signed_text:
        return own_type
    word = typed(signed_text)
    signed = word.signed if word is not None and word.signed is not None else answer(signed_text)
    if signed is None:
        doubts.append(f"Sign in the list: {signed_text}.")
    elif own_type is None:
        return Typed("", Loose.WHOLE, signed)
    elif own_type.kind is Loose.WHOLE:
        return replace(own_type, signed=signed)
    elif own_type.name[:1] in ("u", "i") and (own_type.name[0] == "i") is not signed:
        if folded(text) in _SIGNLESS:
            return replace(own_type, name=f"{'i' if signed else 'u'}{own_type.name[1:]}")
        doubts.append(f"The list says {text}, and signed: {signed_text}.")
    return own_type


def _access(texts: Mapping[str, str], described: Sequence[str], doubts: list[str]) -> str:
    if texts.keys().isdisjoint(("access", "writable", "readable", "function")):
        return spoken_access(described)
    text, writable = texts.get("access", ""), texts.get("writable", "")
    stated = access(text)
    codes = functions(text) if text and not stated else None
    codes = functions(texts["function"]) if "function" in texts else codes
    by_code = ("rw" if codes.reads else "wo") if codes is not None and codes.writes else ""
    by_code = by_code or ("ro" if codes is not None and "function" not in texts else "")
    if text and not stated and codes is None:
        doubts.append(f"Access in the list: {text}.")
    if texts.get("readable") and not stated:
        is_readable, is_writable = answer(texts["readable"]), answer(writable or "no")
        by_columns = {(True, True): "rw", (True, False): "ro", (False, True): "wo"}
        is_understood = is_readable is not None and is_writable is not None
        stated = by_columns.get((bool(is_readable), bool(is_writable)), "") if is_understood else ""
        doubts += [] if stated else [f"Readable in the list: {texts['readable']}; writable: {writable}."]
    elif writable:
        answer_value = answer(writable)
        by_answer = access(writable) or {True: "rw", False: "ro", None: ""}[answer_value]
        if not by_answer:
            doubts.append(f"Writable in the list: {writable}.")
        elif stated and (stated == "ro") is (by_answer != "ro"):
            doubts.append(f"The list says {text}, and writable: {writable}.")
        stated = stated or by_answer
    if stated == "ro" and by_code:
        doubts.append(f"The list says {text or writable}, and the function codes {texts.get('function', text)}.")
    return stated or by_code


def _space(texts: Mapping[str, str], doubts: list[str]) -> str:
    """The name of the space: one of the four, or the list's own word for another."""
    text = texts.get("space", "")
    stated = cells.space(text) or text
    code_text = texts.get("function", "")
    codes = functions(code_text)
    if code_text and codes is None:
        doubts.append(f"Function codes in the list: {code_text}.")
    if codes is None or not stated:
        return stated or (codes.space if codes is not None else "")
    if codes.space != stated:
        doubts.append(f"The list says {text}, and the function codes {code_text}.")
    return stated


def _bit_of_type(own_type: Typed | None) -> str:
    """The number of a bit in brackets after a type: `bool (bit 4)`."""
    bit = _BIT.fullmatch(own_type.aside) if own_type is not None and own_type.kind is Loose.TRUTH else None
    return bit[1] if bit else ""


def _bits_of_mask(texts: Mapping[str, str], doubts: list[str]) -> tuple[int, int] | None:
    """The bits of a mask, but not for one of a whole number of words; a mask with gaps is a doubt."""
    place = mask_bits(whole(texts["mask"]) or 0)
    if place is None:
        doubts.append(f"Mask in the list: {texts['mask']}.")
    return None if place is None or (not place[0] and (place[1] + 1) % _WORD_BITS == 0) else place


def bits(text: str, highest: int = _LAST_BIT) -> tuple[int, int] | None:
    """The lowest and the highest of one or two numbers in a text; None if it has others, or one that is too high."""
    numbers = [int(digits) for digits in re.findall(r"[0-9]{1,3}", text)]
    if not numbers or len(numbers) > 2 or max(numbers) > highest:
        return None
    return min(numbers), max(numbers)


def _meanings(texts: Mapping[str, str], of_range: Meanings | None, doubts: list[str]) -> Meanings:
    states = tuple((number, texts[role]) for number, role in enumerate(STATES) if role in texts)
    if states:
        doubts += [f"Values in the list: {texts['values']}."] if "values" in texts else []
        return Meanings(states)
    text = texts.get("values", "")
    if text:
        if example(text, COMMA) is not None or bounds(text, POINT) is not None:
            return of_range or Meanings()
        meanings = value_meanings(text, single=True)
        if meanings is not None:
            return meanings
        doubts.append(f"Values in the list: {text}.")
    asides = (parted(texts.get(role, ""))[1] for role in ("printed_name", "name", "label", "type"))
    for described_text in (texts.get("label", ""), texts.get("note", ""), *asides):
        described = value_meanings(described_text)
        if of_range is None and described is not None and len(described.members) + len(described.bits) > 1:
            return described
    return of_range or Meanings()


def _with_bits(texts: Mapping[str, str], meanings: Meanings, doubts: list[str]) -> Meanings:
    """The meanings, with the meanings in a column of bits."""
    text = texts.get("bits", "")
    bits = bit_names(text) if text else ()
    if bits is None or (bits and meanings.bits):
        doubts.append(f"Bits in the list: {text}.")
        return meanings
    return replace(meanings, bits=bits) if bits else meanings


def _order(
    texts: Mapping[str, str], own_type: Typed | None, default_order: str, doubts: list[str], described: Sequence[str]
) -> str:
    of_words, of_bytes = (_stated_order(role, texts.get(role, ""), doubts) for role in ("word_order", "byte_order"))
    stated = joined_order(of_bytes, of_words)
    of_type = own_type.order if own_type is not None else ""
    if stated and of_type and stated != of_type:
        text = texts.get("word_order") or texts.get("byte_order")
        doubts.append(f"The list says {texts['type']}, and the order {text}.")
    return stated or of_type or next(filter(None, map(described_order, described)), "") or default_order


def _stated_order(role: str, text: str, doubts: list[str]) -> str:
    """The order in a column of orders of bytes, or of words, where `little` has the low word first and usual bytes."""
    stated = stated_order(text)
    if text and not stated:
        answer_value = answer(text)
        if answer_value is None:
            doubts.append(f"Order of {role.partition('_')[0]}s in the list: {text}.")
        else:
            stated = "CDAB" if answer_value else "ABCD"
    is_code = folded(text) in ("dcba", "4321")
    return "CDAB" if role == "word_order" and stated == "DCBA" and not is_code else stated


def moved(rows: Sequence[ListRow], offset: int) -> Iterator[ListRow]:
    """The rows with the addresses on the wire, which are lower than the addresses of the list by an offset."""
    for row in rows:
        yield replace(row, address=row.address - offset)
