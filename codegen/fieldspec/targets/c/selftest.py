"""A program that proves a header: constants, the place of every field, values at their bounds, every example."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import chain
from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.language.model.encoding import bounds_of
from fieldspec.targets.c.absent import AbsentValue, ranged_values
from fieldspec.targets.c.assertions import (
    LENGTH,
    clear_variable,
    expect,
    expect_equal,
    expect_members,
    same_array,
    set_member,
)
from fieldspec.targets.c.declarations import Function, escape_comment
from fieldspec.targets.c.enums import code_tables
from fieldspec.targets.c.expressions import SIZE_TYPE, Call, Expression, Identifier, SizeOf, Type
from fieldspec.targets.c.fields import members
from fieldspec.targets.c.literals import ZERO, byte_initializer, decimal
from fieldspec.targets.c.lone_values import LoneValue, lone_pieces
from fieldspec.targets.c.machine import literal
from fieldspec.targets.c.naming import Naming, member
from fieldspec.targets.c.printer import Printer
from fieldspec.targets.c.runtime_files import all_records
from fieldspec.targets.c.sample_values import (
    RecordForm,
    all_forms,
    field_sample,
    fitting,
    high_value,
    record_value,
    sample_bytes,
)
from fieldspec.targets.c.selftest_examples import test_example
from fieldspec.targets.c.selftest_quantities import test_absent, test_out_of_range, test_quantities
from fieldspec.targets.c.selftest_values import test_constants, test_conversions, test_value
from fieldspec.targets.c.statements import Statement, Variable, Variables, assign, call
from fieldspec.targets.pieces import facts_of, piece, run_pieces
from fieldspec.targets.templates import fill, text

BYTE = Type("uint8_t")
_BYTES, _WANTED, _IN, _OUT = (Identifier(name) for name in ("bytes", "wanted", "in", "out"))

_IN_POINTER, _OUT_POINTER, _LENGTH_POINTER = _IN.address(), _OUT.address(), LENGTH.address()
_SIZE_OF_BYTES = SizeOf(_BYTES)
_CUT_SIZE = SizeOf(_WANTED) - decimal(1)
_CLEAR = clear_variable(_BYTES), clear_variable(_IN_POINTER), clear_variable(_OUT_POINTER)
_SAME_BYTES = same_array(_BYTES, _WANTED)
_LENGTH_VARIABLE = Variable(SIZE_TYPE, "length", value=ZERO)
_COPY = call("copy", _IN_POINTER, _IN_POINTER, SizeOf(_IN))


def write_selftest(layout: DeviceLayout, naming: Naming, header: str) -> str:
    """The text of the program. It prints each failure, then a count, and exits with 0 where all is well."""
    bodies = chain(
        test_constants(layout, naming),
        _test_records(layout, naming),
    )
    printer = Printer()
    tests = [_print_test(printer, body) for body in bodies]
    tests += _value_tests(layout, naming, printer)
    bodies = chain(
        test_conversions(layout, naming),
        test_quantities(layout, naming),
        (test_example(layout, naming, example) for example in layout.device.examples.values()),
        test_absent(layout, naming),
    )
    tests += [_print_test(printer, body) for body in bodies]
    tests += _range_tests(layout, naming, printer)
    switches = f"#define {naming.own_macro('with_texts')}\n" if code_tables(layout.device) else ""
    return fill(
        "c/selftest.c.j2",
        header=header,
        title=escape_comment(f"{layout.device.name}, version {layout.device.version}"),
        identity=layout.identity,
        selftest=naming.own("selftest"),
        switches=switches,
        support=text("targets/c/runtime/selftest_support.h"),
        tests=[test.replace(f"{_TEST}(", f"test_{number}(", 1) for number, test in enumerate(tests)],
        calls=[f"    test_{number}();\n" for number in range(len(tests))],
    )


_TEST = "test_"
"""Stands for the name of a function until its number is known."""


def _value_tests(layout: DeviceLayout, naming: Naming, printer: Printer) -> Iterator[str]:
    """The function for the value of each register and parameter, where there is something to test."""

    def tests(lone: LoneValue) -> Iterator[str]:
        noun, names, wire, size, trigger = lone
        bodies = test_value(layout.device, naming, noun, names, wire.value, (wire.order, wire.swapped), size, trigger)
        return map(partial(_print_test, printer), bodies)

    return lone_pieces("c test", layout, naming, tests)


def _range_tests(layout: DeviceLayout, naming: Naming, printer: Printer) -> Iterator[str]:
    """The function for the range of each value that may be out of it where it is read."""

    def tests(ranged: AbsentValue) -> tuple[str, ...]:
        facts, words = facts_of(layout.device, ranged.value), (ranged.noun, ranged.names, ranged.trigger)
        bodies = partial(test_out_of_range, layout.device, naming, ranged)
        return piece(
            "c range test", facts, words, lambda: tuple(_print_test(printer, body) for body in bodies()), naming
        )

    return run_pieces("c range tests", ranged_values(layout), (), tests, naming)


def _print_test(printer: Printer, body: list[Statement]) -> str:
    function = Function(Type("void"), _TEST, (), tuple(body), storage="static")
    return "\n".join(["", *printer.print_declarations([function]), ""])


def _test_records(layout: DeviceLayout, naming: Naming) -> Iterator[list[Statement]]:
    """Each member of each record at its highest while all others are low: the bytes show where it lies."""
    for record in all_records(layout):
        for form, selection in all_forms(layout.device, record):
            low_values = {**record_value(layout.device, form.record), **selection}
            fields = members(form.record)
            low_settings = [set_member(naming, form, field, low_values[field.name], _IN) for field in fields]
            for number, field in enumerate(fields):
                values, settings = low_values, low_settings
                if field.name not in selection:
                    value = field_sample(layout.device, field, high_value)
                    values = fitting(layout.device, {**low_values, field.name: value}, form.record, field.name)
                    settings = low_settings.copy()
                    for place, own in enumerate(fields):
                        if values[own.name] != low_values[own.name] or place == number:
                            settings[place] = set_member(naming, form, own, values[own.name], _IN)
                description = ".".join([record.name, *([form.case] if form.case else []), field.name])
                if sample_bytes(form.record, values):  # C has no array of no bytes to compare
                    yield _test_member(naming, form, values, [*chain.from_iterable(settings)], description)
        if record.selector in members(record):
            yield from _test_unknown_selector(naming, record)


def _record_call(naming: Naming, record: RecordLayout, verb: str, *arguments: Expression) -> Call:
    return Call(naming.function("record", record.name, verb), arguments)


def _test_member(
    naming: Naming, form: RecordForm, values: dict[str, Any], settings: list[Statement], description: str
) -> list[Statement]:
    """Encodes values and compares bytes, decodes the bytes and compares members; too few bytes are refused."""
    record = form.struct
    ok = naming.status("ok")
    cut = _record_call(naming, record, "decode", _WANTED, _CUT_SIZE, _OUT_POINTER)
    encoded = _record_call(naming, record, "encode", _IN_POINTER, _BYTES, _SIZE_OF_BYTES, _LENGTH_POINTER)
    decoded = _record_call(naming, record, "decode", _BYTES, LENGTH, _OUT_POINTER)
    short = _record_call(naming, record, "encode", _IN_POINTER, _BYTES, _CUT_SIZE, _LENGTH_POINTER)
    size = Identifier(naming.macro("record", record.name, "size"))
    return [
        Variable(BYTE, "wanted", (None,), byte_initializer(sample_bytes(form.record, values)), "static const"),
        Variable(BYTE, "bytes", (size,)),
        Variables(Type(naming.type("record", record.name)), ("in", "out")),
        _LENGTH_VARIABLE,
        *_CLEAR,
        *settings,
        _COPY,
        expect_equal(f"{description} encodes", encoded, ok),
        expect(_SAME_BYTES, f"{description} bytes"),
        expect_equal(f"{description} decodes", decoded, ok),
        *expect_members(naming, form, values, _OUT, description),
        expect_equal(f"{description} short", short, naming.status("err_capacity")),
        *([expect(cut.differs(ok), f"{description} cut")] if _is_cut_short(form.record) else []),
    ]


def _is_cut_short(record: RecordLayout) -> bool:
    """Whether a record without its last byte is another one, which is refused."""
    last = record.fields[-1]
    if record.spans:
        return record.spans[-1].value is None
    if last.record is not None and last.record.size is None and last.record.least == 1:
        return False  # An element of one byte may be the last one: what is left is a shorter list.
    return last.count is not None or (last.size > 1 and last.packing is None)


def _test_unknown_selector(naming: Naming, record: RecordLayout) -> Iterator[list[Statement]]:
    """A value of the selector that chooses nothing is refused."""
    selector = record.selector
    assert selector is not None
    assert selector.value is not None
    encoding = selector.value.encoding
    minimum, maximum = bounds_of(encoding)
    highest = range(maximum, maximum - len(record.chosen) - 1, -1)
    number = next((number for number in highest if number not in record.chosen), None)
    if number is None:
        return
    unknown_value = naming.status("err_unknown_value")
    encoded = _record_call(naming, record, "encode", _IN_POINTER, _BYTES, _SIZE_OF_BYTES, _LENGTH_POINTER)
    body: list[Statement] = [
        Variable(BYTE, "bytes", (Identifier(naming.macro("record", record.name, "size")),)),
        Variable(Type(naming.type("record", record.name)), "in"),
        Variable(SIZE_TYPE, "length", value=ZERO),
        clear_variable(_IN_POINTER),
        assign(_IN.member(member(selector.name)), literal(encoding, number)),
        expect_equal(f"{record.name} chooses nothing", encoded, unknown_value),
    ]
    if minimum == 0 and number == maximum:
        data = bytearray(record.least)
        data[selector.offset : selector.offset + selector.size] = b"\xff" * selector.size
        unknown = Identifier("unknown")
        decoded = _record_call(naming, record, "decode", unknown, SizeOf(unknown), _IN_POINTER)
        body.insert(0, Variable(BYTE, "unknown", (None,), byte_initializer(bytes(data)), "static const"))
        body.append(expect_equal(f"{record.name} chooses nothing", decoded, unknown_value))
    yield body
