"""`fieldspec audit --captures`: what captures, or the tables made from them, show of a device."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from fieldspec.command.bulk.bulk_decoding import JOURNAL, require_captures, source_files
from fieldspec.command.console.streams import print_error
from fieldspec.command.console.usage import UsageError
from fieldspec.command.files.regular_file import reading
from fieldspec.command.files.storage import exclusive_folder, replace

if TYPE_CHECKING:
    from fieldspec.codec.layout.device import DeviceLayout
    from fieldspec.tools.audit.section import Report
    from fieldspec.tools.captures.decoding import DeviceDecoder
    from fieldspec.tools.captures.observations import Observations


def capture_report(arguments: argparse.Namespace, layout: DeviceLayout) -> tuple[Report, bool]:
    """The report on a folder, and whether anything contradicts the spec. Raises UsageError."""
    require_captures()
    from fieldspec.tools.audit.section import Report
    from fieldspec.tools.captures.decoding import Choices, DeviceDecoder
    from fieldspec.tools.captures.findings import CaptureAudit
    from fieldspec.tools.captures.observations import Observations

    if not layout.links:
        raise UsageError(f"{arguments.device} has no link, so there are no captures of it")
    addresses = [link.link.unit_addresses for link in layout.links.values()]
    observations = Observations(next((own.broadcast for own in addresses if own is not None), None))
    decoder = DeviceDecoder(layout, Choices())
    folder = Path(arguments.captures)
    if (folder / JOURNAL).is_file() and (folder / "frames").is_dir():
        _read_tables(folder, observations)
    else:
        _decode(arguments.captures, decoder, observations)
    if not observations.frames:
        raise UsageError(f"{folder} has no frame of {layout.device.id}")
    audit = CaptureAudit(decoder, observations)
    sections = audit.sections()
    device = layout.device
    contradictions = next(section for section in sections if section.name == "contradictions")
    is_wrong = any("bad" in table.kinds for table in contradictions.tables)
    return Report(device.id, device.name, device.version, layout.identity, sections), is_wrong


def _read_tables(folder: Path, observations: Observations) -> None:
    """Adds the tables that `decode --to parquet` has written. Raises UsageError."""
    from fieldspec.tools.captures.report_tables import parquet_batches

    for table, add in (("frames", observations.add_frames), ("values", observations.add_values)):
        paths = sorted((folder / table).glob("*.parquet"))
        if not paths:
            raise UsageError(f"{folder} has no tables in Parquet; decode with --to parquet, or name the captures")
        for path in paths:
            with reading(path), open(path, "rb") as file:
                for batch in parquet_batches(file):
                    add(batch)


def _decode(name: str, decoder: DeviceDecoder, observations: Observations) -> None:
    """Decodes the captures of a folder, and adds what they have. A file that cannot be read is named."""
    from fieldspec.tools.captures.capture_files import CaptureError

    for source, path in source_files([name]):
        try:
            _decode_file(source, path, decoder, observations)
        except CaptureError as error:  # noqa: PERF203 - the other files are decoded
            print_error(f"{source} could not be read: {error}")


def _decode_file(source: str, path: Path, decoder: DeviceDecoder, observations: Observations) -> None:
    """Adds what one file has. Raises CaptureError, and UsageError for one that the system does not let read."""
    from fieldspec.tools.captures.conversion import Conversion
    from fieldspec.tools.captures.tables import record_batches

    device = decoder.layout.device
    with reading(path), open(path, "rb") as file:
        conversion = Conversion(file, decoder, ())
        for batches in conversion.batches():
            for batch in batches:
                tables = record_batches(batch, decoder.texts.texts, source, f"{device.id}@{device.version}")
                observations.add_frames(tables["frames"])
                observations.add_values(tables["values"])
        for remark, count in sorted(conversion.counters().items()):
            print_error(f"{source}: {remark}: {count}")


def write_tables(report: Report, folder: Path) -> None:
    """Writes each table of a report as a Parquet file. Raises UsageError."""
    from fieldspec.command.rendering.audit_formats import rows
    from fieldspec.tools.captures.report_tables import parquet_bytes

    with exclusive_folder(folder):
        for section in report.sections:
            for table in section.tables:
                content: list[dict[str, Any]] = rows(table)
                replace(folder / f"{table.name}.parquet", parquet_bytes(table.columns, content))
