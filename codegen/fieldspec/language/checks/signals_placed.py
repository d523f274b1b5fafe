"""Every signal is part of some message, only in its own direction, and under its own printed name.

Why: the list of signals and the tables of messages both state the direction. If they differ, or if a listed
signal is in no table, one of the two is misprinted or out of date.

Example: a signal with `direction: request` in a response; OVERRIDE in the list and VERRIDE in a table.

Fix: Correct the list or the table, and write an erratum. If no message carries the signal, state this under
its `notes`.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import fields
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Field
from fieldspec.language.model.value import Signal

_WAYS = {"request": "to the device", "response": "from the device"}


def signals_placed(device: Device) -> Findings:
    for message in device.messages.values():
        for direction, layer in (("request", message.request), ("response", message.response)):
            for field in layer.fields:
                signal = device.signals.get(field.signal)
                if signal is not None and signal.direction not in ("", direction):
                    yield _astray(field, signal, f"the {direction} of {message.name}")
    for field in fields(device):
        signal = device.signals.get(field.signal)
        if signal is not None:
            yield from _named(field, signal)
    placed = {field.signal for field in fields(device)}
    for signal in device.signals.values():
        if signal.direction and signal.name not in placed and not signal.notes:
            text = f"no message carries {signal.name}"
            help = "add it to a message, or state under `notes` that no message carries it"
            yield finding(signal.place, "name", text, help)


def _astray(field: Field, signal: Signal, holder: str) -> Diagnostic:
    text = f"{signal.name} goes {_WAYS[signal.direction]}, but is part of {holder}"
    related_label = label(signal.place, "direction", "its direction")
    return finding(field.place, "signal", text, "correct the direction or the message", related_label)


def _named(field: Field, signal: Signal) -> Findings:
    mine, theirs = ("".join(name.split()).casefold() for name in (field.printed_name, signal.printed_name))
    if mine and theirs and mine != theirs:
        text = f"{field.name} is printed as `{field.printed_name}`, its signal as `{signal.printed_name}`"
        related_label = label(signal.place, "printed_name", signal.name)
        yield finding(field.place, "printed_name", text, "correct one of the names", related_label)
