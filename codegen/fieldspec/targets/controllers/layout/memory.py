"""Memory models of controllers, and the offset of every struct member."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.foundation.classes import dataclass
from fieldspec.targets.controllers.statements.expressions import ArrayType, Elementary, EnumType, StructType, Type
from fieldspec.targets.controllers.structs import Struct, StructMember


@dataclass(frozen=True, slots=True)
class Memory:
    """A model of memory. A value begins at a multiple of its size, or of `pack` where that is less.

    `order` is that of the bytes of a number. `composite` is the least alignment of arrays and structs in bytes, and
    `even` the multiple to which they are filled up beside their own alignment. `bits` says that BOOLs which follow
    each other share bytes; else each takes one.
    """

    name: str
    title: str
    order: str
    pack: int
    composite: int = 1
    even: int = 1
    bits: bool = False

    def aligned(self, offset: int, to: int) -> int:
        """The least multiple of an alignment that is not less than an offset."""
        return -(-offset // to) * to


MEMORIES = {
    memory.name: memory
    for memory in (
        Memory("s7", "S7-300 to S7-1500, standard access", "big", 2, composite=2, even=2, bits=True),
        *(Memory(f"tc3:{pack}", f"TwinCAT 3 with pack_mode {pack}", "little", pack) for pack in (1, 2, 4, 8)),
        Memory("codesys", "CODESYS without pack_mode", "little", 8),
        Memory("c", "C of a little-endian machine, without packing", "little", 8),
    )
}
"""The models by the names that people give on the command line."""


@dataclass(frozen=True, slots=True)
class PlacedMember:
    """A member `at` bytes after the begin of its struct; of a BOOL that shares its byte, `bit` is the bit in it.

    `size` is that of one element in bytes, 0 for a bit; there are `count`, `stride` bytes apart. `inner` is the struct
    that an element is, if it is one. `is_array` says that the member is an array.
    """

    member: StructMember
    at: int
    bit: int | None
    size: int
    count: int
    stride: int
    inner: Placed | None
    is_array: bool

    @property
    def end(self) -> int:
        """The offset of the first byte after the member."""
        return self.at + (self.count - 1) * self.stride + max(self.size, 1)


@dataclass(frozen=True, slots=True)
class Placed:
    """A struct of `size` bytes in a model of memory. It begins at a multiple of `alignment`."""

    struct: Struct
    memory: Memory
    members: tuple[PlacedMember, ...]
    size: int
    alignment: int

    def rows(self, before: str = "", offset: int = 0, bits: bool = True) -> Iterator[tuple[str, int, PlacedMember]]:
        """All members by their paths, with their places after the begin; inner ones after what holds them.

        Those of words of bits are left out unless `bits` is true.
        """
        for placed_member in self.members:
            path = f"{before}{placed_member.member.name}"
            yield path, offset + placed_member.at, placed_member
            if placed_member.inner is not None and (bits or placed_member.inner.struct.kind != "bits"):
                path += "[]" if placed_member.is_array else ""
                yield from placed_member.inner.rows(f"{path}.", offset + placed_member.at, bits)

    def gaps(self) -> Iterator[tuple[int, int]]:
        """The gaps between members: the offset of the first filling byte of each, and the number of its bytes."""
        end = 0
        for placed_member in self.members:
            if placed_member.at > end:
                yield end, placed_member.at - end
            end = max(end, placed_member.end)
        if self.size > end:
            yield end, self.size - end


def placed(struct: Struct, memory: Memory, structs: Mapping[str, Struct]) -> Placed:
    """A struct in a model of memory. `structs` has those that lie in it by name."""
    offset, alignment = 0, memory.composite
    bit: int | None = None
    members: list[PlacedMember] = []
    for member in struct.members:
        if memory.bits and isinstance(member.type, Elementary) and member.type.family == "truth":
            offset, bit = (offset, 0) if bit is None else (offset, bit + 1) if bit < 7 else (offset + 1, 0)
            members.append(PlacedMember(member, offset, bit, 0, 1, 0, None, is_array=False))
            continue
        if bit is not None:
            offset, bit = offset + 1, None
        sizes = _placed(member, memory, structs)
        member_alignment = _alignment(member.type, memory, structs)
        offset, alignment = memory.aligned(offset, member_alignment), max(alignment, member_alignment)
        members.append(
            PlacedMember(member, offset, None, sizes.size, sizes.count, sizes.stride, sizes.inner, sizes.is_array)
        )
        offset += _size(member.type, memory, structs)
    end = offset if bit is None else offset + 1
    return Placed(struct, memory, tuple(members), memory.aligned(end, max(alignment, memory.even)), alignment)


def _placed(member: StructMember, memory: Memory, structs: Mapping[str, Struct]) -> PlacedMember:
    is_array = isinstance(member.type, ArrayType)
    count, kind = 1, member.type
    if isinstance(kind, ArrayType):
        count, kind = kind.high - kind.low + 1, kind.of
    inner = placed(structs[kind.name], memory, structs) if isinstance(kind, StructType) else None
    size = _size(kind, memory, structs)
    return PlacedMember(
        member, 0, None, size, count, memory.aligned(size, _alignment(kind, memory, structs)), inner, is_array
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
            size = _size(kind.of, memory, structs)
            step = memory.aligned(size, _alignment(kind.of, memory, structs))
            return memory.aligned(step * count, memory.even)
