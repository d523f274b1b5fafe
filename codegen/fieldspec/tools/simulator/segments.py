"""Values of parameters that a simulated device sends and takes in pieces."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.segments import SegmentsLayout, segments_of
from fieldspec.codec.reference.parameters import data_of_value, orders_of, value_of_data
from fieldspec.codec.reference.records import CodecError
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.encoding import is_text
from fieldspec.language.model.value import Value
from fieldspec.tools.simulator.refusal import Refusal

if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from fieldspec.codec.layout.record import FieldLayout
    from fieldspec.codec.layout.values import Raw
    from fieldspec.language.model.device import Device
    from fieldspec.tools.simulator.target import Target


@dataclass(slots=True)
class Transfer:
    """A value on its way: the fields of the request that has begun it, and the bytes so far or still to come.

    `size` is the number of bytes that the request has announced, None without one, and `count` that of the pieces.
    """

    pieces: SegmentsLayout
    target: Target
    value: Value
    fields: Mapping[str, Any]
    content: bytes = b""
    size: int | None = None
    count: int = 0


class Transfers:
    """The values that are on their way, one for each link: `running` is the memory of them.

    Any request but the next piece ends one, and so does a loss of power.
    """

    def __init__(self, layout: DeviceLayout, running: dict[str, Transfer]) -> None:
        self.layout, self.running = layout, running
        known = ((name, segments_of(layout, message)) for name, message in layout.messages.items())
        self.by_first = {name: pieces for name, pieces in known if pieces is not None}
        self.pieces = frozenset(pieces.piece.name for pieces in self.by_first.values())

    def fields(self, link: str, message: MessageLayout) -> Mapping[str, Any]:
        """The fields of the request that began the transfer which a request with a piece continues."""
        transfer = self.running.get(link)
        return transfer.fields if transfer is not None and message.name in self.pieces else {}

    def begin_read(self, link: str, transfer: Transfer, raw: Raw) -> dict[str, Any]:
        """Begins to send a value: the fields of the response that say so. Raises Refusal."""
        pieces = transfer.pieces
        transfer.content = sent_bytes(self.layout.device, pieces.data, transfer.value, raw)
        sized = [number for number in pieces.numbers if number not in pieces.unsized]
        unsized = [number for number in pieces.numbers if number in pieces.unsized]
        try:
            size = pieces.size_content(len(transfer.content)) if sized else {}
        except OverflowError:
            sized, size = [], {}
        if not (sized or unsized):
            raise Refusal("type_invalid", f"no response can announce {len(transfer.content)} bytes")
        self.running[link] = transfer
        return {pieces.by: (sized or unsized)[0], **size}

    def begin_write(self, link: str, transfer: Transfer) -> None:
        """Begins to take a value. Raises Refusal for a number of bytes that it cannot have."""
        pieces, value = transfer.pieces, transfer.value
        transfer.size = pieces.stated_size(transfer.fields)
        if transfer.size is not None and not _fits(value, transfer.size):
            raise Refusal("type_invalid", f"the value has {value.size} bytes, not {transfer.size}")
        self.running[link] = transfer

    def next(
        self, link: str, message: MessageLayout, values: Mapping[str, Any]
    ) -> tuple[dict[str, Any], Transfer | None, Raw | None]:
        """The fields of the response to a request with or for a piece.

        With the last piece of a value that is written come its transfer and the raw value. Raises Refusal.
        """
        transfer = self.running.pop(link, None)
        if transfer is None or transfer.pieces.piece.name != message.name:
            raise Refusal("segment_unexpected", "no value is on its way")
        pieces, count = transfer.pieces, transfer.count
        if not pieces.has_number(values, count, pieces.asked):
            raise Refusal("segment_order", f"the piece after {count} others is next")
        if pieces.reads:
            size = pieces.data.size
            piece, transfer.content = transfer.content[:size], transfer.content[size:]
            is_last, answer, raw = not transfer.content, pieces.response(count, piece, not transfer.content), None
        else:
            is_last, raw = self._taken(transfer, values)
            answer = pieces.response(count)
        transfer.count += 1
        if not is_last:
            self.running[link] = transfer
        return answer, transfer if is_last and not pieces.reads else None, raw

    def _taken(self, transfer: Transfer, values: Mapping[str, Any]) -> tuple[bool, Raw | None]:
        """Takes a piece: whether it is the last one, and then the raw value. Raises Refusal."""
        pieces, size = transfer.pieces, transfer.size
        piece = pieces.content(values, None if size is None else size - len(transfer.content))
        if piece is None:
            raise Refusal("type_invalid", "more bytes of a piece are unused than it has")
        transfer.content += piece
        if len(transfer.content) > (transfer.value.size if size is None else size):
            raise Refusal("type_invalid", f"{len(transfer.content)} bytes are too many")
        is_last = pieces.is_last(values) if pieces.last is not None else len(transfer.content) == size
        if not is_last:
            return False, None
        if size is not None and len(transfer.content) != size:
            raise Refusal("type_invalid", f"{size} bytes were announced, and {len(transfer.content)} came")
        try:
            orders = orders_of(self.layout.device, pieces.data, transfer.value)
            return True, value_of_data(transfer.value, transfer.content, *orders)
        except CodecError as error:
            raise Refusal("type_invalid", error.detail) from None


def sent_bytes(device: Device, field: FieldLayout, value: Value, raw: Raw) -> bytes:
    """The bytes of a value that a device sends: of a text, without the zeros that fill it up."""
    data = data_of_value(value, raw, *orders_of(device, field, value))
    return data.rstrip(b"\0") if is_text(value.encoding) and value.text_form is None else data


def _fits(value: Value, size: int) -> bool:
    """Whether a value may have a number of bytes: exactly its own, or fewer for a text."""
    return size <= value.size if is_text(value.encoding) else size == value.size
