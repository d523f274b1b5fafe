"""State machines: the states of a device, and what leads from one to another."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.fact import Citation, Place


@dataclass(frozen=True, slots=True)
class Transition:
    """What leads from one of `origins` to `target`: an event, or conditions that hold, or both.

    `event` has the kind of the event and its subject, or is empty. `conditions` are signals, each with its values.
    `actions` are what happens beside. `assumed` is what the manual does not print, or empty.
    """

    name: str
    place: Place
    origins: tuple[str, ...]
    target: str
    event: tuple[str, str] | tuple[()]
    conditions: tuple[tuple[str, tuple[str, ...]], ...]
    actions: tuple[str, ...]
    assumed: str
    sources: tuple[Citation, ...]


@dataclass(frozen=True, slots=True)
class StateMachine:
    """The states, the first one at power-on, and the transitions between them."""

    name: str
    place: Place
    states: tuple[str, ...]
    transitions: tuple[Transition, ...]
    assumed: str
    sources: tuple[Citation, ...]
