"""Answers frames: decodes a request by the reference codec, carries it out, and encodes the response."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache

from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.reference.frames import FrameCodec, codec
from fieldspec.codec.reference.parameters import bytes_of_value, carries, field_of_bytes, value_of_bytes
from fieldspec.codec.reference.records import CodecError
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.behaviour.part import Part
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.escape import CAN_REMOTE
from fieldspec.tools.simulator import parameters, raw_values
from fieldspec.tools.simulator.access_steps import carry_out_steps
from fieldspec.tools.simulator.bare_requests import Decoder
from fieldspec.tools.simulator.engine import Engine
from fieldspec.tools.simulator.memory import default_raw, element_value
from fieldspec.tools.simulator.received import number_key, received
from fieldspec.tools.simulator.refusal import Refusal, reason_place
from fieldspec.tools.simulator.register_requests import read_bits, read_registers, write_bits, write_registers
from fieldspec.tools.simulator.segments import Transfer, Transfers, sent_bytes
from fieldspec.tools.simulator.target import Target

if TYPE_CHECKING:
    from typing import Any


_MOST_KNOWN = 64
"""The frames of which a device remembers what they ask for."""


@dataclass(frozen=True, slots=True)
class Answer:
    """The answer to a frame: its bytes, empty for silence, and what it is, for people."""

    frame: bytes
    text: str


class Server:
    """A device on its links, at a unit address. `complain` takes the reason where no frame can be the response.

    `decoders` decode requests on some links instead of the reference codec, where they can.
    """

    def __init__(self, engine: Engine, unit_address: int = 1, decoders: Mapping[str, Decoder] | None = None) -> None:
        self.complain: Callable[[str], None] = lambda reason: None
        self.engine, self.unit_address = engine, unit_address
        self.codecs = codec(engine.layout).links
        self.refusals: dict[str, Part] = {part.subject: part for part in engine.behaviour.of_kind("refuse")}
        self.transfers = Transfers(engine.layout, engine.memory.transfers)
        self.answers = {part.subject: part for part in engine.behaviour.of_kind("answer")}
        self._received = lru_cache(_MOST_KNOWN)(
            lambda link, frame, message: received(
                self.codecs[link], unit_address, frame, message, (decoders or {}).get(link)
            )
        )
        """The requests in frames: observers of a device repeat the same requests."""
        self._frames: dict[tuple[object, ...], bytes] = {}

    def answer(self, link: str, frame: bytes, message: str = "", forced: str = "") -> Answer:
        """The answer to a frame; the engine has been advanced to the present.

        `message` names the message where the frame does not; `forced` is a reason to refuse.
        """
        frames = self.codecs[link]
        request = self._received(link, frame, message)
        if isinstance(request, str):
            return Answer(b"", request)
        if request.damage and not forced:
            return Answer(b"", f"damaged: {request.damage}")
        announced, values = request.message, dict(request.values or {})
        began = self.transfers.fields(link, announced) if announced is not None else {}
        try:
            if forced:
                raise Refusal(forced, "by a fault")
            if announced is None:
                raise Refusal(*request.objection)
            if request.is_broadcast and not (announced.message.broadcast and self._accepts_broadcast()):
                return Answer(b"", "broadcast, not accepted")
            body = self._carried_out(link, announced, values, request.out_of_range)
            self.engine.refresh()
            if not request.silence:
                return self._encoded(frames, request.head, announced, values, body)
        except Refusal as refusal:
            if not forced:
                refused = request.announced.message if request.announced is not None else None
                names = {refused.place.path, *refused.roles} if refused is not None else set()
                self.engine.follow_refusal(names, refusal.reason)
            if request.silence:
                return Answer(b"", f"{request.silence}: {refusal}")
            asked_values = {} if forced else {**began, **(request.values or {})}
            return self._refused(frames, request.head, request.code, refusal, asked_values)
        return Answer(b"", f"{request.silence}: {announced.name}")

    def _accepts_broadcast(self) -> bool:
        parts = [part for part in self.engine.behaviour.of_kind("accept") if part.subject == "broadcast"]
        return all(self.engine.holds(part.get("if") or {}) for part in parts)

    def _carried_out(
        self, link: str, announced: MessageLayout, values: dict[str, Any], out_of_range: str
    ) -> dict[str, Any]:
        """Carries out a request: the values of the response that are not computed. Raises Refusal.

        `out_of_range` is the value that is out of its range, if one is.
        """
        engine, message = self.engine, announced.message
        if announced.name in self.transfers.pieces:
            return self._of_piece(link, announced, values)
        self.transfers.running.pop(link, None)
        access = message.single_access
        if access is not None:
            is_of_bits = engine.layout.device.bit_access(message) is not None
            read, write = (read_bits, write_bits) if is_of_bits else (read_registers, write_registers)
            reasons: list[Refusal] = []
            if out_of_range:
                reason = "count_invalid" if out_of_range == access.count else "value_invalid"
                reasons.append(Refusal(reason, f"{out_of_range} is out of range"))
            try:
                if access.operation == "read":
                    count = int(values[access.count]) if access.count else 1
                    if not reasons:
                        return {access.values: read(engine, access, values)}
                    read(engine, access, {**values, access.count: min(count, 1)})
                elif not reasons:
                    write(engine, access, values)
                    return {}
            except Refusal as refusal:
                reasons.append(refusal)
            raise min(reasons, key=self._exception_number)
        if message.access_steps:
            return carry_out_steps(engine, announced, values, self._exception_number)
        if out_of_range:
            raise Refusal("value_invalid", f"{out_of_range} is out of range")
        self._store(announced.request, message.request.place.path, values)
        size = message.segments.size if message.segments is not None else ""
        target = parameters.target_of(engine, announced.request, values, size)
        if target is not None:
            return self._of_parameter(link, announced, values, target)
        values_field = parameters.part_of(announced.request, "values")
        if values_field is not None and values_field.value is not None and values_field.value.parameter is not None:
            parameters.write_all(engine, values_field.value.parameter.set, values[values_field.name])
        engine.follow_message(message.name, message.place.path, message.roles)
        engine.refresh()
        return {}

    def _exception_number(self, refusal: Refusal) -> int:
        """The number of the exception for a reason: where several apply, the lowest is sent."""
        part = self.refusals.get(refusal.reason)
        number = self._exception(part) if part is not None else None
        return 0x10000 if number is None else number

    def _of_piece(self, link: str, announced: MessageLayout, values: dict[str, Any]) -> dict[str, Any]:
        """Carries out a request with a piece of a value, or for one. Raises Refusal."""
        body, ended, raw = self.transfers.next(link, announced, values)
        if ended is not None and raw is not None:
            parameters.write_parameter(self.engine, ended.target, [raw])
            first = ended.pieces.first.message
            self.engine.follow_message(first.name, first.place.path, first.roles)
        return body

    def _of_parameter(
        self, link: str, announced: MessageLayout, values: dict[str, Any], target: Target
    ) -> dict[str, Any]:
        engine, request, response = self.engine, announced.request, announced.response
        key = (target.set_name, target.number)
        value = element_value(target.parameter, target.first) if target.parameter is not None else None
        value_field = parameters.part_of(request, "value")
        carried = value_field or parameters.part_of(response, "value")
        pieces = self.transfers.by_first.get(announced.name)
        if value is None and (pieces is not None or (carried is not None and carried.carries_bytes)):
            raise Refusal("unknown_address", f"the size of parameter {target.number} is unknown")
        if value_field is not None:
            kind = raw_values.chosen_kind(request, values)
            if kind is not None and value is not None and kind != value.type.name:
                raise Refusal("type_invalid", f"the parameter is {value.type.name}, not {kind}")
            raw = values[value_field.name]
            if value_field.carries_bytes and value is not None:
                try:
                    raw = value_of_bytes(engine.layout.device, value_field, value, values)
                except CodecError as error:
                    raise Refusal("type_invalid", error.detail) from None
            raws = [int(item) if isinstance(item, bool) else item for item in (raw if isinstance(raw, list) else [raw])]
            if value is not None:
                raws = [raw_values.in_parameter(item, value_field, value) for item in raws]
            parameters.write_parameter(engine, target, raws)
            if request.selector is not None:
                engine.memory.formats[key] = values[request.selector.name]
            engine.follow_message(announced.name, announced.message.place.path, announced.message.roles)
            return {}
        answer_field = parameters.part_of(response, "value")
        if pieces is not None and not pieces.reads and value is not None:
            parameters.refuse_unwritable(target)
            self.transfers.begin_write(link, Transfer(pieces, target, value, values))
            return {}
        if answer_field is None:
            return {}
        engine.refresh()
        read = parameters.read_parameter(engine, target)
        if answer_field.carries_bytes and value is not None:
            data = sent_bytes(engine.layout.device, answer_field, value, read[0])
            if pieces is not None and not carries(answer_field, len(data)):
                return self.transfers.begin_read(link, Transfer(pieces, target, value, values), read[0])
            if pieces is not None and len(data) < value.size:
                return field_of_bytes(answer_field, data)
            if not carries(answer_field, value.size):
                raise Refusal("type_invalid", f"no response carries {value.size} bytes")
            return bytes_of_value(engine.layout.device, answer_field, value, read[0])
        if response.selector is None:
            return {answer_field.name: raw_values.in_type(read[0], answer_field)}
        number = engine.memory.formats.get(key)
        if number is None and value is not None:
            number = raw_values.number_of_kind(response, value.type.name)
        if number is None:
            raise Refusal("format_invalid", "no format carries the value")
        return {response.selector.name: number, answer_field.name: read}

    def _store(self, record: RecordLayout, path: str, values: Mapping[str, Any]) -> None:
        """Copies the fields of a request to where rules read them."""
        memory = self.engine.memory
        for field in record.fields:
            value, own = values.get(field.name), field.field.place.path
            if field.record is not None:
                carried: list[Any] = value if isinstance(value, list) else [value]
                memory.lists[own] = [{**item} for item in carried]
            elif isinstance(value, bool):
                memory.fields[own] = int(value)
            elif isinstance(value, int | float | bytes):
                memory.fields[own] = value

    def _encoded(
        self,
        frames: FrameCodec,
        head: Mapping[str, Any],
        announced: MessageLayout,
        values: Mapping[str, Any],
        body: Mapping[str, Any],
    ) -> Answer:
        """The response of a message. Raises Refusal."""
        response = self._head(frames, head)
        for field in raw_values.decided_fields(announced.response, response):
            if field.field.measures is None:
                response[field.name] = body[field.name] if field.name in body else self._field(field, values)
            if field.presence is not None and field.presence.numbers and field.name not in body:
                response[field.name] = raw_values.initial_value(self.engine.layout.device, field, response)
        response = announced.response.with_list_bits(response)
        try:
            return Answer(self._frame(frames, announced.name, response), announced.name)
        except CodecError as error:
            return self._unsaid(frames, f"no response of {announced.name} can say this: {error}")

    def _frame(self, frames: FrameCodec, message: str, values: Mapping[str, Any]) -> bytes:
        """The frame of a response; that of the same numbers is remembered. Raises CodecError."""
        key = frames.link.name, message, tuple(values), number_key(values.values())
        if key[-1] is None:
            return frames.encode("response", message, values)
        if key not in self._frames:
            if len(self._frames) == _MOST_KNOWN:
                del self._frames[next(iter(self._frames))]
            self._frames[key] = frames.encode("response", message, values)
        return self._frames[key]

    def _field(self, field: FieldLayout, values: Mapping[str, Any]) -> Any:
        """The value of a field of a response: that of the request, records of a collection, or what is in memory."""
        engine, path = self.engine, field.field.place.path
        if field.field.same_as:
            return values[field.field.same_as]
        if field.record is not None:
            part = self.answers.get(path)
            if part is None:
                return raw_values.initial_value(engine.layout.device, field)
            records = self._records(part)
            if not records and not field.is_list:
                raise Refusal("value_invalid", f"there is no {field.name}")
            return records if field.is_list else records[0]
        value = field.value
        if value is not None and value.parameter is not None and value.parameter.part == "values":
            return parameters.all_values(engine, value.parameter.set, field.is_list)
        cell = next(iter(engine.cells.of(path)), None)
        is_unset = cell is None or (cell.value is None and path not in engine.memory.fields)
        if cell is None or is_unset or field.is_list or (value is not None and value.const is not None):
            return raw_values.initial_value(engine.layout.device, field)
        return raw_values.in_case(engine.layout.device, cell.read(), field)

    def _records(self, part: Part) -> list[dict[str, Any]]:
        """The records of a collection that answer. Raises Refusal if the requested record is missing."""
        engine = self.engine
        records: list[dict[str, Any]] = engine.memory.lists.get(part["from"], [])
        collection = engine.behaviour.named("collection", part["from"])
        key = collection.get("key") if collection is not None else None
        if part.get("at") is not None and key is not None:
            number = round(engine.number(part["at"]))
            records = [record for record in records if record[key] == number]
            if not records:
                raise Refusal("value_invalid", f"{part['from']} has no record {number}")
        if part.get("start") is not None and key is not None:
            first = round(engine.number(part["start"]))
            records = [record for record in records if record[key] >= first]
        return [{**record} for record in records[: part.get("most") or len(records)]]

    def _head(self, frames: FrameCodec, head: Mapping[str, Any]) -> dict[str, Any]:
        """The parts of the response's frame that nothing else decides, from the request or from memory."""
        values: dict[str, Any] = {}
        for part in frames.link.response.header:
            if part.role in ("length", "checksum", "code"):
                continue
            if part.role == "unit_address":
                values[part.name] = self.unit_address
            elif part.constant is not None:
                values[part.name] = part.constant
            elif part.part.same_as:
                values[part.name] = head[part.part.same_as]
            elif part.name in head and raw_values.permits(part.value, head[part.name]):
                values[part.name] = head[part.name]
            else:
                cell = next(iter(self.engine.cells.of(part.part.place.path)), None)
                usual = default_raw(self.engine.layout.device, part.value) if part.value is not None else 0
                values[part.name] = cell.read() if cell is not None else usual
        mark = frames.link.link.exception_response
        if mark is not None and mark.normal is not None and values[mark.part] not in mark.normal:
            values[mark.part] = mark.normal.low
        return values

    def _refused(
        self, frames: FrameCodec, head: Mapping[str, Any], code: int | None, refusal: Refusal, fields: Mapping[str, Any]
    ) -> Answer:
        """The response that refuses a request, or silence.

        A field of the response with the name of a field of the request repeats it, and one that is the same as the code
        repeats that; others that give no reason are 0.
        """
        engine, part = self.engine, self.refusals.get(refusal.reason)
        text = f"refused, {refusal}"
        if part is None:
            return self._unsaid(frames, f"{text}; the device is silent, as no `refuse` says what it answers")
        if (marked := part.get("mark")) is not None:
            engine.refresh()
            return self._marked(frames, head, marked, text)
        record, number = frames.link.link.exception_response, self._exception(part)
        if record is None or number is None:
            return self._unsaid(frames, f"{text}; the device is silent")
        values, coded = self._head(frames, head), frames.link.request.role("code")
        printed_code = code & ~CAN_REMOTE if code is not None and frames.link.link.is_can else code
        for field in engine.layout.records[record.record].fields:
            value = field.value
            if value is not None and value.const is None and is_count(value.encoding) and not field.is_list:
                is_code = coded is not None and field.field.same_as == coded.name
                values[field.name] = printed_code if is_code else fields.get(field.name, 0)
        values[reason_place(engine.layout, frames.link, record)[0]] = number
        code = part.get("code", code) if record.code is None else record.code
        is_uncoded = frames.link.has_uncoded_exceptions
        known = frames.link.message_with_code(code) if code is not None and not is_uncoded else None
        announced = frames.link.messages_with_code(code) if code is not None and "code" not in part.keys else []
        if announced:
            code = announced[0].message.code_of("response")
        flagged = code is not None and (code & record.flag or code == record.code)
        try:
            frame = frames.encode(
                "response", known.name if known and not flagged else "", values, error=True, code=code
            )
        except CodecError as error:
            return self._unsaid(frames, f"{text}; no response can say so: {error}")
        return Answer(frame, text)

    def _unsaid(self, frames: FrameCodec, text: str) -> Answer:
        """An answer without a frame, where no frame can say what is due."""
        self.complain(f"{frames.link.name}: {text}")
        return Answer(b"", text)

    def _exception(self, part: Part) -> int | None:
        """The number of the exception that a part names."""
        name = part.get("with")
        for link in self.engine.layout.device.links.values():
            if (record := link.exception_response) is not None and name is not None:
                enum = reason_place(self.engine.layout, self.codecs[link.name].link, record)[1].enum
                member = self.engine.layout.device.enums[enum].named(name) if enum else None
                if member is not None:
                    return member.value
        return None

    def _marked(self, frames: FrameCodec, head: Mapping[str, Any], marked: str, text: str) -> Answer:
        """A response without data, with a bit set in its header."""
        answering_messages = frames.link.carried("response").values()
        empty = next((message for message in answering_messages if not message.response.fields), None)
        if empty is None:
            return self._unsaid(frames, f"{text}; the device is silent")
        cells = self.engine.cells.of(marked)
        before = [cell.read() for cell in cells]
        for cell in cells:
            cell.write(1)
        frame = frames.encode("response", empty.name, self._head(frames, head))
        for cell, raw in zip(cells, before, strict=True):
            cell.write(raw)
        return Answer(frame, text)
