"""The documentation of all devices, the real and the made-up ones, for the tests of it."""

from __future__ import annotations

import posixpath
import re
from collections import Counter
from functools import cache
from xml.etree.ElementTree import Element

import lxml.html

from fieldspec.targets.docs.backend import files, overview, shared
from layouts import SPECS, TEST_SPECS, layouts
from shared_results import shared as shared_by_all

PARSER = lxml.html.HTMLParser(encoding="utf-8")
"""It takes a fiftieth of the time that html5lib takes."""


@cache
def documentation() -> dict[str, str]:
    """The texts of the documentation by path."""
    return shared_by_all("documentation", _documentation)


def _documentation() -> dict[str, str]:
    texts = {
        path: text
        for root in (SPECS, TEST_SPECS)
        for versions in layouts(root).values()
        for path, text in files(versions).items()
    }
    return texts | shared() | overview(texts, texts.__getitem__)


@cache
def tree(path: str) -> Element:
    """The tree of a page; that it is the one that browsers make of it is a test of its own."""
    root: Element = lxml.html.document_fromstring(documentation()[path].encode(), parser=PARSER)
    return root


@cache
def anchors(path: str) -> Counter[str]:
    """How often each anchor is on a page."""
    return Counter(node.get("id", "") for node in tree(path).iter() if node.get("id"))


def resolved(page: str, link: str) -> str:
    """The path of the page that a link on another page leads to."""
    return posixpath.normpath(posixpath.join(posixpath.dirname(page), link))


def with_ending(ending: str) -> list[str]:
    """The paths of the pages of one form."""
    return [path for path in documentation() if path.endswith(ending)]


def visible_text(text: str) -> str:
    """Text as a page shows it: blanks in one, and pictures for what controls a terminal or the order of letters."""
    text = re.sub(r"\s+", " ", text).strip()
    text = re.sub(r"[\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]", "\ufffd", text)
    return re.sub(r"[\x00-\x1f]", lambda match: chr(0x2400 + ord(match[0])), text)
