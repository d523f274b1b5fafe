"""The outputs: one folder each. A back end turns the layouts of a device's versions into files by path."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.spreadsheet import Workbook
from fieldspec.language.diagnostics import Diagnostic

if TYPE_CHECKING:
    from fieldspec.targets.usages import VersionUsages

Files = dict[str, str | Workbook]
"""Texts, and workbooks that the pipeline packs."""


@dataclass(frozen=True, slots=True)
class PageLink:
    """An entry of an index of pages: its text, and the file that it leads to, relative to the index."""

    text: str
    file: str


@dataclass(frozen=True, slots=True)
class Output:
    """An output by the name of its folder here and below `generated/`.

    Its module is imported when it is first used, so that unused outputs take no time. Outputs of one `family` are made
    of the same declarations: one process makes them for less than two. `backend` takes the place of the module where an
    installed package brings the output. `test_endings` are the endings of files that test a version; `has_blocks` says
    that a project can choose blocks of it.
    """

    name: str
    title: str
    family: str = ""
    backend: object | None = None
    test_endings: tuple[str, ...] = ()
    has_blocks: bool = False

    def files(self, versions: Sequence[DeviceLayout], links: Sequence[PageLink] = ()) -> Files:
        """The files for all versions of one device, the oldest first, by path.

        `links` lead to pages that the back end does not write. Only a back end with an index of pages takes them.
        """
        files: Callable[..., Files] = self._module().files
        return files(versions, links) if links else files(versions)

    def shared(self) -> Files:
        """The files that belong to no device, by path; most outputs have none."""
        shared: Callable[[], Files] | None = getattr(self._module(), "shared", None)
        return shared() if shared is not None else {}

    def overview(self, paths: Iterable[str], content: Callable[[str], str]) -> dict[str, str]:
        """The files that summarize all devices, by path; most outputs have none.

        `paths` are the files of all devices below the folder of the output, and `content` is the text of one of them.
        """
        overview: Callable[..., dict[str, str]] | None = getattr(self._module(), "overview", None)
        return overview(paths, content) if overview is not None else {}

    def usages(self, versions: Sequence[DeviceLayout]) -> dict[str, VersionUsages]:
        """How programs use the output, by the versions of a device that it has; nothing of most outputs.

        A back end whose output programs use has a function `usages` beside `files`.
        """
        usages: Callable[..., dict[str, VersionUsages]] | None = getattr(self._module(), "usages", None)
        return usages(versions) if usages is not None else {}

    @property
    def has_usages(self) -> bool:
        """Whether programs use the output, so that the documentation has code for it."""
        return hasattr(self._module(), "usages")

    def refusals(self, versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
        """The facts that the output cannot express of these versions of a device; called before its files are built.

        A back end that cannot express every device has a function `refusals` beside `files`.
        """
        refusals: Callable[..., list[Diagnostic]] | None = getattr(self._module(), "refusals", None)
        return refusals(versions) if refusals is not None else []

    def _module(self) -> Any:
        return self.backend or import_module(f"fieldspec.targets.{self.name}.backend")


OUTPUTS = {
    output.name: output
    for output in (
        Output("python", "Python codecs"),
        Output("c", "C headers with self-tests", test_endings=("_selftest.c", "_fuzz.c")),
        Output("js", "JavaScript modules with types"),
        Output("wireshark", "Dissectors in Lua for Wireshark"),
        Output("queries", "Decoding as SQL for DuckDB and expressions for Polars"),
        Output("docs", "Documentation as HTML and Markdown"),
        Output("vectors", "Example frames as JSON"),
        Output("hmi", "Texts of alarms, faults and warnings for operator panels as CSV and XLSX"),
        Output("scl", "Types, data blocks, functions and constants for TIA Portal", "structured", has_blocks=True),
        Output("kv", "Word maps and device comments for word-based PLCs as CSV"),
        Output("st", "Structured Text for CODESYS and TwinCAT 3", "structured", has_blocks=True),
        Output("twincat", "Structured Text as source files of TwinCAT 3", "structured", has_blocks=True),
        Output("plcopen", "Structured Text as PLCopen TC6 XML", "structured", has_blocks=True),
        Output("iec", "Structured Text of IEC 61131-3 for Beremiz and OpenPLC", "structured", has_blocks=True),
    )
}
"""All outputs by name. `build` adds the outputs of installed packages."""

BUILT_IN = frozenset(OUTPUTS)
"""The names of fieldspec's own outputs."""
