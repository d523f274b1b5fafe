"""Signals of messages: their ranges and scales; and what counts of them are a share of."""

from __future__ import annotations

from fieldspec.backends.c.accessors import constant_lines
from fieldspec.backends.c.comments import of_value, told
from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.text import comment, indented, integer
from fieldspec.model.device import Device
from fieldspec.model.value import Conversion, Signal


def signal_lines(naming: Naming, signal: Signal) -> list[str]:
    """The constants of a signal, or nothing where it has none."""
    constants = constant_lines(naming, "signal", (signal.name,), signal.value)
    return [*told(signal, of_value(signal.value)), *constants] if constants else []


def bounds(device: Device, conversion: Conversion) -> tuple[int, int]:
    """The least and the greatest count that one of a conversion's signals may have."""
    kind = conversion.type
    ranges = [device.signals[name].value.ranges for name in conversion.signals]
    known = [one for one in ranges if one is not None]
    if not known or len(known) < len(ranges):
        return kind.low, kind.high
    return max(kind.low, min(one.low for one in known)), min(kind.high, max(one.high for one in known))


def conversion_lines(naming: Naming, device: Device, conversion: Conversion) -> list[str]:
    """The functions from a count to a quantity and back, in double."""
    size, signed = conversion.type.size, conversion.type.signed
    kind = f"{'' if signed else 'u'}int{8 * size}_t"
    full, share = f"{conversion.full_scale}.0", f"(double)raw / {conversion.full_scale}.0"
    formula = f"reference * (1 - raw / {full})" if conversion.complement else f"reference * raw / {full}"
    about = [
        f"{conversion.title or conversion.name} = {formula}",
        f"Printed: {conversion.printed}" if conversion.printed else "",
        f"Signals: {', '.join(conversion.signals)}." if conversion.signals else "",
        f"Reference: {', '.join(conversion.references)}." if conversion.references else "",
    ]
    low, high = bounds(device, conversion)
    part = "(1.0 - quantity / reference)" if conversion.complement else "quantity / reference"
    # Beyond 53 bits a double has no halves: there the bound itself is the last number that fits.
    least = f"count >= {low}.0" if -low > 2**52 else f"count > {2 * low - 1}.0 / 2.0"
    most = f"count < {high + 1}.0" if high > 2**52 else f"count < {2 * high + 1}.0 / 2.0"
    return [
        *told(conversion, *about),
        f"static inline double {naming.function('conversion', conversion.name, 'from_raw')}"
        f"({kind} raw, double reference)",
        "{",
        f"    return reference * {f'(1.0 - {share})' if conversion.complement else f'({share})'};",
        "}",
        "",
        *comment(
            "The count of a quantity, the nearest one, of two equally near ones the even one;",
            f"refused where it is not in {low}..{high}, and where the reference is 0.",
        ),
        f"static inline {naming.own('codec_status')} {naming.function('conversion', conversion.name, 'to_raw')}"
        f"(double quantity, double reference, {kind} *raw)",
        "{",
        *indented(_inverse(naming, part, full, least, most, kind, conversion)),
        "}",
    ]


def _inverse(
    naming: Naming, part: str, full: str, least: str, most: str, kind: str, conversion: Conversion
) -> list[str]:
    refused = f"    return {naming.own_macro('err_out_of_range')};"
    one = integer(1, conversion.type.size, conversion.type.signed)
    two = integer(2, conversion.type.size, conversion.type.signed)
    odd = f"whole % {two} != {integer(0, conversion.type.size, conversion.type.signed)}"
    lines = [
        "double count, rest;",
        f"{kind} whole;",
        "if (!(reference < 0.0 || reference > 0.0)) {",
        refused,
        "}",
        f"count = {part} * {full};",
        f"if (!({least} && {most})) {{",
        refused,
        "}",
        f"whole = ({kind})count;",
        "rest = count - (double)whole;",
        f"if (rest > 0.5 || (rest >= 0.5 && {odd})) {{",
        f"    whole = ({kind})(whole + {one});",
    ]
    if conversion.type.signed:
        lines += [
            f"}} else if (rest < -0.5 || (rest <= -0.5 && {odd})) {{",
            f"    whole = ({kind})(whole - {one});",
        ]
    return [*lines, "}", "*raw = whole;", f"return {naming.own_macro('ok')};"]
