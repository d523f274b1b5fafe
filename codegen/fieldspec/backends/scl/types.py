"""PLC data types: images of what lies on the wire, and structs of values."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.scl.project import Project
from fieldspec.plc.layout.fitting import direct
from fieldspec.plc.layout.placing import Placed
from fieldspec.plc.routines.written import comment, plain, type_text
from fieldspec.plc.structs import Struct


def types(held: Project) -> Iterator[list[str]]:
    """All types, each behind those that it uses."""
    declared = held.declared
    for image in declared.images:
        yield _image(held, declared.placed(image))
    for struct in declared.structs:
        yield _values(held, struct)
    if held.texts:
        yield _texts(held)


def _image(held: Project, placed: Placed) -> list[str]:
    struct = placed.struct
    about = [
        f"{struct.title}. As on the wire: {placed.size} bytes in a block with standard access.",
        "Each member begins with its byte and bit.",
    ]
    members = []
    for one in placed.members:
        swapped = "" if direct(placed, one) else " Bytes are in another order than the PLC reads them."
        place = f"{one.at}.{one.bit or 0}"
        members.append((one.member.name, _type(held, one.member.type), f"{place} {one.member.remark}{swapped}"))
    return _type_lines(held, struct.name, about, members)


def _values(held: Project, struct: Struct) -> list[str]:
    about = [f"{struct.title}. Values, for blocks with optimized access; functions convert them from and to the wire."]
    return _type_lines(
        held, struct.name, about, [(one.name, _type(held, one.type), one.remark) for one in struct.members]
    )


def _texts(held: Project) -> list[str]:
    members = [
        ("code", held.code_type.name, "number of the code"),
        ("text", f"STRING[{held.text_length}]", "what it means"),
    ]
    return _type_lines(held, held.text_type, ["A code and its text."], members)


def _type(held: Project, kind: object) -> str:
    return type_text(kind, held.declared.dialect.spelling)  # type: ignore[arg-type]


def _type_lines(held: Project, name: str, about: list[str], members: list[tuple[str, str, str]]) -> list[str]:
    lines = [line for text in about for line in comment(text)]
    lines += [f'TYPE "{name}"', "VERSION : 0.1", "   STRUCT"]
    for member, kind, remark in members:
        beside = f"   {held.declared.dialect.comment.format(plain(remark))}" if plain(remark) else ""
        lines.append(f"      {member} : {kind};{beside}")
    return [*lines, "   END_STRUCT;", "", "END_TYPE"]
