"""PLCopen XML elements of blocks and programs that are given as text."""

from __future__ import annotations

import re
from collections.abc import Sequence

from fieldspec.foundation.classes import replace
from fieldspec.targets.controllers.adapters.objects import DeclaredText, declared
from fieldspec.targets.controllers.statements.expressions import ELEMENTARY, TIME
from fieldspec.targets.controllers.structured.objects import Item
from fieldspec.targets.plcopen.elements import Element, body, documentation, element

_SECTIONS = {
    "VAR_INPUT": element("inputVars"),
    "VAR_OUTPUT": element("outputVars"),
    "VAR_IN_OUT": element("inOutVars"),
    "VAR": element("localVars"),
    "VAR CONSTANT": element("localVars", constant="true"),
}
_POU_TYPES = {"block": "functionBlock", "program": "program"}
_ARRAY = re.compile(r"ARRAY\[(\d+)\.\.(\d+)\] OF (.+)")


def text_pou(item: Item, remarks: Sequence[str]) -> Element:
    """A block or a program; `remarks` is what its comment says."""
    sections = declared(item)
    variables = [
        replace(section, children=tuple(map(_variable, sections[word])))
        for word, section in _SECTIONS.items()
        if sections.get(word)
    ]
    interface = element("interface", *variables, documentation(remarks))
    return element("pou", interface, body(item.implementation), name=item.name, pouType=_POU_TYPES[item.kind])


def _variable(variable: DeclaredText) -> Element:
    parts = [element("type", _type(variable.kind))]
    if variable.initial:
        parts.append(element("initialValue", element("simpleValue", value=variable.initial)))
    if variable.remark:
        parts.append(documentation([variable.remark]))
    address = {"address": variable.address} if variable.address else {}
    return element("variable", *parts, name=variable.name, **address)


def _type(kind: str) -> Element:
    """The type of a variable by its text."""
    match = _ARRAY.fullmatch(kind)
    if match is not None:
        bounds = element("dimension", lower=match[1], upper=match[2])
        return element("array", bounds, element("baseType", _type(match[3])))
    return element(kind) if kind in ELEMENTARY or kind == TIME.name else element("derived", name=kind)
