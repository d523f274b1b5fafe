"""The files of the documentation."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from fieldspec.backends import PageLink
from fieldspec.backends.docs import html, markdown
from fieldspec.backends.docs.changes import NAME, changed, link, page_name, steps, versions
from fieldspec.backends.docs.context import Holding
from fieldspec.backends.docs.document import Document, every, headings, text_piece
from fieldspec.backends.docs.page import page
from fieldspec.classes import replace
from fieldspec.layout.device import DeviceLayout

_ANCHOR = re.compile(r' id="([^"]+)"')


def files(layouts: Sequence[DeviceLayout], links: Sequence[PageLink] = ()) -> dict[str, str]:
    """The pages of all versions of one device, the oldest first, their indexes, and what has changed, by path.

    The indexes also have `links` to other pages of the device. A device of one version has no page of changes.
    """
    folder = layouts[-1].device.id
    held = steps(layouts)
    holding = Holding(layouts)
    pages = {layout.device.version: page(layout, holding) for layout in layouts}
    texts = {
        f"{folder}/index.html": html.page(versions(layouts, held, ".html", links)),
        f"{folder}/README.md": markdown.page(versions(layouts, held, ".md", links)),
    }
    if held:
        rows = {version: frozenset(every(made.sections)) for version, made in pages.items()}
        sections = {version: frozenset(headings(made.sections)) for version, made in pages.items()}
        texts[f"{folder}/{NAME}.html"] = html.page(changed(held, ".html", rows))
        texts[f"{folder}/{NAME}.md"] = markdown.page(changed(held, ".md", sections))
    came_by = {step.new.device.version for step in held}
    for version, made in pages.items():
        name = page_name(version)
        fresh = version in came_by
        texts[f"{folder}/{name}.html"] = html.page(_leading(made, version, ".html") if fresh else made)
        texts[f"{folder}/{name}.md"] = markdown.page(_leading(made, version, ".md") if fresh else made)
    return texts


def fact_links(layout: DeviceLayout, contents: Mapping[str, bytes]) -> dict[str, str]:
    """Links to the facts of a version from another page of its folder, by the paths of facts.

    `contents` are the files of the documentation by path below the folder of all outputs.
    """
    name = f"{page_name(layout.device.version)}.html"
    text = contents[f"docs/{layout.device.id}/{name}"].decode("utf-8")
    return {path: f"{name}#{path}" for path in _ANCHOR.findall(text) if "/" in path}


def _leading(made: Document, version: str, ending: str) -> Document:
    """A page that leads to what has changed with its version."""
    return replace(made, summary=(*made.summary, (text_piece("what has changed", link(version, ending)),)))


def shared() -> dict[str, str]:
    """No file: every page holds all that it needs."""
    return {}
