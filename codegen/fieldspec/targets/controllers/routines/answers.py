"""Whether an answer belongs to what was asked: all that it repeats is compared, before any of it is taken."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.repeated_parts import repeated_fields, repeated_parts
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.encoding import is_truth
from fieldspec.language.model.value import Value
from fieldspec.targets.controllers.routines.parameters import Fields, measure, parameters_of
from fieldspec.targets.controllers.routines.records import is_user_field, members_of
from fieldspec.targets.controllers.routines.world import World, narrowest
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    LREAL,
    UDINT,
    UNSIGNED,
    ArrayType,
    Elementary,
    EnumMemberExpression,
    EnumType,
    Expression,
    StructType,
    Truth,
    Variable,
    Whole,
    either,
    every,
    number,
)
from fieldspec.targets.controllers.statements.numbers import whole_type
from fieldspec.targets.controllers.statements.routine import (
    Assignment,
    Declared,
    Loop,
    Routine,
    Statement,
    Variables,
    when,
)


@dataclass(frozen=True, slots=True)
class Received:
    """Where the function that parses a response puts it, by the names of its outputs: apart from what blocks give.

    `taken` gives it once it is judged right, `refused` gives why the device refuses.
    """

    answered: Mapping[str, Expression]
    taken: Sequence[Statement]
    refused: Sequence[Statement]


def received(
    world: World,
    link: LinkLayout,
    message: MessageLayout,
    parse: Routine,
    variables: Variables,
    output: Callable[[Declared], Variable],
) -> Received:
    """Declares where a response is put; `output` declares what a block gives of what the response does not repeat."""
    _, answers = parameters_of(world, link, message)
    repeated = {id(other) for _, other in repeated_parts(link)} | {id(other) for _, other in repeated_fields(message)}
    outputs = {declared.variable.name: declared for declared in parse.declared}
    names = [
        answers.head[part.name]
        for part in link.response.header
        if part.name in answers.head and id(part) not in repeated
    ]
    for field in message.response.fields:
        if field.name in answers.fields.variables and id(field) not in repeated:
            names.append(answers.fields.variables[field.name])
            if field.field.repeat is not None and answers.fields.count is not None:
                names.append(answers.fields.count)
    reasons = list(answers.refusal.every) if answers.refusal is not None else []
    whole = [*answers.head.values(), *answers.fields.every, *reasons]
    targets = {item.name: output(outputs[item.name]) for item in whole if item in names or item in reasons}
    answer_variables = {item.name: variables.declare(f"{item.name}Answered", item.type, "local") for item in whole}

    def gives(items: Iterable[Variable]) -> list[Statement]:
        return [Assignment(targets[item.name], answer_variables[item.name]) for item in items]

    return Received(answer_variables, gives(names), gives(reasons))


def judged(
    world: World,
    link: LinkLayout,
    message: MessageLayout,
    status: Variable,
    request_values: Mapping[str, Expression],
    response_values: Mapping[str, Expression],
    variables: Variables,
) -> dict[str, Any]:
    """What `judging.st` has to know of an answer: the tests for one that is not to what was asked.

    Both mappings go by the names of the parameters that build the request and parse the answer.
    """
    comparison = _Comparison(world, variables)
    asks, answers = parameters_of(world, link, message)
    refused = status.compared("=", world.status.of("refused"))
    station: list[Expression] = []
    head: list[Expression] = []
    body: list[Expression] = []
    for own, other in repeated_parts(link):
        if other.name in answers.head:
            ours = _known(world, asks.head.get(own.name), own.value, own.constant, request_values)
            tests = station if other.role == "unit_address" else head
            if ours is not None:
                tests.append(comparison.differ(response_values[answers.head[other.name].name], ours))
    error = link.link.exception_response
    coded = link.request.role("code")
    if error is not None and coded is not None and answers.refusal is not None:
        for field in world.layout.records[error.record].fields:
            variable = answers.refusal.variables.get(field.name)
            if field.field.same_as == coded.name and variable is not None and message.message.code is not None:
                code = Whole(message.message.code, UNSIGNED[coded.size])
                head.append(every([refused, comparison.differ(response_values[variable.name], code)]))
    flag = variables.local("xOther", BOOL)
    statements: list[Statement] = []
    for request_field, response_field in repeated_fields(message):
        theirs = _value(world, message.response, response_field, answers.fields, response_values)
        ours = _value(world, message.request, request_field, asks.fields, request_values)
        if theirs is None or ours is None:
            continue
        if isinstance(theirs.type, ArrayType | StructType):
            lists = (
                (response_field, theirs, answers.fields, response_values),
                (request_field, ours, asks.fields, request_values),
            )
            received_count, requested_count = (_elements(*arguments) for arguments in lists)
            unlike = comparison.unlike(flag, (theirs, response_field), (ours, request_field), received_count)
            if (
                received_count is not None
                and requested_count is not None
                and {type(received_count), type(requested_count)} != {Whole}
            ):
                body.append(received_count.compared("<>", requested_count))
                unlike = [when(received_count.compared("=", requested_count), unlike)]
            statements += unlike
        else:
            body.append(comparison.differ(theirs, ours))
    body += _counts(comparison, message, asks.fields, answers.fields, request_values, response_values)
    if statements:
        body.append(flag)
    tests_by_name = {"station": station, "head": head, "body": body}
    return {
        **{name: either(operands) if operands else Truth(False) for name, operands in tests_by_name.items()},
        "refusable": error is not None,
        "differs": flag,
        "lists": bool(statements),
        "comparing": statements,
    }


def _counts(
    comparison: _Comparison,
    message: MessageLayout,
    asks: Fields,
    answers: Fields,
    request_values: Mapping[str, Expression],
    response_values: Mapping[str, Expression],
) -> list[Expression]:
    """Whether the number of registers or bits in a response differs from the requested number."""
    world, access = comparison.world, message.message.single_access
    device = world.layout.device
    if access is None or access.operation != "read" or not access.count or answers.count is None:
        return []
    field, values = message.request.named(access.count), message.response.named(access.values)
    if field is None or values is None or values.field.repeat is None:
        return []
    requested_count = _value(world, message.request, field, asks, request_values)
    if requested_count is None or not isinstance(requested_count.type, Elementary):
        return []
    received_count = response_values[answers.count.name]
    unit = device.space(access.space).unit_size
    if device.bit_access(message.message) is not None:
        bits = requested_count.converted(UDINT).combined("+", 7)
        return [received_count.converted(UDINT).compared("<>", bits.combined("/", 8))]
    if values.size == unit:
        return [comparison.differ(received_count, requested_count)]
    sizes = [
        units.converted(UDINT).combined("*", size)
        for units, size in ((received_count, values.size), (requested_count, unit))
    ]
    return [sizes[0].compared("<>", sizes[1])]


def _value(
    world: World, record: RecordLayout, field: FieldLayout, fields: Fields, values: Mapping[str, Expression]
) -> Expression | None:
    """The content of a field; None where only a function sees it, which compares it with its constant."""
    if field.field.measures is not None:
        count = values[fields.count.name] if fields.count is not None else None
        last = record.fields[-1]
        return measure(record, field, count, number(last.size))
    constant = field.value.const if field.value is not None else None
    return _known(world, fields.variables.get(field.name), field.value, constant, values)


def _known(
    world: World, variable: Variable | None, value: Value | None, constant: int | None, values: Mapping[str, Expression]
) -> Expression | None:
    if variable is not None:
        return values[variable.name]
    if constant is None or value is None:
        return None
    if is_truth(value.encoding):
        return Truth(bool(constant))
    return Whole(constant, whole_type(value.encoding))


class _Comparison:
    """Comparisons of what a response repeats with what was asked. They may need variables."""

    def __init__(self, world: World, variables: Variables) -> None:
        self.world, self.variables = world, variables

    def differ(self, left: Expression, right: Expression) -> Expression:
        """Whether two single values differ; their types may differ too."""
        if left.type == right.type:
            return left.compared("<>", right)
        for own, other in ((left, right), (right, left)):
            if isinstance(own.type, EnumType):
                return either(
                    [every([own.compared("=", m), self._is(other, m)]) for m in self._members(own.type)]
                ).negated()
        assert isinstance(left.type, Elementary)
        assert isinstance(right.type, Elementary)
        real = "real" in (left.type.family, right.type.family)
        low, high = min(left.type.low, right.type.low), max(left.type.high, right.type.high)
        kind = LREAL if real else narrowest(low, high)
        return left.converted(kind).compared("<>", right.converted(kind))

    def _members(self, kind: EnumType) -> list[EnumMemberExpression]:
        enum = next(name for name, known in self.world.names.enums.items() if known == kind)
        names = self.world.names.enum_members[enum]
        members = self.world.layout.device.enums[enum].members
        return [EnumMemberExpression(names[own.name], own.value, kind) for own in members if not own.unavailable]

    def _is(self, other: Expression, member: EnumMemberExpression) -> Expression:
        """Whether a value equals the number of an enum member."""
        if isinstance(other.type, EnumType):
            same = [own for own in self._members(other.type) if own.value == member.value]
            return either([other.compared("=", own) for own in same]) if same else Truth(False)
        assert isinstance(other.type, Elementary)
        if not other.type.low <= member.value <= other.type.high:
            return Truth(False)
        return other.compared("=", member.value)

    def unlike(
        self,
        flag: Variable,
        left: tuple[Expression, FieldLayout],
        right: tuple[Expression, FieldLayout],
        count: Expression | None = None,
        depth: int = 0,
    ) -> list[Statement]:
        """The statements that set a flag where two fields differ, with `count` elements in lists."""
        (own, field), (other, origin) = left, right
        if isinstance(own.type, ArrayType) and isinstance(other.type, ArrayType):
            index = self.variables.local(f"iRepeated{depth or ''}")
            last = count.plus(-1) if count is not None else number(min(own.type.high, other.type.high))
            elements = [array.element(index) for array in (own, other) if isinstance(array.type, ArrayType)]
            element_statements = self.unlike(flag, (elements[0], field), (elements[1], origin), None, depth + 1)
            return [Loop(index, number(0), last, tuple(element_statements))]
        if field.record is not None and origin.record is not None:
            statements: list[Statement] = []
            ours, theirs = members_of(self.world, field.record, own), members_of(self.world, origin.record, other)
            for inner in field.record.fields:
                same = origin.record.named(inner.name)
                if is_user_field(inner) and same is not None and is_user_field(same):
                    statements += self.unlike(flag, (ours(inner), inner), (theirs(same), same), None, depth)
            return statements
        return [when(self.differ(own, other), [Assignment(flag, Truth(True))])]


def _elements(
    field: FieldLayout, value: Expression, fields: Fields, values: Mapping[str, Expression]
) -> Expression | None:
    """The number of elements of a list; None for a struct."""
    if field.field.repeat is not None and fields.count is not None:
        return values[fields.count.name]
    return number(value.type.high + 1) if isinstance(value.type, ArrayType) else None
