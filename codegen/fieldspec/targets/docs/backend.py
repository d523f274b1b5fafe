"""The files of the documentation."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import replace
from fieldspec.foundation.html_text import clean
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.targets import PageLink
from fieldspec.targets.docs import fact_index, html, lab, markdown, search_index
from fieldspec.targets.docs.changes import NAME, changed, link, page_name, steps, versions
from fieldspec.targets.docs.context import Holding
from fieldspec.targets.docs.document import Document, every, headings, text_piece
from fieldspec.targets.docs.overview import overview as overview
from fieldspec.targets.docs.page import page
from fieldspec.targets.docs.site import SCRIPTS, device_place
from fieldspec.targets.templates import text

_ANCHOR = re.compile(r' id="([^"]+)"')


def refusals(layouts: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """The warnings of what the frame lab does not read. Pages say everything else."""
    return [*lab.refusals(layouts)]


def files(layouts: Sequence[DeviceLayout], links: Sequence[PageLink] = ()) -> dict[str, str]:
    """The pages of all versions of one device, the oldest first, their indexes, what has changed, and the search data.

    The indexes also have `links` to other pages of the device. A device of one version has no page of changes.
    """
    folder = layouts[-1].device.id
    device_steps = steps(layouts)
    holding = Holding(layouts)
    pages = {layout.device.version: page(layout, holding) for layout in layouts}
    title = clean(layouts[-1].device.name)
    has_lab = lab.has_lab(layouts)
    index = device_place(title, is_index=True, has_lab=has_lab)
    texts = {
        f"{folder}/index.html": html.page(versions(layouts, device_steps, ".html", links), index),
        f"{folder}/README.md": markdown.page(versions(layouts, device_steps, ".md", links)),
        f"{folder}/{search_index.NAME}": search_index.index_file(layouts, pages),
        f"{folder}/{fact_index.NAME}": fact_index.fact_file(layouts, device_steps),
    }
    if device_steps:
        rows = {version: frozenset(every(document.sections)) for version, document in pages.items()}
        sections = {version: frozenset(headings(document.sections)) for version, document in pages.items()}
        texts[f"{folder}/{NAME}.html"] = html.page(
            changed(device_steps, ".html", rows), device_place(title, has_lab=has_lab)
        )
        texts[f"{folder}/{NAME}.md"] = markdown.page(changed(device_steps, ".md", sections))
    names = tuple(layout.device.version for layout in reversed(layouts))
    came_by = {step.new.device.version for step in device_steps}
    for version, document in pages.items():
        name = page_name(version)
        fresh = version in came_by
        place = device_place(title, name, has_lab=has_lab, versions=names)
        texts[f"{folder}/{name}.html"] = html.page(_leading(document, version, ".html") if fresh else document, place)
        texts[f"{folder}/{name}.md"] = markdown.page(_leading(document, version, ".md") if fresh else document)
    return texts | lab.files(layouts, device_place(title)) if has_lab else texts


def fact_links(layout: DeviceLayout, contents: Mapping[str, bytes]) -> dict[str, str]:
    """Links to the facts of a version from another page of its folder, by the paths of facts.

    `contents` are the files of the documentation by path below the folder of all outputs.
    """
    name = f"{page_name(layout.device.version)}.html"
    page_text = contents[f"docs/{layout.device.id}/{name}"].decode("utf-8")
    return {path: f"{name}#{path}" for path in _ANCHOR.findall(page_text) if "/" in path}


def _leading(document: Document, version: str, ending: str) -> Document:
    """A page that leads to what has changed with its version."""
    return replace(document, summary=(*document.summary, (text_piece("what has changed", link(version, ending)),)))


def shared() -> dict[str, str]:
    """The scripts of all pages, as they are, and that of the labs. Pages say everything without them, too."""
    return {name: text(f"targets/docs/{name}") for name in SCRIPTS} | {lab.SCRIPT: lab.lab_script()}
