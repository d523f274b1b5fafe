"""`fieldspec redact`: files of real units without what identifies them, as evidence that can be given away."""

from __future__ import annotations

import argparse
import json
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from fieldspec.command.audit_inputs.evidence_audit import is_dump
from fieldspec.command.bulk.bulk_decoding import require_captures
from fieldspec.command.console.streams import print_error
from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.files import list_files, regular_file, storage
from fieldspec.command.files.regular_file import SizeError
from fieldspec.command.rendering.blocks import Line, Table
from fieldspec.command.sources import specs
from fieldspec.foundation.classes import dataclass, field
from fieldspec.language.model.encoding import is_array
from fieldspec.language.reading.nodes import Mapping, Scalar
from fieldspec.language.reading.yaml_reader import decoded, parsed
from fieldspec.tools.evidence.observables import Observables
from fieldspec.tools.evidence.redacted_files import RedactedCapture, redacted_dump, redacted_scan
from fieldspec.tools.evidence.redaction import IDENTITY, Redaction
from fieldspec.tools.evidence.secrets import Secrets
from fieldspec.tools.evidence.unit_evidence import FILE, REDACTED
from fieldspec.tools.lists.dump import dump, dump_sheet
from fieldspec.tools.lists.list_file import content_sheet
from fieldspec.tools.lists.sheet import ListError

if TYPE_CHECKING:
    from fieldspec.codec.layout.device import DeviceLayout

_HEAD = 4096
_MOST_BYTES = 1 << 20


@dataclass(slots=True)
class _Output:
    """The output for one unit: contents by new names. `problems` are files that are left out, with the reason."""

    contents: dict[str, str] = field(default_factory=dict)
    rows: list[tuple[str, str, str]] = field(default_factory=list)
    left_out: Counter[str] = field(default_factory=Counter)
    problems: list[str] = field(default_factory=list)
    numbers: Counter[str] = field(default_factory=Counter)

    def add(self, kind: str, ending: str, source: str, content: str, amount: str) -> None:
        """Adds a file under a name that identifies nothing."""
        self.numbers[kind] += 1
        name = f"{kind}-{self.numbers[kind]}.{ending}"
        self.contents[name] = content
        self.rows.append((source, name, amount))


def run(arguments: argparse.Namespace) -> int:
    """Writes the redacted files into `--out`. If a file is left out, the exit code is 1. Raises UsageError."""
    require_captures()
    spec, version = specs.sound_at(arguments.specs, arguments.device)
    layout = specs.layout_of(spec, version)
    units = _units([Path(path) for path in arguments.paths])
    target = Path(arguments.out)
    if target.exists() and (not target.is_dir() or any(target.iterdir())):
        raise UsageError(
            f"{target} is not an empty folder; choose another one, so that no older file stays among these"
        )
    secrets = Secrets(arguments.secret or ())
    spared = _spared(layout, arguments.spare or ())
    for _ in range(2):  # a secret of the last file is not in the first one either
        redaction = Redaction(layout, secrets, spared)
        outputs = [_unit(redaction, folder, files) for folder, files in units]
    for number, output in enumerate(outputs, 1):
        folder = target if len(outputs) == 1 else target / f"unit-{number}"
        folder.mkdir(parents=True, exist_ok=True)
        for name, content in output.contents.items():
            storage.write(folder / name, content.encode())
    return _report(layout, redaction, outputs)


def _units(paths: Sequence[Path]) -> list[tuple[Path | None, list[Path]]]:
    """The files of each unit, with the folder of its note. Raises UsageError."""
    units: list[tuple[Path | None, list[Path]]] = []
    loose: list[Path] = []
    for path in paths:
        if not path.exists():
            raise UsageError(f"there is no {path}")
        if not path.is_dir():
            loose.append(path)
            continue
        inner = sorted(entry for entry in path.iterdir() if entry.is_dir() and (entry / FILE).is_file())
        units += [(folder, _files(folder)) for folder in inner] or [(path, _files(path))]
    if loose:
        units.append((None, loose))
    if not any(files for _, files in units):
        raise UsageError("there is no dump, scan or capture")
    return units


def _files(folder: Path) -> list[Path]:
    own = sorted(file for file in folder.rglob("*") if file.is_file() and not file.name.startswith("."))
    return [file for file in own if file != folder / FILE]


def _spared(layout: DeviceLayout, names: Sequence[str]) -> frozenset[str]:
    """The paths of facts whose texts are copied. Raises UsageError."""
    facts = {
        item.path: item.fact.place.path
        for item in Observables(layout).all
        if is_array(item.value.encoding) and IDENTITY not in item.fact.roles
    }
    for name in names:
        if name not in facts:
            raise unknown("text", name, facts)
    return frozenset(facts[name] for name in names)


def _unit(redaction: Redaction, folder: Path | None, files: Sequence[Path]) -> _Output:
    """The files of a unit without what identifies it."""
    output = _Output()
    note, address = _note(redaction.secrets, folder) if folder is not None else ("", None)
    for path in files:
        _add_file(redaction, output, path, address)
    if note:
        output.contents[FILE] = note
    return output


