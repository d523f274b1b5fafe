"""PLCopen XML elements: types, variables, functions and lists of constants."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from decimal import Decimal
from html import escape

from fieldspec.foundation.classes import dataclass
from fieldspec.targets.controllers.constants import ConstantList
from fieldspec.targets.controllers.dialects import Spelling
from fieldspec.targets.controllers.enums import EnumDeclaration, TextTable
from fieldspec.targets.controllers.literals import initial, string
from fieldspec.targets.controllers.routines.printer import array_name, comment_text
from fieldspec.targets.controllers.statements.expressions import BOOL, ArrayType, Elementary, EnumType, StructType, Type
from fieldspec.targets.controllers.statements.routine import Declared, Routine
from fieldspec.targets.controllers.structs import Struct
from fieldspec.targets.controllers.structured.objects import (
    ENUM_ATTRIBUTES,
    LIST_ATTRIBUTES,
    PACK_MODE,
    Item,
    TextForm,
)
from fieldspec.targets.controllers.structured.program import Program


@dataclass(frozen=True, slots=True)
class Element:
    """An element: its name, its attributes, and either elements or text in it."""

    name: str
    attributes: tuple[tuple[str, str], ...] = ()
    children: tuple[Element, ...] = ()
    text: str = ""


def element(tag: str, /, *children: Element, text: str = "", **attributes: str) -> Element:
    """An XML element with its attributes and its children."""
    return Element(tag, tuple(attributes.items()), children, text)


def document_text(root: Element) -> str:
    """The text of a whole PLCopen document."""
    lines = ['<?xml version="1.0" encoding="utf-8"?>']
    _write(root, "", lines)
    return "\n".join(lines) + "\n"


def _write(node: Element, indent: str, lines: list[str]) -> None:
    """Adds the lines of an element; a variable stands in one, as in a declaration."""
    if node.name == "variable" or not node.children:
        lines.append(indent + _in_line(node))
        return
    lines.append(f"{indent}<{_head(node)}>")
    for child in node.children:
        _write(child, indent + " ", lines)
    lines.append(f"{indent}</{node.name}>")


def _in_line(node: Element) -> str:
    content = escape(_legal(node.text), quote=False) or "".join(map(_in_line, node.children))
    return f"<{_head(node)}>{content}</{node.name}>" if content else f"<{_head(node)}/>"


def _head(node: Element) -> str:
    return node.name + "".join([f" {name}={_quoted(value)}" for name, value in node.attributes])


def _quoted(value: str) -> str:
    """The value of an attribute in quotation marks that it does not contain."""
    text = escape(_legal(value), quote=False).replace("\n", "&#10;").replace("\t", "&#9;")
    if '"' not in text:
        return f'"{text}"'
    return "'" + text + "'" if "'" not in text else '"' + text.replace('"', "&quot;") + '"'


def _legal(text: str) -> str:
    """A text without the characters that XML does not have."""
    if text.replace("\n", "").isprintable():
        return text
    return "".join(char for char in text if char in "\t\n\u00a0" or char.isprintable())


ATTRIBUTES = "http://www.3s-software.com/plcopenxml/attributes"
_XHTML = "http://www.w3.org/1999/xhtml"


def type_element(kind: Type, spelling: Spelling) -> Element:
    """The `type` element of a variable or a member."""
    if isinstance(kind, ArrayType) and kind in spelling.named:
        return element("derived", name=array_name(kind, spelling))
    if isinstance(kind, ArrayType):
        return _array(kind, spelling)
    return _type_name_element(kind)


def _type_name_element(kind: Elementary | EnumType | StructType) -> Element:
    return element(kind.name) if isinstance(kind, Elementary) else element("derived", name=kind.name)


def _array(kind: ArrayType, spelling: Spelling) -> Element:
    bounds = element("dimension", lower=str(kind.low), upper=str(kind.high))
    return element("array", bounds, element("baseType", type_element(kind.of, spelling)))


def array_type(kind: ArrayType, spelling: Spelling) -> Element:
    """An array by its name."""
    return _declared(array_name(kind, spelling), _array(kind, spelling), (), "")


def attributes(*pairs: tuple[str, str]) -> Element:
    """Pragmas, which the schema does not know: as data that CODESYS reads and writes itself."""
    pragmas = (element("Attribute", Name=name, Value=value) for name, value in pairs)
    return element(
        "addData", element("data", element("Attributes", *pragmas), name=ATTRIBUTES, handleUnknown="implementation")
    )


def documentation(lines: Iterable[str]) -> Element:
    """The `documentation` element with a comment."""
    return element(
        "documentation", element("xhtml", text="\n".join(comment_text(line) for line in lines), xmlns=_XHTML)
    )


def variable(name: str, kind: Element, initial: Element | None, remark: str) -> Element:
    """The `variable` element of a variable or of a member of a struct."""
    parts = [element("type", kind)]
    if initial is not None:
        parts.append(element("initialValue", initial))
    if comment_text(remark):
        parts.append(documentation([remark]))
    return element("variable", *parts, name=name)


def _declared(name: str, base: Element, pairs: Iterable[tuple[str, str]], title: str) -> Element:
    parts = [element("baseType", base)]
    attribute_pairs = tuple(pairs)
    if attribute_pairs:
        parts.append(attributes(*attribute_pairs))
    if comment_text(title):
        parts.append(documentation([title]))
    return element("dataType", *parts, name=name)


def enum_type(declared: EnumDeclaration) -> Element:
    """The `dataType` element of a strict enum with its base type."""
    values = (element("value", name=member.name, value=str(member.value)) for member in declared.members)
    base = element("baseType", _type_name_element(declared.base))
    values_and_base = element("enum", element("values", *values), base)
    remarks = [f"{member.name}: {member.remark}" for member in declared.members if comment_text(member.remark)]
    declared_enum = _declared(declared.name, values_and_base, ((name, "") for name in ENUM_ATTRIBUTES), declared.title)
    if not remarks:
        return declared_enum
    remarks_element = documentation([declared.title, *remarks])
    return element(
        "dataType",
        *(child for child in declared_enum.children if child.name != "documentation"),
        remarks_element,
        name=declared.name,
    )


def struct_type(struct: Struct, size: int, spelling: Spelling) -> Element:
    """A struct of some bytes, without gaps between its members."""
    kinds = [type_element(member.type, spelling) for member in struct.members]
    members = [
        variable(member.name, kind, None, member.remark) for member, kind in zip(struct.members, kinds, strict=True)
    ]
    members = members or [variable("byNothing", element("BYTE"), None, "a struct must have a member")]
    pairs = [("pack_mode", str(PACK_MODE))]
    return _declared(struct.name, element("struct", *members), pairs, f"{struct.title} {size} bytes.".strip())


def text_type(form: TextForm) -> Element:
    """The `dataType` element of the struct with the text of a code."""
    code, text = form.members
    kind = element("wstring" if form.wide else "string", length=str(form.longest))
    members = (variable(code, _type_name_element(form.code), None, ""), variable(text, kind, None, ""))
    return _declared(form.name, element("struct", *members), (), "A code and its meaning.")


# The order in which CODESYS exports them.
_SECTIONS = {"input": "inputVars", "output": "outputVars", "in_out": "inOutVars", "local": "localVars"}
_DOCUMENTATION_NAMESPACE = "http://www.w3.org/1999/xhtml"


def function(routine: Routine, text: Item, spelling: Spelling) -> Element:
    """A function and its statements in Structured Text."""
    sections = []
    for role, name in _SECTIONS.items():
        variables = [
            variable(
                declared.variable.name,
                type_element(declared.variable.type, spelling),
                _initial(declared),
                declared.remark,
            )
            for declared in routine.of_role(role)
        ]
        if variables:
            sections.append(element(name, *variables))
    constants = [_constant(item.name, item.type, item.value, item.hexadecimal) for item in routine.constants]
    if constants:
        sections.append(element("localVars", *constants, constant="true"))
    interface = element(
        "interface",
        *([element("returnType", type_element(routine.returns, spelling))] if routine.returns is not None else []),
        *sections,
        documentation(routine.remarks),
    )
    kind = "function" if routine.returns is not None else "functionBlock"
    return element("pou", interface, body(text.implementation), name=routine.name, pouType=kind)


def _initial(declared: Declared) -> Element | None:
    return element("simpleValue", value=declared.initial) if declared.initial else None


def body(lines: Sequence[str]) -> Element:
    """The statements of a routine, in Structured Text."""
    return element("body", element("ST", element("xhtml", text="\n".join(lines), xmlns=_DOCUMENTATION_NAMESPACE)))


def sizes_function(program: Program) -> Element:
    """The function that compares the sizes of structs."""
    measured = [placed.struct.name for placed in program.placed if placed.struct.members]
    variables = [
        variable(f"st{number_of}", _type_name_element(StructType(name)), None, "")
        for number_of, name in enumerate(measured, 1)
    ]
    remarks = [line.removeprefix("// ") for line in program.sizes.declaration if line.startswith("//")]
    interface = element(
        "interface",
        element("returnType", _type_name_element(BOOL)),
        *([element("localVars", *variables)] if variables else []),
        documentation(remarks),
    )
    return element("pou", interface, body(program.sizes.implementation), name=program.sizes.name, pouType="function")


def constants_list(constant_list: ConstantList) -> Element:
    """The list of constants that are numbers."""
    constants = constant_list.constants
    variables = [_constant(item.name, item.type, item.value, item.hexadecimal, item.remark) for item in constants]
    return _list(constant_list.name, variables, constant_list.title)


def _constant(name: str, kind: Elementary, value: int | Decimal, hexadecimal: bool, remark: str = "") -> Element:
    text = initial(value, kind, hexadecimal)
    return variable(name, _type_name_element(kind), element("simpleValue", value=text), remark)


def texts_list(name: str, tables: tuple[TextTable, ...], form: TextForm) -> Element:
    """The list of all texts of codes."""
    code, text = form.members
    variables = []
    for table in tables:
        rows = [
            element(
                "value",
                element(
                    "structValue",
                    element("value", element("simpleValue", value=str(entry.code)), member=code),
                    element("value", element("simpleValue", value=string(entry.text, form.wide)), member=text),
                ),
            )
            for entry in table.texts
        ]
        bounds = element("dimension", lower="0", upper=str(len(rows) - 1))
        kind = element("array", bounds, element("baseType", element("derived", name=form.name)))
        variables.append(variable(table.name, kind, element("arrayValue", *rows), table.title))
    return _list(name, variables, "Texts of codes")


def _list(name: str, variables: list[Element], title: str) -> Element:
    pragmas = attributes(*((pragma, "") for pragma in LIST_ATTRIBUTES))
    return element("globalVars", *variables, pragmas, documentation([title]), name=name, constant="true")


__all__ = ["constants_list", "documentation", "function", "sizes_function", "texts_list"]
