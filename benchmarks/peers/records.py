"""A module of many records as people write it by hand: one file, slotted classes on `struct`, and a base."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

HEAD = """from struct import Struct
from struct import error as StructError

new = object.__new__


class Record:
    __slots__ = ()

    def __eq__(self, other):
        if other.__class__ is not self.__class__:
            return NotImplemented
        return all(getattr(self, name) == getattr(other, name) for name in self.__slots__)

    def __repr__(self):
        shown = ", ".join(f"{name}={getattr(self, name)!r}" for name in self.__slots__)
        return f"{self.__class__.__name__}({shown})"
"""


def module(records: int, fields: Mapping[str, str]) -> str:
    """The text of the module: so many records of the same fields, whose letters for `struct` are given."""
    return "\n".join([HEAD, *(line for number in range(records) for line in _record(number, fields))]) + "\n"


def _record(number: int, fields: Mapping[str, str]) -> Iterator[str]:
    struct = f"STRUCT_{number}"
    yield f'{struct} = Struct(">{"".join(fields.values())}")'
    yield f"class Record{number}(Record):"
    yield f"    __slots__ = ({', '.join(map(repr, fields))})"
    yield f"    def __init__(self, {', '.join(fields)}):"
    yield from (f"        self.{name} = {name}" for name in fields)
    yield "    @classmethod"
    yield "    def decode(cls, data):"
    yield "        record = new(cls)"
    yield "        try:"
    yield f"            ({', '.join(f'record.{name}' for name in fields)}) = {struct}.unpack(data)"
    yield "        except StructError:"
    yield f"            raise ValueError(f'record {number} has no {{len(data)}} bytes') from None"
    yield "        return record"
    yield "    def encode(self):"
    yield "        try:"
    yield f"            return {struct}.pack({', '.join(f'self.{name}' for name in fields)})"
    yield "        except StructError as error:"
    yield f"            raise ValueError(f'record {number}: {{error}}') from None"
