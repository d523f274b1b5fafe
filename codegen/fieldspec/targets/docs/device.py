"""The device of a page, its manual and its versions."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.model.device import Detection, Device, Version, VersionLine
from fieldspec.targets.docs.context import Context, cited
from fieldspec.targets.docs.document import (
    DocumentTable,
    Facts,
    Line,
    Paragraph,
    Section,
    TableColumn,
    TableRow,
    cell,
    code,
    joined,
    label,
    styled,
    table,
    text_piece,
)
from fieldspec.targets.fact_texts import number_text

VERSIONS = (TableColumn("Version"), TableColumn("Description"), TableColumn("Source"))


def identity(context: Context) -> Section:
    """The device, its manual and its versions."""
    device = context.device
    blocks: list[Paragraph | Facts | DocumentTable] = []
    if device.doc:
        blocks.append(Paragraph((text_piece(device.doc),)))
    blocks.append(Facts(tuple(_facts(context))))
    for line in device.lines:
        blocks.append(_versions(line, device.version))
        if line.detected_by is not None:
            blocks.append(Paragraph(_detection(line.detected_by)))
    return Section("device", (text_piece("Device and manual"),), tuple(blocks))


def _facts(context: Context) -> Iterator[tuple[str, tuple[Line, ...]]]:
    device, manual = context.device, context.device.manual
    yield "Device", ((text_piece(f"{device.vendor} {device.name}, "), code(device.id)),)
    yield "Version", ((text_piece(version_title(device)),),)
    remark = text_piece(": the same in all outputs with the same bytes on the wire")
    yield "Identity", ((code(context.layout.identity), remark),)
    yield "Manual", ((label(manual.title),),)
    if manual.edition:
        yield "Edition", ((label(manual.edition),),)
    if manual.language:
        yield "Language", ((code(manual.language),),)
    name, _, extent = manual.extent.partition(", ")
    own = f" and its {manual.unit}" if manual.unit else ""
    yield "Text", ((code(name), text_piece(f", {extent}; a source is a section{own}")),)
    if manual.sha256:
        yield "SHA-256", ((code(manual.sha256),),)


def version_title(device: Device) -> str:
    """`version 2.0`, or the version alone where the device declares no versions."""
    return f"version {device.version}" if device.lines else device.version


def _versions(line: VersionLine, present: str) -> DocumentTable:
    caption = line.title or line.name
    return table(caption, VERSIONS, [_version(version, present) for version in line.versions])


def _detection(detection: Detection) -> Line:
    """The value that identifies the version, the interpretation of its number, and its source."""
    texts = [number_text(detection), detection.doc]
    if detection.inferred:
        texts.append(f"Inferred: {detection.inferred}")
    remark = " ".join(text for text in texts if text)
    return (
        text_piece("The device tells its version in "),
        code(detection.fact, f"#{detection.fact}"),
        text_piece(f". {remark} " if remark else ". "),
        *cited(detection.sources),
    )


def _version(version: Version, present: str) -> TableRow:
    badge: Line = (text_piece(" "), styled("this page", "badge")) if version.id == present else ()
    doc: list[Line] = [(text_piece(text),) for text in (version.title, version.doc) if text]
    if version.inferred:
        doc.append((styled("inferred: ", "strong"), text_piece(version.inferred)))
    if version.detected_as:
        values = joined((code(str(item)),) for item in version.detected_as)
        doc.append((text_piece("Detected as "), *values))
    return TableRow((cell((code(version.id), *badge)), cell(*doc), cell(cited(version.sources))))
