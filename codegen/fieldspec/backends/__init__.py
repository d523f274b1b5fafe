"""The outputs: one folder each. A back end turns the layouts of a device's versions into files by path."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from importlib import import_module
from typing import cast

from fieldspec.classes import dataclass
from fieldspec.diagnostics import Diagnostic
from fieldspec.layout.device import DeviceLayout
from fieldspec.spreadsheet import Workbook

Files = dict[str, str | Workbook]
"""Texts, and workbooks that the pipeline packs."""


@dataclass(frozen=True, slots=True)
class Output:
    """An output by the name of its folder here and below `generated/`.

    Its module is imported when it is first used, so that nobody pays for outputs that are not asked for. Outputs of one
    `family` are made of the same declarations: one process makes them for less than two.
    """

    name: str
    title: str
    family: str = ""

    def files(self, versions: Sequence[DeviceLayout]) -> Files:
        """The files for all versions of one device, the oldest first, by path."""
        return cast("Callable[[Sequence[DeviceLayout]], Files]", self._backend("files"))(versions)

    def shared(self) -> Files:
        """The files that belong to no device, by path."""
        return cast("Callable[[], Files]", self._backend("shared"))()

    def refusals(self, versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
        """What forbids the files for these versions of a device; asked before they are made.

        A back end that cannot express every device has a function `refusals` beside `files`.
        """
        module = import_module(f"fieldspec.backends.{self.name}.backend")
        refusals: Callable[[Sequence[DeviceLayout]], list[Diagnostic]] | None = getattr(module, "refusals", None)
        return refusals(versions) if refusals is not None else []

    def _backend(self, function: str) -> object:
        return getattr(import_module(f"fieldspec.backends.{self.name}.backend"), function)


OUTPUTS = {
    output.name: output
    for output in (
        Output("python", "Python codecs"),
        Output("c", "C headers with self-tests"),
        Output("docs", "Documentation as HTML and Markdown"),
        Output("vectors", "Example frames as JSON"),
        Output("hmi", "Texts of alarms, faults and warnings for operator panels as CSV and XLSX"),
        Output("scl", "Types, data blocks, functions and constants for TIA Portal", "structured"),
        Output("kv", "Word maps and device comments for word-based PLCs as CSV"),
        Output("st", "Structured Text for CODESYS and TwinCAT 3", "structured"),
        Output("twincat", "Structured Text as source files of TwinCAT 3", "structured"),
        Output("plcopen", "Structured Text as PLCopen TC6 XML", "structured"),
        Output("iec", "Structured Text of IEC 61131-3 for Beremiz and OpenPLC", "structured"),
    )
}
