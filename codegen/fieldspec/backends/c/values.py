"""Single values in C: their types, how they are loaded and stored, and what is refused."""

from __future__ import annotations

from fieldspec.backends.c.machine import cleared, copied
from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.text import integer
from fieldspec.classes import dataclass
from fieldspec.model.value import Kind, Value

_TYPES = {
    "u8": "uint8_t",
    "i8": "int8_t",
    "u16": "uint16_t",
    "i16": "int16_t",
    "u32": "uint32_t",
    "i32": "int32_t",
    "u64": "uint64_t",
    "i64": "int64_t",
    "f32": "float",
    "bool8": "bool",
    "bool16": "bool",
}


@dataclass(frozen=True, slots=True)
class Wire:
    """A value and the order of its bytes."""

    value: Value
    order: str
    swapped: bool

    @property
    def kind(self) -> Kind:
        """What it holds."""
        return self.value.type.kind

    @property
    def size(self) -> int:
        """Its bytes."""
        return self.value.size


def declaration(wire: Wire, name: str, count: int | None) -> str:
    """The member of a struct, or the variable, that holds a value."""
    times = f"[{count}]" if count is not None else ""
    if wire.kind is Kind.TEXT:
        return f"char {name}{times}[{wire.size + 1}]"
    if wire.kind is Kind.BYTES:
        return f"uint8_t {name}{times}[{wire.size}]"
    return f"{_TYPES[wire.value.type.name]} {name}{times}"


def shifts(size: int, order: str, swapped: bool) -> list[int]:
    """By how many bits each byte is shifted, the byte at the lowest address first."""
    steps = [8 * at for at in range(size)]
    if (order == "big") != swapped:
        steps.reverse()
    if not swapped:
        return steps
    return [steps[at ^ 1] for at in range(size)]


def access_name(size: int, order: str, swapped: bool) -> str:
    """What the functions that load and store such a number are called: `u32_be`, `u32_be_words_le`."""
    if size == 1:
        return "u8"
    first = "be" if order == "big" else "le"
    second = ("_words_le" if order == "big" else "_words_be") if swapped else ""
    return f"u{8 * size}_{first}{second}"


def access_functions(naming: Naming, size: int, order: str, swapped: bool) -> list[str]:
    """The functions that load and store an unsigned number: right whatever the order of the machine."""
    kind, wide = f"uint{8 * size}_t", "uint64_t" if size == 8 else "uint32_t"
    name, inline = access_name(size, order, swapped), naming.own_macro("inline")
    load, store = naming.own("load", name), naming.own("store", name)
    if size == 1:
        return [
            *(f"{inline} {kind} {load}(const uint8_t *in)", "{", "    return in[0];", "}", ""),
            *(f"{inline} void {store}(uint8_t *out, {kind} value)", "{", "    out[0] = value;", "}"),
        ]
    steps = shifts(size, order, swapped)
    parts = [f"({wide})in[{at}]" + (f" << {step}" if step else "") for at, step in enumerate(steps)]
    return [
        f"{inline} {kind} {load}(const uint8_t *in)",
        "{",
        *_returned(kind, wide, parts),
        "}",
        "",
        f"{inline} void {store}(uint8_t *out, {kind} value)",
        "{",
        *_stored(naming, size, steps),
        "}",
    ]


def _returned(kind: str, wide: str, parts: list[str]) -> list[str]:
    """The statement that joins the bytes, two of them on a line where there are more."""
    rows = [
        " | ".join(part if "<<" not in part else f"({part})" for part in parts[at : at + 2])
        for at in range(0, len(parts), 2)
    ]
    if kind != wide:
        return [f"    return ({kind})({rows[0]});"]
    return [f"    return {rows[0]} |", *(f"           {row} |" for row in rows[1:-1]), f"           {rows[-1]};"]


