"""The state of a random device while it is drawn: choices, names, lines of the manual, and what is there already."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from typing import Any, TypeVar

from hypothesis import strategies as st

from random_specs import NumberText

T = TypeVar("T")
Spec = dict[str, Any]

WORDS = (
    *("speed", "position", "state", "mode", "torque", "limit", "point", "axis", "level", "signal"),
    # Words that mean something in a language of an output, or in its generated code.
    *(
        "class",
        "int",
        "return",
        "values",
        "in",
        "out",
        "length",
        "raw",
        "self",
        "data",
        "error",
        "body",
        "type",
        "none",
    ),
)
SIZES = {
    "u8": 1,
    "i8": 1,
    "u16": 2,
    "i16": 2,
    "u32": 4,
    "i32": 4,
    "u64": 8,
    "i64": 8,
    "bool8": 1,
    "bool16": 2,
    "f32": 4,
}
SIZES |= {"u24": 3, "i24": 3, "u40": 5, "i40": 5, "u48": 6, "i48": 6, "u56": 7, "i56": 7, "f64": 8}
MAGNITUDES = ("sm8", "sm16", "sm24", "sm32", "sm40", "sm48", "sm56", "sm64")
SIZES |= {"f16": 2, **{kind: int(kind[2:]) // 8 for kind in MAGNITUDES}}
INTEGERS = ("u16", "u8", "i16", "u32", "i32", "i8", "u64", "i64")
ODD_INTEGERS = ("u24", "i24", "u40", "i40", "u48", "i48", "u56", "i56")
BOUNDS = {"since", "until", "only"}
"""The keys that bind a fact to some versions."""
ODD_COUNTS = ("u24", "u40", "u48", "u56")
ODD_WORDS = ("u48", "i48")
"""Those of them that have a whole number of words."""


def bounds(kind: str) -> tuple[int, int]:
    """The least and the greatest number of an integer type."""
    bits = 8 * SIZES[kind]
    if kind.startswith("u"):
        return 0, (1 << bits) - 1
    high = (1 << (bits - 1)) - 1
    return -high - (not kind.startswith("sm")), high


def number(value: Decimal | int) -> int | NumberText:
    """A number as a spec writes it."""
    text = format(Decimal(value).normalize(), "f")
    return int(text) if "." not in text else NumberText(text)


@dataclass
class EnumDraft:
    """An enum that values may name: its members and whether other values are accepted."""

    name: str
    members: dict[str, int]
    open: bool


@dataclass
class RecordDraft:
    """A record that fields and tables may name, and its size in bytes; `words` if its fields are whole registers.

    One that is `apart` is in tables only: the range of writing differs from that of reading.
    """

    name: str
    size: int
    words: bool
    apart: bool = False


@dataclass
class Draft:
    """A device that is being drawn. `draw` draws from a strategy; everything else follows from it."""

    draw: Callable[[st.SearchStrategy[Any]], Any]
    spec: Spec = field(default_factory=dict)
    enums: list[EnumDraft] = field(default_factory=list)
    flags: dict[str, str] = field(default_factory=dict)
    ranged: set[str] = field(default_factory=set)
    """The words with a field of bits that has a range, which parts of frames do not have."""
    records: list[RecordDraft] = field(default_factory=list)
    differing: list[str] = field(default_factory=list)
    """The records that differ in size, which tell it."""
    elements: list[tuple[str, list[Spec]]] = field(default_factory=list)
    """The records that say whether another one follows, each with the ways in which it can say so."""
    signals: dict[str, Spec] = field(default_factory=dict)
    exponents: dict[str, str] = field(default_factory=dict)
    """A register with the exponent of scales by the space that it is in."""
    versions: tuple[str, ...] = ()
    names: int = 0
    code_bits: int = 8
    code_flag: int = 0x80
    byte_order: str = "big"
    word_order: str = ""
    sends_characters: bool = False
    """Whether links may send every byte as two characters; then numbers are seldom sent as digits."""

    def digits(self, percent: int) -> bool:
        """Whether a number is sent as digits, with a probability where no link sends every byte as characters."""
        return self.chance(1 if self.sends_characters else percent)

    def chance(self, percent: int) -> bool:
        """Whether something with a probability is so; shrinking makes it not so."""
        return bool(self.draw(st.integers(0, 99)) >= 100 - percent)

    def number(self, low: int, high: int) -> int:
        """A whole number within bounds; shrinking makes it the one nearest to zero."""
        return int(self.draw(st.integers(low, high)))

    def pick(self, options: Sequence[T]) -> T:
        """One of several; shrinking prefers the first."""
        return options[self.number(0, len(options) - 1)]

    def some(self, options: Sequence[T], least: int = 1) -> list[T]:
        """Some of several, in their order."""
        chosen = [option for option in options if self.chance(60)]
        return chosen if len(chosen) >= least else list(options[:least])

    def name(self) -> str:
        """A name that nothing else has; now and then a bare word that outputs must escape."""
        self.names += 1
        word = self.pick(WORDS)
        return word if self.chance(10) and self._free(word) else f"{word}_{self.names}"

    def _free(self, word: str) -> bool:
        taken = self.spec.setdefault("_words", set())
        free = word not in taken
        taken.add(word)
        return free

    def source(self) -> str:
        """Where the manual states a fact: all of it on one line, so that no order is wrong."""
        return "1 L1"

    def fact(self, **keys: Any) -> Spec:
        """A fact with a name, a source, and now and then words that only documentation shows."""
        fact: Spec = {"name": self.name(), "source": self.source(), **keys}
        if self.chance(4):
            fact["doc"] = "It is what it is."
        if self.chance(3):
            fact["label"] = f"标 {self.names}"
        if self.chance(3):
            fact["notes"] = "Mind */ this, and {{ that }}."
        return fact

    def bounded(self, fact: Spec, percent: int = 8) -> Spec:
        """A fact that some versions do not have, now and then."""
        if self.versions and self.chance(percent):
            first, second = self.versions
            only: list[Spec] = [{"only": [version]} for version in self.versions]
            fact |= self.pick(({"since": second}, {"since": second}, {"until": first}, *only))
        return fact

    def intervals(self, low: int, high: int, most: int = 3) -> list[tuple[int, int]]:
        """Some intervals within bounds, in ascending order, apart from each other."""
        ends = sorted({self.edge(low, high) for _ in range(2 * self.number(1, most))})
        if len(ends) % 2:
            ends.append(ends[-1])
        pairs = [(ends[at], ends[at + 1]) for at in range(0, len(ends), 2)]
        return pairs or [(low, high)]

    def code(self) -> int:
        """A code without the bit that marks exception responses; wide ones are often beside each other."""
        highest = (1 << self.code_bits) - 1
        return (highest - self.number(0, 9) if self.chance(30) else self.number(0, highest)) & ~self.code_flag

    def free_mark(self) -> int:
        """A code of exception responses, which no message has."""
        return self.number(0, 9) | self.code_flag

    def edge(self, low: int, high: int) -> int:
        """A number within bounds, often near one of them or near a power of two."""
        near = [n for n in (low, high, 0, 1, -1, 127, 128, 255, 256, 32767, 32768, 65535, 2**31) if low <= n <= high]
        return self.pick(near) if self.chance(40) else self.number(low, high)


def range_text(intervals: Sequence[tuple[int, int]]) -> str:
    """`0..127, 10000`"""
    return ", ".join(str(low) if low == high else f"{low}..{high}" for low, high in intervals)
