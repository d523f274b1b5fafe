"""Fills templates. The only module that knows jinja2."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import jinja2

_FOLDERS = ("backends", "render")


@lru_cache(maxsize=1)
def _environment() -> jinja2.Environment:
    return jinja2.Environment(
        loader=jinja2.ChoiceLoader([jinja2.PackageLoader("fieldspec", folder) for folder in _FOLDERS]),
        undefined=jinja2.StrictUndefined,
        autoescape=lambda name: name is not None and name.endswith(".html.j2"),
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )


def fill(template: str, **view: Any) -> str:
    """The text of a template, given by its path below `backends/` or `render/`, over a view of computed values."""
    return _environment().get_template(template).render(**view)


def prepare() -> None:
    """Compiles all templates, so that nobody waits for it later."""
    for name in _environment().list_templates(["j2"]):
        _environment().get_template(name)
