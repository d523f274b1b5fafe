"""Values that messages read and write in pieces, resolved: the messages, the fields and the bits."""

from __future__ import annotations

from fieldspec.codec.layout.refusal import Refusal
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.language.model.encoding import is_count, is_octets
from fieldspec.language.model.segments import NumberPlace, initial_number, number_places

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping
    from typing import Any, Literal

    from fieldspec.codec.layout.device import DeviceLayout
    from fieldspec.codec.layout.message import MessageLayout
    from fieldspec.codec.layout.record import FieldLayout, RecordLayout
    from fieldspec.language.model.enums import Flags
    from fieldspec.language.model.record import Segments, SegmentsAbort


@dataclass(frozen=True, slots=True)
class AbortLayout:
    """The message that ends a transfer: its field `reason` has the number of one of two causes."""

    message: MessageLayout
    reason: str
    counter: int
    size: int
    flags: Mapping[str, Flags]

    def request(self, first: Mapping[str, Any], cause: str) -> dict[str, Any]:
        """The fields of the request, for what the request with the fields `first` has begun.

        The `cause` is `counter` or `size`.
        """
        record = self.message.request
        repeated = {field.name: first[field.name] for field in record.fields if field.name in first}
        constants = {
            field.name: field.value.const
            for field in record.fields
            if field.value is not None and field.value.const is not None
        }
        number = self.counter if cause == "counter" else self.size
        return {**_initial(record, self.flags), **repeated, **constants, self.reason: number}


@dataclass(frozen=True, slots=True)
class SegmentsLayout:
    """A value that follows the message `first` in pieces, each in the message `piece`.

    `size` is the field of `first` with the number of bytes of the value, None without one. For reading, `by` is the
    field of its response with one of `numbers` where pieces follow; with those in `unsized`, `size` has no meaning.
    `data` is the field with a piece. `asked` and `answered` are the places of the counter in the two directions.
    """

    first: MessageLayout
    piece: MessageLayout
    reads: bool
    by: str
    numbers: tuple[int, ...]
    unsized: frozenset[int]
    size: FieldLayout | None
    data: FieldLayout
    asked: NumberPlace | None
    answered: NumberPlace | None
    unused: NumberPlace | None
    last: NumberPlace | None
    flags: Mapping[str, Flags]
    abort: AbortLayout | None = None

    def follows(self, values: Mapping[str, Any]) -> bool:
        """Whether pieces follow a response of the first message."""
        return self.reads and int(values[self.by]) in self.numbers

    def stated_size(self, values: Mapping[str, Any]) -> int | None:
        """The number of bytes of the value that the first message says; None where it says none."""
        if self.size is None or (self.reads and int(values[self.by]) in self.unsized):
            return None
        content = values[self.size.name]
        return int.from_bytes(content, _order(self.size)) if isinstance(content, bytes) else int(content)

    def size_content(self, size: int) -> dict[str, Any]:
        """The field that says the number of bytes of the value. Raises OverflowError where it cannot."""
        if self.size is None:
            return {}
        is_bytes = is_octets(self.size.primitive.encoding)
        return {self.size.name: size.to_bytes(self.size.size, _order(self.size)) if is_bytes else size}

    def request(self, count: int, piece: bytes = b"", is_last: bool = False) -> dict[str, Any]:
        """The fields of the request with, or for, the piece after `count` others."""
        values = _initial(self.piece.request, self.flags)
        _place(values, self.asked, self.asked.number_behind(count) if self.asked is not None else 0)
        return values if self.reads else self._with_piece(values, piece, is_last)

    def response(self, count: int, piece: bytes = b"", is_last: bool = False) -> dict[str, Any]:
        """The fields of the response with, or for, the piece after `count` others."""
        values = _initial(self.piece.response, self.flags)
        _place(values, self.answered, self.answered.number_behind(count) if self.answered is not None else 0)
        return self._with_piece(values, piece, is_last) if self.reads else values

    def _with_piece(self, values: dict[str, Any], piece: bytes, is_last: bool) -> dict[str, Any]:
        _place(values, self.unused, self.data.size - len(piece))
        _place(values, self.last, int(is_last))
        values[self.data.name] = piece.ljust(self.data.size, b"\0")
        return values

    def has_number(self, values: Mapping[str, Any], count: int, place: NumberPlace | None) -> bool:
        """Whether a message counts as the piece after `count` others."""
        return place is None or place.number(int(values[place.field.name])) == place.number_behind(count)

    def is_last(self, values: Mapping[str, Any]) -> bool:
        """Whether a message says that it has the last piece."""
        return self.last is not None and bool(self.last.number(int(values[self.last.field.name])))

    def content(self, values: Mapping[str, Any], left: int | None) -> bytes | None:
        """The bytes of a piece, of which the value still needs `left`; None where more are unused than it has."""
        data = bytes(values[self.data.name])
        unused = self.unused.number(int(values[self.unused.field.name])) if self.unused is not None else 0
        if unused > len(data):
            return None
        return data[: len(data) - unused] if self.unused is not None or left is None else data[:left]

    def pieces(self, data: bytes) -> Iterator[tuple[bytes, bool]]:
        """A value in pieces, each with whether it is the last one; there is one at least."""
        size = self.data.size
        for offset in range(0, max(len(data), 1), size):
            yield data[offset : offset + size], offset + size >= len(data)


