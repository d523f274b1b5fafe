"""A program that proves a header: constants, the place of every field, values at their bounds, every example."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from fieldspec.backends.c.assertions import assigned, compared, same
from fieldspec.backends.c.decided import Decided, every
from fieldspec.backends.c.enums import coded
from fieldspec.backends.c.expected import field_value, high_value, record_bytes, record_value
from fieldspec.backends.c.fields import members
from fieldspec.backends.c.naming import Naming, member
from fieldspec.backends.c.proofs_of_constants import constants
from fieldspec.backends.c.proofs_of_examples import example_lines
from fieldspec.backends.c.proofs_of_values import conversions, values_at_bounds
from fieldspec.backends.c.text import array, indented, integer, plain, string
from fieldspec.backends.forms import filled
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.record import RecordLayout


def program(layout: DeviceLayout, naming: Naming, header: str) -> str:
    """The text of the program. It prints each failure, then a count, and exits with 0 where all is well."""
    tests = [*constants(layout, naming), *_fields(layout, naming), *values_at_bounds(layout, naming)]
    tests += [*conversions(layout, naming)]
    tests += [example_lines(layout, naming, example) for example in layout.device.examples.values()]
    switches = f"#define {naming.own_macro('with_texts')}\n" if coded(layout.device) else ""
    return filled(
        "backends/c/selftest.c.in",
        header=header,
        title=plain(f"{layout.device.name}, version {layout.device.version}"),
        identity=layout.identity,
        selftest=naming.own("selftest"),
        switches=switches,
        tests=[_function(f"test_{at}", lines) for at, lines in enumerate(tests)],
        calls=[f"    test_{at}();\n" for at in range(len(tests))],
    )


def _function(name: str, lines: list[str]) -> str:
    return "\n".join(["", f"static void {name}(void)", "{", *indented("\n".join(lines).split("\n")), "}", ""])


def _records(layout: DeviceLayout) -> Iterator[RecordLayout]:
    yield from layout.records.values()
    for message in layout.messages.values():
        yield from (message.request, message.response)


def _fields(layout: DeviceLayout, naming: Naming) -> Iterator[list[str]]:
    """Each member of each record at its highest while all others are low: the bytes show where it lies."""
    for record in _records(layout):
        for form, selecting in every(record):
            for field in members(form.record):
                values = {**record_value(layout.device, form.record), **selecting}
                if field.name not in selecting:
                    values[field.name] = field_value(layout.device, field, high_value)
                what = ".".join([record.name, *([form.case] if form.case else []), field.name])
                yield _round(naming, form, values, record_bytes(form.record, values), what)
        if record.selector in members(record):
            yield from _unchosen(naming, record)


def _round(naming: Naming, form: Decided, values: dict[str, Any], data: bytes, what: str) -> list[str]:
    """Encodes values and compares bytes, decodes the bytes and encodes again."""
    name = form.struct.name
    encode, decode = naming.function("record", name, "encode"), naming.function("record", name, "decode")
    ok = naming.own_macro("ok")
    last = form.record.fields[-1]
    cut = f"expect({decode}(wanted, sizeof wanted - 1, &out) != {ok}, {string(what + ' cut')});"
    return [
        f"static const uint8_t wanted[] = {{{array(data)}}};",
        f"uint8_t bytes[{naming.macro('record', name, 'size')}];",
        f"{naming.type('record', name)} in, out;",
        "size_t length = 0;",
        "clear(bytes, sizeof bytes);",
        "clear(&in, sizeof in);",
        "clear(&out, sizeof out);",
        *assigned(naming, form, values, "in."),
        "copy(&in, &in, sizeof in);",
        same(f"{what} encodes", f"{encode}(&in, bytes, sizeof bytes, &length)", ok),
        f"expect(length == sizeof wanted && same_bytes(bytes, wanted, length), {string(what + ' bytes')});",
        same(f"{what} decodes", f"{decode}(bytes, length, &out)", ok),
        *compared(naming, form, values, "out.", what),
        same(f"{what} short", f"{encode}(&in, bytes, sizeof wanted - 1, &length)", naming.own_macro("err_capacity")),
        *([cut] if last.count is not None or last.size > 1 else []),
    ]


def _unchosen(naming: Naming, record: RecordLayout) -> Iterator[list[str]]:
    """A value of the selector for which nothing may follow is refused."""
    by = record.selector
    assert by is not None
    assert by.value is not None
    kind = by.value.type
    number = next((n for n in range(kind.high, kind.high - len(record.chosen) - 1, -1) if n not in record.chosen), None)
    if number is None:
        return
    name, literal = record.name, integer(number, kind.size, kind.signed)
    encode, decode = naming.function("record", name, "encode"), naming.function("record", name, "decode")
    refused = naming.own_macro("err_unknown_value")
    wanted = bytearray(record.least)
    wanted[by.offset : by.offset + by.size] = b"\xff" * by.size
    lines = [
        f"uint8_t bytes[{naming.macro('record', name, 'size')}];",
        f"{naming.type('record', name)} in;",
        "size_t length = 0;",
        "clear(&in, sizeof in);",
        f"in.{member(by.name)} = {literal};",
        same(f"{name} chooses nothing", f"{encode}(&in, bytes, sizeof bytes, &length)", refused),
    ]
    if not kind.signed and number == kind.high:
        lines.insert(0, f"static const uint8_t unknown[] = {{{array(bytes(wanted))}}};")
        lines.append(same(f"{name} chooses nothing", f"{decode}(unknown, sizeof unknown, &in)", refused))
    yield lines
