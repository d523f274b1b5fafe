"""Blocks of a device in one program, compiled, with the ports that they share, scan by scan."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

from compiled import Block, Compiled
from st_syntax import Unit, parsed
from standard_text import anonymous, named, needed, without_comments
from test_scl_execution import siemens_text

from fieldspec.targets.controllers.dialects import Spelling
from fieldspec.targets.controllers.routines.printer import type_text
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    TIME,
    ArrayType,
    Elementary,
    EnumType,
    StructType,
    Type,
)
from fieldspec.targets.controllers.statements.routine import Routine
from fieldspec.targets.iec.backend import source, text
from fieldspec.targets.scl.project import project
from layouts import newest

ORDER = "aOrder"
ENDS = ("Done", "CommandAborted", "Error", "Busy")


class Bench:
    """Some blocks of a device, called in their order. `ports` are the structs and arrays that they are lent.

    A name may have a number after it, which makes it another instance. Blocks share what has one name and one type.
    `lent` has the variable for each parameter of each block. A `program` has more blocks than are called, so that
    several benches have one program, which is compiled once. One that is `ordered` calls them in an order that each
    scan states.
    """

    def __init__(
        self,
        root: Path,
        device: str,
        names: Sequence[str],
        folder: Path,
        dialect: str = "iec",
        program: Sequence[str] = (),
        ordered: bool = False,
    ) -> None:
        self.world, routines, spelling, content = _generated(root, device, dialect)
        by_name = {routine.name: routine for routine in routines}
        prefix = self.world.block()
        blocks: dict[str, Routine] = {name: by_name[prefix + name.split()[0]] for name in program or names}
        self.blocks = {name: blocks[name] for name in names}
        shared = _lent(blocks)
        self.lent = {key: name for name, (_, keys) in shared.items() for key in keys}
        self.inputs = {
            (name, declared.variable.name): _kind(declared.variable.type)
            for name, block in blocks.items()
            for declared in block.of_role("input")
            if declared.variable.type != TIME
        }
        self.initial = {
            (name, declared.variable.name): _initial(declared.initial, declared.variable.type)
            for name, block in blocks.items()
            for declared in block.of_role("input")
            if declared.variable.type != TIME
        }
        self.outputs = {
            (name, declared.variable.name): _kind(declared.variable.type)
            for name, block in blocks.items()
            for declared in block.of_role("output")
        }
        lines = ["PROGRAM PRG_Bench", "VAR"]
        calls = []
        for number, (name, block) in enumerate(blocks.items()):
            lines += [f"b{number} : {block.name};", f"b{number}_called : BOOL;"]
            arguments = []
            for declared in block.of_role("input"):
                if declared.variable.type != TIME:
                    variable = f"b{number}_{declared.variable.name}"
                    lines.append(f"{variable} : {_unquoted(type_text(declared.variable.type, spelling))};")
                    arguments.append(f"{declared.variable.name} := {variable}")
            arguments += [
                f"{item.variable.name} := {self.lent[name, item.variable.name]}" for item in block.of_role("in_out")
            ]
            label = f"{number}: " if ordered else ""
            calls.append(f"{label}IF b{number}_called THEN b{number}({', '.join(arguments)}); END_IF;")
        lines += [f"{name} : {_unquoted(type_text(kind, spelling))};" for name, (kind, _) in shared.items()]
        order = ((ORDER, ("array", 0, len(blocks) - 1, "int")),) if ordered else ()
        if ordered:
            lines += [f"{ORDER} : ARRAY [0..{len(blocks) - 1}] OF INT;", "iCall : INT;"]
            head = f"FOR iCall := 0 TO {len(blocks) - 1} DO CASE {ORDER}[iCall] OF"
            calls = [head, *calls, "END_CASE; END_FOR;"]
        program = "\n".join([*lines, "END_VAR", *calls, "END_PROGRAM", ""])
        content = needed(content, [block.name for block in blocks.values()])
        # Nothing is called but the program, so the types are all that the process is asked for.
        unit = _types(content, dialect)
        whole = content + program if dialect == "iec" else named(content + program)
        numbers = {name: number for number, name in enumerate(blocks)}
        called = tuple((f"b{number}_called", "bool") for number in numbers.values())
        lent = tuple((name, _kind(kind)) for name, (kind, _) in shared.items())
        self._called = [name in self.blocks for name in blocks]
        self._numbers, self._ordered = numbers, ordered
        self._lent = [name for name, _ in lent]
        inputs = ((f"b{numbers[name]}_{variable}", kind) for (name, variable), kind in self.inputs.items())
        outputs = ((f"b{numbers[name]}.{variable}", kind) for (name, variable), kind in self.outputs.items())
        block = Block("PRG_Bench", (*inputs, *called, *order, *lent), (*outputs, *lent))
        self.program = Compiled(whole, folder, block, unit)
        self._kinds = dict(lent)
        self.now: dict[tuple[str, str], Any] = {}
        self.restart()

    def restart(self) -> None:
        """Switches the controller off and on; what is set from outside stays."""
        self.program.restart()
        from_outside = {key: value for key, value in self.now.items() if key in self.inputs}
        self.now = {**self.initial, **from_outside}
        self.out: dict[tuple[str, str], Any] = dict.fromkeys(self.outputs, False)
        self.ports: dict[str, Any] = {name: self.program.fresh(kind) for name, kind in self._kinds.items()}

    def set(self, block: str, **inputs: Any) -> None:
        """Sets inputs of a block."""
        for name, value in inputs.items():
            assert (block, name) in self.inputs, (block, name, [key for key in self.inputs if key[0] == block])
            self.now[block, name] = value

    def scan(self, milliseconds: int = 10, order: Sequence[str] | None = None) -> None:
        """Calls all blocks once; or those of an order, where the program is ordered."""
        ports = [self.ports[name] for name in self._lent]
        called: list[Any] = self._called
        if self._ordered:
            places = list(self._numbers.values() if order is None else map(self._numbers.__getitem__, order))
            called = [*called, places + [-1] * (len(self._numbers) - len(places))]
        values = self.program.scan(milliseconds, [*self.now.values(), *called, *ports])
        self.out = dict(zip(self.outputs, values, strict=False))
        self.ports = dict(zip(self._lent, values[len(self.outputs) :], strict=True))

    def ended(self, block: str) -> str:
        """The output that says how a block has ended, or that it is busy."""
        ends = [name for name in ENDS if self.out.get((block, name))]
        assert len(ends) <= 1, (block, ends)
        return "".join(ends)

    def reason(self, block: str) -> int:
        """The number of the reason of its error; for Siemens it is the low byte of a status of errors."""
        if (block, "ErrorID") in self.out:
            return int(self.out[block, "ErrorID"])
        status = int(self.out[block, "Status"])
        return status & 0xFF if status >= 0x8000 else 0

    def port(self, port: str, name: str) -> str:
        """The name of a member of a port, in the language of the test, as it is in `ports`."""
        return self.world.names.members[port][name].lower().strip('"')


@cache
def _generated(root: Path, device: str, dialect: str) -> tuple[World, Sequence[Routine], Spelling, str]:
    """What is generated for a device."""
    layout = newest(root, device)
    if dialect == "iec":
        iec_source = source(layout)
        return iec_source.declared.world, iec_source.routines, iec_source.spelling, text(iec_source)
    tia = project(layout)
    content = without_comments(siemens_text(device)).replace("TON_TIME", "TON")
    content = re.sub(r"^TYPE \w+CodeText :.*?^END_TYPE$", "", content, flags=re.MULTILINE | re.DOTALL)
    # SCL takes a reserved word in quotes for a name.
    content = re.sub(r"\bon\b", "onMember", content)
    return tia.declared.world, tia.routines, tia.declared.dialect.spelling, content


@cache
def _types(content: str, dialect: str) -> Unit:
    types = needed(content, ())
    return parsed(anonymous(types) if dialect == "iec" else types)


@cache
def block_names(root: Path, device: str) -> list[str]:
    """The blocks of a device, without the words before their names."""
    world, routines, _, _ = _generated(root, device, "iec")
    prefix = world.block()
    return [routine.name.removeprefix(prefix) for routine in routines if routine.name.startswith(prefix)]


def _lent(blocks: dict[str, Routine]) -> dict[str, tuple[Type, list[tuple[str, str]]]]:
    """The variables that blocks are lent, with their types and the parameters that they stand for."""
    variables: dict[tuple[str, Type], str] = {}
    result: dict[str, tuple[Type, list[tuple[str, str]]]] = {}
    for block, routine in blocks.items():
        for declared in routine.of_role("in_out"):
            name, kind = declared.variable.name, declared.variable.type
            others = sum(other == name for other, _ in variables)
            variable = variables.setdefault((name, kind), f"{name}{others or ''}")
            result.setdefault(variable, (kind, []))[1].append((block, name))
    return result


def _initial(text: str, kind: Type) -> Any:
    """The value that an input has where nobody sets it."""
    if kind == BOOL:
        return text == "TRUE"
    return float(text) if "." in text else int(text or "0")


def _unquoted(text: str) -> str:
    return text.replace('"', "")


def _kind(kind: Type) -> Any:
    if isinstance(kind, ArrayType):
        return ("array", kind.low, kind.high, _kind(kind.of))
    if isinstance(kind, EnumType):
        return kind.base.name.lower()
    assert isinstance(kind, Elementary | StructType)
    return kind.name.lower()
