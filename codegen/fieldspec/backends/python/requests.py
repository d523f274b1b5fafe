"""The messages that read and write registers and parameters, as code that builds and parses them."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.python.links import Exchange
from fieldspec.backends.python.naming import Scope
from fieldspec.backends.python.records import RecordShape
from fieldspec.backends.python.slots import Slots, Words
from fieldspec.backends.python.text import filled, item_lines
from fieldspec.classes import dataclass
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.record import CaseLayout
from fieldspec.model.address_space import BIT
from fieldspec.model.device import Device
from fieldspec.model.record import RegisterAccess
from fieldspec.model.value import PRIMITIVES, Kind, Primitive


@dataclass(frozen=True, slots=True)
class AccessView:
    """A message that reads or writes `most` words or bits: its classes, and the expressions of requests and of words.

    `words` has the words of all `responses`, and `checked_words` the same where they must be of this class. A bit is a
    word with 0 or 1.
    """

    request: str
    response: str
    most: int
    make: str
    words: str
    checked_words: str


@dataclass(frozen=True, slots=True)
class SpaceAccess:
    """The messages that read and write the registers of an address space; empty name: the device has only one space."""

    space: str
    read: AccessView | None
    single: AccessView | None
    block: AccessView | None


def space_accesses(device: Device, exchanges: list[Exchange]) -> list[SpaceAccess]:
    """The messages that access each space, in the order of the spec."""
    names = list(device.spaces) if device.several_spaces else [""]
    accesses = []
    for name in names:
        own = [
            exchange
            for exchange in exchanges
            if (access := exchange.message.message.accesses) is not None
            and (not name or device.space_name(access.space) == name)
        ]
        bits = device.space(name).unit == BIT
        accesses.append(SpaceAccess(name, read_access(own, bits), *write_accesses(own, bits)))
    return accesses


def _field(shaped: RecordShape, title: str) -> Slots | None:
    return next((field for field in shaped.fields if field.title == title), None)


def _most(bits: bool, *fields: Slots | None) -> int:
    """The most words, or packed bits, that some fields allow."""
    bounds = []
    for field in fields:
        if field is not None and field.repeated and field.field.field.repeat is not None:
            bounds.append(field.field.field.repeat.high * (8 if bits else 1))
        elif field is not None and field.ranges is not None:
            bounds.append(field.ranges.high)
    return min(bounds, default=1)


def read_access(exchanges: list[Exchange], bits: bool = False) -> AccessView | None:
    """The first message that reads registers, in a space of words or of `bits`."""
    for exchange in exchanges:
        access = exchange.message.message.accesses
        if access is None or access.operation != "read":
            continue
        start, count = _field(exchange.request, access.start), _field(exchange.request, access.count)
        values = _field(exchange.response, access.values)
        if start is None or values is None or not _settable(exchange.request, {access.start, access.count}):
            continue
        count_argument = f", {count.name}=count" if count is not None and count.stored else ""
        most = _most(bits, values, count) if values.is_list else 1
        return AccessView(
            request=exchange.request_name,
            response=exchange.response_name,
            most=most,
            make=f"{exchange.request_name}({start.name}=start{count_argument})",
            words=_words(values, access, bits, most, "responses"),
            checked_words=_words(
                values, access, bits, most, f"_replies(register, responses, {exchange.response_name})"
            ),
        )
    return None


def _words(values: Slots, access: RegisterAccess, bits: bool, most: int, responses: str) -> str:
    """The expression of the words of some responses."""
    each = f"for response in {responses}"
    if bits and values.is_list:
        return f"_unpacked_bits(register, {most}, [response.{values.name} {each}])"
    if bits:
        return f"[_single_bit(register.name, response.{values.name}, {_pair(access)}) {each}]"
    word = f"response.{values.name}" if values.is_list else f"[response.{values.name}]"
    return f"[word {each} for word in {word}]"


def _pair(access: RegisterAccess) -> str:
    """The numbers of a bit that is 1 and of one that is 0."""
    return f"0x{access.set or 0:02X}, 0x{access.clear:02X}"


def write_accesses(exchanges: list[Exchange], bits: bool = False) -> tuple[AccessView | None, AccessView | None]:
    """The first message that writes one register, and the first one that writes several, of words or of `bits`."""
    single: AccessView | None = None
    block: AccessView | None = None
    for exchange in exchanges:
        access = exchange.message.message.accesses
        if access is None or access.operation != "write":
            continue
        start, count = _field(exchange.request, access.start), _field(exchange.request, access.count)
        values = _field(exchange.request, access.values)
        if start is None or values is None:
            continue
        if not _settable(exchange.request, {access.start, access.count, access.values}):
            continue
        count_argument = f", {count.name}=count" if count is not None and count.stored else ""
        if values.is_list:
            words = "_packed_bits(words[at : at + count])" if bits else "words[at : at + count]"
            make = f"{exchange.request_name}({start.name}=start{count_argument}, {values.name}={words})"
            most = _most(bits, values, count)
            block = block or AccessView(exchange.request_name, exchange.response_name, most, make, "", "")
        else:
            word = f"0x{access.set or 0:02X} if words[at] else 0x{access.clear:02X}" if bits else "words[at]"
            make = f"{exchange.request_name}({start.name}=start, {values.name}={word})"
            single = single or AccessView(exchange.request_name, exchange.response_name, 1, make, "", "")
    return single, block


def _settable(shaped: RecordShape, titles: set[str]) -> bool:
    """Whether a request needs no other fields than these."""
    return all(field.title in titles for field in shaped.stored)


_ARGUMENTS = frozenset({"parameter", "response", "self", "value", "values"})


@dataclass(frozen=True, slots=True)
class ParameterMessageView:
    """A message that reads or writes a parameter.

    `head` begins the method that creates the request, and `construction` ends it. `single_head` begins the method for
    one value where a request takes `several`; it passes on the arguments `passed`. `field` carries the values. `table`
    has the values of the selector by the types of parameters; it is empty where there is no selector. `required` are
    the arguments beside parameter and value that have no initial value; an `indexed` one takes the place of an element.
    """

    request: str
    response: str
    head: list[str]
    single_head: list[str]
    passed: str
    construction: list[str]
    field: str
    several: bool
    table: list[str]
    required: tuple[str, ...]
    indexed: bool


def parameter_messages(
    exchanges: Sequence[Exchange], name: str, layout: DeviceLayout, words: Words
) -> tuple[ParameterMessageView | None, ParameterMessageView | None]:
    """The messages that read and write one parameter of a set or a space: those with the fewest other fields."""
    reads, writes = [], []
    for exchange in exchanges:
        request, response = _parts(exchange.request, name), _parts(exchange.response, name)
        if "number" not in request:
            continue
        extra = [field for field in exchange.request.stored if field not in request.values()]
        if "value" in request:
            writes.append((len(extra), exchange, request, request["value"]))
        elif "value" in response:
            reads.append((len(extra), exchange, request, response["value"]))
    read = min(reads, key=lambda candidate: candidate[0], default=None)
    write = min(writes, key=lambda candidate: candidate[0], default=None)
    return (
        _view(read[1], read[2], read[3], layout, words, name) if read else None,
        _view(write[1], write[2], write[3], layout, words, name) if write else None,
    )


def _parts(shaped: RecordShape, name: str) -> dict[str, Slots]:
    """The fields that hold number, sub-index and value of a parameter of a set or a space."""
    parts: dict[str, Slots] = {}
    for field in shaped.stored:
        for value in (field.field.value, *(case.value for case in field.field.cases)):
            if value is not None and value.parameter is not None and value.parameter.set == name:
                parts.setdefault(value.parameter.part, field)
    return parts


def _view(
    exchange: Exchange, request: dict[str, Slots], value: Slots, layout: DeviceLayout, words: Words, name: str
) -> ParameterMessageView:
    selector = exchange.request.selector if "value" in request else None
    table = f"_{name.upper()}_FORMATS" if selector is not None else ""
    scope = Scope(_ARGUMENTS)
    subindex = request.get("subindex")
    start = scope.take("subindex") if subindex is not None else "0"
    expressions = {request["number"].title: "parameter.wire_number"}
    keywords = []
    if subindex is not None:
        expressions[subindex.title] = start
        keywords.append(f"{start}: int = 0")
    if "value" in request:
        expressions[value.title] = _carried(value, start)
    for field in exchange.request.stored:
        if field.title in expressions:
            continue
        key = scope.take(field.title)
        expressions[field.title] = f"_selected(parameter, {table}, {key})" if field is selector else key
        keywords.append(f"{key}: {field.type} | None = None" if field is selector else f"{key}: {_kind(field)}")
    keywords.sort(key=lambda text: "=" in text)
    arguments = ["self", "parameter: _Parameter[_T]", "values: _Sequence[_T]", *(["*"] if keywords else []), *keywords]
    writes, ends = "value" in request, f") -> {exchange.request_name}:"
    value_arguments = [text if text != "values: _Sequence[_T]" else "value: _T" for text in arguments]
    if not writes:
        arguments, value_arguments = [text for text in arguments if "values" not in text], []
        arguments[1] = "parameter: _Parameter[_Any]"
    elif not value.is_list:
        arguments, value_arguments = value_arguments, []
    name_of = "write_values_request" if writes and value.is_list else "write_request" if writes else "read_request"
    construction = [f"{field.name}={expressions[field.title]}" for field in exchange.request.stored]
    rows = _formats(exchange.request, selector, layout, words) if selector is not None else []
    return ParameterMessageView(
        request=exchange.request_name,
        response=exchange.response_name,
        head=item_lines(f"def {name_of}(", arguments, ends, 4),
        single_head=item_lines("def write_request(", value_arguments, ends, 4) if value_arguments else [],
        passed="".join(f", {key}={key}" for key in (text.partition(":")[0] for text in keywords)),
        construction=filled(f"return {exchange.request_name}(", construction, ")", 8),
        field=value.name,
        several=value.is_list,
        table=item_lines(f"{table}: dict[str, {selector.type}] = {{", rows, "}", 0) if selector is not None else [],
        required=tuple(text.partition(":")[0] for text in keywords if "=" not in text),
        indexed=subindex is not None,
    )


def _kind(field: Slots) -> str:
    """The type of an argument, with the initial value of the field where it has one."""
    default = field.field.value.default if field.field.value is not None else None
    return f"{field.type} = {default}" if isinstance(default, int) and field.type == "int" else field.type


def _carried(field: Slots, start: str) -> str:
    """The expression of the field of values: of one `value`, or of several `values` from the element `start` on."""
    if not field.is_list:
        return f"parameter.to_raw(value, {start})"
    raws = f"parameter.to_raws(values, {start})"
    return f"tuple({raws})" if field.decided else raws


def _formats(shaped: RecordShape, selector: Slots, layout: DeviceLayout, words: Words) -> list[str]:
    """The rows of the table from types of parameters to values of the selector."""
    enum, view = layout.device.enums[selector.value.enum], words.enums[selector.value.enum]
    members = {int(member.value): f"{view.name}.{member.name}" for member in view.members}
    rows = []
    for primitive in (primitive for primitive in PRIMITIVES.values() if primitive.name != BIT):
        case = _case(shaped.fields[-1].field.cases, primitive)
        known = [enum.named(name) for name in case.case.when] if case is not None else []
        suiting = [members[member.value] for member in known if member is not None and member.value in members]
        rows += [f'"{primitive.name}": {name}' for name in suiting[:1]]
    return rows


def _case(cases: Sequence[CaseLayout], primitive: Primitive) -> CaseLayout | None:
    """The case that carries a type: one of the same type, or of whole numbers of the same size without a sign."""
    same = next((case for case in cases if case.value.type is primitive), None)
    if same is not None or primitive.kind is not Kind.BOOLEAN:
        return same
    return next((case for case in cases if case.value.type.name == f"u{8 * primitive.size}"), None)
