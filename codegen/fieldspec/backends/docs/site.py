"""What makes pages a site: the search box, the scripts, the way up, and what a page may load."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Sequence
from hashlib import sha256
from urllib.parse import quote

from fieldspec.backends.docs import search_index
from fieldspec.classes import dataclass
from fieldspec.html_text import escaped

SCRIPTS = ("search.js", "tables.js", "facts.js", "compare.js")
"""The scripts of all pages, copied as they are."""

PLACEHOLDER = "address, name, label, code"


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
    """The Content-Security-Policy of a page with one style sheet in it: nothing but that, and scripts beside it."""
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


def panel(place: PagePlace) -> str:
    """The way up and the search box, which is hidden where no script runs."""
    ways = "".join([f'<a href="{escaped(link)}">{escaped(text)}</a>' for text, link in place.parents])
    return (
        (f'<p class="parents">{ways}</p>\n' if ways else "")
        + f'<div id="search" data-sources="{escaped(" ".join(place.sources))}" data-page="{escaped(place.page)}"'
        + ' role="search" hidden>\n<label for="query">Search <kbd>/</kbd></label>\n'
        + f'<input id="query" type="search" autocomplete="off" spellcheck="false" placeholder="{PLACEHOLDER}">\n'
        + '<p id="found" role="status"></p>\n<ul id="results" aria-label="Results" hidden></ul>\n</div>\n'
        + _menu(place)
    )


def _menu(place: PagePlace) -> str:
    """The choice of a version to compare with, which is hidden where no script runs."""
    if len(place.versions) < 2:
        return ""
    options = "".join(
        [f'<option value="{number}">{escaped(name)}</option>' for number, name in enumerate(place.versions)]
    )
    return (
        '<p class="menu" hidden><label for="versions">Compare with</label>\n'
        + f'<select id="versions"><option value="">no other version</option>{options}</select></p>\n'
    )


def scripts(place: PagePlace, names: Sequence[str] = SCRIPTS) -> str:
    """The elements that load the scripts."""
    return "".join([f'<script src="{escaped(place.top + name)}" defer></script>\n' for name in names])
