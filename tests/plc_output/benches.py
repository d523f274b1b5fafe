"""Blocks of a device in one program, compiled, with the ports that they share, scan by scan."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from compiled import Block, Compiled
from st_syntax import parsed
from standard_text import anonymous, named, needed, without_comments
from test_scl_execution import siemens_text

from fieldspec.backends.iec.backend import source, text
from fieldspec.backends.scl.project import project
from fieldspec.plc.routines.expressions import TIME, ArrayType, Elementary, EnumType, StructType, Type
from fieldspec.plc.routines.printer import type_text
from fieldspec.plc.routines.routine import Routine
from layouts import newest

ENDS = ("Done", "CommandAborted", "Error", "Busy")


class Bench:
    """Some blocks of a device, called in their order. `ports` are the structs and arrays that they are lent."""

    def __init__(self, root: Path, device: str, names: Sequence[str], folder: Path, dialect: str = "iec") -> None:
        layout = newest(root, device)
        if dialect == "iec":
            iec_source = source(layout)
            self.world, routines, spelling = iec_source.declared.world, iec_source.routines, iec_source.spelling
            content = text(iec_source)
        else:
            tia = project(layout)
            self.world, routines, spelling = tia.declared.world, tia.routines, tia.declared.dialect.spelling
            content = without_comments(siemens_text(device)).replace("TON_TIME", "TON")
            content = re.sub(r"^TYPE \w+CodeText :.*?^END_TYPE$", "", content, flags=re.MULTILINE | re.DOTALL)
            # SCL takes a reserved word in quotes for a name.
            content = re.sub(r"\bon\b", "onMember", content)
        by_name = {routine.name: routine for routine in routines}
        prefix = f"FB_{self.world.names.device}_"
        self.blocks: dict[str, Routine] = {name: by_name[prefix + name] for name in names}
        shared = {
            declared.variable.name: declared.variable.type
            for block in self.blocks.values()
            for declared in block.of_role("in_out")
        }
        self.inputs = {
            (name, declared.variable.name): _kind(declared.variable.type)
            for name, block in self.blocks.items()
            for declared in block.of_role("input")
            if declared.variable.type != TIME
        }
        self.outputs = {
            (name, declared.variable.name): _kind(declared.variable.type)
            for name, block in self.blocks.items()
            for declared in block.of_role("output")
        }
        lines = ["PROGRAM PRG_Bench", "VAR"]
        calls = []
        for number, block in enumerate(self.blocks.values()):
            lines.append(f"b{number} : {block.name};")
            arguments = []
            for declared in block.of_role("input"):
                if declared.variable.type != TIME:
                    variable = f"b{number}_{declared.variable.name}"
                    lines.append(f"{variable} : {_unquoted(type_text(declared.variable.type, spelling))};")
                    arguments.append(f"{declared.variable.name} := {variable}")
            arguments += [f"{item.variable.name} := {item.variable.name}" for item in block.of_role("in_out")]
            calls.append(f"b{number}({', '.join(arguments)});")
        lines += [f"{name} : {_unquoted(type_text(kind, spelling))};" for name, kind in shared.items()]
        program = "\n".join([*lines, "END_VAR", *calls, "END_PROGRAM", ""])
        content = needed(content, [block.name for block in self.blocks.values()])
        # Nothing is called but the program, so the types are all that the process is asked for.
        types = needed(content, ())
        unit = parsed(anonymous(types) if dialect == "iec" else types)
        whole = content + program if dialect == "iec" else named(content + program)
        numbers = {name: number for number, name in enumerate(self.blocks)}
        lent = tuple((name, _kind(kind)) for name, kind in shared.items())
        self._lent = [name for name, _ in lent]
        block = Block(
            "PRG_Bench",
            (*((f"b{numbers[name]}_{variable}", kind) for (name, variable), kind in self.inputs.items()), *lent),
            (*((f"b{numbers[name]}.{variable}", kind) for (name, variable), kind in self.outputs.items()), *lent),
        )
        self.program = Compiled(whole, folder, block, unit)
        self._kinds = dict(lent)
        self.now: dict[tuple[str, str], Any] = {}
        self.restart()

    def restart(self) -> None:
        """Switches the controller off and on; what is set from outside stays."""
        self.program.restart()
        from_outside = {key: value for key, value in self.now.items() if key in self.inputs}
        self.now = {key: False if kind == "bool" else 0 for key, kind in self.inputs.items()} | from_outside
        self.out: dict[tuple[str, str], Any] = dict.fromkeys(self.outputs, False)
        self.ports: dict[str, Any] = {name: self.program.fresh(kind) for name, kind in self._kinds.items()}

    def set(self, block: str, **inputs: Any) -> None:
        """Sets inputs of a block."""
        for name, value in inputs.items():
            assert (block, name) in self.inputs, (block, name, [key for key in self.inputs if key[0] == block])
            self.now[block, name] = value

    def scan(self, milliseconds: int = 10) -> None:
        """Calls all blocks once."""
        values = self.program.scan(milliseconds, [*self.now.values(), *(self.ports[name] for name in self._lent)])
        self.out = dict(zip(self.outputs, values, strict=False))
        self.ports = dict(zip(self._lent, values[len(self.outputs) :], strict=True))

    def ended(self, block: str) -> str:
        """The output that says how a block has ended, or that it is busy."""
        ends = [name for name in ENDS if self.out.get((block, name))]
        assert len(ends) <= 1, (block, ends)
        return "".join(ends)

    def port(self, port: str, name: str) -> str:
        """The name of a member of a port, in the language of the test, as it is in `ports`."""
        return self.world.names.members[port][name].lower().strip('"')


def _unquoted(text: str) -> str:
    return text.replace('"', "")


def _kind(kind: Type) -> Any:
    if isinstance(kind, ArrayType):
        return ("array", kind.low, kind.high, _kind(kind.of))
    if isinstance(kind, EnumType):
        return kind.base.name.lower()
    assert isinstance(kind, Elementary | StructType)
    return kind.name.lower()
