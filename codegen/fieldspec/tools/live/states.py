"""The state of a device before a write: whether its servo is on, and whether it is busy."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.tools.live.client import Client

if TYPE_CHECKING:
    from fieldspec.tools.live.access import Access, Item, Reading

_ROLES = ("servo_state", "busy")


def active_states(access: Access, client: Client) -> list[str]:
    """The signals with the roles `servo_state` and `busy` that are not 0, as texts.

    A state that the device refuses to show is among them, because it is unknown. Raises NoAnswerError and CarrierError.
    """
    chosen = [item for item in access.items() if any(access.signals(item, _ROLES))]
    values = access.read(client, chosen)
    return [text for item, value in zip(chosen, values, strict=True) for text in _texts(access, item, value)]


def _texts(access: Access, item: Item, value: Reading) -> Iterator[str]:
    path, decoded = value.path, value.decoded
    for role, mask in access.signals(item, _ROLES):
        danger = "the servo is on" if role == "servo_state" else "the device may be busy"
        if decoded is None:
            yield f"{path} is refused ({value.refusal}): its {role} is unknown"
        elif isinstance(decoded.number, int) and decoded.number & mask:
            names = " ".join(meaning.name for meaning in decoded.meanings if meaning.name)
            yield f"{danger}: {path} is {names or int(decoded.number)}"
