"""Every unit is one of the language, or the spec declares it under `units`, with a unique symbol. Its `ucum` has the
form of a code: symbols with exponents, joined by points and slashes; braces contain the counted object. A unit with a
`factor` has a `quantity`.

Why: software that converts values must know the unit, and a misspelt unit is unknown. Exports pass the code to other
software.

Example: `unit: Pluse`, or `ucum: mm//s`

Fix: Use the intended unit, and write an erratum with the printed one. Declare a unit that the language does not
have under `units`, with its quantity and its factor. Correct the code, or remove it.
"""

from __future__ import annotations

import re
from collections.abc import Collection

from fieldspec.language.checks.facts import values
from fieldspec.language.checks.finding import Findings, finding, label, near
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact, Place
from fieldspec.language.model.ucum import is_code
from fieldspec.language.model.units import standard_unit, standard_units

_SCALED = re.compile(r"([0-9]+(?:\.[0-9]+)?) ?(.+)")
_OTHER_WORDS = {
    "amp": "A",
    "amps": "A",
    "celsius": "°C",
    "c": "°C",
    "deg": "°",
    "deg_c": "°C",
    "degc": "°C",
    "degree": "°",
    "degrees": "°",
    "fahrenheit": "°F",
    "hour": "h",
    "hours": "h",
    "hr": "h",
    "kelvin": "K",
    "l/m": "L/min",
    "lpm": "L/min",
    "l/s": "L/s",
    "lps": "L/s",
    "m3/h": "m³/h",
    "meter": "m",
    "millimeter": "mm",
    "ml/m": "mL/min",
    "min": "min",
    "minute": "min",
    "minutes": "min",
    "msec": "ms",
    "newton": "N",
    "pascal": "Pa",
    "percent": "%",
    "r/min": "rpm",
    "rev/min": "rpm",
    "revolution": "rev",
    "revolutions": "rev",
    "revs": "rev",
    "sec": "s",
    "second": "s",
    "seconds": "s",
    "usec": "µs",
    "us": "µs",
    "volt": "V",
    "volts": "V",
    "turn": "rev",
    "turns": "rev",
    "watt": "W",
    "watts": "W",
}
"""What others write for some units, in small letters."""
_LOOKALIKES = str.maketrans(
    {"\u00ba": "°", "\u02da": "°", "\u2109": "°F", "\u2103": "°C", "\u03bc": "µ", "\u2126": "Ω"}
)
"""Characters that look like unit symbols: the ordinal indicator and the ring above like the sign of degrees."""


def units_known(device: Device) -> Findings:
    declared: dict[str, Place] = {}
    for own in device.units.values():
        symbol = own.symbol
        standard = standard_unit(symbol)
        if standard is not None:
            text = f"every spec may use the unit {symbol}"
            yield finding(own.place, "symbol", text, f"remove the declaration, and use `{standard.symbol}`")
        elif symbol in declared:
            related_label = label(declared[symbol], "symbol", "the first one")
            text = f"two units have the symbol {symbol}"
            yield finding(own.place, "symbol", text, "rename one of them", related_label)
        declared.setdefault(symbol, own.place)
        if own.factor and not own.quantity:
            text = f"{symbol} has a factor, but no quantity, so that nothing is converted to it"
            yield finding(own.place, "factor", text, "state the `quantity` that the unit measures")
        if own.ucum and not is_code(own.ucum):
            text = f"`{own.ucum}` is not a UCUM code, which has symbols with exponents, joined by `.` and `/`"
            yield finding(own.place, "ucum", text, "write it as `mm/{rev}`, `m/s2` or `kg.m2`, or remove it")
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
            help = f"write it as `{_yaml_text(titled.symbol)}`" if titled is not None else _meant(unit, known)
            yield finding(fact.place, "unit", f"`unit` cannot be `{unit}`", help)


def _meant(unit: str, known: Collection[str]) -> str:
    """The help for a unit that the language does not have: what others write for one that it has, or a near one."""
    scaled = _SCALED.fullmatch(unit)
    if scaled is not None and (symbol := _symbol(scaled[2], known)):
        return f"state the factor apart: `scale: {scaled[1]}, unit: {_yaml_text(symbol)}`"
    symbol = _symbol(unit, known)
    if symbol:
        return f"write it as `{_yaml_text(symbol)}`"
    help = near(unit, known)
    return help if help.endswith("?") else f"{help}, or declare it under `units`"


def _symbol(unit: str, known: Collection[str]) -> str:
    """The symbol of a unit that may be written in another way; empty where there is none."""
    if unit in known:
        return unit
    if (standard := standard_unit(unit)) is not None:
        return standard.symbol
    if unit != (clean := unit.translate(_LOOKALIKES)):
        return _symbol(clean, known)
    other = _OTHER_WORDS.get(unit.lower(), "")
    if other in known:
        return other
    alike = [symbol for symbol in known if symbol.lower() == unit.lower()]
    return alike[0] if len(alike) == 1 else ""


def _yaml_text(symbol: str) -> str:
    """A symbol as YAML has it: `%` begins no text without quotes."""
    return f'"{symbol}"' if symbol.startswith("%") else symbol
