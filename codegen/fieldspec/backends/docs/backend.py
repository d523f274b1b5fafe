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
    held = steps(layouts)
    holding = Holding(layouts)
    pages = {layout.device.version: page(layout, holding) for layout in layouts}
    texts = _index(layouts, held, ())
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


def index(layouts: Sequence[DeviceLayout], beside: Sequence[tuple[str, str]]) -> dict[str, str]:
    """The lists of versions alone, which also lead to other pages: what each is, and its file."""
    return _index(layouts, steps(layouts), beside)


def _index(layouts: Sequence[DeviceLayout], held: Sequence[Step], beside: Sequence[tuple[str, str]]) -> dict[str, str]:
    folder = layouts[-1].device.id
    return {
        f"{folder}/index.html": html.page(versions(layouts, held, ".html", beside)),
        f"{folder}/README.md": markdown.page(versions(layouts, held, ".md", beside)),
    }


def _leading(made: Document, version: str, ending: str) -> Document:
    """A page that leads to what has changed with its version."""
    return replace(made, summary=(*made.summary, (text_piece("what has changed", link(version, ending)),)))


def shared() -> dict[str, str]:
    """No file: every page holds all that it needs."""
    return {}
