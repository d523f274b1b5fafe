"""A matrix of facts by versions as an HTML page."""

from __future__ import annotations

from fieldspec.facts.matrix import SAME, Matrix
from fieldspec.html_text import clean, escaped

_STYLE = (
    "body{font:14px/1.4 system-ui,sans-serif;margin:2rem}table{border-collapse:collapse}"
    "th,td{border:1px solid #ccc;padding:.2rem .5rem;text-align:left;vertical-align:top}"
    "thead th{position:sticky;top:0;background:#f4f4f4}"
    ".same{color:#888}.gone{background:#f9ecec}.new{background:#eaf6ea}"
)


def rendered(device: str, matrix: Matrix) -> str:
    """The page; marks cells of facts that a version does not have, and of facts that change with a version."""
    title = _visible(f"{device}: facts by versions")
    head = "".join(f"<th scope=col>{_visible(name)}</th>" for name in ("fact", *matrix.versions))
    rows = "".join(
        f"<tr><th scope=row>{_visible(row.path)}</th>{''.join(map(_cell, row.cells))}</tr>\n" for row in matrix.rows
    )
    return (
        f'<!doctype html>\n<html lang="en">\n<head><meta charset="utf-8"><title>{title}</title>'
        f"<style>{_STYLE}</style></head>\n<body><h1>{title}</h1>\n"
        f"<table><thead><tr>{head}</tr></thead>\n<tbody>\n{rows}</tbody></table>\n</body></html>\n"
    )


def _visible(text: str) -> str:
    return escaped(clean(text))


def _cell(text: str) -> str:
    kind = "gone" if not text else "same" if text == SAME else "new"
    return f"<td class={kind}>{_visible(text)}</td>"
