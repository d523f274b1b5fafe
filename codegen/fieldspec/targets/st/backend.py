"""The files of the Structured Text output."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.names import stem
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.targets.controllers.dialects import DIALECTS
from fieldspec.targets.controllers.structured.layout_table import layout_table
from fieldspec.targets.controllers.structured.program import Program, declared_in_text, newest, program
from fieldspec.targets.controllers.structured.program import refusals as program_refusals
from fieldspec.targets.controllers.structured.usages import usage_rows, version_usages
from fieldspec.targets.usages import VersionUsages, cache_spelling

_PARTS = {
    "type": "Types: enums and structs",
    "list": "Constants: each list is an object of its own, by the name above it",
    "function": "Functions",
    "block": "Function blocks",
}


def files(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """One text with everything of a device's newest version, and a table of where members of structs lie."""
    layout = newest(versions)
    name = stem(layout.device.id, layout.device.version)
    st_program = program(layout)
    cache_spelling("st", layout, partial(usage_rows, layout, declared_in_text))
    return {f"{name}.st": text(st_program), f"{name}_layout.csv": layout_table(st_program)}


def usages(versions: Sequence[DeviceLayout]) -> dict[str, VersionUsages]:
    """How programs use the newest version of a device."""
    return version_usages("st", "Structured Text", newest(versions), declared_in_text)


def refusals(versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """Names that controllers do not take, or take for one."""
    return program_refusals(newest(versions), DIALECTS["st"])


def text(program: Program) -> str:
    """All objects of a program in one text."""
    lines = [f"// {line}".rstrip() for line in (*program.about(), "", *program.guide())]
    part = ""
    for item in program.items:
        if item.kind != part:
            part = item.kind
            lines += ["", f"// ==== {_PARTS[part]} ===="]
        lines.append("")
        if item.kind == "list":
            lines.append(f"// {item.name}")
        lines += item.lines
    return "\n".join(lines) + "\n"
