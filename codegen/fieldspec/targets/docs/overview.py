"""The index of all devices, made of the search data of each."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, cast

from fieldspec.targets.docs import html, markdown, search_index
from fieldspec.targets.docs.document import (
    Document,
    Facts,
    Paragraph,
    Section,
    TableColumn,
    TableRow,
    cell,
    code,
    joined,
    table,
    text_piece,
)
from fieldspec.targets.docs.site import PagePlace

COLUMNS = (
    TableColumn("Device", unbroken=True),
    TableColumn("Vendor", unbroken=True),
    TableColumn("Type", "wide"),
    TableColumn("Reference, newest version first", unbroken=True),
    TableColumn("Contents"),
    TableColumn("Decode a frame", unbroken=True),
    TableColumn("Identity", unbroken=True),
)
SUBTITLE = "Protocol reference of motion controllers, generated from their manuals"
ABOUT = (
    "fieldspec compiles a transcription of each manual into codecs for Python, C and JavaScript, into PLC code, and "
    "into these pages. Every fact names its section and line in the manual."
)
USES = (
    ("A model name", "Open its reference in the table below. The device's name leads to all its versions."),
    ("An address, a name, an alarm", "Type it into the search box, which searches all devices."),
    ("Recorded bytes", "Open the device's frame lab and paste them. The lab explains each byte."),
)
_ENDINGS = (".html", ".md")
_INDEXES = ("index.html", "README.md")


def overview(paths: Iterable[str], content: Callable[[str], str]) -> dict[str, str]:
    """The indexes by path. `paths` are the files of all devices; `content` is the text of one of them."""
    paths = list(paths)
    sources = sorted(path for path in paths if path.count("/") == 1 and path.endswith(f"/{search_index.NAME}"))
    devices = [cast("dict[str, Any]", search_index.parsed(content(path))) for path in sources]
    if not devices:
        return {}
    place = PagePlace("", tuple(sources))
    labs = {path.partition("/")[0] for path in paths if path.endswith("/lab.html")}
    documents = [_document(devices, labs, ending, index) for ending, index in zip(_ENDINGS, _INDEXES, strict=True)]
    return {"index.html": html.page(documents[0], place), "README.md": markdown.page(documents[1])}


def _document(devices: Iterable[dict[str, Any]], labs: set[str], ending: str, index: str) -> Document:
    rows = [_device_row(device, labs, ending, index) for device in devices]
    uses = Facts(tuple((case, ((text_piece(advice),),)) for case, advice in USES))
    sections = (
        Section("start", (text_piece("What do you have?"),), (Paragraph((text_piece(ABOUT),)), uses)),
        Section("devices", (text_piece("Devices"),), (table("Devices", COLUMNS, rows),)),
    )
    return Document("fieldspec", SUBTITLE, "", "", (), sections)


def _device_row(device: dict[str, Any], labs: set[str], ending: str, index: str) -> TableRow:
    folder, pages = device["id"], device["pages"]
    name = device["name"]
    versions = joined((text_piece(f"{name} {version}", f"{folder}/{page}{ending}"),) for page, version, _ in pages)
    return TableRow(
        (
            cell(text_piece(name, f"{folder}/{index}")),
            cell(device["vendor"]),
            cell(device["title"]),
            cell(versions),
            cell(pages[0][2]),
            cell(text_piece(f"{name} frame lab", f"{folder}/lab.html") if folder in labs else text_piece("")),
            cell(code(device["identity"])),
        ),
        f"devices/{folder}",
    )
