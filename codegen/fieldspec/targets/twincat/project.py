"""The project of a PLC and its tasks, as XAE keeps them below the item PLC of a TwinCAT project."""

from __future__ import annotations

import re
import uuid
from collections.abc import Sequence

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.spreadsheet import BYTE_ORDER_MARK

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