def _stored(naming: Naming, size: int, steps: list[int]) -> list[str]:
    """The statements that store a number: at once where the machine may and its bytes lie in one order."""
    single = [f"    out[{at}] = (uint8_t){f'(value >> {step})' if step else 'value'};" for at, step in enumerate(steps)]
    if steps not in (sorted(steps), sorted(steps, reverse=True)):
        return single
    turned = [f"    value = __builtin_bswap{8 * size}(value);"] if steps[0] else []
    return [
        f"#ifdef {naming.own_macro('stores_at_once')}",
        *turned,
        f"    {copied(naming, 'out', '&value', 'sizeof value')}",
        "#else",
        *single,
        "#endif",
    ]


def load(naming: Naming, wire: Wire, source: str) -> str:
    """An expression for the number at `source`, an expression for a pointer to its first byte."""
    call = f"{naming.own('load', access_name(wire.size, wire.order, wire.swapped))}({source})"
    if wire.value.type.signed and wire.kind is Kind.INTEGER:
        return f"{naming.own('signed', str(8 * wire.size))}({call})"
    return call


def signed_functions(naming: Naming) -> list[str]:
    """Two's complement without conversions that the standard leaves to the compiler."""
    lines: list[str] = []
    for bits, wide in ((8, "int32_t"), (16, "int32_t"), (32, "int32_t"), (64, "int64_t")):
        kind = f"uint{bits}_t"
        top = f"UINT64_C(0x{1 << (bits - 1):X})" if bits == 64 else f"0x{1 << (bits - 1):X}u"
        lines += [
            f"{naming.own_macro('inline')} int{bits}_t {naming.own('signed', str(bits))}({kind} raw)",
            "{",
            f"    return (int{bits}_t)((raw & {top}) ? -({wide})({kind})~raw - 1 : ({wide})raw);",
            "}",
            "",
        ]
    return lines[:-1]


def range_test(value: Value, name: str) -> str:
    """A condition under which an integer may not be written; empty where every value of its type is in it.

    Bounds that are those of the type are left out: compilers warn of comparisons that are always true.
    """
    ranges = value.writable_ranges
    if ranges is None:
        return ""
    kind = value.type
    parts = []
    for low, high in sorted(ranges.intervals):
        low_text, high_text = integer(low, value.size, kind.signed), integer(high, value.size, kind.signed)
        if low == high:
            parts.append(f"{name} == {low_text}")
            continue
        bounds = []
        if low > kind.low:
            bounds.append(f"{name} >= {low_text}")
        if high < kind.high:
            bounds.append(f"{name} <= {high_text}")
        if not bounds:
            return ""
        parts.append(" && ".join(bounds))
    parts += [
        f"{name} == {integer(sentinel.value, value.size, kind.signed)}"
        for sentinel in value.sentinels
        if sentinel.value not in ranges
    ]
    return "!(" + " || ".join(parts if len(parts) == 1 else [f"({part})" for part in parts]) + ")"


def float_test(value: Value, name: str) -> str:
    """A condition under which a floating-point number is out of range; no comparison holds of a NaN."""
    if value.ranges is None:
        return ""
    pairs = [*value.ranges.intervals, *((one.value, one.value) for one in value.sentinels if not one.is_nan)]
    if value.absent_nan:
        return " && ".join(f"({name} < {low}.0f || {name} > {high}.0f)" for low, high in sorted(pairs))
    parts = [f"({name} >= {low}.0f && {name} <= {high}.0f)" for low, high in sorted(pairs)]
    return f"!({' || '.join(parts)})" if len(parts) > 1 else f"!{parts[0]}"


def load_lines(naming: Naming, wire: Wire, source: str, target: str) -> list[str]:
    """Statements that move the value at `source` to `target` without a look at it."""
    if wire.kind is Kind.TEXT:
        return [copied(naming, target, source, f"{wire.size}u"), f"{target}[{wire.size}] = '\\0';"]
    if wire.kind is Kind.BYTES:
        return [copied(naming, target, source, f"{wire.size}u")]
    if wire.kind is Kind.FLOAT:
        return [f"{target} = {naming.own('float_of')}({load(naming, wire, source)});"]
    if wire.kind is Kind.BOOLEAN:
        return [f"{target} = {load(naming, wire, source)} != 0;"]
    return [f"{target} = {load(naming, wire, source)};"]


