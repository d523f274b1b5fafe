"""How programs use what an output generates: code to copy, by the paths of facts."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any, NamedTuple

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_exact, is_real, is_truth
from fieldspec.language.model.enums import Enum, Member
from fieldspec.language.model.value import Value


class Usage(NamedTuple):
    """Code that reads or writes a fact. `@0@`, `@1@` in the template are the arguments, `@name@` the variables."""

    fact: str
    template: str
    arguments: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class VersionUsages:
    """The code for one version of a device in one language. `variables` differ from version to version.

    Templates and arguments do not, wherever the names of the versions are the same; versions then share their code.
    """

    language: str
    variables: dict[str, str]
    rows: tuple[Usage, ...]


Rows = tuple[Usage, ...]
Spellings = dict[str, dict[str, Rows]]
"""The code for a device, by output and version, as far as it is spelled."""

_at_hand: list[Spellings] = []


@contextmanager
def using(spellings: Spellings | None) -> Iterator[None]:
    """Meanwhile, code is taken from these, and what is not there is kept in them; for None, nothing is kept."""
    _at_hand[:] = [spellings] if spellings is not None else []
    try:
        yield
    finally:
        _at_hand.clear()


def spelling(output: str, layout: DeviceLayout, spell: Callable[[], Iterable[Usage]]) -> Rows:
    """The code of an output for a version: what is kept of it, or else what `spell` gives.

    Both are equal: a project that chooses blocks changes no code for facts.
    """
    if not _at_hand:
        return tuple(spell())
    rows = _at_hand[0].setdefault(output, {})
    version = layout.device.version
    if version not in rows:
        rows[version] = tuple(spell())
    return rows[version]


def cache_spelling(output: str, layout: DeviceLayout, spell: Callable[[], Iterable[Usage]]) -> Rows:
    """Spells the code for a version where its output is built and the names are known.

    Returns the code if a build keeps it, else nothing.
    """
    return spelling(output, layout, spell) if _at_hand else ()


def restore_spelling(output: str, layout: DeviceLayout, rows: Rows) -> None:
    """Keeps code that was spelled when the same output was built before."""
    if rows:
        cache_spelling(output, layout, rows.__iter__)


def stored_text(versions: Mapping[str, Rows]) -> bytes:
    """The code of an output by version as JSON: a list of all templates, then rows of a fact, a template, arguments."""
    templates: dict[str, int] = {}
    data = {
        version: [[row.fact, templates.setdefault(row.template, len(templates)), *row.arguments] for row in rows]
        for version, rows in versions.items()
    }
    return json.dumps([[*templates], data], separators=(",", ":")).encode()


def from_stored(content: bytes) -> dict[str, Rows]:
    """The code of an output by version. Raises ValueError for a content that no `stored_text` has made."""
    try:
        templates, versions = json.loads(content)
        return {version: tuple(_stored_row(row, templates) for row in rows) for version, rows in versions.items()}
    except (TypeError, AttributeError, IndexError, RecursionError):
        raise ValueError("the content has a different shape") from None


def _stored_row(row: Any, templates: list[str]) -> Usage:
    fact, number, *arguments = row
    usage = Usage(fact, templates[number], tuple(arguments))
    if not all(isinstance(text, str) for text in (fact, usage.template, *arguments)):
        raise TypeError("not a text")
    return usage


def sample_count(value: Value, device: Device) -> int | None:
    """A raw value that may be written; None for texts, bytes and floating-point numbers."""
    if not is_exact(value.encoding):
        return None
    if value.const is not None:
        return value.const
    ranges = value.writable_ranges
    enum = device.enums.get(value.enum)
    if enum is not None:
        for member in enum.members:
            if not member.unavailable and (ranges is None or member.value in ranges):
                return member.value
    if isinstance(value.default, int) and (ranges is None or value.default in ranges):
        return value.default
    return 0 if ranges is None or 0 in ranges else ranges.low


def sample_text(
    value: Value, device: Device, member_text: Callable[[Enum, Member], str], number_text: Callable[[int], str]
) -> str:
    """An expression of a language with braces that may be written; empty where there is none, and for constants.

    `member_text` gives the constant of a member of an enum, `number_text` the literal of a whole number.
    """
    if is_real(value.encoding):
        return "0" if value.ranges is None or 0 in value.ranges else str(value.ranges.low)
    if value.const is not None:
        return ""
    if is_truth(value.encoding):
        return "true" if value.ranges is None or 1 in value.ranges else "false"
    count = sample_count(value, device)
    if count is None:
        return ""
    enum = device.enums.get(value.enum)
    for member in enum.members if enum is not None else ():
        if enum is not None and member.value == count and not member.unavailable:
            return member_text(enum, member)
    return number_text(count)
