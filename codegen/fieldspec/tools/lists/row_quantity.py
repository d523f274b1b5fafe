"""The quantity of a row: its unit, and what its cells say of the scale and the offset of its counts."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction

from fieldspec.foundation.classes import replace
from fieldspec.tools.lists.brackets import parted
from fieldspec.tools.lists.cells import COMMA, bounds, number, whole
from fieldspec.tools.lists.quantities import (
    Quantity,
    exact_decimal,
    factor,
    formula,
    known_unit,
    scaled_unit,
    states_direction,
    times,
    unit_cell,
)
from fieldspec.tools.lists.type_words import typed
from fieldspec.tools.lists.words import alternatives, folded, meaning, whole_words, words

FACTORS = ("scale", "gain", "divisor")
"""The roles of columns with factors, whose direction a list may leave open."""

SCALED_BOUNDS = ("raw_low", "raw_high", "scaled_low", "scaled_high")
"""The roles of columns with two counts and the quantities that they stand for."""

IDLE_SCALES = ("none", "linear")
"""Cells of columns of scales that have no scale: the kinds of scaling that need no word."""

_WEIGHT = re.compile(r"(?:value\s+)?weight\s*:?\s*([^\W\d]+)\s*[*x\u00d7]\s*([1-9][0-9]{0,8})", re.IGNORECASE)
"""How many counts are one of a unit: `Value weight: Volt*10`."""

_STEP = re.compile(alternatives("step") + r"\s*((?:0[.,][0-9]{1,4}|1/10+|1)\s?[^\s0-9,;.()]{1,6})", re.IGNORECASE)
_UNIT = re.compile(alternatives("unit") + r"\s*[:=]?\s*(\S{1,8})\.?", re.IGNORECASE)
_FRACTION = re.compile(rf"\b(?:({alternatives('tenth')})|{alternatives('hundredth')})\s+(\S{{1,8}})", re.IGNORECASE)
_EXAMPLE = re.compile(
    rf"(?:{alternatives('example')}\s*:?\s*)?([-+]?[0-9]{{1,9}})(?:\s*-\s*([0-9]{{1,9}}))?"
    rf"(?:\s*{alternatives('counts')})?\s*{alternatives('means')}"
    r"\s*\+?(-?[0-9]+(?:[.,][0-9]+)?)(?:\s*-\s*([0-9]+(?:[.,][0-9]+)?))?\s*([^\s0-9][^0-9=;()]{0,15})",
    re.IGNORECASE,
)
_ASIDES = re.compile(r"[(\[]([^()\[\]]{2,30})[)\]]")
_SENTENCES = re.compile(r"[;\n]|[.,](?=\s|$)")
COUNT = re.compile(rf"\(?\s*{alternatives('count')}(?:[ _]?(?:value|val|data))?\s*[-+*/x\u00d7÷]", re.IGNORECASE)
"""The count in a formula within a text."""

_SCALE_BEHIND = re.compile(r"(?<=\S)\s+[*x\u00d7]\s?(0[.,]0*1)$", re.IGNORECASE)
"""A part of ten after its sign at the end of a description: `Grid voltage x0.1`."""

_TIMES = re.compile(r"^\s*[*x\u00d7]\s*", re.IGNORECASE)
_BEHIND_RANGE = re.compile(r"(?:(?<=[0-9])[^\s0-9.,xX]|(?<=[0-9]) [^\s0-9])[^\s0-9]*$")
_LABEL = re.compile(
    r"([^\W\d][^\W\d ]*)\s*(?:[:=]\s*)?(?=([x\u00d7*/÷])?)((?:[x\u00d7*/÷]\s*)?[0-9.].*)", re.IGNORECASE
)
"""A word, and a number after it, perhaps with the sign of a factor before it."""

_FIXED = re.compile(r"(?:fix(?:ed)?|dec(?:imals?)?)[ _]?([0-9])", re.IGNORECASE)
_FORMATS = {"temp": 1}
"""The places after the point of formats that have names beside `FIX2`."""

_NO_FORMULAS = ("none", "v", "value", "raw", "rawvalue", "x", "val", "y", "keine", "无")
_HIGHEST_EXPONENT = 9
_DEGREES = {"C": "°C", "F": "°F"}
"""The symbols of other units that lists write for degrees."""


def quantity_of(
    texts: Mapping[str, str],
    names: Sequence[str],
    notes: Sequence[tuple[str, str]],
    decimal: str,
    has_factors: bool,
    headings: Sequence[str],
    doubts: list[str],
) -> Quantity:
    """The unit of a row, and the scale and the offset that need no decision for the whole list."""
    text = texts.get("unit", "")
    if text:
        unit = scaled_unit(text, decimal) or unit_cell(text, decimal)
    else:
        unit = _unit_of_texts(texts, names, decimal)
        of_headings = {quantity: heading for heading in headings if (quantity := _unit_behind(heading, decimal))}
        if len(of_headings) > 1:
            doubts.append(f"Units of headings in the list: {', '.join(of_headings.values())}.")
        elif of_headings and unit == Quantity():
            (unit,) = of_headings
    if unit is not None and unit.unit in _DEGREES:
        is_temperature = any(word in folded(name) for name in names for word in words("measured")["K"])
        unit = replace(unit, unit=_DEGREES[unit.unit]) if is_temperature else None
    if unit is None and (step := number(text, decimal)) is not None and 0 < step < 1:
        unit = Quantity(Fraction(step))
    if unit is None or (typed(unit.unit) is not None and not known_unit(unit.unit)):
        doubts.append(f"Unit in the list: {text or texts['range']}.")
        unit = Quantity()
    stated: list[tuple[Fraction, str]] = [(unit.scale, text)] if unit.scale not in (None, 1) else []
    in_counts = replace(unit, evidence=text or next(iter(names), ""))
    offset = number(texts.get("value_offset", ""), decimal) or Decimal(0)
    if texts.get("value_offset") and number(texts["value_offset"], decimal) is None:
        doubts.append(f"Offset in the list: {texts['value_offset']}.")
    if texts.get("formula"):
        linear = formula(texts["formula"], decimal)
        if linear is not None:
            stated.append((linear.scale or Fraction(1), texts["formula"]))
            offset = offset or linear.offset
        elif folded(texts["formula"]) not in _NO_FORMULAS:
            doubts.append(f"Formula in the list: {texts['formula']}.")
    line = _between_bounds(texts, decimal)
    if line is not None:
        stated.append((line.scale or Fraction(1), "raw and scaled bounds"))
        offset = offset or line.offset
    else:
        doubts += [
            f"{role.replace('_', ' ').capitalize()} in the list: {texts[role]}."
            for role in SCALED_BOUNDS
            if role in texts
        ]
    stated += _powers(texts, doubts)
    for _, note in notes:
        weight = _WEIGHT.fullmatch(note.strip())
        if weight and known_unit(weight[1]):
            stated.append((Fraction(1, int(weight[2])), note))
            unit = replace(unit, unit=unit.unit or known_unit(weight[1]))
        elif len(note.strip()) > 1:  # a name may be a word of a unit, too: `Hour`
            unit = replace(unit, unit=unit.unit or known_unit(note))
    joint = joint_factor(texts, decimal)
    stated += [joint] if joint else []
    for role in FACTORS if not joint else ():
        cell = factor_cell(texts, role)
        operator, operand = meaning("operators", texts.get("operator", "")), factor(cell, decimal)
        if operator and operand is not None:
            stated.append((operand if operator == "multiply" else 1 / operand, texts[role]))
        elif (count_factor := times(cell, decimal)) is not None:
            in_counts = Quantity(times=count_factor, evidence=texts[role])
        elif cell and states_direction(cell):
            bare = _TIMES.sub("", cell)
            scaled = example(cell, decimal) or scaled_unit(bare, decimal) or unit_cell(bare, decimal)
            own_factor = factor(cell, decimal)
            linear = formula(cell, decimal) if own_factor is None and COUNT.match(cell) else None
            if linear is not None:
                own_factor, offset = linear.scale, offset or linear.offset
            if own_factor is None and scaled is not None and scaled.scale is not None:
                own_factor = scaled.scale
                if unit.unit not in ("", scaled.unit):
                    doubts.append(f"Unit in the list: {text}.")
                unit = replace(unit, unit=scaled.unit or unit.unit)
            if own_factor is not None:
                stated.append((own_factor, texts[role]))
            elif scaled is not None and scaled.times is None:
                unit = replace(unit, unit=unit.unit or scaled.unit)
    type_aside = texts.get("type", "").partition(",")[2].strip()
    of_step = _step(texts, decimal)
    is_open = not stated and in_counts.times is None and not has_factors
    if of_step is not None and is_open and unit.unit in ("", of_step.unit or unit.unit):
        return replace(of_step, unit=unit.unit or of_step.unit, offset=offset)
    if texts.get("step") and factor(texts["step"], decimal) != 1:
        doubts.append(f"Step in the list: {texts['step']}.")
    if is_open:
        for described in (
            *names,
            *(note for _, note in notes),
            *(texts.get(role, "") for role in ("values", "range")),
            type_aside,
        ):
            quantity = _described(described, decimal)
            if quantity is not None and (not quantity.unit or unit.unit in ("", quantity.unit)):
                return replace(
                    quantity, unit=unit.unit or quantity.unit, offset=offset or quantity.offset, evidence=described
                )
    scales = {scale for scale, _ in stated}
    if len(scales) > 1:
        doubts.append("The list has several scales: " + ", ".join(cell for _, cell in stated) + ".")
        return replace(unit, scale=None, offset=offset, times=None)
    if scales or in_counts.times is None:
        return Quantity(next(iter(scales), None), unit.unit, offset)
    return Quantity(None, unit.unit, offset, in_counts.times, in_counts.evidence)


def _step(texts: Mapping[str, str], decimal: str) -> Quantity | None:
    """The scale of a row whose settings have a step of a tenth or the like; None for greater steps, and for others, of
    which counts may be parts: `5`, `0.5`."""
    text = texts.get("step", "")
    scaled = scaled_unit(text, decimal) or Quantity(factor(text, decimal))
    is_part = scaled.scale is not None and scaled.scale < 1 and _is_power(scaled)
    return replace(scaled, evidence=f"step {text}") if is_part else None


def factor_cell(texts: Mapping[str, str], role: str) -> str:
    """The cell of a column of factors, without the sign and the size of the type after it: `/100 (signed)`."""
    bare, aside = parted(texts.get(role, ""))
    return bare if bare and aside and known_unit(aside) == "" else texts.get(role, "")


def open_factor(texts: Mapping[str, str], decimal: str) -> Fraction | None:
    """The factor of a row whose cell does not say whether it multiplies or divides; None if it says so, or has none."""
    role = next((role for role in FACTORS if texts.get(role)), "")
    if not role or joint_factor(texts, decimal):
        return None
    text = factor_cell(texts, role)
    is_stated = states_direction(text) or meaning("operators", texts.get("operator", ""))
    return None if is_stated else factor(text, decimal)


def joint_factor(texts: Mapping[str, str], decimal: str) -> tuple[Fraction, str] | None:
    """The scale of a row with a multiplier and a divisor that differ, and their cells; one alone may be the scale in
    both ways: `0.1` and `10`."""
    role = "scale" if "scale" in texts else "gain"
    multiplier, divisor = factor(texts.get(role, ""), decimal), factor(texts.get("divisor", ""), decimal)
    if multiplier is None or divisor is None or multiplier * divisor == 1:
        return None
    return multiplier / divisor, f"{texts[role]} and {texts['divisor']}"


def example(text: str, decimal: str) -> Quantity | None:
    """The quantity of counts with what they stand for, as in `1 = 0.1 A`, `0 = 0 A; 60-160 = 6-16 A`; None for anything
    else, such as a choice."""
    pairs = [_EXAMPLE.fullmatch(piece.strip()) for piece in re.split(r"\s+/\s+|[;\n]", text) if piece.strip()]
    scales, units = set(), set()
    for pair in pairs:
        if pair is None or (pair[2] is None) is not (pair[4] is None):
            return None
        for count_text, quantity_text in ((pair[1], pair[3]), (pair[2], pair[4])) if pair[2] else ((pair[1], pair[3]),):
            count, quantity = whole(count_text), number(quantity_text, decimal or COMMA)
            if count is None or quantity is None or bool(count) is not bool(quantity):
                return None
            scales |= {Fraction(quantity) / count} if count else set()
        units.add(known_unit(pair[5]))
    scale = next(iter(scales), Fraction(0))
    is_power = scale.numerator == 1 and set(str(scale.denominator)[1:]) <= {"0"}
    return Quantity(scale, max(units)) if len(scales) == len(units) == 1 and is_power and max(units) else None


def described_range(text: str, decimal: str) -> Quantity | None:
    """The unit of a description that is a range: `0~100%`; None for another one, and for numbers alone."""
    unit = known_unit(re.sub(r"^.*[0-9]", "", text))
    return Quantity(unit=unit) if unit and bounds(text, decimal) is not None else None


def _described(text: str, decimal: str) -> Quantity | None:
    """The quantity that a description says: `Dew point in 0.01 °C`, `Charge (÷10 for %)`, `(Hz x 100)`, `(XX.X V)`,
    `325 = 32.5 °C`, `Temperature = raw / 10 - 40`."""
    quantity = example(text, decimal) or scaled_unit(text, decimal) or described_range(text, decimal)
    if quantity is not None and known_unit(quantity.unit):
        return quantity
    pieces = [piece.strip() for piece in _SENTENCES.split(text)]
    for piece in pieces:
        for right in (piece.partition("=")[2].strip(), piece):
            if COUNT.match(right) and (linear := formula(right, decimal)) is not None:
                return linear
        if (labelled := _labelled(piece, decimal)) is not None:
            return labelled
    after_word = _UNIT.fullmatch(text.strip())
    if after_word and (unit := known_unit(after_word[1])):
        return Quantity(unit=unit)
    if own_scale := _SCALE_BEHIND.search(text):
        return Quantity(Fraction(own_scale[1].replace(",", ".")))
    if (fraction := _FRACTION.search(text)) and (unit := known_unit(fraction[2].strip(".,;)"))):
        return Quantity(Fraction(1, 10 if fraction[1] else 100), unit if unit != "°" else "")
    scaled_pieces = [unit_cell(piece, decimal) for piece in pieces] if len(pieces) > 1 else []
    known_pieces = [piece for piece in scaled_pieces if piece is not None and piece.unit == known_unit(piece.unit)]
    powers = [piece for piece in known_pieces if _is_power(piece)]
    if len(powers) == 1:
        return powers[0]
    if step := _STEP.search(text):
        quantity = scaled_unit(step[1], decimal)
        return quantity if quantity is not None and known_unit(quantity.unit) else None
    for aside in _ASIDES.findall(text):
        quantity = unit_cell(aside, decimal) if typed(aside) is None else None
        if quantity is not None and (quantity.times or quantity.scale) and quantity.unit == known_unit(quantity.unit):
            return quantity
    return None


def _labelled(text: str, decimal: str) -> Quantity | None:
    """The quantity of a scale after a word for it, or of a factor with its sign: `Value: x0.1 V`, `Scale 0,1`."""
    label = _LABEL.fullmatch(text)
    if label is None:
        return None
    is_scale = whole_words().get(folded(label[1])) == "scale"
    sign = decimal or COMMA
    quantity = unit_cell(label[3], sign) or scaled_unit(_TIMES.sub("", label[3]), sign)
    if quantity is None and is_scale and (own_factor := factor(label[3], sign)) is not None and own_factor < 1:
        quantity = Quantity(own_factor)
    is_known = quantity is not None and quantity.unit == known_unit(quantity.unit)
    is_scaled = quantity is not None and bool(quantity.scale or quantity.times)
    return quantity if is_known and is_scaled and (is_scale or label[2]) else None


def _is_power(quantity: Quantity) -> bool:
    """Whether the scale of a quantity, or its factor, is a power of ten other than 1."""
    scale = quantity.scale or quantity.times or Fraction(1)
    digits = str(max(scale.numerator, scale.denominator))
    return scale != 1 and min(scale.numerator, scale.denominator) == 1 and digits.strip("0") == "1"


def unread_scales(texts: Mapping[str, str]) -> list[str]:
    """The cells of columns of scales, but those that have none."""
    cells_of_scales = [texts[role] for role in FACTORS if role in texts]
    return [cell for cell in cells_of_scales if folded(cell) not in IDLE_SCALES and not known_unit(cell)]


def decimal_places(text: str) -> int | None:
    """How many places a count has after the point: a number, or the name of a format such as `FIX2`."""
    places = named_places(text)
    return places if places is not None else whole(text)


def named_places(text: str) -> int | None:
    """The places after the point of a format that its name says: `FIX2`, `DEC 1`."""
    fixed = _FIXED.fullmatch(text.strip())
    return int(fixed[1]) if fixed else _FORMATS.get(folded(text))


def _powers(texts: Mapping[str, str], doubts: list[str]) -> Iterator[tuple[Fraction, str]]:
    """The scales of a number of places, and of a power of ten. Beside a scale, places say how a value is shown."""
    is_display = not texts.keys().isdisjoint(FACTORS)
    for role, sign, highest in (("places", -1, 0), ("exponent", 1, _HIGHEST_EXPONENT)):
        text = texts.get(role, "")
        power = decimal_places(text) if role == "places" else whole(text)
        if power is not None and -_HIGHEST_EXPONENT <= sign * power <= highest and not (is_display and sign < 0):
            yield Fraction(10) ** (sign * power), text
        elif text:
            doubts.append(f"{role.capitalize()} in the list: {text}.")


def _between_bounds(texts: Mapping[str, str], decimal: str) -> Quantity | None:
    """The line through two counts and the quantities that they stand for."""
    ends = [number(texts.get(role, ""), decimal) for role in SCALED_BOUNDS]
    raw_low, raw_high, low, high = ends
    if raw_low is None or raw_high is None or low is None or high is None or raw_low >= raw_high or low >= high:
        return None
    scale = Fraction(high - low) / Fraction(raw_high - raw_low)
    offset = exact_decimal(Fraction(low) - Fraction(raw_low) * scale)
    return None if offset is None else Quantity(scale, "", offset)


def _unit_of_texts(texts: Mapping[str, str], names: Sequence[str], decimal: str) -> Quantity | None:
    """The unit after a name, or after a range, where the list has no cell for it: `Speed [rpm]`."""
    if (unit := next(filter(None, (_unit_behind(name, decimal) for name in names)), None)) is not None:
        return unit
    measured = bounds(texts.get("range", ""), decimal) and _BEHIND_RANGE.search(texts["range"])
    return unit_cell(measured[0], decimal) if measured else Quantity()


def _unit_behind(name: str, decimal: str) -> Quantity | None:
    """The unit in brackets, or after a comma, at the end of a name or a heading: `Speed [rpm]`; None without one."""
    aside = parted(name)[1] or next(filter(known_unit, map(str.strip, name.split(",")[1:])), "")
    quantity = unit_cell(aside, decimal) if aside else None
    if quantity is None or not known_unit(quantity.unit) or typed(aside) is not None:
        return None
    if aside.isupper() and quantity.unit.islower() and len(aside) == 2:
        return None  # a name in capital letters
    is_scaled = quantity.scale or quantity.times
    is_phase = not is_scaled and not name.endswith("]") and _may_be_a_phase(known_unit(quantity.unit), name)
    return None if is_phase else quantity


def _may_be_a_phase(unit: str, name: str) -> bool:
    """Whether a capital letter in round brackets may be a phase or a half: the name does not say what it measures."""
    is_capital = len(unit) == 1 and unit.isupper()
    return is_capital and not any(word in folded(name) for word in words("measured").get(unit, ()))
