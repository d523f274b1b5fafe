"""The parameters of the functions that build requests and parse responses, by the parts and fields they stand for."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.targets.controllers.routines.drafts import Draft
from fieldspec.targets.controllers.routines.frames import head_members, wire_of
from fieldspec.targets.controllers.routines.records import choice_type, field_type, is_user_field
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.routines.wrapping import LENGTH
from fieldspec.targets.controllers.statements.expressions import (
    INT,
    ArrayType,
    Expression,
    StructType,
    Type,
    Variable,
    number,
)

FRAME = "aFrame"


@dataclass(frozen=True, slots=True)
class Fields:
    """The parameters of a routine for the fields of a record, and for how many elements its repeated field has."""

    variables: dict[str, Variable]
    count: Variable | None

    def place(self, field: FieldLayout) -> Expression:
        """The parameter that stands for a field."""
        return self.variables[field.name]

    @property
    def every(self) -> Iterator[Variable]:
        """The parameters for the fields, and the one for the number of elements."""
        yield from self.variables.values()
        if self.count is not None:
            yield self.count


@dataclass(frozen=True, slots=True)
class Parameters:
    """The parameters of a routine for a request, or its results for a response; `refusal` is of an
    exception response.
    """

    head: dict[str, Variable]
    fields: Fields
    refusal: Fields | None = None


def request_parameters(draft: Draft, link: LinkLayout, message: MessageLayout) -> Parameters:
    """Declares the inputs of the function that builds a request, whose frame and its length are declared later."""
    draft.keep(FRAME, LENGTH)
    head = _head(draft, link.request, "input")
    return Parameters(head, _fields(draft, message, message.request, "input"))


def response_parameters(draft: Draft, link: LinkLayout, message: MessageLayout) -> Parameters:
    """Declares the outputs of the function that parses a response."""
    head = _head(draft, link.response, "output")
    fields = _fields(draft, message, message.response, "output")
    error = link.link.exception_response
    if error is None:
        return Parameters(head, fields)
    return Parameters(head, fields, _fields(draft, message, draft.world.layout.records[error.record], "output"))


def parameters_of(world: World, link: LinkLayout, message: MessageLayout) -> tuple[Parameters, Parameters]:
    """The parameters of the functions that build the request and parse the response of a message."""
    asking, answering = Draft(world, "", ""), Draft(world, "", "")
    answering.declare(LENGTH, INT, "input")
    answering.declare(FRAME, world.frame, "in_out")
    return request_parameters(asking, link, message), response_parameters(answering, link, message)


def _head(draft: Draft, shape: FrameLayout, role: str) -> dict[str, Variable]:
    """Parameters for the parts before the body."""
    head = {}
    for part in head_members(shape):
        value = wire_of(part).value
        kind = draft.world.type_of(value)
        head[part.name] = draft.declare(
            draft.world.variable(part.name, kind), kind, role, draft.world.comment(part.part, value)
        )
    return head


def _fields(draft: Draft, message: MessageLayout, record: RecordLayout, role: str) -> Fields:
    """Parameters for the fields of a record: arrays and structs are passed by reference, the others are inputs or
    outputs.
    """
    variables: dict[str, Variable] = {}
    count: Variable | None = None
    for field in record.fields:
        if not is_user_field(field):
            continue
        kind = _type(draft.world, message, field)
        lent = isinstance(kind, ArrayType | StructType)
        remark = draft.world.comment(field.field, field.value)
        if lent and role == "input":
            remark = f"is read only. {remark}".strip()
        name = draft.world.variable(field.name, kind)
        variables[field.name] = draft.declare(name, kind, "in_out" if lent else role, remark)
        if field.field.repeat is not None:
            text = f"how many of them: {field.field.repeat.text()}"
            count = draft.declare(f"{draft.world.variable(field.name, INT)}Count", INT, role, text)
    return Fields(variables, count)


def _type(world: World, message: MessageLayout, field: FieldLayout) -> Type:
    """The type of a parameter: words and bits of registers are in the one array that all routines for these take."""
    access = world.layout.device.word_access(message.message)
    if access is not None and field.field.repeat is not None and field.name == access.values:
        return world.words
    bits = world.layout.device.bit_access(message.message)
    if bits is not None and field.field.repeat is not None and field.name == bits.values:
        return world.bits
    return choice_type(field) if field.cases else field_type(world, field)


def measure(record: RecordLayout, field: FieldLayout, count: Expression | None, element: Expression) -> Expression:
    """The content of a field that measures another field with `count` elements of the size `element`."""
    measured = field.field.measures
    assert measured is not None
    other = record.named(measured.field)
    assert other is not None
    if other.field.repeat is None or count is None:
        return number(measured.number(other.count or 1, other.size))
    if measured.of != "bytes" or element == number(1):
        return count.plus(measured.plus)
    return count.combined("*", element).plus(measured.plus)
