"""Statements of self-tests: what is expected, and members of structs that are set and compared."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from typing import Any

from fieldspec.backends.c.decided import Decided, of_values
from fieldspec.backends.c.fields import members
from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.text import hexadecimal, integer, string
from fieldspec.layout.record import FieldLayout
from fieldspec.model.value import Kind


def same(what: str, left: str, right: str) -> str:
    """Two expressions are equal."""
    return f"expect({left} == {right}, {string(what)});"


def same_bytes(what: str, target: str, data: bytes) -> str:
    """Some bytes of memory are these."""
    return f"expect(same_bytes({target}, {_bytes_literal(data)}, {len(data)}u), {string(what)});"


def _bytes_literal(data: bytes) -> str:
    return '"' + "".join(f"\\{byte:03o}" for byte in data) + '"'


def assigned(naming: Naming, record: Decided, values: Mapping[str, Any], holder: str) -> list[str]:
    """Statements that give the members their values."""
    lines = []
    for field in members(record.record):
        name = f"{holder}{record.path(field)}"
        held = values[field.name]
        if field.field.repeat is not None:
            lines.append(f"{holder}{record.count(field)} = {len(held)}u;")
        for target, item in _items(field, name, held):
            if field.record is not None:
                lines += assigned(naming, of_values(field.record, item), item, f"{target}.")
            else:
                lines += _assign(naming, field, target, item)
    return lines


def compared(naming: Naming, record: Decided, values: Mapping[str, Any], holder: str, what: str) -> list[str]:
    """Statements that compare members with values; members that have none are left out."""
    lines = []
    for field in members(record.record):
        if field.name not in values:
            continue
        name = f"{holder}{record.path(field)}"
        held = values[field.name]
        if field.field.repeat is not None:
            lines.append(same(f"{what}: {field.name} count", f"{holder}{record.count(field)}", f"{len(held)}u"))
        for target, item in _items(field, name, held):
            if field.record is not None:
                lines += compared(naming, of_values(field.record, item), item, f"{target}.", what)
            else:
                lines += _compare(naming, field, target, item, f"{what}: {field.name}")
    return lines


def _items(field: FieldLayout, name: str, held: Any) -> list[tuple[str, Any]]:
    return [(f"{name}[{at}]", item) for at, item in enumerate(held)] if field.is_list else [(name, held)]


def _assign(naming: Naming, field: FieldLayout, target: str, held: Any) -> list[str]:
    if field.primitive.kind in (Kind.TEXT, Kind.BYTES):
        data = _data(held)
        return [f"copy({target}, {_bytes_literal(data)}, {len(data)}u);"] if data else []
    if field.primitive.kind is Kind.FLOAT:
        return [f"{target} = {naming.own('float_of')}({_float_bits(held)});"]
    return [f"{target} = {_literal(field, held)};"]


def _compare(naming: Naming, field: FieldLayout, target: str, held: Any, what: str) -> list[str]:
    if field.primitive.kind in (Kind.TEXT, Kind.BYTES):
        data = _data(held)
        return [same_bytes(what, target, data)] if data else []
    if field.primitive.kind is Kind.FLOAT:
        return [same(what, f"{naming.own('bits_of')}({target})", _float_bits(held))]
    return [same(what, target, _literal(field, held))]


def _data(held: Any) -> bytes:
    return held.encode("ascii") if isinstance(held, str) else bytes(held)


def _float_bits(held: Any) -> str:
    return hexadecimal(int.from_bytes(struct.pack(">f", held), "big"), 4)


def _literal(field: FieldLayout, held: Any) -> str:
    if field.primitive.kind is Kind.BOOLEAN:
        return "true" if held else "false"
    return integer(int(held), field.primitive.size, field.primitive.signed)
