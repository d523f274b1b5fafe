"""Fills templates. The only module that knows jinja2, and loads it for the first template."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import fieldspec
from fieldspec.foundation.html_text import clean

if TYPE_CHECKING:
    import jinja2
    from jinja2.bccache import Bucket

Load = Callable[[str], bytes | None]
Store = Callable[[str, bytes], None]

_PACKAGE = Path(fieldspec.__file__).resolve().parent
_FOLDERS = ("targets", "command/rendering")
_stores: list[tuple[Load, Store]] = []


def fill(template: str, **view: Any) -> str:
    """The text of a template, given by its path below one of `_FOLDERS`, over a view of computed values.

    Raises `jinja2.UndefinedError` for a name that the view does not have.
    """
    return _environment().get_template(template).render(**view)


@cache
def text(path: str) -> str:
    """The text of a file that stands in an output unchanged, by its path in the package."""
    return _PACKAGE.joinpath(path).read_text("utf-8")


@cache
def style_sheet(*paths: str) -> str:
    """Style sheets of the package as one, without the blanks that only their authors need."""
    return re.sub(r"\s*([{};])\s*|([:,])\s+", r"\1\2", "".join(map(text, paths)))


def use_cache(load: Load, store: Store) -> None:
    """Keeps compiled templates from run to run: `load` returns what `store` has stored under a name, or None.

    Only the user may be able to write to the store, because what it returns is executed.
    """
    _stores[:] = [(load, store)]


def prepare() -> None:
    """Compiles all templates ahead of their first use."""
    for name in _environment().list_templates(["j2"]):
        _environment().get_template(name)


@cache
def _environment() -> jinja2.Environment:
    import jinja2

    class Compiled(jinja2.BytecodeCache):
        """Compiled templates of earlier runs; none without a store.

        Jinja refuses bytecode of another source or Python. The name of an entry has the version of Jinja in it, whose
        compiler changes without the format of its bytecode.
        """

        def load_bytecode(self, bucket: Bucket) -> None:
            content = next((load(bucket.key) for load, _ in _stores), None)
            if content is not None:
                bucket.bytecode_from_string(content)

        def dump_bytecode(self, bucket: Bucket) -> None:
            for _, store in _stores:
                store(bucket.key, bucket.bytecode_to_string())

        def get_cache_key(self, name: str, filename: str | None = None) -> str:
            return f"jinja2 {jinja2.__version__} {name} {filename}"

    environment = jinja2.Environment(
        loader=jinja2.ChoiceLoader([jinja2.PackageLoader("fieldspec", folder) for folder in _FOLDERS]),
        undefined=jinja2.StrictUndefined,
        autoescape=lambda name: name is not None and name.endswith(".html.j2"),
        bytecode_cache=Compiled(),
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters["clean"] = clean
    return environment
