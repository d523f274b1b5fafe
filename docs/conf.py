"""How the pages of this folder become a site. See CONTRIBUTING.md, `make docs-site`."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "generated" / "python"))

project = "fieldspec"
author = "The fieldspec authors"
extensions = ["myst_parser", "sphinx.ext.autodoc"]
root_doc = "index"
myst_heading_anchors = 4
html_theme = "furo"
html_title = "fieldspec"
html_static_path = ["images/figures.css"]
html_css_files = ["figures.css"]
html_copy_source = False
html_show_sourcelink = False
html_show_copyright = False
html_show_sphinx = False
html_show_search_summary = False  # which would fetch pages, and a browser forbids that for files
highlight_language = "none"
default_role = "code"
autodoc_typehints = "signature"
autodoc_member_order = "bysource"

_OUTSIDE = re.compile(r"\[([^\]]+)\]\(\.\./[^)]*\)")


def _without_links_to_the_repository(app: Any, page: str, source: list[str]) -> None:
    """Leaves out links to files outside this folder, which the site does not have."""
    source[0] = _OUTSIDE.sub(r"\1", source[0])


def setup(app: Any) -> None:
    """Adds what pages need: the links that lead out, and the languages that no highlighter knows, as bare text."""
    from pygments.lexers.special import TextLexer

    app.connect("source-read", _without_links_to_the_repository)
    for language in ("iecst", "scl"):
        app.add_lexer(language, TextLexer)