def _order(field: FieldLayout) -> Literal["big", "little"]:
    return "little" if field.order == "little" else "big"


def _place(values: dict[str, Any], place: NumberPlace | None, number: int) -> None:
    if place is not None:
        values[place.field.name] = place.placed(int(values[place.field.name]), number)


def _initial(record: RecordLayout, flags: Mapping[str, Flags]) -> dict[str, Any]:
    """The numbers of all fields that are numbers, before anything is put in."""
    return {
        field.name: initial_number(field.field, flags)
        for field in record.fields
        if field.value is not None and is_count(field.value.encoding) and not field.is_list
    }


def segments_of(layout: DeviceLayout, first: MessageLayout) -> SegmentsLayout | None:
    """How a value follows a message in pieces; None where none does."""
    stated = first.message.segments
    if stated is None:
        return None
    piece = layout.messages[stated.message]
    carrier, own = (piece.response, first.response) if stated.reads else (piece.request, first.request)
    flags = layout.device.flags
    data = carrier.named(stated.data)
    assert data is not None

    def place(record: RecordLayout, name: str) -> NumberPlace | None:
        return next(number_places(flags, record.record, name), None) if name else None

    deciding = _deciding(first)
    return SegmentsLayout(
        first,
        piece,
        stated.reads,
        deciding.name if deciding is not None else "",
        _numbers(layout, deciding, stated.when),
        frozenset(_numbers(layout, deciding, stated.unsized)),
        own.named(stated.size) if stated.size else None,
        data,
        place(piece.request, stated.counter),
        place(piece.response, stated.counter),
        place(carrier, stated.unused),
        place(carrier, stated.last),
        flags,
        _abort(layout, stated.abort) if stated.abort is not None else None,
    )


def _abort(layout: DeviceLayout, stated: SegmentsAbort) -> AbortLayout:
    message = layout.messages[stated.message]
    field = message.request.named(stated.reason)
    assert field is not None
    counter, size = _numbers(layout, field, (stated.counter, stated.size))
    return AbortLayout(message, stated.reason, counter, size, layout.device.flags)


def piece_refusals(layout: DeviceLayout, reader: str) -> list[Refusal]:
    """A refusal of each message whose value follows in pieces, and of the messages with the pieces.

    `reader` is what does not put them together.
    """
    refusals: list[Refusal] = []
    for message in layout.device.messages.values():
        stated = message.segments
        if stated is None:
            continue
        text = f"the value of {message.name} is in pieces, which {reader} does not put together"
        finding = Diagnostic("plc_values_whole", text, message.place["segments"], help=LEAVE_OUT)
        names = (message.name, stated.message, *([stated.abort.message] if stated.abort is not None else []))
        refusals += (Refusal(layout.device.messages[name], finding) for name in dict.fromkeys(names))
    return refusals


def _deciding(first: MessageLayout) -> FieldLayout | None:
    """The field of a response that says how many of its bytes are the value, or that pieces follow."""
    stated: Segments | None = first.message.segments
    if stated is None or not stated.reads:
        return None
    for field in first.response.fields:
        part = field.value.parameter if field.value is not None else None
        if part is not None and part.sizes is not None:
            return first.response.named(part.sizes.by)
    return None


def _numbers(layout: DeviceLayout, field: FieldLayout | None, names: Iterable[str]) -> tuple[int, ...]:
    """The numbers of some members of a field's enum, in the order of their names."""
    enum = layout.device.enums[field.value.enum] if field is not None and field.value is not None else None
    members = (enum.named(name) for name in names) if enum is not None else ()
    return tuple(member.value for member in members if member is not None)
