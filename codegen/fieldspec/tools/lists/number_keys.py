"""The numbers of a fact as keys of a spec: scale, offset, range, default and constant."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

from fieldspec.language.model.encoding import is_count, is_exact, is_real, is_text, is_truth
from fieldspec.language.model.primitives import Primitive
from fieldspec.language.model.ranges import Ranges, whole_intervals
from fieldspec.tools.lists.meaning_text import count_of
from fieldspec.tools.lists.row_reading import PARAMETER, ListRow
from fieldspec.tools.lists.yaml_text import exact, quoted


def numbers(row: ListRow, primitive: Primitive, has_exponent: bool, doubts: list[str]) -> list[str]:
    """Scale, offset, range, default and constant, if they are whole counts of the type; else they become doubts."""
    texts, parts, is_integer = row.texts, [], is_count(primitive.encoding)
    scale = row.scale or Fraction(1)
    if scale != 1 and not has_exponent:
        if is_integer:
            parts.append(f"scale: {row.scale_text or exact(scale)}")
        else:
            doubts.append(f"Scale in the list: {exact(scale)}.")
    if row.offset and is_integer:
        parts.append(f"offset: {row.offset:f}")
    elif row.offset:
        doubts.append(f"Offset in the list: {row.offset:f}.")
    has_counts, (lowest, highest) = is_exact(primitive.encoding), (primitive.low, primitive.high)
    is_whole = row.in_unit or row.is_own or not any(map(_has_places, (row.low, row.high)))
    low, high = (count_of(bound, row) if is_whole else None for bound in (row.low, row.high))
    are_counts = has_counts and (low, high).count(None) == (row.low, row.high).count(None)
    is_switch = is_truth(primitive.encoding) and not row.is_own
    if is_switch and row.low == 0 and row.high == 1:
        pass  # it has no other values
    elif low is not None and high is not None and has_counts and not is_switch and lowest <= low <= high <= highest:
        parts.append(f"{'unit_range' if row.in_unit else 'range'}: {_bound(row.low)}..{_bound(row.high)}")
        lowest, highest = low, high
    elif is_real(primitive.encoding) and row.low is not None and row.high is not None and scale == 1:
        parts.append(f"range: {row.low:f}..{row.high:f}")
    else:
        unread = {"Least value": texts.get("min"), "Greatest value": texts.get("max")}
        is_apart = row.low is not None and row.high is not None and not any(unread.values())
        unread |= {"Range": texts.get("range", f"{row.low:f}..{row.high:f}")} if is_apart else {}
        doubts += [f"{heading} in the list: {text}." for heading, text in unread.items() if text]
    states = ", ".join(number for number, _ in row.special if not number.startswith("NaN"))
    special = Ranges(whole_intervals(states) or ()) if states else Ranges(())
    is_set = row.is_own or row.kind == PARAMETER or row.access != "ro" or row.default != 0
    for key, word, number in (("default", "Default", row.default), ("const", "Constant", row.const)):
        count = count_of(number, row) if key == "default" else _whole(number)
        if _has_places(number) and not (row.in_unit or row.is_own):
            count = None  # nobody writes counts with a fraction
        if key == "default" and key in texts and not is_set:
            doubts.append(f"{word} in the list, whose value is only read: {texts[key]}.")
        elif key in texts and count is not None and are_counts and (lowest <= count <= highest or count in special):
            unit_key = "unit_default" if row.in_unit and key == "default" else key
            parts.append(f"{unit_key}: {_bound(number)}")
        elif key in texts and (row.is_own or row.kind == PARAMETER) and is_text(primitive.encoding):
            parts.append(f"default: {quoted(texts[key])}")
        elif key == "default" and number is not None and is_real(primitive.encoding) and scale == 1:
            parts.append(f"default: {number:f}")
        elif key in texts:
            doubts.append(f"{word} in the list: {texts[key]}.")
    return parts


def _bound(number: Decimal | None) -> str:
    """A bound without zeros after a point."""
    return exact(Fraction(number or 0))


def _has_places(number: Decimal | None) -> bool:
    """Whether a list writes a number with places after the point: `50.00`."""
    return number is not None and "." in str(number)


def _whole(number: Decimal | None) -> int | None:
    return int(number) if number is not None and number == number.to_integral_value() else None
