"""An adapter of the documentation, compiled, between a port and a stand-in of the vendor's block, scan by scan."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from adapter_texts import SIEMENS, STRUCTURED, called_in, siemens, siemens_types, standard
from compiled import Block, Compiled
from st_syntax import parsed
from standard_text import anonymous, named, needed, without_comments
from vendor_blocks import ALL

from fieldspec.targets.controllers.routines.blocks.ports import ABANDONED, ANSWERED, ASKED, FREE
from fieldspec.targets.iec.backend import source, text
from layouts import SPECS, newest


@dataclass(frozen=True)
class Adapter:
    """What a stand calls: the adapter with its arguments, the type of its port, and the variables of a test.

    They are paths below the adapter with their types: what a test sets, and what it only reads.
    """

    name: str
    device: str
    port: str
    port_type: str
    arguments: str
    inputs: Mapping[str, Any]
    outputs: Mapping[str, Any]
    milliseconds: int = 10

    @property
    def is_siemens(self) -> bool:
        """Whether it is for TIA Portal."""
        return self.name in SIEMENS


class Stand:
    """An adapter that runs. `set` and `get` are its variables; `port` is the struct that it serves."""

    def __init__(self, adapter: Adapter, folder: Path) -> None:
        self.adapter = adapter
        block = siemens(SIEMENS[adapter.name]) if adapter.is_siemens else standard(STRUCTURED[adapter.name])
        content = generated(adapter.device, adapter.is_siemens)
        types = needed(content, called_in(block))
        program = (
            f"PROGRAM PRG_Stand VAR adapter : {adapter.name}; port : {adapter.port_type}; END_VAR\n"
            f"adapter({adapter.arguments}, {adapter.port} := port);\nEND_PROGRAM\n"
        )
        port = ("port", adapter.port_type.lower())
        self._inputs = {f"adapter.{path}": kind for path, kind in adapter.inputs.items()}
        self._paths = [*self._inputs, *(f"adapter.{path}" for path in adapter.outputs)]
        outputs = (*zip(self._paths, [*adapter.inputs.values(), *adapter.outputs.values()], strict=True), port)
        unit = parsed(anonymous(needed(content, ())))
        whole = named(without_comments(types) + ALL + block + program)
        self._program = Compiled(whole, folder, Block("PRG_Stand", (*self._inputs.items(), port), outputs), unit)
        self.restart()

    def restart(self) -> None:
        """Switches the controller on."""
        self._program.restart()
        self.values = {path: self._program.fresh(kind) for path, kind in self._inputs.items()}
        self.port: dict[str, Any] = self._program.fresh(self.adapter.port_type.lower())

    def get(self, path: str) -> Any:
        """A variable of the adapter or of a vendor's block in it."""
        return self.values[f"adapter.{path}"]

    def set(self, **values: Any) -> None:
        """Sets variables; `__` stands for a point."""
        for name, value in values.items():
            path = f"adapter.{name.replace('__', '.')}"
            assert path in self._inputs, (path, [*self._inputs])
            self.values[path] = value

    def member(self, word: str) -> str:
        """The name of a member of the port."""
        return next(name for name in self.port if name.endswith(word))

    def of(self, word: str) -> Any:
        """A member of the port."""
        return self.port[self.member(word)]

    def put(self, **values: Any) -> None:
        """Changes members of the port."""
        for word, value in values.items():
            self.port[self.member(word)] = value

    def scan(self) -> None:
        """Calls the adapter once."""
        values = [self.values[path] for path in self._inputs]
        *values, self.port = self._program.scan(self.adapter.milliseconds, [*values, self.port])
        self.values = dict(zip(self._paths, values, strict=True))

    def run(self, scans: int) -> None:
        """Calls it some times."""
        for _ in range(scans):
            self.scan()

    def ask_words(self, write: bool, words: Sequence[int] = (0x5678,), address: int = 0x201E) -> int:
        """Reads or writes registers as a block does; gives the error of the answer."""
        have = self.of("words")
        self.put(write=write, address=address, count=len(words), words=[*words, *have[len(words) :]])
        return self.answered()

    def answered(self, scans: int = 400) -> int:
        """Asks, waits for the answer, takes it, and gives its error."""
        assert self.of("state") == FREE
        self.ask()
        for _ in range(scans):
            self.scan()
            if self.of("state") == ANSWERED:
                assert self.of("answered") == self.of("request")
                self.put(state=FREE)
                return int(self.of("error"))
        raise AssertionError("there is no answer")

    def ask(self) -> None:
        """Asks, with the next number."""
        self.put(state=ASKED, request=self.of("request") + 1)

    def abandoned(self, scans: int = 400) -> None:
        """Asks, gives up in the next scan, and waits until the port is free again."""
        self.ask()
        self.run(2)
        assert self.of("state") == ASKED
        self.put(state=ABANDONED)
        for _ in range(scans):
            self.scan()
            if self.of("state") == FREE:
                return
        raise AssertionError("the port is not freed")

    def gives_way(self, scans: int) -> int:
        """Asks, and some scans later a stop is to go first; gives the error of the answer."""
        self.put(**{"send" if "frames" in self.adapter.port.lower() else "count": 1})
        self.ask()
        self.run(scans)
        self.put(urgent=6)
        self.scan()
        assert self.of("state") == ANSWERED
        assert self.of("answered") == self.of("request")
        return int(self.of("error"))


def generated(device: str, is_siemens: bool) -> str:
    """What is generated for a device, without comments."""
    content = siemens_types(device) if is_siemens else text(source(newest(SPECS, device)))
    return without_comments(content)
