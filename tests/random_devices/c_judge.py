"""The generated C header as a judge: a program asks it about each line of its input."""

from __future__ import annotations

import struct
import subprocess
from pathlib import Path

from bounded import HANGING
from external_tools import require_tool
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.targets.c.backend import files
from random_devices.c_driver import REASONS, Driver
from random_devices.quantities import is_for_doubles, with_rounding
from random_devices.queries import Answer, Query, quantity_text


class C:
    """The answers of a compiled header. `command` compiles a source into a program, `runner` is put before it."""

    def __init__(self, layout: DeviceLayout, folder: Path, command: list[str], runner: tuple[str, ...] = ()) -> None:
        self.layout, self.folder, self.runner = layout, folder, runner
        self.program = folder / f"driver_{command[0].replace('/', '_')}"
        for path, text in files([layout]).items():
            (folder / path).write_text(text, encoding="utf-8")
        source, driver = folder / "driver.c", Driver(layout)
        source.write_text(driver.source(), encoding="utf-8")
        self.quantities = driver.quantities.names
        tool, *flags = command
        command = [require_tool(tool), *flags, "-o", str(self.program), str(source)]
        compiled = subprocess.run(command, capture_output=True, text=True, check=False, timeout=HANGING)
        assert compiled.returncode == 0, f"{tool} does not compile the header: {compiled.stderr[:1000]}"

    def answers(self, queries: list[Query]) -> list[Answer]:
        """The answer to each query; values to encode are not asked for, as C takes them from what it has decoded."""
        is_asked = [self._is_asked(query) for query in queries]
        asked = [query for query, is_own in zip(queries, is_asked, strict=True) if is_own]
        lines = [f"{_name(query)} {_data(query).hex()}\n" for query in asked]
        result = subprocess.run(
            [*self.runner, str(self.program)], input="".join(lines), capture_output=True, text=True, timeout=HANGING
        )
        assert result.returncode == 0, f"the C program ends with {result.returncode}: {result.stderr[-2000:]}"
        outputs = iter(result.stdout.splitlines())
        return [
            _answer(query, next(outputs)) if is_own else Answer(reason=None)
            for query, is_own in zip(queries, is_asked, strict=True)
        ]

    def _is_asked(self, query: Query) -> bool:
        """Whether there is a function, or macros, for a question that arithmetic with doubles has one answer to."""
        return query.values is None or (_name(query) in self.quantities and is_for_doubles(query))


def _name(query: Query) -> str:
    link_direction = query.kind == "frame"
    return ".".join((query.kind, *(part for part in query.path if part or not link_direction)))


def _data(query: Query) -> bytes:
    """The bytes that are decoded; for a quantity eight bytes of the number and eight of the exponent or reference."""
    if query.values is None:
        return query.data
    number, *others = query.values.values()
    return b"".join(_eight_bytes(each) for each in (number, *(others if others != [None] else ())))


def _eight_bytes(number: float) -> bytes:
    return struct.pack(">d", number) if isinstance(number, float) else (number % (1 << 64)).to_bytes(8, "big")


def _answer(query: Query, output: str) -> Answer:
    values, status, second, again = output.rsplit(" ", 3)
    if status != "0":
        return Answer(REASONS[int(status)])
    if query.kind == "count":
        return Answer(again=values)
    if query.kind == "state":
        return Answer(quantity=values)
    if query.values is not None:
        return _quantity(query, *values.split(" "))
    return Answer(values=values, again=again if second == "0" else "!" + REASONS[int(second)])


def _quantity(query: Query, number: str, state: str) -> Answer:
    """The quantity of a count; it is refused for one that stands for a state."""
    if number == "!-1":
        return Answer(reason=None)  # the numbers of its scale are too large for macros
    if state != "None" and number.startswith("!"):
        assert REASONS[int(number[1:])] == "out_of_range", f"the quantity of {state} is {number}"
    own = None if state != "None" else "!" + REASONS[int(number[1:])] if number.startswith("!") else float(number)
    return with_rounding(query, Answer(quantity=quantity_text(own, state)))
