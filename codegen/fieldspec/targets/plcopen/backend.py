"""The files of the PLCopen output: one TC6 XML for a device, in the form that CODESYS exports itself."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.names import stem
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.targets.controllers.adapters.objects import objects
from fieldspec.targets.controllers.adapters.programs import ALTERNATIVE, Source, codesys
from fieldspec.targets.controllers.dialects import DIALECTS
from fieldspec.targets.controllers.structured.arrays import named_arrays
from fieldspec.targets.controllers.structured.layout_table import layout_table
from fieldspec.targets.controllers.structured.program import Program, newest, program
from fieldspec.targets.controllers.structured.program import refusals as program_refusals
from fieldspec.targets.plcopen.elements import (
    Element,
    array_type,
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
from fieldspec.targets.plcopen.folders import ADAPTERS, folders, identified
from fieldspec.targets.plcopen.text_objects import text_pou

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


def shared() -> dict[str, str]:
    """No files: every file of this output belongs to one device."""
    return {}


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
