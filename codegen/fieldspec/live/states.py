"""What a device is doing before something is written: whether its servo is on, and whether it is busy."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.explain.registers import Occupant
from fieldspec.live.client import Client
from fieldspec.live.reading import Reading, all_occupants, blocks, read
from fieldspec.model.access import readable

_ROLES = ("servo_state", "busy")


def active_states(client: Client) -> list[str]:
    """The signals with the roles `servo_state` and `busy` that are not 0, as texts.

    A state that the device refuses to show is among them, since nobody knows it. Raises NoAnswerError and CarrierError.
    """
    layout = client.layout
    chosen = [
        (space, occupant)
        for space, occupant in all_occupants(layout)
        if readable(occupant.access) and any(_signals(client, occupant))
    ]
    return [text for value in read(client, blocks(layout, chosen)) for text in _texts(client, value)]


def _signals(client: Client, occupant: Occupant) -> Iterator[tuple[str, int]]:
    """The roles of a value or of its bits, each with its mask; -1 for all bits."""
    for role in _ROLES:
        if role in occupant.fact.roles:
            yield role, -1
        if occupant.value.flags:
            for bit in client.layout.device.flags[occupant.value.flags].bits:
                if role in bit.roles:
                    yield role, bit.mask


def _texts(client: Client, value: Reading) -> Iterator[str]:
    path, decoded = value.occupant.path, value.decoded
    for role, mask in _signals(client, value.occupant):
        what = "the servo is on" if role == "servo_state" else "the device may be busy"
        if decoded is None:
            yield f"{path} is refused ({value.refusal}): nobody knows its {role}"
        elif isinstance(decoded.number, int) and decoded.number & mask:
            names = " ".join(meaning.name for meaning in decoded.meanings if meaning.name)
            yield f"{what}: {path} is {names or int(decoded.number)}"
