"""`fieldspec decode --to`: captures and logs as tables of frames and values, in parts that are always whole."""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.console.streams import print_note
from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.console.usage import UsageError
from fieldspec.command.files.regular_file import reading
from fieldspec.command.files.storage import exclusive_folder, replace
from fieldspec.command.files.table_parts import TableParts
from fieldspec.command.frames.frame_options import frame_options
from fieldspec.command.sources import specs
from fieldspec.foundation.line_text import visible_text

if TYPE_CHECKING:
    from collections.abc import Callable

    from fieldspec.tools.captures.decoding import Choices

JOURNAL, SUMMARY = "journal.json", "summary.json"
JOURNAL_FORMAT = 2
"""The version of the journal format: a run continues only from journals of this version."""
PART = 1_000_000
"""The frames of a part, unless --part-frames says another number."""

OF_FRAMES = ("request", "format")
"""The options that explain single frames."""


def run(arguments: argparse.Namespace) -> int:
    """Decodes files into a folder. Exit code 1 where bytes could not be decoded or read. Raises UsageError."""
    require_captures()
    spec, version = specs.sound_at(arguments.specs, arguments.device)
    layout = specs.layout_of(spec, version)  # the framers come from generated code, which needs the whole model
    choices = _choices(layout, arguments)
    if not arguments.out:
        raise UsageError("--to writes a folder of tables; name it with --out FOLDER")
    if arguments.part_frames is not None and arguments.part_frames < 1:
        raise UsageError("--part-frames must be 1 or more")
    numbers_of("--port", arguments.port, 0xFFFF)
    files = source_files(arguments.frame)
    output_folder = Path(arguments.out)
    with exclusive_folder(output_folder):
        return _Job(layout, choices, arguments, files, output_folder).run()


def require_captures() -> None:
    """Raises UsageError where the libraries of tables are not installed."""
    try:
        for library in ("numpy", "pyarrow"):
            import_module(library)
    except ImportError as error:
        raise UsageError(f"tables need {error.name}: pip install 'fieldspec[captures]'") from None


def _choices(layout: DeviceLayout, arguments: argparse.Namespace) -> Choices:
    """The options that apply to all frames. Raises UsageError."""
    from fieldspec.tools.captures.decoding import Choices

    for option in OF_FRAMES:
        if getattr(arguments, option) not in (None, "text"):
            raise UsageError(f"--{option} explains single frames and has no effect with --to; leave it out")
    if not layout.links:
        raise UsageError(f"{arguments.device} has no link, so there are no frames to decode")
    options = frame_options(layout, arguments)
    links = list(dict.fromkeys(link for link, _ in options.places))
    link = arguments.link or (links[0] if options.message and len(links) == 1 else "")
    directions = sorted(options.directions)
    direction = directions[0] if len(directions) == 1 else ""
    return Choices(link, options.message, direction, frozenset(numbers_of("--units", arguments.units, 0xFFFFFFFF)))


def numbers_of(option: str, text: str | None, maximum: int) -> list[int]:
    """The numbers in a text such as `1,3-5`. Raises UsageError."""
    result: list[int] = []
    for part in text.split(",") if text else ():
        low, _, high = part.partition("-")
        if not (low.isdecimal() and (high or low).isdecimal()) or not int(low) <= int(high or low) <= maximum:
            raise UsageError(f"{option} {text} is not a list of numbers up to {maximum}; write it as 1,3-5")
        if int(high or low) - int(low) > 0xFFFF:
            raise UsageError(f"{option} {text} has too many numbers")
        result += range(int(low), int(high or low) + 1)
    return result


def source_files(names: list[str]) -> list[tuple[str, Path]]:
    """The files to decode with their names in the tables, also all files in folders. Raises UsageError."""
    if not names:
        raise UsageError("--to decodes files; name captures or logs, or folders with them")
    files: dict[str, Path] = {}
    for name in names:
        path = Path(name)
        if path.is_dir():
            folder_files = sorted(file for file in path.rglob("*") if file.is_file() and not file.name.startswith("."))
            files |= {file.relative_to(path).as_posix(): file for file in folder_files}
        elif path.is_file():
            files[path.name if path.name not in files else path.as_posix()] = path
        else:
            raise UsageError(f"there is no file {name}")
    if not files:
        raise UsageError(f"there are no files in {' and '.join(names)}")
    return [(visible_text(name), path) for name, path in files.items()]  # tables cannot have what is not UTF-8


