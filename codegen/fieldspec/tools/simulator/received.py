"""The meaning of the bytes of a request, whatever the device does at the time."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.reference.frames import Decoded, FrameCodec, Outline
from fieldspec.codec.reference.records import CodecError
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass, replace
from fieldspec.tools.simulator import judging
from fieldspec.tools.simulator.bare_requests import Decoder

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


def received(
    frames: FrameCodec, unit_address: int, frame: bytes, message: str, decode: Decoder | None = None
) -> Request | str:
    """The request in a frame; its fault if the device ignores it.

    `message` names the message where the frame does not. `decode` may decode it instead of the reference.
    """
    bare = decode(frame) if decode is not None else None
    if bare is not None:
        stranger, is_broadcast = _addressee(frames, unit_address, bare.head)
        return stranger or _sound(frames, bare.head, bare.message, bare.values, is_broadcast)
    framed, link = frames.framed["request"], frames.link
    shape = framed.shape
    try:
        outline = frames.outline(frame, "request")
    except CodecError as error:
        return f"damaged: {error.detail}"
    parts, numbers = outline
    garbled = next((part for part in framed.digits if numbers[part.name] is None), None)
    if garbled is not None:
        return f"damaged: {garbled.name} is not a number"
    head = {part.name: numbers[part.name] for part in shape.header}
    code = head[framed.code.name] if framed.code is not None else None
    outcome = _decoded(frames, outline, message if code is None else "")
    if framed.checksums and not isinstance(outcome, Decoded) and not frames.has_right_checksum(frame, "request"):
        return "damaged: wrong checksum"
    stranger, is_broadcast = _addressee(frames, unit_address, head)
    if stranger:
        return stranger
    if link.link.is_can and any(head.get(part.name, part.constant) != part.constant for part in framed.constants):
        return "another identifier"
    if framed.code is not None and framed.code.part.bits is not None and not link.messages_with_code(int(code or 0)):
        return "another identifier"
    if code is None and not message:
        message = judging.recognised_message(frames, frame)
        outcome = _decoded(frames, outline, message)
    if isinstance(outcome, Decoded) and outcome.message is not None:
        return _sound(frames, head, outcome.message, outcome.values, is_broadcast)
    announced = link.announced(code, parts[shape.header_size : len(parts) - shape.trailer_size], message)
    request = Request(head, code, announced, _silence(frames, announced, is_broadcast), is_broadcast)
    if not isinstance(outcome, CodecError):
        return replace(request, objection=("unknown_code",))
    if outcome.reason in judging.DAMAGED:
        return replace(request, damage=outcome.detail)
    stated_name = message if code is None else ""
    return replace(request, objection=judging.refusal_words(frames, frame, stated_name, outcome))


def _addressee(frames: FrameCodec, unit_address: int, head: Mapping[str, Any]) -> tuple[str, bool]:
    """Why a frame is not for a unit address, empty where it is, and whether it is for all of them."""
    part = frames.framed["request"].unit_address
    if part is None or head[part.name] == unit_address:
        return "", False
    addresses = frames.link.link.unit_addresses
    is_broadcast = addresses is not None and head[part.name] == addresses.broadcast
    return "" if is_broadcast else f"for unit {head[part.name]}", is_broadcast


def _silence(frames: FrameCodec, announced: MessageLayout | None, is_broadcast: bool) -> str:
    """Why no device answers a request; empty where one does."""
    if is_broadcast:
        return "broadcast"
    is_answered = announced is None or announced.message.is_answered_on(frames.link.name)
    return "" if is_answered else "not answered"


def _sound(
    frames: FrameCodec, head: Mapping[str, Any], message: MessageLayout, values: Mapping[str, Any], is_broadcast: bool
) -> Request:
    """A request that has been decoded."""
    part, silence = frames.framed["request"].code, _silence(frames, message, is_broadcast)
    code = head[part.name] if part is not None else None
    out_of_range = judging.first_out_of_range(frames.layout.device, message.request, values)
    return Request(head, code, message, silence, is_broadcast, "", (), message, values, out_of_range)


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
        if type(value) is int:
            key.append(value)
        elif type(value) is list and all(type(number) is int for number in value):
            key.append(tuple(value))
        else:
            return None
    return tuple(key)
