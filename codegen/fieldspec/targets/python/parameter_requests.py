"""The messages that read and write numbered parameters, as code that builds and parses them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import CaseLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.address_space import BIT
from fieldspec.language.model.encoding import is_truth
from fieldspec.language.model.primitives import PRIMITIVES, Primitive
from fieldspec.targets.python.links import Exchange
from fieldspec.targets.python.naming import Scope
from fieldspec.targets.python.record_shape import RecordShape
from fieldspec.targets.python.slots import Slots, Words
from fieldspec.targets.python.text import filled, item_lines

_ARGUMENTS = frozenset({"parameter", "response", "self", "value", "values"})


@dataclass(frozen=True, slots=True)
class ParameterMessageView:
    """A message that reads or writes a parameter.

    `head` begins the method that creates the request, and `construction` ends it. `single_head` begins the method for
    one value where a request takes `several`; it passes on the arguments `passed`. `writable` are the arguments of the
    test whether it may be written. `reading` is the expression of the value in a response. `table` has the values of
    the selector by the types of parameters, or the numbers of bytes by what a response says; it may be empty.
    `required` are the arguments beside parameter and value that have no initial value; an `indexed` one takes the place
    of an element.
    """

    request: str
    response: str
    head: list[str]
    single_head: list[str]
    passed: str
    construction: list[str]
    writable: str
    reading: str
    field: str
    several: bool
    table: list[str]
    required: tuple[str, ...]
    indexed: bool


def parameter_messages(
    exchanges: Sequence[Exchange], name: str, layout: DeviceLayout, words: Words
) -> tuple[ParameterMessageView | None, ParameterMessageView | None]:
    """The messages that read and write one parameter of a set or a space: those with the fewest other fields."""
    reads: list[_Candidate] = []
    writes: list[_Candidate] = []
    for exchange in exchanges:
        request, response = _parts(exchange.request, name), _parts(exchange.response, name)
        if "number" not in request:
            continue
        value = request.get("value", response.get("value"))
        if value is not None:
            (writes if "value" in request else reads).append(_Candidate(exchange, request, value))
    read = min(reads, key=lambda candidate: len(candidate.extra), default=None)
    write = min(writes, key=lambda candidate: len(candidate.extra), default=None)
    return (
        _view(read, (), layout, words, name) if read else None,
        _view(write, [other for other in writes if other.is_like(write)], layout, words, name) if write else None,
    )


@dataclass(frozen=True, slots=True)
class _Candidate:
    """A message that reads or writes parameters: the fields that are parts of the access, and that with the value."""

    exchange: Exchange
    request: dict[str, Slots]
    value: Slots

    @property
    def by(self) -> str:
        """The field that says how many bytes are the value; empty where all are."""
        part = self.value.field.value.parameter if self.value.field.value is not None else None
        return part.sizes.by if part is not None and part.sizes is not None else ""

    @property
    def extra(self) -> list[Slots]:
        """The fields of the request that only an argument decides."""
        own = self.by if "value" in self.request else ""
        parts = self.request.values()
        return [field for field in self.exchange.request.stored if field not in parts and field.title != own]

    def is_like(self, other: _Candidate) -> bool:
        """Whether another message takes the same arguments, for a value of another size."""
        has_bytes = self.value.field.carries_bytes and other.value.field.carries_bytes
        parts = "subindex" in self.request, [field.title for field in self.extra]
        return has_bytes and parts == ("subindex" in other.request, [field.title for field in other.extra])


def _parts(shaped: RecordShape, name: str) -> dict[str, Slots]:
    """The fields that hold number, sub-index and value of a parameter of a set or a space."""
    parts: dict[str, Slots] = {}
    for field in shaped.stored:
        for value in (field.field.value, *(case.value for case in field.field.cases)):
            if value is not None and value.parameter is not None and value.parameter.set == name:
                parts.setdefault(value.parameter.part, field)
    return parts


def _view(
    candidate: _Candidate, variants: Sequence[_Candidate], layout: DeviceLayout, words: Words, name: str
) -> ParameterMessageView:
    """The view of a message; `variants` carry values of other sizes, in bytes, and the message itself is among them."""
    exchange, request, value = candidate.exchange, candidate.request, candidate.value
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
    for field in candidate.extra:
        key = scope.take(field.title)
        expressions[field.title] = f"_selected(parameter, {table}, {key})" if field is selector else key
        keywords.append(f"{key}: {field.type} | None = None" if field is selector else f"{key}: {_kind(field)}")
    keywords.sort(key=lambda text: "=" in text)
    arguments = ["self", "parameter: _Parameter[_T]", "values: _Sequence[_T]", *(["*"] if keywords else []), *keywords]
    kinds = [other.exchange.request_name for other in variants] or [exchange.request_name]
    writes, ends = "value" in request, f") -> {' | '.join(kinds)}:"
    value_arguments = [text if text != "values: _Sequence[_T]" else "value: _T" for text in arguments]
    if not writes:
        arguments, value_arguments = [text for text in arguments if "values" not in text], []
        arguments[1] = "parameter: _Parameter[_Any]"
    elif not value.is_list:
        arguments, value_arguments = value_arguments, []
    name_of = "write_values_request" if writes and value.is_list else "write_request" if writes else "read_request"
    if variants:
        construction = bytes_requests(variants, expressions, start, words)
    else:
        filling = [f"{field.name}={expressions[field.title]}" for field in exchange.request.stored]
        construction = filled(f"return {exchange.request_name}(", filling, ")", 8)
    reading, table_lines = f"parameter.from_raw(response.{value.name}, subindex)", []
    if selector is not None:
        rows = _formats(exchange.request, selector, layout, words)
        table_lines = item_lines(f"{table}: dict[str, {selector.type}] = {{", rows, "}", 0)
    elif value.field.carries_bytes and not writes:
        reading = f"parameter.from_bytes(response.{value.name}, subindex)"
        if value.field.sizes:
            table, deciding = f"_{name.upper()}_SIZES", _titled_field(exchange.response, candidate.by)
            rows = [f"0x{number:X}: {size}" for number, size in value.field.sizes.items()]
            table_lines = item_lines(f"{table}: dict[int, int] = {{", rows, "}", 0)
            reading = (
                f"parameter.from_bytes(response.{value.name}[: {table}.get(response.{deciding.name}, 0)], subindex)"
            )
    return ParameterMessageView(
        request=exchange.request_name,
        response=exchange.response_name,
        head=item_lines(f"def {name_of}(", arguments, ends, 4),
        single_head=item_lines("def write_request(", value_arguments, ends, 4) if value_arguments else [],
        passed="".join(f", {key}={key}" for key in (text.partition(":")[0] for text in keywords)),
        construction=construction,
        writable=_elements(layout, name, start, value.is_list) if subindex is not None else "",
        reading=reading,
        field=value.name,
        several=value.is_list,
        table=table_lines,
        required=tuple(text.partition(":")[0] for text in keywords if "=" not in text),
        indexed=subindex is not None,
    )


def bytes_requests(
    candidates: Sequence[_Candidate], expressions: Mapping[str, str], start: str, words: Words
) -> list[str]:
    """The lines that return the request for a value, by the number of its bytes."""
    parts = {"number": expressions[candidates[0].request["number"].title]}
    if "subindex" in candidates[0].request:
        parts["subindex"] = start
    lines = [f"data = parameter.to_bytes(value, {start})"]
    earlier_sizes: set[int] = set()
    for candidate in candidates:
        field, stored = candidate.value.field, candidate.exchange.request.stored
        for number, size in field.sizes.items() or ((None, field.size),):
            if size in earlier_sizes:
                continue
            earlier_sizes.add(size)
            data = "data" if size == field.size else f'data.ljust({field.size}, b"\\0")'
            own = {**expressions, candidate.value.title: data}
            own |= {candidate.request[role].title: text for role, text in parts.items()}
            if number is not None:
                own[candidate.by] = _member(_titled_field(candidate.exchange.request, candidate.by), number, words)
            arguments = [f"{slot.name}={own[slot.title]}" for slot in stored]
            call = filled(f"return {candidate.exchange.request_name}(", arguments, ")", 12)
            lines += [f"if len(data) == {size}:", *(f"    {line}" for line in call)]
    return [*lines, "raise _no_message(parameter, data)"]


def _titled_field(shaped: RecordShape, title: str) -> Slots:
    return next(field for field in shaped.fields if field.title == title)


def _member(field: Slots, number: int, words: Words) -> str:
    """The member of the enum of a field with a number."""
    view = words.enums[field.value.enum]
    return next(f"{view.name}.{member.name}" for member in view.members if int(member.value) == number)


def _elements(layout: DeviceLayout, name: str, start: str, is_list: bool) -> str:
    """The arguments of the test whether elements may be written; empty if all elements of a parameter are alike."""
    rows = (row for parameter_set in layout.device.sets(name) for row in parameter_set.parameters)
    if not any(inner.access for row in rows for inner in row.subindices):
        return ""
    return f"{start}, len(values)" if is_list else start


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
    if same is not None or not is_truth(primitive.encoding):
        return same
    return next((case for case in cases if case.value.type.name == f"u{8 * primitive.size}"), None)
