"""Routines as text in any dialect."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any

from fieldspec.foundation.classes import replace
from fieldspec.foundation.line_text import wrapped
from fieldspec.targets.controllers.dialects import Spelling
from fieldspec.targets.controllers.literals import fraction, initial, whole
from fieldspec.targets.controllers.statements.expressions import (
    TIMER,
    ArrayType,
    Call,
    Conversion,
    Element,
    Elementary,
    EnumMemberExpression,
    EnumType,
    Expression,
    Fraction,
    Member,
    Negation,
    Operation,
    Output,
    Shift,
    Truth,
    Type,
    Variable,
    Whole,
)
from fieldspec.targets.controllers.statements.interfaces import camel, siemens_names
from fieldspec.targets.controllers.statements.routine import (
    Assignment,
    Body,
    Condition,
    Invocation,
    Loop,
    Region,
    Remark,
    Return,
    Routine,
    Selection,
    Statement,
    Timing,
)

_WIDTH = 112
_STEP = "    "
_ASSOCIATIVE = ("+", "AND", "OR", "XOR")


def comment(text: str, indent: str = "", form: str = "// {}") -> list[str]:
    """A text of a spec as lines of comment. It stays within them, whatever it holds."""
    room = _WIDTH - len(indent) - len(form) + len("// {}")
    return [f"{indent}{form.format(line)}".rstrip() for line in wrapped(comment_text(text), room)]


def array_name(kind: ArrayType, spelling: Spelling) -> str:
    """The name of an array type: its elements and its bounds, as in `T_Gadget_BYTE_0_255`"""
    bounds: list[str] = []
    element: Type = kind
    while isinstance(element, ArrayType):
        bounds[:0] = [str(element.low), str(element.high)]
        element = element.of
    return spelling.array.format("_".join([type_text(element, spelling), *bounds]))


def comment_text(text: str) -> str:
    """A text on one line, with nothing in it that begins or ends a comment or a pragma."""
    if not text.isprintable():
        text = "".join(char if char.isprintable() else " " for char in text)
    if "*" in text or "/" in text:
        for mark in ("(*", "*)", "/*", "*/", "//"):
            text = text.replace(mark, " ".join(mark))
    return " ".join(text.replace("{", "(").replace("}", ")").split())


def type_text(kind: Type, spelling: Spelling) -> str:
    """The text of a type in a declaration."""
    if isinstance(kind, ArrayType) and (spelling.all_named or kind in spelling.named):
        return array_name(kind, spelling)
    if isinstance(kind, ArrayType):
        return f"ARRAY[{kind.low}..{kind.high}] OF {type_text(kind.of, spelling)}"
    if isinstance(kind, Elementary):
        return kind.name
    if kind == TIMER:
        return spelling.timer
    if isinstance(kind, EnumType) and not spelling.enums:
        return kind.base.name
    return spelling.struct.format(kind.name)


def declaration(routine: Routine, spelling: Spelling) -> list[str]:
    """The head of a routine: its comment, its name, its variables."""
    spelling = named(routine, spelling)
    form = spelling.comment
    lines = [line for paragraph in routine.remarks for line in comment(paragraph, form=form)]
    name = spelling.routine.format(routine.name)
    if routine.returns is None:
        lines.append(f"FUNCTION_BLOCK {name}")
    else:
        lines.append(spelling.head.format(name, type_text(routine.returns, spelling)))
    lines += spelling.attributes
    for role, word in spelling.sections.items():
        declared = routine.of_role(role)
        if not declared:
            continue
        lines.append("VAR" if role == "local" and routine.returns is None else word)
        for variable in declared:
            remark = f" {form.format(comment_text(variable.remark))}" if variable.remark else ""
            kind = type_text(variable.variable.type, spelling) + (f" := {variable.initial}" if variable.initial else "")
            lines.append(
                f"{_STEP}{spelling.names.get(variable.variable.name, variable.variable.name)} : {kind};{remark}"
            )
        lines.append("END_VAR")
    return [*lines, *constants_section(routine.constants)]


def constants_section(constants: Sequence[Whole]) -> list[str]:
    """The lines that declare the constants of a routine; none where it has none."""
    values = ((item, initial(item.value, item.type, item.hexadecimal)) for item in constants)
    texts = [f"{_STEP}{item.name} : {item.type.name} := {value};" for item, value in values]
    return ["VAR CONSTANT", *texts, "END_VAR"] if texts else []


def implementation(routine: Routine, spelling: Spelling) -> list[str]:
    """The lines of the statements of a routine."""
    return _body(routine.body, named(routine, spelling), "")


def named(routine: Routine, spelling: Spelling) -> Spelling:
    """A spelling with the names of the variables of a routine, where these are others in text."""
    return replace(spelling, names=siemens_names(routine)) if spelling.siemens_names else spelling


def parameter(name: str, spelling: Spelling) -> str:
    """The name of a parameter where a routine is called, or of an output where it is read."""
    return camel(name) if spelling.siemens_names else name


def variable_text(name: str, spelling: Spelling) -> str:
    """A variable in a statement."""
    return spelling.variable.format(spelling.names.get(name, name))


def routine_text(routine: Routine, spelling: Spelling) -> list[str]:
    """The lines of a routine: its declaration and its statements."""
    begin = [spelling.begin] if spelling.begin else []
    end = "END_FUNCTION_BLOCK" if routine.returns is None else spelling.end
    return [*declaration(routine, spelling), *begin, *implementation(routine, spelling), end]


def call_lines(routine: Routine, spelling: Spelling, **arguments_by_name: Expression) -> list[str]:
    """A call with variables of the parameters' names as arguments, or with the expressions of `arguments_by_name`."""
    names = [declared.variable for declared in routine.declared if declared.role != "local"]
    arguments: dict[str, Expression] = {
        variable.name: arguments_by_name.get(variable.name, variable) for variable in names
    }
    assert routine.returns is not None
    result = Variable("eStatus", routine.returns)
    return _body((Assignment(result, routine.called(**arguments)),), named(routine, spelling), "")