class _Job:
    """One run over all files, which continues where an earlier run was stopped."""

    def __init__(
        self,
        layout: DeviceLayout,
        choices: Choices,
        arguments: argparse.Namespace,
        files: list[tuple[str, Path]],
        output_folder: Path,
    ) -> None:
        from fieldspec.tools.captures.decoding import DeviceDecoder
        from fieldspec.tools.captures.totals import Totals

        self.files, self.out, self.form = files, output_folder, arguments.to
        self.most = arguments.part_frames or PART
        self.ports = numbers_of("--port", arguments.port, 0xFFFF)
        self.device = DeviceDecoder(layout, choices)
        self.name = f"{layout.device.id}@{layout.device.version}"
        self.totals = Totals()
        self.sources: dict[str, Any] = {}
        self.task = {
            "device": self.name,
            "identity": layout.identity,
            "to": self.form,
            "part_frames": self.most,
            "ports": self.ports,
            "link": choices.link,
            "message": choices.message,
            "direction": choices.direction,
            "units": sorted(choices.units),
            "sources": [[name, path.stat().st_size] for name, path in files],
        }

    def run(self) -> int:
        """Decodes what is left, and prints what has been seen."""
        journal = self._journal()
        first = 0
        state = None
        part = 0
        if journal is not None:
            from fieldspec.tools.captures.totals import Totals

            self.totals, first, state = Totals.of_data(journal["totals"]), journal["source"], journal["state"]
            self.sources, part = journal["faults"], journal["part"]
            place_text = f"going on in file {first + 1} of {len(self.files)}"
            print_note(place_text if first < len(self.files) else "all files are decoded already")
        parts = TableParts(self.out, self.form, part)
        try:
            with _progress(sum(path.stat().st_size for _, path in self.files)) as advance:
                done = sum(path.stat().st_size for _, path in self.files[:first])
                for number in range(first, len(self.files)):
                    for position in self._file(number, state, parts):
                        advance(done + position, self.frame_count)
                    state = None
                    done += self.files[number][1].stat().st_size
            parts.finish()
            self._note(parts.number, len(self.files), None, Counter())
        finally:
            parts.drop()
        replace(self.out / SUMMARY, _json(self._summary()))
        print_blocks(self._blocks(parts.number))
        return int(self._is_flawed())

    @property
    def frame_count(self) -> int:
        """The number of frames so far."""
        return sum(self.totals.frames.values())

    def _file(self, number: int, state: Any, parts: TableParts) -> Iterator[int]:
        """Decodes one file and yields how many bytes are done. One that cannot be read is noted."""
        from fieldspec.tools.captures.capture_files import CaptureError
        from fieldspec.tools.captures.conversion import Conversion
        from fieldspec.tools.captures.tables import record_batches

        name, path = self.files[number]
        try:
            with reading(path), open(path, "rb") as file:
                conversion = Conversion(file, self.device, self.ports, state)
                for batches in conversion.batches():
                    for batch in batches:
                        self.totals.add(batch)
                        parts.write(record_batches(batch, self.device.texts.texts, name, self.name))
                    yield conversion.position
                    if parts.frames >= self.most:
                        parts.finish()
                        conversion.forget_texts()
                        self._note(parts.number, number, conversion.state(), conversion.counters())
                self.totals.counters += conversion.counters()
                if conversion.is_left_out:
                    self.sources[name] = "nothing in it is a frame of the device; the counts say what is left out"
        except CaptureError as error:
            self.sources[name] = str(error)

    def _journal(self) -> Any:
        """The journal of an earlier run, None without one. Raises UsageError for another task."""
        path = self.out / JOURNAL
        if not path.exists():
            if any(self.out.iterdir()):
                raise UsageError(f"the folder {self.out} is not empty; name a new one")
            return None
        try:
            journal = json.loads(path.read_bytes())
            same = journal["task"] == json.loads(_json(self.task))
            known = journal.get("format") == JOURNAL_FORMAT
        except (ValueError, KeyError, TypeError, AttributeError):
            raise UsageError(f"{path} is not a journal of this command; name a new folder") from None
        if not known:
            raise UsageError(f"{path} is a journal of another version of fieldspec; name a new folder")
        if not same:
            raise UsageError(f"{self.out} has the tables of another task; name a new folder, or repeat that task")
        return journal

    def _note(self, part: int, source: int, state: Any, counters: Counter[str]) -> None:
        """Writes the journal: what is on the disk, and where decoding continues."""
        totals = self.totals.as_data()
        totals["counters"] = dict(Counter(totals["counters"]) + counters)
        content = {
            "format": JOURNAL_FORMAT,
            "task": self.task,
            "part": part,
            "source": source,
            "state": state,
            "totals": totals,
            "faults": self.sources,
        }
        replace(self.out / JOURNAL, _json(content))

    def _is_flawed(self) -> bool:
        valid, total = self.totals.whole
        lost = [counter for counter in self.totals.counters if counter.startswith(("bytes lost", "damage"))]
        return valid < total or bool(lost) or bool(self.sources)

    def _summary(self) -> dict[str, Any]:
        return {"device": self.name, "identity": self.task["identity"], **self.totals.as_data(), "faults": self.sources}

    def _blocks(self, parts: int) -> Iterator[Any]:
        from fieldspec.command.rendering.captures import summary_blocks

        return summary_blocks(self.totals.as_data(), len(self.files), parts, self.sources)


def _json(content: Any) -> bytes:
    return (json.dumps(content, sort_keys=True) + "\n").encode()


@contextmanager
def _progress(total: int) -> Iterator[Callable[[int, int], None]]:
    """A bar on a terminal, with the rate and the time that is left; nothing elsewhere."""
    if not sys.stderr.isatty():
        yield lambda done, frames: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

    columns = (TextColumn("decoding"), BarColumn(), TaskProgressColumn(), TextColumn("{task.fields[rate]}"))
    with Progress(*columns, TimeRemainingColumn(), console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("decoding", total=total, rate="")

        def advance(done: int, frames: int) -> None:
            elapsed = bar.tasks[0].elapsed or 0
            bar.update(task, completed=done, rate=f"{frames / elapsed:,.0f} frames/s" if elapsed else "")

        yield advance
