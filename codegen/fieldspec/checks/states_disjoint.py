"""No two states of a word hold at the same time, and no state asks a bit to be 1 and 0.

Why: the bits of a word show one state. Where two of them fit the same bits, a bit of one of them is
misprinted or was left out.

Example: a state with `set: [ready]` beside one with `set: [ready, operating]`: the first one needs
`clear: [operating]`.

Cure: Give the bits that tell the states apart, and write an erratum if they are misprinted.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from fieldspec.checks.finding import enumeration, finding, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.enums import Flags

_CODE = "states_disjoint"
_MOST = 64
"""How many states of one word are compared with each other."""


def states_disjoint(device: Device) -> Iterator[Diagnostic]:
    for word in device.flags.values():
        yield from _of_word(word)


def _of_word(word: Flags) -> Iterator[Diagnostic]:
    for state in word.states:
        both = [name for name in state.set if name in state.clear]
        if both or not (state.set or state.clear):
            text = (
                f"{state.name} asks {enumeration(both)} to be 1 and 0"
                if both
                else f"no bit shows the state {state.name}"
            )
            yield finding(_CODE, state.place, "set", text, "put the bits of the state right")
    states = [state for state in word.states if state.set or state.clear]
    for state, other in combinations(states[:_MOST], 2):
        mask, value = word.masked(state)
        same, theirs = word.masked(other)
        if not (value ^ theirs) & mask & same:
            text = f"{state.name} and {other.name} of {word.name} can hold at the same time"
            there = label(state.place, "name", state.name)
            yield finding(_CODE, other.place, "name", text, "give the bits that tell them apart", there)
