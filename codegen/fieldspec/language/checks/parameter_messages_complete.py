"""If a parameter applies to a message, it also applies to every message with at least the same signals, and to every
message with a signal that has the parameter as its reference.

Why: the lists of messages next to parameters are not always updated when a message is added. A message that
carries the same signals and more needs the same parameters.

Example: a reference speed with `messages: [telegram_3]` where telegram 5 carries the signals of telegram 3
and two more.

Fix: Add the missing messages, and write an erratum. If the parameter really has no effect there, set `allow:
{parameter_messages_complete: <reason>}`.
"""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import Parameter
from fieldspec.language.model.value import Conversion

_Signals = Mapping[str, frozenset[tuple[str, str]]]
"""By the name of a message, its signals with their directions."""


def parameter_messages_complete(device: Device) -> Findings:
    carried = _carried(device)
    references: dict[str, list[Conversion]] = {}
    for conversion in device.conversions.values():
        for path in conversion.references:
            references.setdefault(path, []).append(conversion)
    for parameter_set in device.parameters.values():
        for parameter in parameter_set.parameters:
            if parameter.messages:
                yield from _wider(device, parameter, carried)
                yield from _referring(device, parameter, references.get(parameter.place.path, []), carried)


def _carried(device: Device) -> _Signals:
    return {
        message.name: frozenset(
            (direction, field.signal)
            for direction, layer in (("request", message.request), ("response", message.response))
            for field in layer.fields
            if field.signal
        )
        for message in device.messages.values()
    }


def _wider(device: Device, parameter: Parameter, carried: _Signals) -> Findings:
    for name, signals in carried.items():
        narrower = [message for message in parameter.messages if carried.get(message) and carried[message] <= signals]
        if name not in parameter.messages and narrower:
            text = f"{parameter.name} has an effect with {narrower[0]}, and {name} carries all of its signals"
            yield _finding(device, parameter, name, text)


def _referring(device: Device, parameter: Parameter, conversions: list[Conversion], carried: _Signals) -> Findings:
    for conversion in conversions:
        for name, signals in carried.items():
            shared = sorted(signal for _, signal in signals if signal in conversion.signals)
            if shared and name not in parameter.messages:
                text = f"{parameter.name} is the reference of {shared[0]}, which {name} carries"
                yield _finding(device, parameter, name, text)
                break


def _finding(device: Device, parameter: Parameter, name: str, text: str) -> Diagnostic:
    related_label = label(device.messages[name].place, "name", name)
    help = "add the message under `messages`, or allow it with a reason"
    return finding(parameter.place, "messages", text, help, related_label)
