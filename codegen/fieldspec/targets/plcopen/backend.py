"""The files of the PLCopen output: one TC6 XML for a device, in the form that CODESYS exports itself."""

from __future__ import annotations

import re
import uuid
from collections.abc import Iterable, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import replace
from fieldspec.foundation.names import stem
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.targets.controllers.adapters.objects import DeclaredText, declared, objects
from fieldspec.targets.controllers.adapters.programs import ALTERNATIVE, Source, codesys
from fieldspec.targets.controllers.dialects import DIALECTS
from fieldspec.targets.controllers.statements.expressions import ELEMENTARY, TIME
from fieldspec.targets.controllers.structured.layout_table import layout_table
from fieldspec.targets.controllers.structured.objects import Item
from fieldspec.targets.controllers.structured.program import Program, named_arrays, newest, program
from fieldspec.targets.controllers.structured.program import refusals as program_refusals
from fieldspec.targets.plcopen.elements import (
    Element,
    array_type,
    body,
    constants_list,
    document_text,
    documentation,
    element,
    enum_type,
    function,
    sizes_function,
    struct_type,
    text_type,
    texts_list,
)

# What CODESYS writes and TwinCAT reads; 2.01 differs in nothing that stands here.
NAMESPACE = "http://www.plcopen.org/xml/tc6_0200"
GLOBALS = "http://www.3s-software.com/plcopenxml/globalvars"
# The schema demands a date. This one says nothing, and is the same in every build.
CREATED = "2000-01-01T00:00:00"


def files(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """A project with everything of a device's newest version, and a table of where members of structs lie."""
    layout = newest(versions)
    name = stem(layout.device.id, layout.device.version)
    st_program = program(layout)
    sources = list(codesys(st_program.declared.world, st_program.spelling, st_program.routines))
    alone = [source for source in sources if source.name == ALTERNATIVE]
    programs = [source for source in sources if source.name != ALTERNATIVE]
    return {
        f"{name}.xml": document_text(project(st_program, programs)),
        **{f"{name}_{source.name}.xml": document_text(added(st_program, source)) for source in alone},
        f"{name}_layout.csv": layout_table(st_program),
    }


def refusals(versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """Names that controllers do not take, or take for one."""
    return program_refusals(newest(versions), DIALECTS["plcopen"])


def added(program_of_device: Program, source: Source) -> Element:
    """A project with the objects of one text alone, to be imported into that of the device."""
    items = list(objects(source.text, ADAPTERS))
    pous = [text_pou(item, source.remarks) for item in items]
    return _document(program_of_device, [*program_of_device.about(), *source.remarks], [], pous, [], folders(items))


def project(program_of_device: Program, sources: Sequence[Source]) -> Element:
    """The project: types, functions, and the lists of constants as data that CODESYS reads and writes itself.

    The adapters and programs of `sources` come last.
    """
    types = [enum_type(enum) for enum in program_of_device.declared.enums]
    spelling, structs = program_of_device.spelling, []
    known: set[str] = set()
    for placed in program_of_device.placed:
        members = [member.type for member in placed.struct.members]
        structs += [array_type(kind, spelling) for kind in named_arrays(members, spelling, known)]
        structs.append(struct_type(placed.struct, placed.size, spelling))
    variables = [declared.variable.type for routine in program_of_device.routines for declared in routine.declared]
    structs += [array_type(kind, spelling) for kind in named_arrays(variables, spelling, known)]
    types += structs
    lists = [constants_list(constant_list) for constant_list in program_of_device.declared.constants]
    if program_of_device.texts is not None:
        types.append(text_type(program_of_device.texts))
        lists.append(
            texts_list(program_of_device.texts_list, program_of_device.declared.texts, program_of_device.texts)
        )
    functions = [
        sizes_function(program_of_device),
        *(
            function(routine, text, spelling)
            for routine, text in zip(program_of_device.routines, program_of_device.functions, strict=True)
        ),
    ]
    own = [(item, source.remarks) for source in sources for item in objects(source.text, ADAPTERS)]
    functions += [text_pou(item, remarks) for item, remarks in own]
    remarks = [*program_of_device.about(), "", *program_of_device.guide()]
    structure = folders([*program_of_device.items, *(item for item, _ in own)])
    return _document(program_of_device, remarks, types, functions, lists, structure)


def _document(
    program_of_device: Program,
    remarks: Sequence[str],
    types: Sequence[Element],
    pous: Sequence[Element],
    lists: Sequence[Element],
    structure: Element,
) -> Element:
    layout = program_of_device.declared.layout
    scaling = element("scaling", x="1", y="1")
    return element(
        "project",
        element("fileHeader", companyName="", productName="fieldspec", productVersion="", creationDateTime=CREATED),
        element(
            "contentHeader",
            element("Comment", text="\n".join(remarks)),
            element("coordinateInfo", element("fbd", scaling), element("ld", scaling), element("sfc", scaling)),
            name=stem(layout.device.id, layout.device.version),
        ),
        element(
            "types",
            element("dataTypes", *map(identified, types)),
            element("pous", *map(identified, pous)),
        ),
        element("instances", element("configurations")),
        element(
            "addData",
            *(element("data", identified(data), name=GLOBALS, handleUnknown="implementation") for data in lists),
            structure,
        ),
        documentation(program_of_device.about()),
        xmlns=NAMESPACE,
    )


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
