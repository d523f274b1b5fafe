"""The index of all devices, made of the search data of each."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, cast

from fieldspec.targets.docs import html, markdown, search_index
from fieldspec.targets.docs.document import (
    Document,
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
    TableColumn("What it is", "wide"),
    TableColumn("Versions, the newest first"),
    TableColumn("The newest has"),
    TableColumn("Frame lab", unbroken=True),
    TableColumn("Identity", unbroken=True),
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
    text = (
        "fieldspec has written these pages from the manuals of the devices; every fact has its section and line there. "
        "Open a device for its registers, messages, parameters and codes, or its lab to explain a frame."
    )
    blocks = (Paragraph((text_piece(text),)), table("Devices", COLUMNS, rows))
    return Document("Devices", "", "", "", (), (Section("devices", (text_piece("All devices"),), blocks),))


def _device_row(device: dict[str, Any], labs: set[str], ending: str, index: str) -> TableRow:
    folder, pages = device["id"], device["pages"]
    versions = joined((text_piece(version, f"{folder}/{page}{ending}"),) for page, version, _ in pages)
    return TableRow(
        (
            cell(text_piece(device["name"], f"{folder}/{index}")),
            cell(device["title"]),
            cell(versions),
            cell(pages[0][2]),
            cell(text_piece(f"Lab of {device['name']}", f"{folder}/lab.html") if folder in labs else text_piece("")),
            cell(code(device["identity"])),
        ),
        f"devices/{folder}",
    )
