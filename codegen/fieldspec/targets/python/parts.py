"""Large modules in parts: what Python compiles at once takes sixty times the memory of its text."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from functools import lru_cache

MOST = 400_000
"""The most characters of classes and registers in a module. Longer texts are divided into parts of this size."""

_DEFINED = re.compile(r"^class (\w+)\(|^(\w+): _Final = ", re.MULTILINE)
_BETWEEN_WORDS = {code: " " for code in range(128) if not (chr(code).isalnum() or chr(code) == "_")}


def divided(texts: Sequence[str]) -> list[str]:
    """Texts of a module as parts of `MOST` characters or a little more; none where one module has room for them."""
    if sum(map(len, texts)) <= MOST:
        return []
    return ["".join(part) for part in _parts(texts)]


def _parts(texts: Iterable[str]) -> Iterator[list[str]]:
    part: list[str] = []
    size = 0
    for text in texts:
        part.append(text)
        size += len(text)
        if size >= MOST:
            yield part
            part, size = [], 0
    if part:
        yield part


@lru_cache(maxsize=128)
def defined_names(text: str) -> tuple[str, ...]:
    """The names of the classes, tables and registers of a part. Most parts are the same in the next build."""
    return tuple(sorted({match[1] or match[2] for match in _DEFINED.finditer(text)}))


def all_words(text: str) -> frozenset[str]:
    """The words of a text, among which are all names that it uses."""
    return frozenset(text.translate(_BETWEEN_WORDS).split())


words_of = lru_cache(maxsize=128)(all_words)
"""The words of a part."""


def part_imports(places: Mapping[str, str], words: AbstractSet[str]) -> list[str]:
    """The imports of the names among some words; `places` has the part in which each name is defined."""
    names_by_part: dict[str, list[str]] = {}
    for name in sorted(places.keys() & words):
        names_by_part.setdefault(places[name], []).append(name)
    return [
        "\n".join([f"from .{part} import (", *(f"    {name}," for name in names), ")"])
        for part, names in names_by_part.items()
    ]
