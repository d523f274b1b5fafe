"""The generated C header as a judge: a program asks it about each line of its input."""

from __future__ import annotations

import subprocess
from pathlib import Path

from bounded import HANGING
from external_tools import require_tool
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.targets.c.backend import files
from random_devices.c_driver import REASONS, Driver
from random_devices.queries import Answer, Query


class C:
    """The answers of a compiled header. `command` compiles a source into a program, `runner` is put before it."""

    def __init__(self, layout: DeviceLayout, folder: Path, command: list[str], runner: tuple[str, ...] = ()) -> None:
        self.layout, self.folder, self.runner = layout, folder, runner
        self.program = folder / f"driver_{command[0].replace('/', '_')}"
        for path, text in files([layout]).items():
            (folder / path).write_text(text, encoding="utf-8")
        source = folder / "driver.c"
        source.write_text(Driver(layout).source(), encoding="utf-8")
        tool, *flags = command
        command = [require_tool(tool), *flags, "-o", str(self.program), str(source)]
        compiled = subprocess.run(command, capture_output=True, text=True, check=False, timeout=HANGING)
        assert compiled.returncode == 0, f"{tool} does not compile the header: {compiled.stderr[:1000]}"

    def answers(self, queries: list[Query]) -> list[Answer]:
        """The answer to each query; values to encode are not asked for, as C takes them from what it has decoded."""
        lines = [f"{_name(query)} {query.data.hex()}\n" for query in queries if query.values is None]
        result = subprocess.run(
            [*self.runner, str(self.program)], input="".join(lines), capture_output=True, text=True, timeout=HANGING
        )
        assert result.returncode == 0, f"the C program ends with {result.returncode}: {result.stderr[-2000:]}"
        outputs = iter(result.stdout.splitlines())
        return [Answer(reason=None) if query.values is not None else _answer(next(outputs)) for query in queries]


def _name(query: Query) -> str:
    link_direction = query.kind == "frame"
    return ".".join((query.kind, *(part for part in query.path if part or not link_direction)))


def _answer(output: str) -> Answer:
    values, status, second, again = output.rsplit(" ", 3)
    if status != "0":
        return Answer(REASONS[int(status)])
    return Answer(values=values, again=again if second == "0" else "!" + REASONS[int(second)])
