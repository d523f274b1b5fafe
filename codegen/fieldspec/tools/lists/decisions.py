"""The decisions of a whole list for its rows: the unit of lengths, the direction of factors, the unit of bounds."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

from fieldspec.foundation.classes import replace
from fieldspec.tools.lists import directions
from fieldspec.tools.lists.assumption import Assumption, Options
from fieldspec.tools.lists.brackets import parted
from fieldspec.tools.lists.column_roles import Columns
from fieldspec.tools.lists.directions import DIVIDE, LENGTHS, UNIT, Measured
from fieldspec.tools.lists.numbering import Placed, wire_number
from fieldspec.tools.lists.quantities import known_unit
from fieldspec.tools.lists.remarks import described_states
from fieldspec.tools.lists.row_quantity import FACTORS, unread_scales
from fieldspec.tools.lists.row_reading import ListRow
from fieldspec.tools.lists.shapes import BIT
from fieldspec.tools.lists.sheet import ListError
from fieldspec.tools.lists.type_words import UNSIGNED, Typed
from fieldspec.tools.lists.value_texts import Meanings, NamedBits
from fieldspec.tools.lists.words import folded, words

_STATE_NUMBER = re.compile("0|-1|255|-?99+")
_FEWEST = 3
"""The rows that show what addresses count."""

_OF_SCALES = re.compile(r"\b(?:sf|scale|scaling|exponent)(?:\b|_)|_sf$", re.IGNORECASE)
"""The names of rows with exponents, as in SunSpec."""

_FEWEST_MASKS = 4
"""The masks of bits that show without a type that values are bits: 1, 2, 4, 8."""

_OF_BITS = re.compile(r"^bits?$|bitfield|bitmap|bitmask|flags?$|flags?[0-9]|bitstring|^b?mask")
"""The folded types that have bits."""

_WIDE = 4
"""The bytes of the registers of most chips."""

_OF_WORDS = re.compile(r"%?(?:m|v|db)w[0-9]+$", re.IGNORECASE)
"""Words in the memory of a controller, which has one for all kinds of data."""

_BOUNDS = ("min", "max", "range", "default")

_TEXT, _CHARACTERS = "text", "char"
"""The type of texts, and the beginning of the types that a list has for their characters."""

_FINE = ("V", "A", "°C", "°F", "K", "Hz", "%", "bar", "pH", "°")
"""The units in whose parts devices measure."""


def decided(
    columns_of_sheet: Columns,
    rows: Sequence[ListRow],
    places: Placed,
    ways: Sequence[str],
    options: Options,
    assumptions: list[Assumption],
    undecided: list[Assumption],
) -> list[ListRow]:
    """The rows with what the whole list decides: the unit of lengths, the direction of factors, the unit of bounds."""
    rows = _with_exponents_apart(rows)
    numbers = [wire_number(row_place, ways[0]) for _, row_place in places.rows]
    gaps = [b - a if a is not None and b is not None else 0 for a, b in pairwise(numbers)] + [0]
    sizes = [
        (row.length, row.type.size if row.type else 0, gap)
        for row, gap in zip(rows, gaps, strict=True)
        if row.length and not _own_unit(row)
    ]
    heading = columns_of_sheet.heading("words") if "words" in columns_of_sheet.places else ""
    unit, length_assumption = directions.length_unit(heading, sizes, options.length)
    if not options.address_unit:
        _refuse_bytes(rows, numbers, gaps, unit, assumptions)
    decided = _with_elements([_with_length(row, unit) for row in rows], gaps, columns_of_sheet, assumptions)
    role = next((role for role in FACTORS if role in columns_of_sheet.places), "scale")
    bare_rows = [row for row in decided if row.factor is not None and not row.is_times]
    factors = [row.factor for row in bare_rows if row.factor is not None]
    measured = [decision for row in bare_rows if (decision := _measured(row, row.factor)) is not None]
    factor_heading = columns_of_sheet.heading(role) if role in columns_of_sheet.places else ""
    direction, gain_assumption = directions.gain_direction(
        factor_heading, role, factors, measured, _coarse(bare_rows), _fraction(decided, role), options.gain
    )
    if not direction and gain_assumption is not None:
        undecided.append(gain_assumption)
        gain_assumption = None
    signed = [row for row in decided if row.is_times]
    measured = [decision for row in signed if (decision := _measured(row, row.factor)) is not None]
    of_signs = ""
    if signed:
        of_signs, assumption = directions.times_direction(signed[0].scaled_by, measured, _coarse(signed), options.gain)
        assumptions += [assumption] if assumption is not None else []
    decided = [_scaled(row, of_signs if row.is_times else direction) for row in decided]
    described = [row.scaled_by for row in decided if row.scaled_by and not row.is_times and row.scale is not None]
    if described:
        examples = ", ".join(f"`{text}`" for text in described[:2])
        assumptions.append(Assumption("scales", "those that texts of rows say", examples))
    proved = gain_assumption is not None and gain_assumption.evidence.startswith("the bounds")
    headings = [columns_of_sheet.heading(role) for role in _BOUNDS if role in columns_of_sheet.places]
    in_unit = next((f"{heading} has the unit" for heading in headings if known_unit(parted(heading)[1])), "")
    in_unit = "so they prove the direction of the factor" if proved else in_unit
    measured = [
        decision
        for row in decided
        for ends in (row, replace(row, low=row.default, high=row.default))
        if (decision := _measured(ends, row.scale)) is not None
    ]
    bounds, bounds_assumption = directions.bounds_unit(measured, in_unit, options.bounds)
    assumptions += [
        decision for decision in (length_assumption, gain_assumption, bounds_assumption) if decision is not None
    ]
    decided = [_with_states(replace(row, in_unit=bounds == UNIT and row.scale not in (None, 1))) for row in decided]
    return _with_masks(decided, assumptions)


def _with_masks(rows: Sequence[ListRow], assumptions: list[Assumption]) -> list[ListRow]:
    """The rows, with the values of a bit field as bits where each is the mask of one, as 1, 2, 4, 8, or its number."""
    result = []
    examples, numbered = [], []
    for row in rows:
        members = dict(row.meanings.members)
        masks = sorted(number for number in members if number)
        has_no_quantity = row.scale in (None, 1) and not row.unit and row.bits is None and not row.meanings.bits
        are_masks = len(masks) > 1 and has_no_quantity and all(0 < mask == mask & -mask for mask in masks)
        type_word = folded(row.texts.get("type", ""))
        is_stated = _OF_BITS.search(type_word) is not None
        is_whole = len(masks) >= _FEWEST_MASKS and masks == [1 << number for number in range(len(masks))]
        size = row.words or (row.type.size if row.type else 0) or 1
        has_numbers = is_stated and has_no_quantity and type_word != BIT
        has_numbers = has_numbers and 0 in members and max(members) < LENGTHS["bits"] * size
        if has_numbers and (not are_masks or sorted(members) == list(range(len(members)))):
            bits = tuple(NamedBits(number, number, name) for number, name in row.meanings.members)
            row = replace(row, meanings=Meanings(bits=bits))
            numbered.append(row.texts["type"])
        elif are_masks and (is_stated or is_whole):
            bits = tuple(NamedBits(mask.bit_length() - 1, mask.bit_length() - 1, members[mask]) for mask in masks)
            doubts = (*row.doubts, *([f"Values in the list: 0 {members[0]}."] if 0 in members else []))
            row = replace(row, meanings=Meanings(bits=bits), doubts=doubts)
            examples += [", ".join(map(str, masks[:4]))] if not is_stated else []
        result.append(row)
    if examples:
        assumptions.append(Assumption("values", "bits", f"their numbers are masks of bits: {examples[0]}"))
    if numbered:
        assumptions.append(Assumption("values", "numbers of bits", f"the type {numbered[0]}, and that there is a 0"))
    return result


def _with_states(row: ListRow) -> ListRow:
    """A row with the states that its descriptions say in counts, beyond its bounds, or by a number that no quantity in
    counts has: 0, -1, 255 or nines."""
    is_quantity = bool(row.unit) and row.scale in (None, 1) and not row.offset
    own_type = row.type or Typed("i16" if row.low is not None and row.low < 0 else "u16")
    states = tuple(
        (str(count), name)
        for count, name, is_certain in described_states(own_type, row.described)
        if is_certain or (is_quantity and _STATE_NUMBER.fullmatch(str(count))) or _is_beyond(row, count)
    )
    return replace(row, special=states) if states and not row.special else row


def _is_beyond(row: ListRow, count: int) -> bool:
    """Whether a count is beyond the bounds of a row, which are counts."""
    has_bounds = row.low is not None and row.high is not None and not row.in_unit
    return has_bounds and not (row.low or 0) <= count <= (row.high or 0)


def _with_exponents_apart(rows: Sequence[ListRow]) -> list[ListRow]:
    """The rows, without the factors that are addresses of rows named as scale factors."""
    addresses = {
        folded(row.texts.get("address", "")) for row in rows if any(_OF_SCALES.search(name) for name in row.names)
    }
    are_addresses = [folded(row.texts.get("scale", "")) in addresses - {""} for row in rows]
    return [
        replace(row, factor=None) if is_address else row for row, is_address in zip(rows, are_addresses, strict=True)
    ]


def _refuse_bytes(
    rows: Sequence[ListRow],
    numbers: Sequence[int | None],
    gaps: Sequence[int],
    unit: str,
    assumptions: list[Assumption],
) -> None:
    """Raises ListError for addresses that lie apart as bytes do, and for even ones of words in a controller's memory,
    which no odd one shows to count words."""
    of_words = [row.texts["address"] for row in rows if _OF_WORDS.match(row.texts["address"])]
    odd = next((text for text in of_words if text[-1] in "13579"), "")
    if odd:
        assumptions.append(Assumption("addresses", "words of a memory", f"`{odd}` is odd", "--address-unit"))
    sizes = [
        row.length * LENGTHS["bytes"] // LENGTHS[unit] if row.length else row.type.bytes if row.type else 0
        for row in rows
    ]
    pairs = [(gap, size) for gap, size in zip(gaps, sizes, strict=True) if gap > 0 and size]
    if len(pairs) >= _FEWEST and len({size for _, size in pairs}) > 1 and all(gap == size for gap, size in pairs):
        row, gap = next((row, gap) for row, gap in zip(rows, gaps, strict=True) if gap > 1)
        evidence = f"row {row.row} has {gap} bytes, and the next address is {gap} higher, as in all {len(pairs)} rows"
    elif (
        sum(gap == _WIDE for gap in gaps) >= _FEWEST - 1
        and not any((number or 0) % _WIDE for number in numbers)
        and not any(row.space for row in rows)
        and (not pairs or max(size for _, size in pairs) == _WIDE)
    ):
        evidence = f"all are multiples of {_WIDE}, as of registers of {_WIDE} bytes"
    elif of_words and not odd:
        evidence = (
            f"`{of_words[0]}` is in a memory whose words some controllers count by their bytes, and no number is odd"
        )
    else:
        return
    raise ListError(
        f"has addresses with two readings: {evidence}. They count bytes, of which a register has two, or registers lie "
        "apart; choose with --address-unit bytes or --address-unit words"
    )


def _with_elements(
    rows: list[ListRow], gaps: Sequence[int], columns_of_sheet: Columns, assumptions: list[Assumption]
) -> list[ListRow]:
    """The rows, with counts as their lengths where each is the number of words of its type, or that of a text without
    a length: no value is repeated. They are characters of the type `char`, and of a text whose next address is nearer.
    Beside strides, they count values."""
    row_types = {
        row.row: row.type for row in rows if "count" in row.texts and row.words is None and row.type and row.type.name
    }
    sized = [row for row in rows if row.row in row_types and row_types[row.row].size]
    are_elements = any(row.count != row_types[row.row].size for row in sized)
    of_characters = {
        row.row
        for row, gap in zip(rows, gaps, strict=True)
        if row.row in row_types
        and row_types[row.row].name == _TEXT
        and row.count > 1
        and (0 < gap < row.count or folded(row.texts["type"]).startswith(_CHARACTERS))
    }
    of_words = {number for number, own_type in row_types.items() if own_type.name == _TEXT or not are_elements}
    if any("stride" in row.texts for row in rows if row.row in row_types):
        return rows
    for readings, reading, evidence in (
        (of_words - of_characters, "lengths in words", "each is that of the type, or of a text"),
        (of_characters, "characters of texts", "their types and their next addresses"),
    ):
        if any(row.count > 1 for row in rows if row.row in readings):
            assumptions.append(Assumption(columns_of_sheet.heading("count"), reading, evidence, "--column words"))
    result = []
    for row in rows:
        if row.row in of_characters:
            row = replace(row, type=replace(row_types[row.row], length=row.count), count=1)
        elif row.row in of_words:
            row = replace(row, words=row.count, count=1)
        result.append(row)
    return result


def _own_unit(row: ListRow) -> str:
    """The unit that the cell of a length has itself: `16 bytes`; empty for a number alone."""
    text = folded(row.texts.get("words", "").strip("0123456789 "))
    return next((unit for unit, own in words("lengths").items() if text and text.startswith(own)), "")


def _with_length(row: ListRow, unit: str) -> ListRow:
    """A row with its words, by the unit of its length; a length that is not a whole number of words is a doubt."""
    text, unit = row.texts.get("words", ""), _own_unit(row) or unit
    factor = LENGTHS[unit]
    if unit == "bits" and row.bits is not None and row.length and row.length % factor:
        return replace(row, bits=(row.bits[0], row.bits[0] + row.length - 1))
    if not text or (row.length is not None and row.length > 0 and (row.length < factor or row.length % factor == 0)):
        return replace(row, words=max(row.length // factor, 1)) if row.length else row
    return replace(row, doubts=(*row.doubts, f"Length in the list: {text}."))


def _scaled(row: ListRow, direction: str) -> ListRow:
    """A row with its scale; a factor beside another scale has to be the same, or is a doubt."""
    if row.factor is None:
        unread = [f"Scale in the list: {text}." for text in unread_scales(row.texts)] if row.scale is None else []
        return replace(row, doubts=(*row.doubts, *unread))
    own_way = DIVIDE if "divisor" in row.texts and "scale" not in row.texts and "gain" not in row.texts else direction
    scale = 1 / row.factor if own_way == DIVIDE else row.factor
    if not own_way or (row.scale is not None and row.scale != scale and 1 not in (row.scale, scale)):
        text = row.scaled_by or next(row.texts[role] for role in FACTORS if role in row.texts)
        return replace(row, doubts=(*row.doubts, f"Scale in the list: {text}."))
    return replace(row, scale=scale if row.scale in (None, 1) else row.scale)


def _fraction(rows: Sequence[ListRow], role: str) -> str:
    """A cell of a column of factors that is a fraction: `1/10`; empty if it has none."""
    return next((text for row in rows if re.fullmatch(r"1\s*/\s*[0-9]+", text := row.texts.get(role, ""))), "")


def _coarse(rows: Sequence[ListRow]) -> int:
    """How many rows would count in steps of ten or more of a unit in whose parts devices measure, if their factors
    multiplied; 0 where some would if they divided."""
    factors = [row.factor for row in rows if row.factor is not None and (known_unit(row.unit) or row.unit) in _FINE]
    return 0 if any(factor * 10 <= 1 for factor in factors) else sum(factor >= 10 for factor in factors)


def _measured(row: ListRow, factor: Fraction | None) -> Measured | None:
    if factor is None or row.low is None or row.high is None:
        return None
    type_name = row.type.of_words(row.words) if row.type else UNSIGNED.get(row.words or 1, "u64")
    if row.type is None and row.low < 0:
        type_name = type_name.replace("u", "i")
    return Measured(row.row, factor, row.low, row.high, type_name)
