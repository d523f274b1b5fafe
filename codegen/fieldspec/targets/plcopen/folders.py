"""The folders of a project of CODESYS, and the identifiers by which they name objects, as data of CODESYS."""

from __future__ import annotations

import uuid
from collections.abc import Iterable

from fieldspec.foundation.classes import replace
from fieldspec.targets.controllers.structured.objects import Item
from fieldspec.targets.plcopen.elements import Element, element

OBJECT = "http://www.3s-software.com/plcopenxml/objectid"
STRUCTURE = "http://www.3s-software.com/plcopenxml/projectstructure"
ADAPTERS = "adapters and programs"
# An identifier that is made of a name is the same in every build, and differs where names differ.
_SPACE = uuid.uuid5(uuid.NAMESPACE_DNS, "plcopen.fieldspec")
_FOLDERS = {"type": "Types", "list": "Constants", "function": "Functions", "block": "Blocks"}
_BEFORE = ("documentation",)
"""What follows the data of vendors in an element."""


def identifier(name: str) -> str:
    """The GUID of an object: names are unique in a project, whatever the case of their letters."""
    return str(uuid.uuid5(_SPACE, name.lower()))


def identified(item: Element) -> Element:
    """An object with its identifier."""
    name = dict(item.attributes)["name"]
    data = element("data", element("ObjectId", text=identifier(name)), name=OBJECT, handleUnknown="discard")
    children = list(item.children)
    for position, child in enumerate(children):
        if child.name == "addData":
            children[position] = replace(child, children=(*child.children, data))
            return replace(item, children=tuple(children))
    end = next((position for position, child in enumerate(children) if child.name in _BEFORE), len(children))
    return replace(item, children=(*children[:end], element("addData", data), *children[end:]))


def folders(items: Iterable[Item]) -> Element:
    """The folders: types, constants, functions and blocks, and beside them adapters and programs."""
    content: dict[str, list[Element]] = {}
    for item in items:
        folder = "Adapters and programs" if item.about == ADAPTERS else _FOLDERS[item.kind]
        content.setdefault(folder, []).append(element("Object", Name=item.name, ObjectId=identifier(item.name)))
    structure = element("ProjectStructure", *(element("Folder", *inner, Name=name) for name, inner in content.items()))
    return element("data", structure, name=STRUCTURE, handleUnknown="discard")
