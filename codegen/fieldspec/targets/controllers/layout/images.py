"""Images: structs whose members lie where the fields of a record lie on the wire, without conversion in between."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.names import Name
from fieldspec.language.model.encoding import is_odd
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value
from fieldspec.targets.controllers.statements.expressions import BOOL, BYTE, StructType, Type, sequence
from fieldspec.targets.controllers.structs import (
    Struct,
    StructMember,
    bit_names,
    bit_places,
    bits_remark,
    elements,
    wire_type,
)


class Naming:
    """How images and their members are called: as the spec names their facts, unless a class names them otherwise."""

    def struct(self, key: str, fact: Fact) -> str:
        """The name of an image, or of the bits of a word."""
        return key

    def members(self, key: str, members: Sequence[tuple[str, Fact | None, Type]]) -> list[str]:
        """The names of the members of a struct; a member without a fact takes a name that no fact has."""
        return [name for name, _, _ in members]

    def remark(self, fact: Fact, value: Value | None) -> str:
        """The comment of a member."""
        return ""


class Images:
    """The images of a device's records, each made once. `structs` has them after those that lie in them, by name.

    `packed` says that words of flags are structs of BOOLs, in the order of their bits in memory.
    """

    def __init__(self, layout: DeviceLayout, naming: Naming, packed: bool) -> None:
        self.layout, self.naming, self.packed = layout, naming, packed
        self.structs: dict[str, Struct] = {}
        self._records: dict[str, Struct] = {}
        self._bits: dict[tuple[str, str, bool], Struct] = {}

    def of(self, record: RecordLayout, kind: str, fact: Fact, title: str) -> Struct:
        """The image of a record; a list without an end has its greatest number of elements."""
        if record.name not in self._records:
            kinds = [self._type(field) for field in record.fields]
            typed_fields = zip(record.fields, kinds, strict=True)
            names = self.naming.members(
                record.name, [(field.name, field.field, kind_of) for field, kind_of in typed_fields]
            )
            members = tuple(
                StructMember(
                    name,
                    kind_of,
                    f"{self.naming.remark(field.field, field.value)} {bits_remark(field.value)}".strip(),
                    field.field,
                    field.value,
                    field.offset,
                    0,
                    field.order,
                    field.swapped,
                )
                for field, name, kind_of in zip(record.fields, names, kinds, strict=True)
            )
            struct = Struct(self.naming.struct(record.name, fact), record.name, kind, title, members, record.size, fact)
            self._records[record.name] = self.structs[struct.name] = struct
        return self._records[record.name]

    def _type(self, field: FieldLayout) -> Type:
        if field.record is not None:
            fact = field.record.record
            element: Type = StructType(self.of(field.record, "record", fact, titled(fact)).name)
        else:
            assert field.value is not None
            element = self._of_value(field.value, field.order, field.swapped)
            if field.is_list and is_odd(field.value.encoding):
                return sequence(elements(field) * field.size, BYTE)
        return sequence(elements(field), element) if field.is_list else element

    def _of_value(self, value: Value, order: str, swapped: bool) -> Type:
        # A struct has an even number of bytes where bits share bytes.
        if self.packed and value.flags and value.size % 2 == 0 and not is_odd(value.encoding):
            return StructType(self._of_bits(value, order, swapped).name)
        return wire_type(value)

    def _of_bits(self, value: Value, order: str, swapped: bool) -> Struct:
        key = (value.flags, order, swapped)
        if key not in self._bits:
            flags = self.layout.device.flags[value.flags]
            known: Mapping[int, tuple[str, Fact]] = bit_names(flags)
            places = list(bit_places(value.size, order, swapped))
            facts: list[tuple[str, Fact | None]] = [known.get(bit, (f"reserved_{bit}", None)) for _, _, bit in places]
            bit_members = [(name, fact, BOOL) for name, fact in facts]
            names = self.naming.members(flags.name, bit_members)
            members = tuple(
                StructMember(
                    name,
                    BOOL,
                    f"bit {bit}. {self.naming.remark(fact, None) if fact else ''}".strip(),
                    fact,
                    None,
                    byte,
                    position,
                )
                for name, (_, fact), (byte, position, bit) in zip(names, facts, places, strict=True)
            )
            struct = Struct(
                self.naming.struct(flags.name, flags), flags.name, "bits", titled(flags), members, value.size, flags
            )
            self._bits[key] = self.structs[struct.name] = struct
        return self._bits[key]


def choices(record: RecordLayout) -> Iterator[tuple[str, RecordLayout]]:
    """The record itself, or one for each type that its last field can have, with the values that decide it."""
    if record.selector is None:
        yield "", record
        return
    for case in record.fields[-1].cases:
        for number in sorted(case.numbers):
            yield f"{record.selector.name} = {', '.join(case.case.when)}", record.chosen[number]
            break


def titled(fact: Fact) -> str:
    """The name of a fact as words, and what the manual calls it."""
    title = Name.of(fact.name).title()
    return title if fact.label in ("", title) else f"{title} {fact.label}"
