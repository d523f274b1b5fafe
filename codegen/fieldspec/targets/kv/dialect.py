"""The requirements of a controller with word memory, as a row of facts."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.foundation.classes import dataclass, field


@dataclass(frozen=True, slots=True)
class WordDialect:
    """`letters` name its data memory, `base` is the number of the first used word, `last` of the last.

    Areas begin at multiples of `step`. A comment has at most `width` characters of ASCII. A value of 32 bits has its
    less significant word first where `low_word_first` is set. `suffixes` are what its instructions write after a
    device for a type.
    """

    name: str
    letters: str
    base: int
    last: int
    step: int
    width: int
    low_word_first: bool
    suffixes: Mapping[str, str] = field(default_factory=dict)

    def device(self, number: int) -> str:
        """`DM10000`, or nothing where it has no such word."""
        return f"{self.letters}{number}" if number <= self.last else ""

    def next_step(self, number: int) -> int:
        """Where the next area may begin."""
        return -(-number // self.step) * self.step


KV = WordDialect(
    name="Keyence KV",
    letters="DM",
    base=10000,
    last=65534,
    step=10,
    width=32,
    low_word_first=True,
    suffixes={
        "u8": ".U",
        "bool8": ".U",
        "u16": ".U",
        "bool16": ".U",
        "i16": ".S",
        "u32": ".D",
        "i32": ".L",
        "f32": ".F",
    },
)
