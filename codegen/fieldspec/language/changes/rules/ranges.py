"""Rules about permitted values, defaults, access and handling."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import attributes
from fieldspec.language.changes.bounds import bounds_pairs, text, without
from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.changes.comparison import Comparison
from fieldspec.language.changes.descriptions import change, changed, named
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.record import Field, Message
from fieldspec.language.model.registers import Parameter, Register, Subindex, Table
from fieldspec.language.model.texts import Limit
from fieldspec.language.model.value import Handling


def range_narrowed(comparison: Comparison) -> Iterator[Change]:
    """Fewer values, fewer elements or only a shorter text are permitted.

    Why: the device or the generated code rejects values that it accepted before.

    Example: `range: 0..100` that becomes `range: 1..100`.

    Fix: Inform users of the lost values.
    """

    for bounds in bounds_pairs(comparison):
        lost = without(bounds.old, bounds.new)
        if lost.intervals:
            message = f"{bounds.name}: {bounds.what} is {text(bounds.new)}; {text(lost)} is not allowed any more"
            yield change(Effect.BEHAVIOUR, bounds.pair, bounds.key, message, text(bounds.old), text(bounds.new))


def range_widened(comparison: Comparison) -> Iterator[Change]:
    """More values, more elements or a longer text are permitted.

    Why: an existing program receives values that it does not expect, and generated code of the old version rejects
    them.

    Example: `range: 0..100` that becomes `range: 0..200`.

    Fix: No action is needed.
    """

    for bounds in bounds_pairs(comparison):
        gained = without(bounds.new, bounds.old)
        if gained.intervals:
            message = f"{bounds.name}: {bounds.what} is {text(bounds.new)}; {text(gained)} is allowed now"
            yield change(Effect.BEHAVIOUR, bounds.pair, bounds.key, message, text(bounds.old), text(bounds.new))


def default_changed(comparison: Comparison) -> Iterator[Change]:
    """The default of a value has changed.

    Why: a program that relies on the old default, or fills a record or a bit field only partly, sends different values.
    Different bytes are written into reserved fields.

    Example: `default: 100` that becomes `default: 50`.

    Fix: Tell users to set the value explicitly. If the old spec was wrong, accept the change with that reason;
    otherwise, assign a new version number.
    """

    for value_pair in comparison.all_values:
        old, new = value_pair.old.default, value_pair.new.default
        filling = value_pair.reserved and value_pair.new.const is None and (old or 0) != (new or 0)
        effect = Effect.WIRE if filling else Effect.BEHAVIOUR
        yield from changed(effect, value_pair, "default", "the default", old, new)
    for pair in comparison.of(Bit):
        yield from changed(Effect.BEHAVIOUR, pair, "default", "the default", pair.old.default, pair.new.default)


_KEYS = {
    "kind": ("kind", "the kind"),
    "value": ("value", "the value"),
    "low": ("min", "the least"),
    "high": ("max", "the most"),
    "text": ("text", "the text"),
    "unit": ("unit", "the unit"),
}


def limit_changed(comparison: Comparison) -> Iterator[Change]:
    """A limit of the device, such as a time, a maximum or a supply, has changed.

    Why: a machine that was built for the old number may be too fast, too slow or too weak.

    Example: `value: 5` of a reply time in ms that becomes `value: 20`.

    Fix: Inform users of the old number.
    """

    for pair in comparison.of(Limit):
        for attribute, (key, subject) in _KEYS.items():
            old, new = getattr(pair.old, attribute), getattr(pair.new, attribute)
            effect = Effect.DOCS if attribute == "kind" else Effect.BEHAVIOUR
            yield from changed(effect, pair, key, subject, old, new)


def access_changed(comparison: Comparison) -> Iterator[Change]:
    """The access of a register, table, field, parameter or element has changed.

    Why: the device, or the generated code, rejects writes to a read-only value.

    Example: `access: rw` that becomes `access: ro`.

    Fix: List the writes that no longer work in the notes of the version. If the old spec was wrong, accept the change
    with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.any_of(Register, Table, Field, Parameter, Subindex):
        old, new = pair.old.access, pair.new.access
        yield from changed(Effect.BEHAVIOUR, pair, "access", "the access", old, new)


_HANDLING_TEXTS = {
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


def handling_changed(comparison: Comparison) -> Iterator[Change]:
    """The handling of a value has changed: whether it must be accessed in one request, starts an action, or is saved.

    Why: a program that reads the value in two requests gets halves of two values, a program that reads back a trigger
    does not get the written value, and a value that is not saved is lost when the power is switched off. If two facts
    have opposite senses, a program that ignores this does the opposite of the intended action.

    Example: `atomic: true` at a register without it, or `saved_by: registers/save` at a parameter.

    Fix: Tell users how to access the value.
    """

    for pair in comparison.any_of(Register, Field, Parameter):
        for key in ("atomic", "trigger"):
            old, new = getattr(pair.old, key, False), getattr(pair.new, key, False)
            if old != new:
                text = f"{named(pair.new)} {_HANDLING_TEXTS[key, new]}"
                yield change(Effect.BEHAVIOUR, pair, key, text, old, new)
    for handled in comparison.any_of(Register, Field, Parameter, Table, Message, Bit):
        if handled.old.handling == handled.new.handling:
            continue
        for key in attributes(Handling):
            before, after = getattr(handled.old.handling, key), getattr(handled.new.handling, key)
            if key in _PATHS and before:
                before = comparison.renamed_path(before)
            yield from changed(Effect.BEHAVIOUR, handled, key, _ASKED[key], before, after)


def restart_changed(comparison: Comparison) -> Iterator[Change]:
    """A change of a value takes effect only after a restart, or no longer needs a restart.

    Why: a program that sets the value without a restart keeps the old value in effect.

    Example: `restart: true` at a parameter that took effect at once.

    Fix: Tell users when to restart the device.
    """

    for pair in comparison.any_of(Register, Field, Parameter):
        old, new = pair.old.restart, pair.new.restart
        if old != new and not pair.new.reserved:
            yield from changed(Effect.BEHAVIOUR, pair, "restart", "whether a restart is needed", old, new)
