"""The files of the documentation."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.docs import markdown
from fieldspec.backends.docs.document import Document
from fieldspec.backends.docs.page import page
from fieldspec.backends.docs.versions import versions
from fieldspec.backends.templates import fill
from fieldspec.layout.device import DeviceLayout


def files(layouts: Sequence[DeviceLayout]) -> dict[str, str]:
    """The pages of all versions of one device, the oldest first, and the lists of these versions, by path."""
    folder = layouts[-1].device.id
    texts = {
        f"{folder}/index.html": _html(versions(layouts, ".html")),
        f"{folder}/README.md": _markdown(versions(layouts, ".md")),
    }
    for layout in layouts:
        made = page(layout)
        texts[f"{folder}/{layout.device.version}.html"] = _html(made)
        texts[f"{folder}/{layout.device.version}.md"] = _markdown(made)
    return texts


def shared() -> dict[str, str]:
    """No file: every page holds all that it needs."""
    return {}


def _html(document: Document) -> str:
    return fill("docs/page.html.j2", page=document)


def _markdown(document: Document) -> str:
    return fill(
        "docs/page.md.j2",
        title=markdown.escaped(document.title),
        subtitle=markdown.escaped(document.subtitle),
        identity=document.identity,
        summary=[markdown.line(held) for held in document.summary],
        contents=markdown.contents(document),
        parts=markdown.parts(document),
    )
