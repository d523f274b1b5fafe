"""Fills forms: texts with a place for everything that is worked out, `${name}`.

A form has no loops, so that nothing but the standard library is loaded for it, which takes a tenth of the time of
templates. What is repeated is written before, and stands in one place.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from string import Template

_PACKAGE = Path(__file__).resolve().parent.parent


def filled(form: str, **texts: object) -> str:
    """The text of a form, given by its path in the package. Raises KeyError for a place that nothing is given for."""
    return Template(text(form)).substitute(texts)


@cache
def text(path: str) -> str:
    """The text of a file that stands in an output as it is, by its path in the package."""
    return _PACKAGE.joinpath(path).read_text("utf-8")
