"""The answers of the reference codec, with which all judges are compared."""

from __future__ import annotations

from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.reference import CodecError, DeviceCodec, codec
from fieldspec.codec.reference.quantities import special_name
from fieldspec.codec.reference.records import decoded, decoded_value, encoded, encoded_value
from fieldspec.codec.reference.structs import value_construct
from fieldspec.foundation.classes import replace
from random_devices.queries import UNKNOWN, Answer, Query, flat, flat_value, is_stable, refused, to_encode


class Reference:
    """The answers of the reference codec."""

    def __init__(self, layout: DeviceLayout) -> None:
        self.layout = layout
        self.codec: DeviceCodec = codec(layout)

    def answer(self, query: Query) -> Answer:
        """The answer to one query."""
        try:
            if query.kind == "frame":
                return self._frame(query)
            if query.kind == "record":
                return self._record(query)
            return self._value(query)
        except CodecError as error:
            answer = refused(error)
            # A value alone is in no frame; an error about it may leave out where it is.
            return answer if query.kind in ("frame", "record") else Answer(answer.reason)

    def _frame(self, query: Query) -> Answer:
        link, direction, message = query.path
        reference = self.codec.links[link]
        if query.values is not None:
            frame = reference.encode(direction, message, query.values, error=query.error, code=query.code)
            return Answer(again=frame.hex())
        result = reference.decode(query.data, direction, message)
        assert result.body is not None
        shape = self.layout.links[link].frame(direction)
        code = shape.role("code")
        head = {part.name: result.head[part.name] for part in shape.header if part.is_argument}
        number = result.head[code.name] if code is not None else None
        name = result.message.name if result.message is not None else ""
        values = to_encode(result.body, result.values)
        text = "".join(f"{value};" for value in head.values()) + f"|{int(result.error)}|{number}|"
        text += flat(result.body, result.values)
        try:
            again = reference.encode(direction, name, {**head, **values}, error=result.error, code=number).hex()
        except CodecError as error:
            again = "!" + error.reason
        return Answer(values=text, again=again, is_stable=is_stable(values))

    def _record(self, query: Query) -> Answer:
        record: RecordLayout = query.shape
        if query.values is not None:
            return Answer(again=encoded(record, query.values, self.layout.device).hex())
        values = decoded(record, query.data, self.layout.device)
        try:
            again = encoded(record, to_encode(record, values), self.layout.device).hex()
        except CodecError as error:
            again = "!" + error.reason
        return Answer(values=flat(record, values), again=again, is_stable=is_stable(values))

    def _value(self, query: Query) -> Answer:
        value, order, swapped, trigger, size = query.shape
        name = query.path[-1]
        if query.values is not None:
            return Answer(again=self._encoded(query.shape, name, query.values[name]))
        if len(query.data) != size:
            return Answer("incomplete" if len(query.data) < size else "wrong_length", UNKNOWN)
        # What a device answers is read, whatever it is: a constant binds writing, and so does the enum of a trigger.
        answer = replace(value, const=None, enum="" if trigger else value.enum)
        raw = value_construct(answer, order, swapped).parse(query.data[: value.size])
        result = decoded_value(name, answer, raw, self.layout.device, None)
        try:
            again = self._encoded(query.shape, name, result)
        except CodecError as error:
            again = "!" + error.reason
        return Answer(values=flat_value(value, result), again=again, is_stable=is_stable(result))

    def _encoded(self, shape: Any, name: str, raw: Any) -> str:
        value, order, swapped, _, size = shape
        absent = isinstance(raw, int | float) and bool(special_name(value, raw))
        is_number = isinstance(raw, int | float)
        if value.write_ranges is not None and is_number and raw not in value.write_ranges and not absent:
            raise CodecError("out_of_range", f"{name} is {raw}, and may not be written")
        # Writing a trigger takes what its enum lists, as writing anything does.
        number = encoded_value(name, value, raw, self.layout.device)
        is_swapped = swapped != bool(value.write_word_order)
        data: bytes = value_construct(value, order, is_swapped).build(number)
        return data.ljust(size, b"\0").hex()