def _add_file(redaction: Redaction, output: _Output, path: Path, address: int | None) -> None:
    """Adds a file, or the reason why it is left out."""
    try:
        with open(path, "rb") as file:
            head = file.read(_HEAD)
        if is_dump(head):
            _add_dump(redaction, output, path)
        else:
            _add_capture(redaction, output, path, address)
    except (OSError, UsageError, ListError) as error:
        output.problems.append(f"{path}: {error}")


def _note(secrets: Secrets, folder: Path) -> tuple[str, int | None]:
    """The note of a unit without remarks, and its address. A number that it has is a secret. Raises UsageError."""
    path = folder / FILE
    if not path.is_file():
        return "", None
    try:
        file, findings = decoded(FILE, regular_file.content(path, _MOST_BYTES))
    except (SizeError, OSError):
        raise UsageError(f"cannot read {path}") from None
    node = None
    if not findings:
        node, findings = parsed(file)
    if findings or not isinstance(node, Mapping):
        raise UsageError(f"{path} is not a note; it has the keys model, firmware and serial_number")
    texts = {key: value.text.strip() for key, value in node.values.items() if isinstance(value, Scalar)}
    if texts.get("serial_number", REDACTED) != REDACTED:
        secrets.add_text(texts["serial_number"])
    own = {key: texts.get(key, "unknown") for key in ("model", "firmware")}
    texts_of_note = {key: REDACTED if secrets.is_in(text.encode()) else text for key, text in own.items()}
    lines = [f"{key}: {json.dumps(text, ensure_ascii=False)}" for key, text in texts_of_note.items()]
    lines.append(f"serial_number: {REDACTED}")
    address = texts.get("unit_address", "")
    if address.isdecimal():
        lines.append(f"unit_address: {address}")
    return "".join(f"{line}\n" for line in lines), int(address) if address.isdecimal() else None


def _add_dump(redaction: Redaction, output: _Output, path: Path) -> None:
    """Adds a dump or a scan. Raises UsageError and ListError."""
    data = list_files.content(str(path))
    try:
        content = json.loads(data)
    except (ValueError, RecursionError):
        content = None
    if isinstance(content, dict) and "spaces" in content:
        try:
            text = redacted_scan(redaction, content)
        except (ValueError, TypeError, KeyError, AttributeError):
            raise UsageError("is neither a scan nor a dump") from None
        output.add("scan", "json", str(path), text, "")
        return
    sheet = dump_sheet(data) or content_sheet(data)
    text = redacted_dump(redaction, dump(sheet, {}))
    output.add("dump", "csv", str(path), text, f"{text.count(chr(10)) - 1} rows")


def _add_capture(redaction: Redaction, output: _Output, path: Path, address: int | None) -> None:
    """Adds the frames of a capture, a log or rows of registers. Raises UsageError."""
    from fieldspec.tools.captures.capture_files import CaptureError
    from fieldspec.tools.captures.conversion import Conversion
    from fieldspec.tools.captures.decoding import Choices, DeviceDecoder

    units = frozenset() if address is None else frozenset((address,))
    decoder = DeviceDecoder(redaction.layout, Choices(units=units))
    capture = RedactedCapture(redaction, decoder)
    try:
        with open(path, "rb") as file:
            conversion = Conversion(file, decoder, ())
            for batches in conversion.batches():
                for batch in batches:
                    capture.add(batch)
            output.left_out.update(conversion.counters())
    except CaptureError as error:
        raise UsageError(f"could not be read: {error}") from None
    logs, table = capture.logs(), capture.table()
    output.left_out.update(capture.left_out)
    if not logs and not table:
        raise UsageError(f"has no frame of {redaction.layout.device.id}")
    for text in logs:
        output.add("capture", "log", str(path), text, f"{text.count(chr(10))} frames")
    if table:
        output.add("rows", "csv", str(path), table, f"{table.count(chr(10)) - 1} rows")


def _report(layout: DeviceLayout, redaction: Redaction, outputs: Sequence[_Output]) -> int:
    """Prints what was written, replaced and left out. The exit code."""
    rows = tuple(row for output in outputs for row in output.rows)
    replaced = tuple((path, str(count)) for path, count in sorted(redaction.replaced.items()))
    left_out: Counter[str] = Counter()
    for output in outputs:
        left_out.update(output.left_out)
    blocks: list[Line | Table] = [Table(("file", "written as", "amount"), rows)] if rows else []
    if replaced:
        blocks += [Line("Values that were replaced:", "bold"), Table(("fact", "times"), replaced)]
    if left_out:
        counts = tuple((reason, str(count)) for reason, count in sorted(left_out.items()))
        blocks += [Line("Left out:", "bold"), Table(("what", "times"), counts)]
    if not any(IDENTITY in item.fact.roles for item in Observables(layout).all):
        blocks.append(
            Line(
                f"The spec of {layout.device.id} has no fact with the role {IDENTITY}. Texts and what it does not "
                "describe are replaced; name what else identifies the unit with --secret."
            )
        )
    print_blocks(blocks)
    problems = [problem for output in outputs for problem in output.problems]
    for problem in problems:
        print_error(f"left out: {problem}")
    return int(bool(problems))
