"""Functions and lists of constants as elements."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.plcopen.elements import Element, element
from fieldspec.backends.plcopen.types import attributes, documentation, type_element, variable
from fieldspec.plc.constants import ConstantList
from fieldspec.plc.routines.routine import Routine
from fieldspec.plc.routines.types import BOOL, StructType
from fieldspec.plc.structured.item import Item
from fieldspec.plc.structured.lists import LIST_ATTRIBUTES, TextForm
from fieldspec.plc.structured.literals import number, string
from fieldspec.plc.structured.program import Program
from fieldspec.plc.texts import TextTable

_SECTIONS = {"input": "inputVars", "in_out": "inOutVars", "output": "outputVars", "local": "localVars"}
_XHTML = "http://www.w3.org/1999/xhtml"


def function(routine: Routine, text: Item) -> Element:
    """A function and its statements in Structured Text."""
    sections = []
    for role, name in _SECTIONS.items():
        held = [
            variable(one.variable.name, type_element(one.variable.type), None, one.remark)
            for one in routine.of_role(role)
        ]
        if held:
            sections.append(element(name, *held))
    interface = element(
        "interface",
        element("returnType", type_element(routine.returns)),
        *sections,
        documentation(routine.remarks),
    )
    return element("pou", interface, _body(text.implementation), name=routine.name, pouType="function")


def _body(lines: Sequence[str]) -> Element:
    return element("body", element("ST", element("xhtml", text="\n".join(lines), xmlns=_XHTML)))


def sizes_function(made: Program) -> Element:
    """The function that compares the sizes of structs."""
    measured = [one.struct.name for one in made.placed if one.struct.members]
    held = [
        variable(f"st{number_of}", type_element(StructType(name)), None, "")
        for number_of, name in enumerate(measured, 1)
    ]
    told = [line.removeprefix("// ") for line in made.sizes.declaration if line.startswith("//")]
    interface = element(
        "interface",
        element("returnType", type_element(BOOL)),
        *([element("localVars", *held)] if held else []),
        documentation(told),
    )
    return element("pou", interface, _body(made.sizes.implementation), name=made.sizes.name, pouType="function")


def constants_list(listed: ConstantList) -> Element:
    """A list of numbers."""
    held = [
        variable(one.name, type_element(one.type), element("simpleValue", value=number(one)), one.remark)
        for one in listed.constants
    ]
    return _list(listed.name, held, listed.title)


def texts_list(name: str, tables: tuple[TextTable, ...], form: TextForm) -> Element:
    """The list of all texts of codes."""
    code, text = form.members
    held = []
    for table in tables:
        rows = [
            element(
                "value",
                element(
                    "structValue",
                    element("value", element("simpleValue", value=str(one.code)), member=code),
                    element("value", element("simpleValue", value=string(one.text, form.wide)), member=text),
                ),
            )
            for one in table.texts
        ]
        bounds = element("dimension", lower="0", upper=str(len(rows) - 1))
        kind = element("array", bounds, element("baseType", element("derived", name=form.name)))
        held.append(variable(table.name, kind, element("arrayValue", *rows), table.title))
    return _list(name, held, "Texts of codes")


def _list(name: str, held: list[Element], title: str) -> Element:
    pragmas = attributes(*((one, "") for one in LIST_ATTRIBUTES))
    return element("globalVars", *held, pragmas, documentation([title]), name=name, constant="true")


__all__ = ["constants_list", "documentation", "function", "sizes_function", "texts_list"]
