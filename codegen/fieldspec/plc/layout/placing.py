"""The place of every member of a struct in a model of memory."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.classes import dataclass
from fieldspec.plc.layout.memory import Memory
from fieldspec.plc.routines.types import ArrayType, Elementary, EnumType, StructType, Type
from fieldspec.plc.structs import Member, Struct


@dataclass(frozen=True, slots=True)
class PlacedMember:
    """A member `at` bytes behind the begin of its struct; of a BOOL that shares its byte, `bit` is the bit in it.

    `size` is that of one element in bytes, 0 for a bit; there are `count`, `stride` bytes apart. `inner` is the struct
    that an element is, if it is one. `listed` says that it is an array.
    """

    member: Member
    at: int
    bit: int | None
    size: int
    count: int
    stride: int
    inner: Placed | None
    listed: bool

    @property
    def end(self) -> int:
        """The byte behind it."""
        return self.at + (self.count - 1) * self.stride + max(self.size, 1)


@dataclass(frozen=True, slots=True)
class Placed:
    """A struct of `size` bytes in a model of memory. It begins at a multiple of `alignment`."""

    struct: Struct
    memory: Memory
    members: tuple[PlacedMember, ...]
    size: int
    alignment: int

    def rows(self, before: str = "", at: int = 0, bits: bool = True) -> Iterator[tuple[str, int, PlacedMember]]:
        """All members by their paths, with their places behind the begin; inner ones behind what holds them.

        Those of words of bits are left out unless `bits` is true.
        """
        for one in self.members:
            path = f"{before}{one.member.name}"
            yield path, at + one.at, one
            if one.inner is not None and (bits or one.inner.struct.kind != "bits"):
                path += "[]" if one.listed else ""
                yield from one.inner.rows(f"{path}.", at + one.at, bits)

    def gaps(self) -> Iterator[tuple[int, int]]:
        """The bytes that are filled up: the first one and how many."""
        end = 0
        for one in self.members:
            if one.at > end:
                yield end, one.at - end
            end = max(end, one.end)
        if self.size > end:
            yield end, self.size - end


def placed(struct: Struct, memory: Memory, structs: Mapping[str, Struct]) -> Placed:
    """A struct in a model of memory. `structs` has those that lie in it by name."""
    at, alignment = 0, memory.composite
    bit: int | None = None
    members: list[PlacedMember] = []
    for member in struct.members:
        if memory.bits and isinstance(member.type, Elementary) and member.type.family == "truth":
            at, bit = (at, 0) if bit is None else (at, bit + 1) if bit < 7 else (at + 1, 0)
            members.append(PlacedMember(member, at, bit, 0, 1, 0, None, listed=False))
            continue
        if bit is not None:
            at, bit = at + 1, None
        made = _placed(member, memory, structs)
        of = _alignment(member.type, memory, structs)
        at, alignment = memory.aligned(at, of), max(alignment, of)
        members.append(PlacedMember(member, at, None, made.size, made.count, made.stride, made.inner, made.listed))
        at += _size(member.type, memory, structs)
    end = at if bit is None else at + 1
    return Placed(struct, memory, tuple(members), memory.aligned(end, max(alignment, memory.even)), alignment)


def _placed(member: Member, memory: Memory, structs: Mapping[str, Struct]) -> PlacedMember:
    listed = isinstance(member.type, ArrayType)
    count, kind = 1, member.type
    if isinstance(kind, ArrayType):
        count, kind = kind.high - kind.low + 1, kind.of
    inner = placed(structs[kind.name], memory, structs) if isinstance(kind, StructType) else None
    size = _size(kind, memory, structs)
    return PlacedMember(
        member, 0, None, size, count, memory.aligned(size, _alignment(kind, memory, structs)), inner, listed
    )


def _alignment(kind: Type, memory: Memory, structs: Mapping[str, Struct]) -> int:
    match kind:
        case Elementary():
            return min(kind.size, memory.pack)
        case EnumType():
            return _alignment(kind.base, memory, structs)
        case ArrayType():
            return max(_alignment(kind.of, memory, structs), memory.composite)
        case StructType():
            return placed(structs[kind.name], memory, structs).alignment


def _size(kind: Type, memory: Memory, structs: Mapping[str, Struct]) -> int:
    match kind:
        case Elementary():
            return kind.size
        case EnumType():
            return kind.base.size
        case StructType():
            return placed(structs[kind.name], memory, structs).size
        case ArrayType():
            count = kind.high - kind.low + 1
            if memory.bits and isinstance(kind.of, Elementary) and kind.of.family == "truth":
                return memory.aligned(-(-count // 8), memory.even)
            one = _size(kind.of, memory, structs)
            step = memory.aligned(one, _alignment(kind.of, memory, structs))
            return memory.aligned(step * count, memory.even)
