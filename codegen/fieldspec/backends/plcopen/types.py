"""Enums, structs and the types of variables as elements."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.backends.plcopen.elements import Element, element
from fieldspec.plc.enums import EnumDeclaration
from fieldspec.plc.routines.types import ArrayType, Elementary, Type
from fieldspec.plc.routines.written import plain
from fieldspec.plc.structs import Struct
from fieldspec.plc.structured.lists import TextForm
from fieldspec.plc.structured.types import ENUM_ATTRIBUTES, PACK_MODE

ATTRIBUTES = "http://www.3s-software.com/plcopenxml/attributes"
_XHTML = "http://www.w3.org/1999/xhtml"


def type_element(kind: Type) -> Element:
    """A type."""
    if isinstance(kind, ArrayType):
        bounds = element("dimension", lower=str(kind.low), upper=str(kind.high))
        return element("array", bounds, element("baseType", type_element(kind.of)))
    return element(kind.name) if isinstance(kind, Elementary) else element("derived", name=kind.name)


def attributes(*pairs: tuple[str, str]) -> Element:
    """Pragmas, which the schema does not know: as data that CODESYS reads and writes itself."""
    held = (element("Attribute", Name=name, Value=value) for name, value in pairs)
    return element(
        "addData", element("data", element("Attributes", *held), name=ATTRIBUTES, handleUnknown="implementation")
    )


def documentation(lines: Iterable[str]) -> Element:
    """A comment."""
    return element("documentation", element("xhtml", text="\n".join(plain(line) for line in lines), xmlns=_XHTML))


def variable(name: str, kind: Element, initial: Element | None, remark: str) -> Element:
    """A variable or a member."""
    parts = [element("type", kind)]
    if initial is not None:
        parts.append(element("initialValue", initial))
    if plain(remark):
        parts.append(documentation([remark]))
    return element("variable", *parts, name=name)


def _declared(name: str, base: Element, pairs: Iterable[tuple[str, str]], title: str) -> Element:
    parts = [element("baseType", base)]
    given = tuple(pairs)
    if given:
        parts.append(attributes(*given))
    if plain(title):
        parts.append(documentation([title]))
    return element("dataType", *parts, name=name)


def enum_type(declared: EnumDeclaration) -> Element:
    """A strict enum with its base type."""
    values = (element("value", name=one.name, value=str(one.value)) for one in declared.members)
    base = element("baseType", type_element(declared.base))
    held = element("enum", element("values", *values), base)
    remarks = [f"{one.name}: {one.remark}" for one in declared.members if plain(one.remark)]
    made = _declared(declared.name, held, ((name, "") for name in ENUM_ATTRIBUTES), declared.title)
    if not remarks:
        return made
    told = documentation([declared.title, *remarks])
    return element("dataType", *(one for one in made.children if one.name != "documentation"), told, name=declared.name)


def struct_type(struct: Struct, size: int) -> Element:
    """A struct of some bytes, without gaps between its members."""
    members = [variable(one.name, type_element(one.type), None, one.remark) for one in struct.members]
    members = members or [variable("byNothing", element("BYTE"), None, "a struct must have a member")]
    pairs = [("pack_mode", str(PACK_MODE))]
    return _declared(struct.name, element("struct", *members), pairs, f"{struct.title} {size} bytes.".strip())


def text_type(form: TextForm) -> Element:
    """The struct of a code's text."""
    code, text = form.members
    kind = element("wstring" if form.wide else "string", length=str(form.longest))
    members = (variable(code, type_element(form.code), None, ""), variable(text, kind, None, ""))
    return _declared(form.name, element("struct", *members), (), "What a code means.")
