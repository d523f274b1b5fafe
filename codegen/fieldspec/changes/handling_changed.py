"""A value has to be read or written in another way: in one request or not, as a trigger or not, saved or not.

Why: a program that reads a value in two requests gets halves of two values; one that reads back a trigger gets
nothing; one that does not save what is lost with the power finds it gone; and one that does not know that two facts
have opposite senses does the contrary of what it should.

Example: `atomic: true` at a register that did not have it, or `saved_by: registers/save` at a parameter.

Cure: Tell users how to access the value.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.classes import attributes
from fieldspec.model.flags import Bit
from fieldspec.model.handling import Handling
from fieldspec.model.message import Message
from fieldspec.model.parameter import Parameter
from fieldspec.model.record import Field
from fieldspec.model.register import Register
from fieldspec.model.table import Table

_SAID = {
    ("atomic", True): "must be accessed in one request",
    ("atomic", False): "may be accessed in several requests",
    ("trigger", True): "starts an action when it is written",
    ("trigger", False): "no longer starts an action when it is written",
}
_ASKED = {
    "memory": "the memory that keeps it",
    "saved_by": "what saves it",
    "endurance": "how often it may be written",
    "clears_on_read": "whether reading clears it",
    "opposite_of": "what has the opposite sense",
}
_PATHS = ("saved_by", "opposite_of")


def handling_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.any_of(Register, Field, Parameter):
        for key in ("atomic", "trigger"):
            old, new = getattr(pair.old, key, False), getattr(pair.new, key, False)
            if old != new:
                text = f"{named(pair.new)} {_SAID[key, new]}"
                yield change("handling_changed", Effect.BEHAVIOUR, pair, key, text, old, new)
    for held in both.any_of(Register, Field, Parameter, Table, Message, Bit):
        if held.old.handling == held.new.handling:
            continue
        for key in attributes(Handling):
            before, after = getattr(held.old.handling, key), getattr(held.new.handling, key)
            if key in _PATHS and before:
                before = both.renamed_path(before)
            if before != after:
                text = f"{named(held.new)}: {turned(_ASKED[key], before, after)}"
                yield change("handling_changed", Effect.BEHAVIOUR, held, key, text, before, after)
