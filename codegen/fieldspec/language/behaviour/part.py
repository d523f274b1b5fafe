"""The parts of a behaviour, as a spec states them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from decimal import Decimal
from math import inf

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.fact import Citation, Place

if TYPE_CHECKING:
    from typing import Any, TypeAlias

Term: TypeAlias = "int | Decimal | bool | str"
"""A number, or the name of a member or of a signal."""

PART_KEYS: Mapping[str, tuple[frozenset[str], frozenset[str]]] = {
    "machine": (frozenset(), frozenset()),
    "axis": (frozenset(), frozenset()),
    "show": (frozenset(), frozenset({"value", "if", "otherwise"})),
    "initial": (frozenset({"value"}), frozenset()),
    "rule": (frozenset(), frozenset({"when", "if", "refused"})),
    "refuse": (frozenset(), frozenset({"with", "code", "mark"})),
    "timing": (frozenset({"limit"}), frozenset()),
    "accept": (frozenset(), frozenset({"if"})),
    "collection": (frozenset(), frozenset({"key", "most"})),
    "answer": (frozenset({"from"}), frozenset({"at", "start", "most"})),
    "unmodelled": (frozenset({"reason"}), frozenset()),
}
"""The kinds of parts: the keys that each needs beside its own, and those that it may have."""

ACTION_KEYS: Mapping[str, tuple[frozenset[str], frozenset[str]]] = {
    "set": (frozenset({"to"}), frozenset()),
    "enter": (frozenset({"state"}), frozenset()),
    "move": (frozenset({"speed"}), frozenset({"to", "acceleration", "deceleration"})),
    "stop": (frozenset(), frozenset({"deceleration"})),
    "place": (frozenset(), frozenset()),
    "raise": (frozenset(), frozenset({"after"})),
    "load": (frozenset({"at"}), frozenset()),
    "copy": (frozenset({"to"}), frozenset()),
    "save": (frozenset(), frozenset()),
    "record": (frozenset({"value", "newest"}), frozenset()),
    "insert": (frozenset({"of"}), frozenset()),
    "append": (frozenset({"values"}), frozenset()),
    "remove": (frozenset(), frozenset({"at", "count"})),
    "restart": (frozenset(), frozenset()),
    "refuse": (frozenset(), frozenset()),
}
"""The kinds of actions: the keys that each needs beside its own, and those that it may have."""

STATED_KEYS = frozenset({"name", "doc", "source", "notes", "standard", "since", "until", "only", "assumed"})
"""The keys of every part that say what it rests on."""

MODELLED, ASSUMED, NOT_MODELLED = STANDINGS = ("modelled", "assumed", "not modelled")
"""How a simulator implements a statement of a manual: as printed, with an assumption, or not at all."""

NONZERO = "nonzero"
"""The word of conditions for any value but 0."""

BUILT_IN_EVENTS = ("power_on", "arrived", "stopped", "limit_reached")
"""The events that the axis and the power raise."""

AXIS_PROPERTIES = (
    "position",
    "commanded",
    "speed",
    "moving",
    "homing",
    "homed",
    "in_position",
    "accelerating",
    "decelerating",
    "constant_speed",
    "forward",
    "at_lowest",
    "at_highest",
)
"""What rules and outputs can ask of the axis."""


@dataclass(frozen=True, slots=True)
class Product:
    """The product of `factors`, divided by the factors of `over`; `alternative` where it is 0 or a factor is not a
    number.

    Where there are `bits`, the number that they make, the lowest first, is the first factor.
    """

    factors: tuple[Term, ...]
    over: tuple[Term, ...]
    alternative: Term | None
    bits: tuple[Term, ...] = ()

    def terms(self) -> tuple[Term, ...]:
        """The numbers and the names of signals that are multiplied."""
        return (*self.factors, *self.over, *self.bits, *(() if self.alternative is None else (self.alternative,)))


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a behaviour or an action of a rule. `kind` is its key in PART_KEYS or ACTION_KEYS.

    `keys` has the values of its keys: terms, products, tuples of terms, mappings, and for a rule a tuple of actions.
    `assumed` is what the manual does not print, or empty.
    """

    kind: str
    name: str
    place: Place
    keys: Mapping[str, Any]
    assumed: str = ""
    sources: tuple[Citation, ...] = ()
    standard: str = ""

    def __getitem__(self, key: str) -> Any:
        return self.keys[key]

    def get(self, key: str, default: Any = None) -> Any:
        """The value of a key, or a default."""
        return self.keys.get(key, default)

    @property
    def subject(self) -> Any:
        """The value of the key that makes its kind."""
        return self.keys[self.kind]

    @property
    def received(self) -> tuple[str, ...]:
        """The messages, by role or path, whose requests are the event of a rule."""
        names = (self.get("when") or {}).get("receive", ())
        return names if isinstance(names, tuple) else (names,)

    @property
    def standing(self) -> str:
        """How the simulator stands to what the manual states: a member of STANDINGS."""
        if self.kind == "unmodelled":
            return NOT_MODELLED
        return ASSUMED if self.assumed else MODELLED


@dataclass(frozen=True, slots=True)
class Behaviour:
    """The parts of a behaviour in the order of the spec."""

    parts: tuple[Part, ...]

    def of_kind(self, kind: str) -> list[Part]:
        """The parts of a kind."""
        return [part for part in self.parts if part.kind == kind]

    def named(self, kind: str, name: str) -> Part | None:
        """The part of a kind with a name."""
        return next((part for part in self.parts if part.kind == kind and part.name == name), None)

    def statements(self) -> list[Part]:
        """The parts in the order in which the manual states them; after them those that it does not state."""
        first = {
            id(part): min((low for source in part.sources for low, _ in source.lines), default=inf)
            for part in self.parts
        }
        return sorted(self.parts, key=lambda part: first[id(part)])

    def assumptions(self) -> Iterable[Part]:
        """The parts that rest on assumptions."""
        return (part for part in self.parts if part.assumed)
