"""The files of a TwinCAT 3 project: one for each type, list of constants and function."""

from __future__ import annotations

import uuid
from collections.abc import Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import stem
from fieldspec.foundation.spreadsheet import BYTE_ORDER_MARK
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.targets.controllers.dialects import DIALECTS
from fieldspec.targets.controllers.structured.layout_table import layout_table
from fieldspec.targets.controllers.structured.objects import Item
from fieldspec.targets.controllers.structured.program import newest, program
from fieldspec.targets.controllers.structured.program import refusals as program_refusals

# An identifier that is made of a name is the same in every build, and differs where names differ.
_SPACE = uuid.uuid5(uuid.NAMESPACE_DNS, "twincat.fieldspec")


@dataclass(frozen=True, slots=True)
class Form:
    """How TwinCAT keeps a kind of object: its element, the ending of its file, and its folder."""

    element: str
    ending: str
    folder: str
    attributes: str = ""


FORMS = {
    "type": Form("DUT", "TcDUT", "DUTs"),
    "list": Form("GVL", "TcGVL", "GVLs"),
    "function": Form("POU", "TcPOU", "POUs", ' SpecialFunc="None"'),
    "block": Form("POU", "TcPOU", "POUs", ' SpecialFunc="None"'),
}


def files(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """The objects of a device's newest version, what includes them in a project, and where members of structs lie."""
    layout = newest(versions)
    st_program = program(layout)
    folder = stem(layout.device.id, layout.device.version)
    heading = st_program.about()
    texts = {f"{folder}/{path(item)}": source(item, heading) for item in st_program.items}
    texts[f"{folder}/project_items.xml"] = inclusion(st_program.items)
    texts[f"{folder}/layout.csv"] = layout_table(st_program)
    return texts


def refusals(versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """Names that controllers do not take, or take for one."""
    return program_refusals(newest(versions), DIALECTS["twincat"])


def shared() -> dict[str, str]:
    """No files: every file of this output belongs to one device."""
    return {}


def path(item: Item) -> str:
    """Where an object is, from the folder of the project on."""
    form = FORMS[item.kind]
    return f"{form.folder}/{item.name}.{form.ending}"


def identifier(name: str) -> str:
    """The GUID of an object: names are unique in a project, whatever the case of their letters."""
    return f"{{{uuid.uuid5(_SPACE, name.lower())}}}"


def source(item: Item, heading: list[str]) -> str:
    """The file of an object, with the byte order mark of all files that TwinCAT writes itself."""
    form = FORMS[item.kind]
    head = [f"// {line}" for line in heading]
    lines = [
        f'{BYTE_ORDER_MARK}<?xml version="1.0" encoding="utf-8"?>',
        '<TcPlcObject Version="1.1.0.1" ProductVersion="3.1.4024.0">',
        f'  <{form.element} Name="{item.name}" Id="{identifier(item.name)}"{form.attributes}>',
        f"    <Declaration>{_characters([*head, *item.declaration])}</Declaration>",
    ]
    if item.kind in ("function", "block"):
        lines += [
            "    <Implementation>",
            f"      <ST>{_characters(item.implementation)}</ST>",
            "    </Implementation>",
        ]
    return "\n".join([*lines, f"  </{form.element}>", "</TcPlcObject>"]) + "\n"


def _characters(lines: Sequence[str]) -> str:
    """Lines that XML takes as they are; what would end them is divided."""
    text = "\n".join(lines).replace("]]>", "]]]]><![CDATA[>")
    return f"<![CDATA[{text}]]>"


def inclusion(items: Sequence[Item]) -> str:
    """The part of a `.plcproj` that includes the objects."""
    lines = ["<!-- Copy these elements into an ItemGroup of the .plcproj. -->", "<ItemGroup>"]
    folders = dict.fromkeys(form.folder for form in FORMS.values())
    lines += [f'  <Folder Include="{folder}" />' for folder in folders]
    for item in items:
        lines += [
            f'  <Compile Include="{path(item).replace("/", chr(92))}">',
            "    <SubType>Code</SubType>",
            "  </Compile>",
        ]
    return "\n".join([*lines, "</ItemGroup>"]) + "\n"
