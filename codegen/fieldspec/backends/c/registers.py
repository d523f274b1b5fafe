"""Registers and tables of records: constants, and functions for their values and addresses."""

from __future__ import annotations

from fieldspec.backends.c.accessors import ACCESS, access_lines, constant_lines
from fieldspec.backends.c.comments import of_value, told
from fieldspec.backends.c.naming import Naming, Noun
from fieldspec.backends.c.text import comment, hexadecimal, indented
from fieldspec.backends.c.values import Wire
from fieldspec.layout.device import TableLayout
from fieldspec.layout.record import RegisterLayout
from fieldspec.model.device import Device


def register_lines(naming: Naming, device: Device, laid: RegisterLayout) -> list[str]:
    """The constants of a register, and the functions for its value."""
    register, value = laid.register, laid.register.value
    facts = (
        f"In the address space {device.space_name(register.space)}." if device.several_spaces else "",
        ACCESS[register.access],
        "A change takes effect after a restart." if register.restart else "",
        "Writing starts an action." if register.trigger else "",
        f"{laid.words} words must be accessed in one request." if register.atomic and laid.words > 1 else "",
        f"The same as {register.same_as}." if register.same_as else "",
        f"A copy of {register.copy_of}." if register.copy_of else "",
    )
    lines = told(register, " ".join(fact for fact in facts if fact), of_value(value))
    constants = [("address", hexadecimal(laid.address, 2)), ("words", f"{laid.words}u")]
    if register.number is not None:
        constants.append(("number", f"{register.number}u"))
    if laid.count > 1:
        constants += [("count", f"{laid.count}u"), ("stride", f"{laid.stride}u"), ("first", f"{register.index_from}u")]
    lines += _defined(naming, "register", laid.name, constants)
    lines += constant_lines(naming, "register", (laid.name,), value)
    wire = Wire(value, laid.order, laid.swapped)
    size = value.size + value.size % 2
    lines += ["", *access_lines(naming, device, "register", (laid.name,), wire, size, register.trigger)]
    if laid.count > 1:
        lines += ["", *_address(naming, "register", laid.name, f"{laid.name} by its number")]
    return lines


def _defined(naming: Naming, noun: Noun, name: str, constants: list[tuple[str, str]]) -> list[str]:
    return [f"#define {naming.macro(noun, name, constant)} {text}" for constant, text in constants]


def _address(naming: Naming, noun: Noun, name: str, what: str) -> list[str]:
    base, first, count, stride = (naming.macro(noun, name, end) for end in ("address", "first", "count", "stride"))
    return [
        *comment(f"The address of {what}; a number that there is not is refused."),
        f"static inline {naming.own('codec_status')} {naming.function(noun, name, 'at')}"
        "(uint32_t number, uint16_t *address)",
        "{",
        *indented(
            [
                f"if (number - {first} >= {count}) {{",
                f"    return {naming.own_macro('err_out_of_range')};",
                "}",
                f"*address = (uint16_t)({base} + (number - {first}) * {stride});",
                f"return {naming.own_macro('ok')};",
            ]
        ),
        "}",
    ]


def _read_only(laid: TableLayout) -> str:
    """Which fields can only be read, where the table does not say it of all."""
    return f"Read only: {', '.join(laid.read_only)}." if laid.read_only else ""


def table_lines(naming: Naming, device: Device, laid: TableLayout) -> list[str]:
    """The constants of a table, and the function that gives an element's address."""
    table = laid.table
    access = ACCESS[table.access] if table.access else ""
    if device.several_spaces:
        access = f"In the address space {device.space_name(table.space)}. {access}".strip()
    lines = told(table, f"Its elements are {naming.type('record', laid.record.name)}.", access, _read_only(laid))
    constants = [
        ("address", hexadecimal(table.base, 2)),
        ("words", f"{laid.words}u"),
        ("stride", f"{table.stride}u"),
        ("count", f"{table.count}u"),
        ("first", f"{table.index_from}u"),
    ]
    lines += _defined(naming, "table", laid.name, constants)
    return [*lines, "", *_address(naming, "table", laid.name, f"an element of {table.name} by its number")]
