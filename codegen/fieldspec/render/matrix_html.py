"""A matrix of facts by versions as an HTML page."""

from __future__ import annotations

from fieldspec.backends.templates import fill
from fieldspec.facts.matrix import SAME, Matrix
from fieldspec.html_text import clean


def rendered(device: str, matrix: Matrix) -> str:
    """The page; marks cells of facts that a version does not have, and of facts that change with a version."""
    return fill("matrix.html.j2", title=clean(f"{device}: facts by versions"), matrix=matrix, same=SAME)