def found_tests(naming: Naming, wire: Wire, source: str, closed: str) -> list[str]:
    """Statements that return where the value at `source`, which has been loaded, is refused."""
    if wire.value.const is not None:
        return const_test(naming, wire, source)
    if wire.kind is Kind.TEXT:
        return refused(naming, f"!{naming.own('is_ascii')}({source}, {wire.size}u)", "err_unknown_value")
    if wire.kind is Kind.BOOLEAN:
        return refused(naming, f"{load(naming, wire, source)} > 1u", "err_unknown_value")
    return refused(naming, closed, "err_unknown_value") if closed else []


def decode_lines(naming: Naming, wire: Wire, source: str, target: str, closed: str) -> list[str]:
    """Statements that read the value at `source` into `target`, and return where it is refused.

    `closed` is the condition under which a closed enum refuses the value, over the name `target`, or empty.
    """
    if wire.value.const is not None:
        return const_test(naming, wire, source)
    return [*load_lines(naming, wire, source, target), *found_tests(naming, wire, source, closed)]


def refused(naming: Naming, test: str, error: str) -> list[str]:
    """Statements that return an error where a condition holds."""
    return [f"if ({test}) {{", f"    return {naming.own_macro(error)};", "}"]


def const_test(naming: Naming, wire: Wire, source: str) -> list[str]:
    """Statements that refuse another value than the constant at `source`."""
    assert wire.value.const is not None
    wanted = integer(wire.value.const, wire.size, wire.value.type.signed)
    return refused(naming, f"{load(naming, wire, source)} != {wanted}", "err_wrong_const")


def given_tests(naming: Naming, wire: Wire, source: str, closed: str) -> list[str]:
    """Statements that return where the value `source`, which is to be written, is refused."""
    if wire.kind is Kind.TEXT:
        return refused(naming, f"!{naming.own('is_text')}({source}, {wire.size}u)", "err_unknown_value")
    if wire.kind is Kind.FLOAT:
        test = float_test(wire.value, source)
        return refused(naming, test, "err_out_of_range") if test else []
    if wire.kind is not Kind.INTEGER:
        return []
    lines = refused(naming, closed, "err_unknown_value") if closed else []
    test = range_test(wire.value, source)
    return [*lines, *refused(naming, test, "err_out_of_range")] if test else lines


def store_lines(naming: Naming, wire: Wire, source: str, target: str) -> list[str]:
    """Statements that write the value `source` at `target` without a look at it."""
    if wire.kind is Kind.TEXT:
        return [f"{naming.own('put_text')}({target}, {source}, {wire.size}u);"]
    if wire.kind is Kind.BYTES:
        return [copied(naming, target, source, f"{wire.size}u")]
    store = naming.own("store", access_name(wire.size, wire.order, wire.swapped))
    if wire.kind is Kind.FLOAT:
        return [f"{store}({target}, {naming.own('bits_of')}({source}));"]
    number = f"uint{8 * wire.size}_t"
    if wire.kind is Kind.BOOLEAN:
        return [f"{store}({target}, ({number})({source} ? 1 : 0));"]
    cast = f"({number})" if wire.value.type.signed else ""
    return [f"{store}({target}, {cast}{source});"]


def encode_lines(naming: Naming, wire: Wire, source: str, target: str, closed: str) -> list[str]:
    """Statements that check the value `source` and write it at `target`, and return where it is refused."""
    return [*given_tests(naming, wire, source, closed), *store_lines(naming, wire, source, target)]


def fixed_lines(naming: Naming, wire: Wire, number: int, target: str) -> list[str]:
    """Statements that write a number that nobody gives: a constant, or that of a reserved field."""
    if wire.kind in (Kind.TEXT, Kind.BYTES):
        return [cleared(naming, target, f"{wire.size}u")]
    store = naming.own("store", access_name(wire.size, wire.order, wire.swapped))
    raw = number & ((1 << (8 * wire.size)) - 1)
    return [f"{store}({target}, {integer(raw, wire.size, False)});"]
