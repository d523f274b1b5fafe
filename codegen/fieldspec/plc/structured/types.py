"""Enums and structs as text."""

from __future__ import annotations

from fieldspec.plc.enums import EnumDeclaration
from fieldspec.plc.routines.written import comment, plain
from fieldspec.plc.structs import Struct
from fieldspec.plc.structured.item import Item
from fieldspec.plc.structured.literals import type_name

ENUM_ATTRIBUTES = ("qualified_only", "strict")
"""Members are used with the name of their enum, and nothing but members is assigned."""

PACK_MODE = 1


def enum_item(declared: EnumDeclaration) -> Item:
    """A strict enum with its base type."""
    lines = [*comment(declared.title), *(f"{{attribute '{name}'}}" for name in ENUM_ATTRIBUTES)]
    lines += [f"TYPE {declared.name} :", "("]
    for at, member in enumerate(declared.members, 1):
        mark = "," if at < len(declared.members) else ""
        beside = f" // {plain(member.remark)}" if plain(member.remark) else ""
        lines.append(f"    {member.name} := {member.value}{mark}{beside}")
    return Item(declared.name, "type", "enums", (*lines, f") {declared.base.name};", "END_TYPE"))


def struct_item(struct: Struct, size: int) -> Item:
    """A struct of some bytes, without gaps between its members."""
    lines = comment(f"{struct.title} {size} bytes.".strip())
    lines += [f"{{attribute 'pack_mode' := '{PACK_MODE}'}}", f"TYPE {struct.name} :", "STRUCT"]
    for member in struct.members:
        beside = f" // {plain(member.remark)}" if plain(member.remark) else ""
        lines.append(f"    {member.name} : {type_name(member.type)};{beside}")
    if not struct.members:
        lines.append("    byNothing : BYTE; // a struct must have a member")
    return Item(struct.name, "type", "structs", (*lines, "END_STRUCT;", "END_TYPE"))