def _body(body: Body, spelling: Spelling, indent: str) -> list[str]:
    lines: list[str] = []
    for statement in body:
        _write(statement, spelling, indent, lines)
    return lines


def _write(statement: Statement, spelling: Spelling, indent: str, lines: list[str]) -> None:
    """Adds the lines of a statement."""
    inner = indent + _STEP
    match statement:
        case Assignment(target, value):
            lines += _broken(f"{indent}{_expression_text(target, spelling)} := ", value, ";", spelling, indent)
        case Condition(branches, otherwise):
            word = "IF"
            for test, body in branches:
                lines += _broken(f"{indent}{word} ", test, " THEN", spelling, indent)
                lines += _body(body, spelling, inner)
                word = "ELSIF"
            if otherwise:
                lines.append(f"{indent}ELSE")
                lines += _body(otherwise, spelling, inner)
            lines.append(f"{indent}END_IF;")
        case Timing(timer, running, time):
            texts = (_expression_text(expression, spelling) for expression in (timer, running, time))
            lines.append("{}{}(IN := {}, PT := {});".format(indent, *texts))
        case Invocation(block, arguments):
            lines += _invoked(block, arguments, spelling, indent)
        case Remark(text):
            lines += comment(text, indent, spelling.comment)
        case Region(heading, body) if spelling.has_regions:
            lines += [f"{indent}REGION {heading}", *_body(body, spelling, indent), f"{indent}END_REGION"]
        case Region(heading, body):
            lines += ["", *comment(heading, indent, spelling.comment), *_body(body, spelling, indent)]
        case Return():
            lines.append(f"{indent}RETURN;")
        case Loop(index, first, last, body):
            bounds = f"{_expression_text(first, spelling)} TO {_expression_text(last, spelling)}"
            lines.append(f"{indent}FOR {_expression_text(index, spelling)} := {bounds} DO")
            lines += _body(body, spelling, inner)
            lines.append(f"{indent}END_FOR;")
        case Selection(selector, cases, otherwise):
            lines.append(f"{indent}CASE {_expression_text(selector, spelling)} OF")
            for labels, body in cases:
                heads = list(_labels(labels, spelling, inner))
                if isinstance(body[0], Remark):
                    heads[-1] += " " + spelling.comment.format(comment_text(body[0].text))
                    lines += [*heads, *_body(body[1:], spelling, inner + _STEP)]
                else:
                    lines += _branch(heads, _body(body, spelling, inner + _STEP))
            if otherwise:
                lines.append(f"{indent}ELSE")
                lines += _body(otherwise, spelling, inner)
            lines.append(f"{indent}END_CASE;")


def _invoked(
    block: Variable, arguments: Sequence[tuple[str, Expression]], spelling: Spelling, indent: str
) -> Iterator[str]:
    """The lines of a call of a block, filled with arguments."""
    line = f"{indent}{variable_text(block.name, spelling)}("
    for position, (name, value) in enumerate(arguments, 1):
        end = ");" if position == len(arguments) else ", "
        text = f"{parameter(name, spelling)} := {_expression_text(value, spelling)}{end}"
        if len(line) + len(text.rstrip()) > _WIDTH:
            yield line.rstrip()
            line = indent + _STEP
        line += text
    yield line


def _branch(labels: list[str], body: list[str]) -> list[str]:
    """A branch of CASE, on one line where it is short."""
    line = f"{labels[-1]} {body[0].strip()}"
    return [*labels[:-1], line] if len(body) == 1 and len(line) <= _WIDTH else [*labels, *body]


def _labels(labels: Iterable[tuple[int, int] | EnumMemberExpression], spelling: Spelling, indent: str) -> Iterator[str]:
    """The labels of a branch, on one or more lines."""
    line = indent
    texts = [_label(label, spelling) for label in labels]
    for index, text in enumerate(texts):
        mark = ":" if index + 1 == len(texts) else ","
        if len(line) + len(text) > _WIDTH:
            yield line.rstrip()
            line = indent
        line += f"{text}{mark} "
    yield line.rstrip()


