"""The meaning of the bytes of a request, whatever the device does at the time."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.reference.frames import Decoded, FrameCodec, Outline
from fieldspec.codec.reference.records import CodecError
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass, replace
from fieldspec.tools.simulator import judging

if TYPE_CHECKING:
    from typing import Any


@dataclass(frozen=True, slots=True)
class Request:
    """A frame for this device: the parts of its head, its code, and the message that they announce.

    `silence` says why no device answers, `damage` why none can understand it, and `objection` why it is refused, as a
    reason and what is wrong. Where all is well, `message` and `values` are what it says; `out_of_range` is the first
    value that is.
    """

    head: Mapping[str, Any]
    code: int | None
    announced: MessageLayout | None
    silence: str
    is_broadcast: bool
    damage: str = ""
    objection: tuple[str, ...] = ()
    message: MessageLayout | None = None
    values: Mapping[str, Any] | None = None
    out_of_range: str = ""


def received(frames: FrameCodec, unit_address: int, frame: bytes, message: str) -> Request | str:
    """The request in a frame; its fault if the device ignores it.

    `message` names the message where the frame does not.
    """
    shape = frames.link.request
    try:
        outline = frames.outline(frame, "request")
    except CodecError as error:
        return f"damaged: {error.detail}"
    parts, numbers = outline
    garbled = next((part for part in frames.framed["request"].digits if numbers[part.name] is None), None)
    if garbled is not None:
        return f"damaged: {garbled.name} is not a number"
    head = {part.name: numbers[part.name] for part in shape.header}
    coded = shape.role("code")
    code = head[coded.name] if coded is not None else None
    outcome = _decoded(frames, outline, message if code is None else "")
    has_checksum = bool(frames.framed["request"].checksums)
    if has_checksum and not isinstance(outcome, Decoded) and not frames.has_right_checksum(frame, "request"):
        return "damaged: wrong checksum"
    is_broadcast = False
    addressed = shape.role("unit_address")
    if addressed is not None and head[addressed.name] != unit_address:
        addresses = frames.link.link.unit_addresses
        is_broadcast = addresses is not None and head[addressed.name] == addresses.broadcast
        if not is_broadcast:
            return f"for unit {head[addressed.name]}"
    if frames.link.link.is_can and any(head.get(part.name, part.constant) != part.constant for part in shape.constants):
        return "another identifier"
    if coded is not None and coded.part.bits is not None and not frames.link.messages_with_code(int(code or 0)):
        return "another identifier"
    if code is None and not message:
        message = judging.recognised_message(frames, frame)
        outcome = _decoded(frames, outline, message)
    announced = frames.link.announced(code, parts[shape.header_size : len(parts) - shape.trailer_size], message)
    silence = "broadcast" if is_broadcast else ""
    if announced is not None and announced.name not in frames.link.carried("response"):
        silence = silence or "not answered"
    request = Request(head, code, announced, silence, is_broadcast)
    if isinstance(outcome, CodecError):
        if outcome.reason in judging.DAMAGED:
            return replace(request, damage=outcome.detail)
        stated_name = message if code is None else ""
        return replace(request, objection=judging.refusal_words(frames, frame, stated_name, outcome))
    if outcome.message is None:
        return replace(request, objection=("unknown_code",))
    out_of_range = judging.first_out_of_range(frames.layout.device, outcome.message.request, outcome.values)
    return replace(request, message=outcome.message, values=outcome.values, out_of_range=out_of_range)


def _decoded(frames: FrameCodec, outline: Outline, message: str) -> Decoded | CodecError:
    """The meaning of a request, or why it has none."""
    try:
        return frames.decode_outline(outline, "request", message)
    except CodecError as error:
        return error


def number_key(values: Iterable[object]) -> tuple[object, ...] | None:
    """A key of whole numbers and lists of them; None for other values, as 1 equals 1.0 and is another value."""
    key: list[object] = []
    for value in values:
        numbers = value if type(value) is list else (value,)
        if set(map(type, numbers)) - {int}:
            return None
        key.append(tuple(numbers))
    return tuple(key)
