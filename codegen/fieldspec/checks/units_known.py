"""Every unit is one of the language, or the spec declares it under `units`, with a symbol of its own. Its `ucum` has
the form of a code: symbols with exponents, joined by points and slashes; words in braces say what is counted. A unit
with a `factor` has a `quantity`.

Why: software that converts values must know the unit, and a misspelt unit is unknown. Exports hand the code on to
software that reads it.

Example: `unit: Pluse`, or `ucum: mm//s`

Cure: Use the intended unit, and write an erratum with the printed one. Declare a unit that the language does not
have under `units`, with its quantity and its factor. Correct the code, or remove it.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import values
from fieldspec.checks.finding import finding, label, near
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.fact import Fact, Place
from fieldspec.model.ucum import is_code
from fieldspec.model.units import standard_unit, standard_units

_CODE = "units_known"


def units_known(device: Device) -> Iterator[Diagnostic]:
    declared: dict[str, Place] = {}
    for own in device.units.values():
        symbol = own.symbol
        standard = standard_unit(symbol)
        if standard is not None:
            text = f"every spec may use the unit {symbol}"
            yield finding(_CODE, own.place, "symbol", text, f"remove the declaration, and use `{standard.symbol}`")
        elif symbol in declared:
            there = label(declared[symbol], "symbol", "the first one")
            text = f"two units have the symbol {symbol}"
            yield finding(_CODE, own.place, "symbol", text, "rename one of them", there)
        declared.setdefault(symbol, own.place)
        if own.factor and not own.quantity:
            text = f"{symbol} has a factor, but no quantity, so that nothing is converted to it"
            yield finding(_CODE, own.place, "factor", text, "state the `quantity` that the unit measures")
        if own.ucum and not is_code(own.ucum):
            text = f"`{own.ucum}` is no code of UCUM: symbols with exponents, joined by `.` and `/`"
            yield finding(_CODE, own.place, "ucum", text, "write it as `mm/{rev}`, `m/s2` or `kg.m2`, or remove it")
    known = {*declared, *standard_units()}
    stated: list[tuple[Fact, str]] = [(fact, value.quantity_unit) for fact, value in values(device)]
    stated += [(limit, limit.unit) for limit in device.limits]
    stated += [(bit, bit.unit) for word in device.flags.values() for bit in word.bits]
    for fact, unit in stated:
        if unit and unit not in known:
            standard = standard_unit(unit)
            titled = standard or next(
                (own for own in standard_units().values() if own.title.lower() == unit.lower()), None
            )
            help = f"write it as `{titled.symbol}`" if titled is not None else near(unit, known)
            yield finding(_CODE, fact.place, "unit", f"`unit` cannot be `{unit}`", help)
