"""Rules about what carries frames: the settings of serial lines, the ports of networks, the silence between frames."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.changes.comparison import Comparison
from fieldspec.language.changes.descriptions import change, changed, named
from fieldspec.language.model.link import Link, Network, Serial

_NONE = Serial((), None, (), (), (), None, ())
_SERIAL_KEYS = (
    "baud",
    "default_baud",
    "data_bits",
    "default_data_bits",
    "parity",
    "default_parity",
    "stop_bits",
    "start_bits",
)


def serial_changed(comparison: Comparison) -> Iterator[Change]:
    """The settings or the default of a serial line have changed.

    Why: two sides with different settings cannot communicate.

    Example: `default_baud: 9600` that becomes `default_baud: 19200`.

    Fix: Tell users the settings for their side.
    """

    for pair in comparison.of(Link):
        before, after = pair.old.serial or _NONE, pair.new.serial or _NONE
        for key in _SERIAL_KEYS:
            old, new = getattr(before, key), getattr(after, key)
            yield from changed(Effect.BEHAVIOUR, pair, "serial", key.replace("_", " "), old, new)


def default_link_changed(comparison: Comparison) -> Iterator[Change]:
    """A device uses a different link with factory settings, or the default link is no longer stated.

    Why: programs open a device with factory settings over this link.

    Example: `default: true` that moves from the link `rtu` to the link `ascii`.

    Fix: Tell users which link new devices use.
    """
    for pair in comparison.of(Link):
        if pair.old.is_default != pair.new.is_default:
            state = "the default link" if pair.new.is_default else "no longer the default link"
            text = f"{named(pair.new)} is {state}"
            old, new = pair.old.is_default, pair.new.is_default
            yield change(Effect.BEHAVIOUR, pair, "default", text, old, new)


_NO_NETWORK = Network(None, None, ())


def network_changed(comparison: Comparison) -> Iterator[Change]:
    """The device listens on a different network port.

    Why: a program that connects to the old port receives no response.

    Example: `network: {tcp: 502}` that becomes `network: {tcp: 10502}`.

    Fix: Tell users the port.
    """
    for pair in comparison.of(Link):
        before, after = pair.old.network or _NO_NETWORK, pair.new.network or _NO_NETWORK
        for key in ("tcp", "udp"):
            old, new = getattr(before, key), getattr(after, key)
            yield from changed(Effect.BEHAVIOUR, pair, "network", f"{key.upper()} port", old, new)


def timing_changed(comparison: Comparison) -> Iterator[Change]:
    """The silence between frames has changed.

    Why: if a program waits too briefly, the device reads two frames as one.

    Example: `silence: {characters: 3.5}` that becomes `silence: {milliseconds: 50}`.

    Fix: Tell users how long to wait.
    """

    for pair in comparison.of(Link):
        for key, unit in (("silence_characters", "characters"), ("silence_milliseconds", "milliseconds")):
            old, new = getattr(pair.old, key), getattr(pair.new, key)
            yield from changed(Effect.BEHAVIOUR, pair, "silence", "the silence between frames in " + unit, old, new)
