"""What makes pages a site: where each stands, its scripts, and what it may load. `site.html.j2` has the rest."""

from __future__ import annotations

from base64 import b64encode
from hashlib import sha256
from urllib.parse import quote

from fieldspec.foundation.classes import dataclass
from fieldspec.targets.docs import search_index

SCRIPTS = ("search.js", "tables.js", "facts.js", "compare.js")
"""The scripts of all pages, copied as they are."""


@dataclass(frozen=True, slots=True)
class PagePlace:
    """The place of a page: its path to the top folder, the index of its search, and its name in that index.

    `page` is the name of a version's page, else empty. `parents` are the links above it, by their texts. `versions` are
    all versions of the device on the page of one, the newest first.
    """

    top: str
    sources: tuple[str, ...]
    page: str = ""
    parents: tuple[tuple[str, str], ...] = ()
    versions: tuple[str, ...] = ()


def device_place(
    device: str, page: str = "", is_index: bool = False, has_lab: bool = False, versions: tuple[str, ...] = ()
) -> PagePlace:
    """The place of a page of a device, by the device's name; it leads to the frame lab if the device has one."""
    parents: tuple[tuple[str, str], ...] = (("All devices", "../index.html"),)
    parents = parents if is_index else (*parents, (device, "index.html"))
    lab = (("Frame lab", f"lab.html#version={quote(page)}" if page else "lab.html"),) if has_lab else ()
    return PagePlace("../", (search_index.NAME,), page, (*parents, *lab), versions)


def policy(style: str, scripts: bool) -> str:
    """The Content-Security-Policy of a page with one style sheet in it: only that, and its scripts."""
    digest = b64encode(sha256(style.encode("utf-8")).digest()).decode("ascii")
    sources = {
        "default-src": "'none'",
        "style-src": f"'sha256-{digest}'",
        "script-src": "'self'" if scripts else "",
        "img-src": "data:",
        "base-uri": "'none'",
        "form-action": "'none'",
    }
    return "; ".join(f"{name} {source}" for name, source in sources.items() if source)
