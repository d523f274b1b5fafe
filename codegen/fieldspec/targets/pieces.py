"""What outputs make of single facts, remembered by a process that builds again and again, or builds many versions.

A fact that has not changed is the same object in the next build and in the next version. A piece is taken again where
all that it was made of is the same: the objects of the model, numbers and words beside them, and the names that it
asked for, which depend on other facts too.
"""

from __future__ import annotations

import marshal
from collections.abc import Callable, Hashable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from typing import Any, Protocol, TypeVar

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.observation import is_same_layout, observed_layout
from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.language.model.device import Device
from fieldspec.language.model.value import Value

Item = TypeVar("Item")
Result = TypeVar("Result")
RequestedNames = tuple[dict[str, str], dict[str, str]]
"""The names that a piece asked for: those that were given before, and those that were given to it first."""

_CONTENT = 2
"""The version of the serialization of data that is equal for equal data."""

MOST = 100_000
"""The most pieces that are remembered; the oldest ones go first."""


class Names(Protocol):
    """The names of an output, which are assigned in the order of the requests. They begin alike for a key."""

    key: str

    @contextmanager
    def noting(self) -> Iterator[RequestedNames]:
        """Meanwhile, records the requests and the names."""

    def gives(self, requested_names: RequestedNames) -> bool:
        """Gives the same names again, all or none."""


class Pieces:
    """The pieces of outputs, by what they were made of. Versions are only `remembered` where they may come again."""

    def __init__(self, remembered: bool = False) -> None:
        self._remembered = remembered
        self._pieces: dict[Hashable, tuple[tuple[object, ...], RequestedNames, Any]] = {}
        self._versions: dict[tuple[str, str, str], tuple[Hashable, DeviceLayout, Any]] = {}
        self._latest: dict[Hashable, tuple[bytes, Any]] = {}

    def of_version(
        self, kind: str, layout: DeviceLayout, words: Hashable, make: Callable[[DeviceLayout], Result]
    ) -> Result:
        """The piece of a kind that was made of a layout in which it has read the same, or else what `make` gives."""
        if not self._remembered:
            return make(layout)
        key, words = (kind, layout.device.id, layout.device.version), (words, layout.equal_versions, layout.blocks)
        remembered = self._versions.get(key)
        if remembered is not None and remembered[0] == words and is_same_layout(remembered[1], layout):
            result: Result = remembered[2]
            return result
        reading = observed_layout(layout)
        result = make(reading)
        self._versions[key] = words, reading, result
        return result

    def latest(self, kind: Hashable, data: object, make: Callable[[], Result]) -> Result:
        """The last piece of a kind if it was made of equal data, or else what `make` gives."""
        if not self._remembered:
            return make()
        content = marshal.dumps(data, _CONTENT)  # type: ignore[arg-type]
        remembered = self._latest.get(kind)
        if remembered is None or remembered[0] != content:
            self._latest[kind] = remembered = content, make()
        result: Result = remembered[1]
        return result

    def taken(
        self,
        kind: str,
        facts: tuple[object, ...],
        words: tuple[Hashable, ...],
        names: Names | None,
        make: Callable[[], Result],
    ) -> Result:
        """The piece of a kind that was made of the same, or else what `make` gives."""
        # As long as the piece is there, no other object gets the identity of a fact.
        key = (kind, words, names and names.key, tuple(map(id, facts)))
        remembered = self._pieces.get(key)
        if remembered is not None and (names is None or names.gives(remembered[1])):
            result: Result = remembered[2]
            return result
        requested_names: RequestedNames = {}, {}
        if names is None:
            result = make()
        else:
            with names.noting() as requested_names:
                result = make()
        if remembered is None and len(self._pieces) >= MOST:
            del self._pieces[next(iter(self._pieces))]
        self._pieces[key] = facts, requested_names, result
        return result


_at_hand: list[Pieces] = []


@contextmanager
def using_pieces(pieces: Pieces | None) -> Iterator[None]:
    """Meanwhile, pieces are remembered; for None, they are not."""
    _at_hand[:] = [pieces] if pieces is not None else []
    try:
        yield
    finally:
        _at_hand.clear()


def facts_of(device: Device, value: Value) -> tuple[object, ...]:
    """A value and all else of the model that its codec depends on: its enum or its bits, with their enums."""
    word, enum = device.flags.get(value.flags), device.enums.get(value.enum)
    return (value, enum, word, *(device.enums.get(bit.enum) for bit in word.bits)) if word else (value, enum)


RUN = 16
"""How many registers make one piece together, so that unchanged ones are looked up and joined in few steps."""

Run = tuple[tuple[object, ...], Callable[[], Iterable[Item]]]
"""Items that follow from facts of the model alone, and these facts; none where there is no telling."""


def register_runs(layout: DeviceLayout) -> Iterator[tuple[tuple[RegisterLayout, ...], tuple[object, ...]]]:
    """The registers of a layout, a few at a time, and all of the model that the codecs of these depend on."""
    for run in runs_of(layout.registers):
        yield run, (*run, layout.device.enums, layout.device.flags)


def runs_of(items: Sequence[Item]) -> Iterator[tuple[Item, ...]]:
    """Some items, a few at a time."""
    return (tuple(items[start : start + RUN]) for start in range(0, len(items), RUN))


def run_pieces(
    kind: str,
    runs: Iterable[Run[Item]],
    words: tuple[Hashable, ...],
    make: Callable[[Item], Iterable[Result]],
    names: Names | None = None,
) -> Iterator[Result]:
    """The results of `make` for all items, which depend only on their facts, on words and on names."""

    def all_of(items: Callable[[], Iterable[Item]]) -> tuple[Result, ...]:
        return tuple([result for item in items() for result in make(item)])

    for facts, items in runs:
        yield from piece(kind, facts, words, partial(all_of, items), names) if facts else all_of(items)


def piece(
    kind: str,
    facts: tuple[object, ...],
    words: tuple[Hashable, ...],
    make: Callable[[], Result],
    names: Names | None = None,
) -> Result:
    """The result of `make`, which depends only on these facts and words, and on the `names` that it requests.

    The result must not be changed.
    """
    return _at_hand[0].taken(kind, facts, words, names, make) if _at_hand else make()


def version_piece(kind: str, layout: DeviceLayout, words: Hashable, make: Callable[[DeviceLayout], Result]) -> Result:
    """The result of `make` for a layout, which depends only on what it reads of the layout, and on words.

    The last one of a version is remembered. The result must not be changed.
    """
    return _at_hand[0].of_version(kind, layout, words, make) if _at_hand else make(layout)


def content_piece(kind: str, data: object, words: tuple[Hashable, ...], make: Callable[[], Result]) -> Result:
    """The result of `make`, which depends only on plain data and words: a piece by the content of the data.

    Only numbers, texts, bytes, and lists and dictionaries of these are cached.
    """
    if not _at_hand:
        return make()
    try:
        content = marshal.dumps(data, _CONTENT)  # type: ignore[arg-type]
    except ValueError:
        return make()
    return _at_hand[0].taken(kind, (), (content, *words), None, make)


def latest_piece(kind: Hashable, data: object, make: Callable[[], Result]) -> Result:
    """The result of `make`, which depends only on plain data. The last one of a kind is remembered."""
    return _at_hand[0].latest(kind, data, make) if _at_hand else make()
