"""The files of a TwinCAT 3 project: one for each type, list of constants and function, the project, and its tasks."""

from __future__ import annotations

import re
import uuid
from collections.abc import Iterator, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import stem
from fieldspec.foundation.spreadsheet import BYTE_ORDER_MARK
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.targets.controllers.adapters.objects import objects
from fieldspec.targets.controllers.adapters.programs import twincat
from fieldspec.targets.controllers.dialects import DIALECTS
from fieldspec.targets.controllers.statements.routine import Routine
from fieldspec.targets.controllers.structured.layout_table import layout_table
from fieldspec.targets.controllers.structured.objects import Item
from fieldspec.targets.controllers.structured.program import Program, newest, origin, program
from fieldspec.targets.controllers.structured.program import refusals as program_refusals

LIBRARIES = (("Tc2_SerialCom", "ComBuffer"), ("Tc2_ModbusRTU", "ModbusRtuMaster"))
"""The libraries of adapters, and types of each by which its use is known."""


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
    "program": Form("POU", "TcPOU", "POUs", ' SpecialFunc="None"'),
}


def files(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """The objects of a device's newest version, what includes them in a project, and where members of structs lie."""
    layout = newest(versions)
    st_program = program(layout)
    folder = stem(layout.device.id, layout.device.version)
    heading = [origin(layout)]
    texts = {f"{folder}/{path(item)}": source(item, heading) for item in st_program.items}
    own = list(adapters(st_program))
    texts |= {f"{folder}/{path(item)}": source(item, [*heading, *remarks]) for item, remarks in own}
    items = [*st_program.items, *(item for item, _ in own)]
    texts |= {f"{folder}/{name}": text for name, text in project_files(st_program, items).items()}
    texts[f"{folder}/layout.csv"] = layout_table(st_program)
    return texts


def refusals(versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """Names that controllers do not take, or take for one."""
    return program_refusals(newest(versions), DIALECTS["twincat"])


def adapters(st_program: Program) -> Iterator[tuple[Item, tuple[str, ...]]]:
    """The objects of adapters and programs, with what their comments say."""
    for text in twincat(st_program.declared.world, st_program.spelling, st_program.routines):
        yield from ((item, text.remarks) for item in objects(text.text, "adapters"))


def project_files(st_program: Program, items: Sequence[Item]) -> dict[str, str]:
    """The project with its tasks by their paths; none where there is no program to be called."""
    programs = [item.name for item in items if item.kind == "program"]
    if not programs:
        return {"project_items.xml": "".join(f"{line}\n" for line in comments(st_program.about())) + inclusion(items)}
    lines = [name for name in programs if name.endswith("SerialLine")]
    # Of several telegrams a drive has one: that with the most blocks, unless the project is changed.
    called = max(
        (name for name in programs if name not in lines),
        key=lambda name: len(_panel(st_program, name).body),
    )
    tasks = [Task("Line", 1000, 10, lines), Task("PlcTask", 10000, 20, [called])]
    used = [task for task in tasks if task.programs]
    name = st_program.declared.world.names.device
    files = {f"{task.name}.TcTTO": task_file(name, task) for task in used}
    text = " ".join(line for item in items for line in item.declaration)
    libraries = ["Tc2_Standard", *(library for library, mark in LIBRARIES if mark in text)]
    project = project_file(name, st_program.about(), inclusion(items), [task.name for task in used], libraries)
    return files | {f"{name}.plcproj": project}


def _panel(st_program: Program, name: str) -> Routine:
    """The ready program that a program calls."""
    device = st_program.declared.world.names.device
    rest = name.removeprefix(f"PRG_{device}").removeprefix("_")
    return next(item for item in st_program.routines if item.name == f"FB_{device}_{rest}Panel")


def path(item: Item) -> str:
    """Where an object is, from the folder of the project on."""
    form = FORMS[item.kind]
    return f"{form.folder}/{item.name}.{form.ending}"


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
    if item.kind in ("function", "block", "program"):
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
    lines = ["<!-- Copy these elements into an ItemGroup of another .plcproj. -->", "<ItemGroup>"]
    folders = dict.fromkeys(form.folder for form in FORMS.values())
    lines += [f'  <Folder Include="{folder}" />' for folder in folders]
    for item in items:
        lines += [
            f'  <Compile Include="{path(item).replace("/", chr(92))}">',
            "    <SubType>Code</SubType>",
            "  </Compile>",
        ]
    return "\n".join([*lines, "</ItemGroup>"]) + "\n"


# An identifier that is made of a name is the same in every build, and differs where names differ.
_SPACE = uuid.uuid5(uuid.NAMESPACE_DNS, "twincat.fieldspec")
_PROPERTIES = (
    "Application",
    "TypeSystem",
    "Implicit_Task_Info",
    "Implicit_KindOfTask",
    "Implicit_Jitter_Distribution",
    "LibraryReferences",
)
"""Parts of a project that have a GUID each."""


@dataclass(frozen=True, slots=True)
class Task:
    """A task: its cycle in microseconds, its priority, and the programs that it calls."""

    name: str
    cycle: int
    priority: int
    programs: Sequence[str]


def identifier(name: str) -> str:
    """The GUID of an object: names are unique in a project, whatever the case of their letters."""
    return f"{{{uuid.uuid5(_SPACE, name.lower())}}}"


def task_file(project: str, task: Task) -> str:
    """The file of a task."""
    return "\n".join(
        [
            f'{BYTE_ORDER_MARK}<?xml version="1.0" encoding="utf-8"?>',
            '<TcPlcObject Version="1.1.0.1" ProductVersion="3.1.4024.0">',
            f'  <Task Name="{task.name}" Id="{identifier(f"{project} task {task.name}")}">',
            f"    <CycleTime>{task.cycle}</CycleTime>",
            f"    <Priority>{task.priority}</Priority>",
            *(f"    <PouCall>\n      <Name>{name}</Name>\n    </PouCall>" for name in task.programs),
            "  </Task>",
            "</TcPlcObject>\n",
        ]
    )


def comments(lines: Sequence[str]) -> list[str]:
    """Lines as comments of XML, which have no two hyphens in a row, and none at their end."""
    return [f"<!-- {re.sub('-(?=-|$)', '- ', line)} -->" for line in lines]


def project_file(name: str, remarks: Sequence[str], items: str, tasks: Sequence[str], libraries: Sequence[str]) -> str:
    """The project: what it is of, its objects, the tasks that call programs, and the libraries that adapters need."""
    group = items.partition("<ItemGroup>\n")[2].rpartition("</ItemGroup>")[0].replace("\n", "\n  ")
    lines = [
        f'{BYTE_ORDER_MARK}<?xml version="1.0" encoding="utf-8"?>',
        '<Project DefaultTargets="Build" xmlns="http://schemas.microsoft.com/developer/msbuild/2003">',
        *(f"  {line}" for line in comments(remarks)),
        "  <PropertyGroup>",
        "    <FileVersion>1.0.0.0</FileVersion>",
        "    <SchemaVersion>2.0</SchemaVersion>",
        f"    <ProjectGuid>{identifier(f'{name} project')}</ProjectGuid>",
        f"    <Name>{name}</Name>",
        "    <ProgramVersion>3.1.4024.0</ProgramVersion>",
        *(f"    <{part}>{identifier(f'{name} {part}')}</{part}>" for part in _PROPERTIES),
        "    <GenerateTpy>false</GenerateTpy>",
        "  </PropertyGroup>",
        "  <ItemGroup>",
        f"  {group.rstrip()}",
    ]
    for task in tasks:
        lines += [f'    <Compile Include="{task}.TcTTO">', "      <SubType>Code</SubType>", "    </Compile>"]
    lines += ["  </ItemGroup>", "  <ItemGroup>"]
    for library in libraries:
        lines += [
            f'    <PlaceholderReference Include="{library}">',
            f"      <DefaultResolution>{library}, * (Beckhoff Automation GmbH)</DefaultResolution>",
            f"      <Namespace>{library}</Namespace>",
            "    </PlaceholderReference>",
        ]
    return "\n".join([*lines, "  </ItemGroup>", "</Project>"]) + "\n"
