"""A matrix of facts by versions as an HTML page."""

from __future__ import annotations

from fieldspec.foundation.html_text import clean
from fieldspec.targets.templates import fill
from fieldspec.tools.facts.matrix import SAME, Matrix


def rendered(device: str, matrix: Matrix) -> str:
    """The page; marks cells of facts that a version does not have, and of facts that change with a version."""
    return fill("matrix.html.j2", title=clean(f"{device}: facts by versions"), matrix=matrix, same=SAME)
