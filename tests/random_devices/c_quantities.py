"""The cases of the C program that print quantities: by functions, else by the macros of scale and offset."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.encoding import is_real, is_signed
from fieldspec.language.model.value import Conversion, Sentinel, Value
from fieldspec.targets.c.absent import AbsentValue
from fieldspec.targets.c.conversions import count_type
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.quantities import fixed_values, scaled_values
from fieldspec.targets.c.values import type_name
from random_devices.quantities import Measured, StatedValue, measured_values, stated_values

FUNCTIONS = """
static double double_of(const uint8_t *bytes)
{
    uint64_t bits = 0;
    double number;
    int at;
    for (at = 0; at < 8; at++) {
        bits = bits << 8 | bytes[at];
    }
    memcpy(&number, &bits, 8);
    return number;
}

static int64_t whole_of(const uint8_t *bytes)
{
    uint64_t bits = 0;
    int at;
    for (at = 0; at < 8; at++) {
        bits = bits << 8 | bytes[at];
    }
    return (int64_t)bits;
}
"""


class QuantityCases:
    """The cases of a header. `names` are the questions that it answers: `quantity.register.speed`."""

    def __init__(self, layout: DeviceLayout, naming: Naming, header: str) -> None:
        self.layout, self.naming, self.header = layout, naming, header
        self.names: set[str] = set()
        self.with_function = {(row.noun, *row.names) for row in (*fixed_values(layout), *scaled_values(layout))}

    def cases(self) -> Iterator[str]:
        """Statements that each answer one question."""
        for path, measured in measured_values(self.layout):
            has_function = path in self.with_function
            if has_function or path[0] != "record":
                yield self._case("quantity", path, self._quantity(path, measured, has_function))
            if has_function:
                yield self._case("count", path, self._count(path, measured))
        for path, stated in stated_values(self.layout):
            yield self._case("state", path, self._state_of_number(path, stated))
        for conversion in self.layout.device.conversions.values():
            yield self._case("share", ("conversion", conversion.name), self._share(conversion))

    def _case(self, kind: str, path: tuple[str, ...], statements: str) -> str:
        name = ".".join((kind, *path))
        self.names.add(name)
        return f'if (strcmp(name, "{name}") == 0) {{ status = second = 0; {statements} }}'

    def _quantity(self, path: tuple[str, ...], measured: Measured, has_function: bool) -> str:
        value = measured.value
        kind = type_name(value)
        number = "double_of(data)" if is_real(value.encoding) else "whole_of(data)"
        begin = f"double quantity = 0; int refusal = 0; {kind} raw = ({kind}){number};"
        if has_function:
            function = self.naming.function(path[0], *path[1:], "from_raw")  # type: ignore[arg-type]
            quantity = f"refusal = (int){function}(raw, {self._exponent(measured)}&quantity);"
        else:
            quantity = f"quantity = (double)raw; {self._by_macros(path, value)}"
        show = f'if (refusal) {{ printf("!%d", refusal); }} else {{ {_SHOW} }}'
        return f'{begin} {quantity} {show} printf(" "); {self._state(path, value)}'

    def _state_of_number(self, path: tuple[str, ...], stated: StatedValue) -> str:
        """The state of a number, by the functions that the header has for it."""
        value, kind = stated.value, type_name(stated.value)
        number = "double_of(data)" if is_real(value.encoding) else "whole_of(data)"
        begin = f"{kind} raw = ({kind}){number};"
        special = self._state(path, value)
        outside = AbsentValue(path[0], path[1:], value).range_function(self.naming)  # type: ignore[arg-type]
        if f" {outside}(" not in self.header:
            return f"{begin} {special}"
        state = f'printf("%s", {outside}(raw) ? "out_of_range" : "None");'
        return f"{begin} {special.replace(_NO_STATE, state, 1)}"

    def _by_macros(self, path: tuple[str, ...], value: Value) -> str:
        """What users compute of a scale and an offset, where these are not 1 and 0."""
        scale, offset = (self.naming.macro(path[0], *path[1:], name) for name in ("scale", "offset"))  # type: ignore[arg-type]
        missing = "refusal = -1;"
        times = f"quantity = quantity * (double){scale}_NUMERATOR / (double){scale}_DENOMINATOR;"
        plus = f"quantity += (double){offset}_NUMERATOR / (double){offset}_DENOMINATOR;"
        return "".join(
            f"\n#ifdef {macro}_NUMERATOR\n{statement}\n#else\n{missing}\n#endif\n"
            for macro, statement, is_needed in ((scale, times, value.scale != 1), (offset, plus, value.offset != 0))
            if is_needed
        )

    def _state(self, path: tuple[str, ...], value: Value) -> str:
        if not value.sentinels:
            return _NO_STATE
        absent = AbsentValue(path[0], path[1:], value)  # type: ignore[arg-type]
        tests = [f'if ({self._stands_for(absent, own)}) {{ printf("{own.name}"); }}' for own in value.sentinels]
        known = " else ".join((*tests, '{ printf("no_constant"); }'))
        return f"if (!{absent.function(self.naming)}(raw)) {{ {_NO_STATE} }} else {known}"

    def _stands_for(self, absent: AbsentValue, own: Sentinel) -> str:
        constant = absent.constant(self.naming, own)
        if own.is_nan:
            return "raw != raw"
        return f"raw == {constant}" if own.last is None else f"raw >= {constant} && raw <= {constant}_LAST"

    def _exponent(self, measured: Measured) -> str:
        return f"({type_name(measured.exponent.value)})whole_of(data + 8), " if measured.exponent is not None else ""

    def _count(self, path: tuple[str, ...], measured: Measured) -> str:
        kind = type_name(measured.value)
        function = self.naming.function(path[0], *path[1:], "to_raw")  # type: ignore[arg-type]
        call = f"{function}(double_of(data), {self._exponent(measured)}&raw)"
        form = ("lld", "long long") if is_signed(measured.value.encoding) else ("llu", "unsigned long long")
        return f'{kind} raw = 0; status = (int){call}; printf("%{form[0]}", ({form[1]})raw);'

    def _share(self, conversion: Conversion) -> str:
        kind = count_type(conversion)
        function = self.naming.function("conversion", conversion.name, "from_raw")
        quantity = f"double quantity = {function}(({kind})whole_of(data), double_of(data + 8));"
        return f'{quantity} {_SHOW} printf(" None");'


_NO_STATE = 'printf("None");'
_SHOW = 'printf("%.17g", quantity);'
