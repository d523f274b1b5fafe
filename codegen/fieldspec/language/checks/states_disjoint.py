"""No two states of a word are possible at the same time, and no state requires a bit to be both 1 and 0.

Why: the bits of a word show one state. If two states match the same bits, a bit of one of them is misprinted
or missing.

Example: a state with `set: [ready]` and one with `set: [ready, operating]`: the first needs `clear:
[operating]`.

Fix: Add the bits that distinguish the states, and write an erratum if they are misprinted.
"""

from __future__ import annotations

from itertools import combinations

from fieldspec.language.checks.finding import Findings, enumeration, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Flags

_MOST = 64
"""How many states of one word are compared with each other."""


def states_disjoint(device: Device) -> Findings:
    for word in device.flags.values():
        yield from _of_word(word)


def _of_word(word: Flags) -> Findings:
    for state in word.states:
        contradictory = [name for name in state.set if name in state.clear]
        if contradictory or not (state.set or state.clear):
            text = (
                f"{state.name} requires {enumeration(contradictory)} to be both 1 and 0"
                if contradictory
                else f"no bit shows the state {state.name}"
            )
            yield finding(state.place, "set", text, "correct the bits of the state")
    states = [state for state in word.states if state.set or state.clear]
    for state, other in combinations(states[:_MOST], 2):
        mask, value = word.masked(state)
        same, theirs = word.masked(other)
        if not (value ^ theirs) & mask & same:
            text = f"{state.name} and {other.name} of {word.name} are possible at the same time"
            related_label = label(state.place, "name", state.name)
            yield finding(other.place, "name", text, "add the bits that distinguish them", related_label)
