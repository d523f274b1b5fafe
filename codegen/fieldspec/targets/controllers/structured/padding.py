"""Structs whose members lie, packed, where their fields lie on the wire: what users do not get is padding by name."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.classes import replace
from fieldspec.targets.controllers.declarations import Declarations
from fieldspec.targets.controllers.layout.memory import MEMORIES, placed
from fieldspec.targets.controllers.routines.records import is_user_field
from fieldspec.targets.controllers.statements.expressions import BYTE, sequence
from fieldspec.targets.controllers.structs import Struct, StructMember

PACKED = MEMORIES["tc3:1"]
"""Where nothing is aligned: what pack_mode 1 says."""


def padded(declared: Declarations) -> tuple[Struct, ...]:
    """The structs of a device; structs of records and telegrams have padding."""
    structs: dict[str, Struct] = {}
    for struct in declared.structs:
        record = _record(declared.layout, struct)
        structs[struct.name] = struct if record is None else _filled(struct, record, structs)
    return tuple(structs.values())


def _record(layout: DeviceLayout, struct: Struct) -> RecordLayout | None:
    if struct.kind == "record":
        return layout.records[struct.key]
    data = (record for message in layout.messages.values() for record in message.bodies)
    return next((record for record in data if struct.kind == "telegram" and record.name == struct.key), None)


def _filled(struct: Struct, record: RecordLayout, structs: dict[str, Struct]) -> Struct:
    """The struct with padding where a field is not given, or takes more bytes on the wire than its variable."""
    members = {id(member.fact): member for member in struct.members}
    used_names = {member.name.lower() for member in struct.members}
    filled_members: list[StructMember] = []
    offset = 0
    for field in record.fields:
        size = field.size * (field.count or 1)
        if is_user_field(field):
            member = members[id(field.field)]
            filled_members.append(replace(member, at=field.offset, order=field.order, swapped=field.swapped))
            offset += placed(replace(struct, members=(member,)), PACKED, structs).size
        missing = field.offset + size - offset
        if missing > 0:
            filled_members.append(_padding(missing, field, used_names, offset))
            offset += missing
    return replace(struct, members=tuple(filled_members), size=record.size)


def _padding(size: int, field: FieldLayout, used_names: set[str], offset: int) -> StructMember:
    prefix, number = "by" if size == 1 else "aby", 1
    while f"{prefix}padding{number}" in used_names:
        number += 1
    used_names.add(f"{prefix}padding{number}")
    remark = f"fills up {field.name}" if is_user_field(field) else f"{field.name} on the wire; the functions set it"
    kind = BYTE if size == 1 else sequence(size, BYTE)
    return StructMember(f"{prefix}Padding{number}", kind, remark, None, None, offset)
