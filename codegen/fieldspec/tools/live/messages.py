"""Values beside registers: parameters that messages read and write, and fields of responses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.codec.explain.hazards import is_bare, is_query, is_single, reads_state, roles_of, write_hazards
from fieldspec.codec.explain.values import DecodedValue, decode_value
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import Orders, RecordLayout
from fieldspec.codec.layout.segments import segments_of
from fieldspec.codec.layout.values import MeaningError, raw_value
from fieldspec.codec.reference.parameters import bytes_of_value, carries, number_in_field, value_of_bytes, value_of_data
from fieldspec.codec.reference.records import CodecError, encoded_value
from fieldspec.codec.reference.structs import value_construct
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.encoding import is_exact
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.registers import Parameter, ParameterSet
from fieldspec.language.model.segments import initial_number
from fieldspec.language.model.text_form import text_bytes
from fieldspec.language.model.value import Value
from fieldspec.tools.live.client import Client, NoAnswerError, RefusedError, UnfitAnswerError
from fieldspec.tools.live.segments import read_pieces, write_pieces
from fieldspec.tools.live.writing import WriteError
from fieldspec.tools.simulator.parameters import count_field, part_of

if TYPE_CHECKING:
    from typing import Any, Literal


@dataclass(frozen=True, slots=True)
class NumberedParameter:
    """A parameter with its set, and its number on the wire."""

    parameter_set: ParameterSet
    parameter: Parameter
    wire_number: int


@dataclass(frozen=True, slots=True)
class Signal:
    """A value that messages carry: a parameter, or a field or a part of the response to `query`.

    `path` is its name for people. `numbered` is the parameter, None for other values, and `index` the number of an
    element, None for a single value.
    """

    path: str
    fact: Fact
    value: Value
    order: str
    swapped: bool
    numbered: NumberedParameter | None = None
    index: int | None = None
    query: str = ""

    @property
    def access(self) -> str:
        """Whether a parameter, or its element, can be read and written; empty where nothing says so."""
        return self.numbered.parameter.element_access(self.index or 0) if self.numbered is not None else ""


@dataclass(frozen=True, slots=True)
class SignalReading:
    """A value that was read, or the reason why the device refused it. `words` are its bytes on the wire."""

    signal: Signal
    words: tuple[int, ...]
    decoded: DecodedValue | None
    refusal: str = ""
    is_absent: bool = False

    @property
    def path(self) -> str:
        """The path of the value."""
        return self.signal.path


@dataclass(frozen=True, slots=True)
class ParameterAssignment:
    """A value for a parameter: its raw value, its bytes, and what a person should know before it is written."""

    signal: Signal
    raw: Any
    words: tuple[int, ...]
    hazards: tuple[str, ...]
    mask: tuple[int, ...] = ()

    @property
    def path(self) -> str:
        """The path of the value."""
        return self.signal.path

    @property
    def sent(self) -> object:
        """What its request has: this value alone."""
        return self.path


def link_of(layout: DeviceLayout) -> LinkLayout | None:
    """The default link if its messages read something, else the first one that does; None if no link does."""
    links = (layout.links.get(layout.device.default_link), *layout.links.values())
    return next((link for link in links if link is not None and any(True for _ in signals(layout, link))), None)


def signals(layout: DeviceLayout, link: LinkLayout) -> Iterator[Signal]:
    """Everything that the messages of a link read: fields of responses to requests without arguments, parameters."""
    if is_bare(link):
        return  # a cyclic exchange does not only read
    for message in link.exchanged.values():
        for field in message.response.fields if is_query(message) else ():
            if is_single(field) and field.value is not None:
                path = f"{message.name}.{field.name}"
                yield Signal(path, field.field, field.value, field.order, field.swapped, query=message.name)
    yield from _parts(layout, link)
    orders = Orders(layout.device.byte_order, layout.device.word_order)
    for parameter_set in layout.device.parameters.values():
        reading = parameter_message(link, parameter_set, "read")
        if reading is None:
            continue
        carried = part_of(reading.response, "value")
        for row in parameter_set.parameters:
            for place in range(row.count if not row.reserved else 0):
                name = row.name if row.count == 1 else f"{row.name}[{place}]"
                numbered = NumberedParameter(parameter_set, row, parameter_set.base + row.number + place)
                for path, fact, value, index in _elements(name, row):
                    whole = carried is not None and carried.carries_bytes and reading.message.segments is None
                    if whole and carried is not None and not carries(carried, value.size):
                        continue  # a value that no message carries
                    order, swapped = orders.of(value)
                    yield Signal(path, fact, value, order, swapped, numbered, index)


def _elements(name: str, row: Parameter) -> Iterator[tuple[str, Fact, Value, int | None]]:
    """The elements of a parameter, each with its path, its fact and its index; the index is None for a single value."""
    if row.elements is None:
        yield name, row, row.value, None
        return
    for index in range(row.elements):
        own = row.element(index)
        if own is None:
            yield f"{name}[{index}]", row, row.value, index
        elif not own.reserved:
            is_series = own.indices.low != own.indices.high
            yield f"{name}.{own.name}" + (f"[{index}]" if is_series else ""), own, own.value, index


def _parts(layout: DeviceLayout, link: LinkLayout) -> Iterator[Signal]:
    """The parts of a response that say something about the device, such as a status."""
    query = next((own.name for own in link.exchanged.values() if reads_state(layout, own)), "")
    request_names = {part.name for part in link.request.parts}
    for part in link.response.header:
        if (
            query
            and part.role == "plain"
            and part.constant is None
            and (part.part.same_as or part.name) not in request_names
            and part.value is not None
        ):
            yield Signal(part.name, part.part, part.value, part.order, False, query=query)


def parameter_message(
    link: LinkLayout, parameter_set: ParameterSet, operation: str, size: int | None = None
) -> MessageLayout | None:
    """The message of a link that reads or writes one parameter of a set; the one with the fewest other fields.

    A field with the bytes of a value must be able to carry `size` of them, where that is stated, or they follow it in
    pieces.
    """
    suitable, beginning = [], []
    for message in link.exchanged.values():
        number = part_of(message.request, "number")
        part = number.value.parameter if number is not None and number.value is not None else None
        if part is None or part.set not in (parameter_set.name, parameter_set.space):
            continue
        pieces = message.message.segments
        if pieces is not None and not pieces.reads and operation == "write":
            beginning.append(message)
        sent_field = part_of(message.request, "value")
        carried = sent_field or part_of(message.response, "value")
        if (sent_field is not None) != (operation == "write") or carried is None:
            continue
        follows = pieces is not None and pieces.reads
        if size is None or not carried.carries_bytes or carries(carried, size) or follows:
            suitable.append(message)
    return min(suitable or beginning, key=lambda message: len(message.request.fields), default=None)


def named_signals(layout: DeviceLayout, known: Sequence[Signal], name: str) -> list[Signal]:
    """The signals that a name means: a path, all fields of a message, a parameter by its printed name, a role."""
    exact = [signal for signal in known if signal.path == name]
    if exact:
        return exact
    return [
        signal
        for signal in known
        if signal.path.startswith((f"{name}.", f"{name}["))
        or (signal.fact.printed_name and name == signal.fact.printed_name)
        or name in roles_of(layout.device, signal.fact, signal.value)
    ]


def read_signals(client: Client, chosen: Sequence[Signal]) -> Iterator[SignalReading]:
    """Reads values; one request serves all values of a response. Raises NoAnswerError and CarrierError."""
    answers: dict[str, Any] = {}
    for signal in chosen:
        try:
            if signal.numbered is not None:
                yield signal_reading(client.layout, signal, read_parameter(client, signal))
                continue
            if signal.query not in answers:
                answers[signal.query] = client.ask(signal.query, {})
            answer = answers[signal.query]
            name = signal.fact.name
            yield signal_reading(client.layout, signal, {**answer.values, **answer.head}[name])
        except (RefusedError, UnfitAnswerError) as error:
            yield SignalReading(signal, (), None, str(error))


def read_parameter(client: Client, signal: Signal) -> Any:
    """The raw value of a parameter, or of one element.

    Raises RefusedError, UnfitAnswerError, NoAnswerError and CarrierError.
    """
    assert signal.numbered is not None
    message = parameter_message(client.frames.link, signal.numbered.parameter_set, "read")
    assert message is not None
    first = parameter_address(message, signal)
    answer = client.ask(message.name, first)
    carried = part_of(message.response, "value")
    assert carried is not None
    if carried.carries_bytes:
        pieces = segments_of(client.layout, message)
        try:
            if pieces is not None and pieces.follows(answer.values):
                data = read_pieces(client, pieces, first, answer.values, signal.value.size)
                return value_of_data(signal.value, data, signal.order, signal.swapped)
            return value_of_bytes(client.layout.device, carried, signal.value, answer.values)
        except CodecError as error:
            raise UnfitAnswerError(str(error)) from None
    content = answer.values[carried.name]
    return content[0] if isinstance(content, list) else content


def parameter_address(message: MessageLayout, signal: Signal) -> dict[str, Any]:
    """The fields of a request that name a parameter: its number, the element, and how many elements."""
    request, pieces = message.request, message.message.segments
    number, index = part_of(request, "number"), part_of(request, "subindex")
    assert number is not None
    assert signal.numbered is not None
    values: dict[str, Any] = {number.name: signal.numbered.wire_number}
    if index is not None:
        values[index.name] = signal.index or 0
        count = count_field(request, pieces.size if pieces is not None else "")
        if count is not None:
            values[count.name] = 0 if signal.index is None else 1
    return values


def signal_reading(layout: DeviceLayout, signal: Signal, raw: Any) -> SignalReading:
    """The meaning of a raw value."""
    data = _bytes_of(signal, raw)
    value = signal.value.as_answer(False)
    decoded = decode_value(layout.device, value, data, signal.order, signal.swapped)
    return SignalReading(signal, tuple(data), decoded)


def _bytes_of(signal: Signal, raw: Any) -> bytes:
    """The bytes of a raw value on the wire."""
    value = signal.value
    order: Literal["big", "little"] = "big" if signal.order == "big" else "little"
    is_binary = is_exact(value.encoding) and not (signal.swapped or value.digits)
    if isinstance(raw, int) and is_binary:
        return (int(raw) & ((1 << 8 * value.size) - 1)).to_bytes(value.size, order)
    if isinstance(raw, str):
        return text_bytes(value, signal.order, raw)
    return bytes(value_construct(value, signal.order, signal.swapped).build(raw))


def parameter_assignment(layout: DeviceLayout, link: LinkLayout, signal: Signal, text: str) -> ParameterAssignment:
    """The assignment of a value as people write it. Raises WriteError."""
    if signal.numbered is None:
        raise WriteError(f"{signal.path} is part of a response; only parameters are written")
    message = parameter_message(link, signal.numbered.parameter_set, "write", signal.value.size)
    if message is None:
        raise WriteError(f"no message writes {signal.path} by itself")
    if signal.index is not None and not writes_elements(message):
        raise WriteError(f"{signal.path} is an element of an array, and is not written by itself")
    if signal.access == "ro":
        raise WriteError(f"{signal.path} can only be read")
    value = signal.value.for_writing()
    try:
        raw = encoded_value(signal.path, value, raw_value(layout.device, signal.path, value, text), layout.device)
    except (MeaningError, CodecError) as error:
        raise WriteError(str(error)) from None
    hazards = tuple(_hazards(layout, signal, signal.numbered.parameter, message))
    return ParameterAssignment(signal, raw, tuple(_bytes_of(signal, raw)), hazards)


def writes_elements(message: MessageLayout) -> bool:
    """Whether a message writes one element of a parameter by itself: in bytes, which carry values of any type."""
    carried, pieces = part_of(message.request, "value"), message.message.segments
    has_bytes = carried.carries_bytes if carried is not None else pieces is not None and not pieces.reads
    return has_bytes and part_of(message.request, "subindex") is not None


def _hazards(layout: DeviceLayout, signal: Signal, fact: Parameter, message: MessageLayout) -> Iterator[str]:
    # A message that stores what it writes does so for every parameter.
    handlings = sorted((fact.handling, message.message.handling), key=lambda own: own.memory != "nonvolatile")
    return write_hazards(
        trigger=fact.trigger,
        access=signal.access,
        restart=fact.restart,
        handlings=handlings,
        roles=(*fact.roles, *roles_of(layout.device, signal.fact, signal.value)),
    )


def parameter_request(client: Client, chosen: ParameterAssignment) -> tuple[str, dict[str, Any], bytes]:
    """The message that writes a parameter, its fields, and its frame. Raises WriteError."""
    signal = chosen.signal
    assert signal.numbered is not None
    message = parameter_message(client.frames.link, signal.numbered.parameter_set, "write", signal.value.size)
    assert message is not None
    request = message.request
    values = parameter_address(message, signal)
    carried, pieces = part_of(request, "value"), segments_of(client.layout, message)
    if carried is None:
        assert pieces is not None
        flags = client.layout.device.flags
        other_fields = (field for field in request.fields if field.name not in values)
        values |= {field.name: initial_number(field.field, flags) for field in other_fields}
        values |= pieces.size_content(len(chosen.words))
    elif carried.carries_bytes:
        values |= bytes_of_value(client.layout.device, carried, signal.value, chosen.raw)
    if request.selector is not None:
        form = _form(request, signal.value)
        if form is None:
            raise WriteError(f"no format of {message.name} carries {signal.path}")
        values[request.selector.name] = form
        carried = request.chosen[form].fields[-1]
    if carried is not None and not carried.carries_bytes:
        number = number_in_field(carried.value, signal.value, chosen.raw)
        values[carried.name] = [number] if carried.is_list else number
    try:
        return message.name, values, client.request(message.name, values)
    except CodecError as error:
        raise WriteError(f"{signal.path}: {error}") from None


def write_parameter(client: Client, chosen: ParameterAssignment) -> None:
    """Writes a parameter, once, in pieces where no message has its value alone.

    Raises WriteError, NoAnswerError, RefusedError and CarrierError.
    """
    name, values, _ = parameter_request(client, chosen)
    client.ask(name, values, retries=0)
    pieces = segments_of(client.layout, client.layout.messages[name])
    if pieces is not None and not pieces.reads:
        try:
            write_pieces(client, pieces, values, bytes(chosen.words))
        except UnfitAnswerError as error:
            raise NoAnswerError(str(error)) from None


def _form(request: RecordLayout, value: Value) -> int | None:
    """The number of the selector for values of a type: of the same type, or without a sign of the same size."""
    last = {number: chosen.fields[-1].value for number, chosen in request.chosen.items()}
    for name in (value.type.name, f"u{8 * value.size}"):
        for number, kind in last.items():
            if kind is not None and kind.type.name == name:
                return number
    return None