def _label(label: tuple[int, int] | EnumMemberExpression, spelling: Spelling) -> str:
    if isinstance(label, EnumMemberExpression):
        return _expression_text(label, spelling)
    low, high = label
    return f"{low}" if low == high else f"{low}..{high}"


def _broken(before: str, value: Expression, after: str, spelling: Spelling, indent: str) -> list[str]:
    """A line around an expression; if it is too long, each operand is on its own line."""
    whole = f"{before}{_expression_text(value, spelling)}{after}"
    if len(whole) <= _WIDTH:
        return [whole]
    parts: list[str] = []
    end = ""
    match value:
        case Operation(operator, operands) if operator in _ASSOCIATIVE:
            parts = _operands(operator, operands, spelling)
        case Call() if value.inputs:
            arguments = _arguments(value, spelling)
            parts = [*(f"{text}," for text in arguments[:-1]), arguments[-1]]
            before, end = f"{before}{spelling.routine.format(value.routine)}(", ")"
        case Conversion(Operation(operator, operands) as inner, to) if operator in _ASSOCIATIVE:
            parts = _operands(operator, operands, spelling)
            before, end = f"{before}{_name_of(inner.type)}_TO_{to.name}(", ")"
    if len(parts) < 2:
        return [whole]
    deep = indent + 2 * _STEP
    return [before.rstrip(), *(f"{deep}{part}" for part in parts[:-1]), f"{deep}{parts[-1]}{end}{after}"]


def _operands(operator: str, operands: Sequence[Expression], spelling: Spelling) -> list[str]:
    """Operands with the operator before each but the first."""
    first, *following = (_operand(operand, operator, spelling) for operand in operands)
    return [first, *(f"{operator} {text}" for text in following)]


def _name_of(kind: Type) -> str:
    assert isinstance(kind, Elementary)
    return kind.name


def _operand(operand: Expression, operator: str, spelling: Spelling) -> str:
    """An operand, in parentheses unless it is plain or of the same chain."""
    text = _expression_text(operand, spelling)
    if isinstance(operand, Operation) and not (operand.operator == operator and operator in _ASSOCIATIVE):
        return f"({text})"
    return text


def _arguments(call: Call, spelling: Spelling) -> list[str]:
    return [
        *(f"{parameter(name, spelling)} := {_expression_text(value, spelling)}" for name, value in call.inputs),
        *(f"{parameter(name, spelling)} => {_expression_text(value, spelling)}" for name, value in call.outputs),
    ]


def _expression_text(expression: Expression, spelling: Spelling) -> str:
    return _TEXTS[expression.__class__](expression, spelling)


def _member_text(member: EnumMemberExpression, spelling: Spelling) -> str:
    return spelling.member.format(member.type.name, member.member, member.value)


def _member(member: Member, spelling: Spelling) -> str:
    return f"{_expression_text(member.of, spelling)}.{member.name}"


def _element(element: Element, spelling: Spelling) -> str:
    return f"{_expression_text(element.of, spelling)}[{_expression_text(element.index, spelling)}]"


def _operation(operation: Operation, spelling: Spelling) -> str:
    return f" {operation.operator} ".join(
        [_operand(operand, operation.operator, spelling) for operand in operation.operands]
    )


def _negation(negation: Negation, spelling: Spelling) -> str:
    text = _expression_text(negation.of, spelling)
    return f"NOT ({text})" if isinstance(negation.of, Operation) else f"NOT {text}"


def _shift(shift: Shift, spelling: Spelling) -> str:
    return spelling.shift.format(shift.direction, _expression_text(shift.of, spelling), shift.bits)


def _conversion(conversion: Conversion, spelling: Spelling) -> str:
    return f"{_name_of(conversion.of.type)}_TO_{conversion.type.name}({_expression_text(conversion.of, spelling)})"


def _call(call: Call, spelling: Spelling) -> str:
    return f"{spelling.routine.format(call.routine)}({', '.join(_arguments(call, spelling))})"


_TEXTS: Mapping[type[Expression], Callable[[Any, Spelling], str]] = {
    Whole: lambda literal, spelling: spelling.variable.format(literal.name) if literal.name else whole(literal),
    Fraction: lambda literal, spelling: fraction(literal),
    Truth: lambda expression, spelling: "TRUE" if expression.value else "FALSE",
    Variable: lambda expression, spelling: variable_text(expression.name, spelling),
    EnumMemberExpression: _member_text,
    Member: _member,
    Output: lambda output, spelling: f"{_expression_text(output.of, spelling)}.{parameter(output.name, spelling)}",
    Element: _element,
    Operation: _operation,
    Negation: _negation,
    Shift: _shift,
    Conversion: _conversion,
    Call: _call,
}
"""The text of an expression, by its class: there are some ten thousand of them in a device."""
