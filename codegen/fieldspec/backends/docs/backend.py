"""The files of the documentation."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.docs import html, markdown
from fieldspec.backends.docs.changes import NAME, Step, changed, link, page_name, steps, versions
from fieldspec.backends.docs.context import Holding
from fieldspec.backends.docs.document import Document, every, headings, text_piece
from fieldspec.backends.docs.page import page
from fieldspec.classes import replace
from fieldspec.layout.device import DeviceLayout


def files(layouts: Sequence[DeviceLayout]) -> dict[str, str]:
    """The pages of all versions of one device, the oldest first, the lists of these versions, and what has changed.

    A device of one version has no page of changes.
    """
    folder = layouts[-1].device.id
    device_steps = steps(layouts)
    holding = Holding(layouts)
    pages = {layout.device.version: page(layout, holding) for layout in layouts}
    texts = _index(layouts, device_steps, ())
    if device_steps:
        rows = {version: frozenset(every(document.sections)) for version, document in pages.items()}
        sections = {version: frozenset(headings(document.sections)) for version, document in pages.items()}
        texts[f"{folder}/{NAME}.html"] = html.page(changed(device_steps, ".html", rows))
        texts[f"{folder}/{NAME}.md"] = markdown.page(changed(device_steps, ".md", sections))
    came_by = {step.new.device.version for step in device_steps}
    for version, document in pages.items():
        name = page_name(version)
        fresh = version in came_by
        texts[f"{folder}/{name}.html"] = html.page(_leading(document, version, ".html") if fresh else document)
        texts[f"{folder}/{name}.md"] = markdown.page(_leading(document, version, ".md") if fresh else document)
    return texts


def index(layouts: Sequence[DeviceLayout], beside: Sequence[tuple[str, str]]) -> dict[str, str]:
    """The lists of versions alone, which also lead to other pages: what each is, and its file."""
    return _index(layouts, steps(layouts), beside)


def _index(
    layouts: Sequence[DeviceLayout], device_steps: Sequence[Step], beside: Sequence[tuple[str, str]]
) -> dict[str, str]:
    folder = layouts[-1].device.id
    return {
        f"{folder}/index.html": html.page(versions(layouts, device_steps, ".html", beside)),
        f"{folder}/README.md": markdown.page(versions(layouts, device_steps, ".md", beside)),
    }


def _leading(document: Document, version: str, ending: str) -> Document:
    """A page that leads to what has changed with its version."""
    return replace(document, summary=(*document.summary, (text_piece("what has changed", link(version, ending)),)))


def shared() -> dict[str, str]:
    """No file: every page holds all that it needs."""
    return {}
