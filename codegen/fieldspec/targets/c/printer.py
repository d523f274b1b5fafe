"""Writes declarations and statements of C as text: how C is indented and folded."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

from fieldspec.targets.c.declarations import (
    Blank,
    Comment,
    Declaration,
    Define,
    Directive,
    Enumeration,
    Function,
    Source,
    Struct,
    Typedef,
    Union,
)
from fieldspec.targets.c.expression_printer import ExpressionPrinter
from fieldspec.targets.c.expressions import Type
from fieldspec.targets.c.statements import (
    Assignment,
    Block,
    Break,
    CompileIf,
    Constant,
    CountDown,
    CountUp,
    Evaluation,
    Expectation,
    If,
    Printed,
    Return,
    Statement,
    Switch,
    Table,
    Variable,
    Variables,
)

INDENT = "    "
_CONTINUATION = "        "


class Printer(ExpressionPrinter):
    """Writes trees of C as lines. It notes which local variables a function uses, so that only those are declared.

    Heads of functions and conditions that are longer than `longest_line` go on in further lines.
    """

    def __init__(self, longest_line: int = 120) -> None:
        super().__init__()
        self.lines: list[str] = []
        self._longest_line = longest_line
        self._statements: dict[type, Callable[[Any, str], None]] = {
            Assignment: self._assignment,
            Evaluation: self._evaluation,
            Expectation: self._expectation,
            Return: self._return,
            Break: self._break,
            If: self._if,
            CountUp: self._count_up,
            CountDown: self._count_down,
            Switch: self._switch,
            Variable: self._variable_statement,
            Variables: self._variables,
            Constant: self._constant,
            Table: self._table,
            Block: self._block,
            CompileIf: self._compile_if,
            Printed: self._printed,
        }
        self._declarations: dict[type, Callable[[Any], None]] = {
            Comment: self._comment,
            Blank: self._blank,
            Directive: self._directive,
            Define: self._define,
            Typedef: self._typedef,
            Struct: self._struct,
            Enumeration: self._enumeration,
            Function: self._function,
            Source: self._source,
        }

    def print_declarations(self, declarations: Iterable[Declaration]) -> list[str]:
        """The lines of declarations as C writes them."""
        self.lines = []
        for declaration in declarations:
            self._declarations[declaration.__class__](declaration)
        return self.lines

    def print_statements(self, body: Iterable[Statement], indent: str) -> list[str]:
        """The lines of statements, which declare their variables themselves."""
        self.lines = []
        self._body(body, indent)
        return self.lines

    def _body(self, body: Iterable[Statement], indent: str) -> None:
        for statement in body:
            self._statements[statement.__class__](statement, indent)

    # Declarations

    def _blank(self, node: Blank) -> None:
        self.lines.append("")

    def _directive(self, node: Directive) -> None:
        self.lines.append(f"#{node.keyword} {node.condition}".rstrip())

    def _typedef(self, node: Typedef) -> None:
        self.lines.append(f"typedef {node.type.name} {node.name};")

    def _source(self, node: Source) -> None:
        self.lines += node.text.rstrip("\n").split("\n")

    def _comment(self, node: Comment, indent: str = "") -> None:
        lines = node.lines
        if len(lines) == 1:
            self.lines.append(f"{indent}/** {lines[0]} */")
        elif lines:
            self.lines.append(f"{indent}/**")
            self.lines += [f"{indent} * {line}".rstrip() for line in lines]
            self.lines.append(f"{indent} */")

    def _define(self, node: Define) -> None:
        self.lines.append(f"#define {node.name} {self._expression_text(node.value)}{_remark_text(node.remark)}")

    def _struct(self, node: Struct) -> None:
        self.lines.append(f"typedef struct {node.name} {{")
        self._members(node.members, INDENT)
        self.lines.append(f"}} {node.name};")

    def _members(self, members: Sequence[Comment | Variable | Union], indent: str) -> None:
        for member in members:
            if isinstance(member, Comment):
                self._comment(member, indent)
            elif isinstance(member, Union):
                self.lines.append(f"{indent}union {{")
                self._members(member.members, indent + INDENT)
                self.lines.append(f"{indent}}} {member.name};")
            else:
                self.lines.append(f"{indent}{self.print_variable(member)};")

    def _enumeration(self, node: Enumeration) -> None:
        self.lines.append(f"typedef enum {node.name} {{")
        last = len(node.enumerators) - 1
        for number, member in enumerate(node.enumerators):
            comma = "," if number < last else ""
            self.lines.append(
                f"{INDENT}{member.name} = {self._expression_text(member.value)}{comma}{_remark_text(member.remark)}"
            )
        attribute = f"{node.attribute} " if node.attribute else ""
        self.lines.append(f"}} {attribute}{node.name};")

    def _function(self, node: Function) -> None:
        parameters = ", ".join([self.print_variable(parameter) for parameter in node.parameters]) or "void"
        head = f"{node.storage} {_declarator(node.result, node.name)}({parameters})"
        self.lines += _fold(head, "", self._longest_line) if len(head) > self._longest_line else [head]
        self.lines.append("{")
        self._used.clear()
        start = len(self.lines)
        self._body(node.body, INDENT)
        if self._used:
            used = [local for local in node.locals if local.name in self._used]
            self.lines[start:start] = [f"{INDENT}{_declarator(local.type, local.name)};" for local in used]
        self.lines.append("}")

    # Statements

    def _assignment(self, node: Assignment, indent: str) -> None:
        texts, target, value = self._expressions, node.target, node.value
        left, right = texts[target.__class__](target), texts[value.__class__](value)
        self.lines.append(f"{indent}{left} {node.operator} {right};")

    def _expectation(self, node: Expectation, indent: str) -> None:
        texts, left, right = self._expressions, node.left, node.right
        test = f"{texts[left.__class__](left)} == {texts[right.__class__](right)}"
        self.lines.append(f"{indent}expect({test}, {node.what.text});")

    def _evaluation(self, node: Evaluation, indent: str) -> None:
        self.lines.append(f"{indent}{self._expression_text(node.expression)};")

    def _return(self, node: Return, indent: str) -> None:
        value = node.value
        self.lines.append(f"{indent}return;" if value is None else f"{indent}return {self._expression_text(value)};")

    def _if(self, node: If, indent: str, before: str = "") -> None:
        line = f"{indent}{before}if ({self._expression_text(node.test)}) {{"
        if len(line) > self._longest_line:
            self.lines += _fold(line.lstrip(), indent, self._longest_line)
        else:
            self.lines.append(line)
        self._body(node.body, indent + INDENT)
        alternative = node.alternative
        if len(alternative) == 1 and isinstance(alternative[0], If):
            self._if(alternative[0], indent, "} else ")
            return
        if alternative:
            self.lines.append(f"{indent}}} else {{")
            self._body(alternative, indent + INDENT)
        self.lines.append(f"{indent}}}")

    def _break(self, node: Break, indent: str) -> None:
        self.lines.append(f"{indent}break;")

    def _count_up(self, node: CountUp, indent: str) -> None:
        index = self._expression_text(node.index)
        self.lines.append(f"{indent}for ({index} = 0; {index} < {self._expression_text(node.limit)}; {index}++) {{")
        self._body(node.body, indent + INDENT)
        self.lines.append(f"{indent}}}")

    def _count_down(self, node: CountDown, indent: str) -> None:
        index = self._expression_text(node.index)
        self.lines.append(f"{indent}for ({index} = {self._expression_text(node.start)}; {index}-- > 0;) {{")
        self._body(node.body, indent + INDENT)
        self.lines.append(f"{indent}}}")

    def _switch(self, node: Switch, indent: str) -> None:
        self.lines.append(f"{indent}switch ({self._expression_text(node.value)}) {{")
        for labels, body in node.branches:
            if labels:
                self.lines += [f"{indent}case {self._expression_text(label)}:" for label in labels]
                self._body(body if body and isinstance(body[-1], Return) else (*body, Break()), indent + INDENT)
        self.lines.append(f"{indent}default:")
        self._body(node.default, indent + INDENT)
        self.lines.append(f"{indent}}}")

    def _variable_statement(self, node: Variable, indent: str) -> None:
        self.lines.append(f"{indent}{self.print_variable(node)};")

    def _variables(self, node: Variables, indent: str) -> None:
        self.lines.append(f"{indent}{_declarator(node.type, ', '.join(node.names))};")

    def _constant(self, node: Constant, indent: str) -> None:
        self.lines.append(f"{indent}enum {{ {node.name} = {self._expression_text(node.value)} }};")

    def _table(self, node: Table, indent: str) -> None:
        self.lines.append(f"{indent}static const {_declarator(node.type, node.name)}[] = {{")
        self.lines += [f"{indent}{INDENT}{self._expression_text(row)}," for row in node.rows]
        self.lines.append(f"{indent}}};")

    def _block(self, node: Block, indent: str) -> None:
        self.lines.append(f"{indent}{{")
        self._body(node.body, indent + INDENT)
        self.lines.append(f"{indent}}}")

    def _printed(self, node: Printed, indent: str) -> None:
        self.lines += node.lines

    def _compile_if(self, node: CompileIf, indent: str) -> None:
        self.lines.append(f"{indent}#{node.directive} {node.condition}")
        self._body(node.body, indent)
        self.lines.append(f"{indent}#endif")

    def print_variable(self, node: Variable) -> str:
        """The declaration of a variable, a parameter or a member, without what ends it."""
        kind = node.type
        line = f"{kind.name} *{node.name}" if kind.pointer else f"{kind.name} {node.name}"
        if kind.const:
            line = f"const {line}"
        if node.storage:
            line = f"{node.storage} {line}"
        for dimension in node.dimensions:
            line += "[]" if dimension is None else f"[{self._expression_text(dimension)}]"
        return line if node.value is None else f"{line} = {self._expression_text(node.value)}"


def _declarator(kind: Type, name: str) -> str:
    """`const uint8_t *name`"""
    const = "const " if kind.const else ""
    return f"{const}{kind.name} *{name}" if kind.pointer else f"{const}{kind.name} {name}"


def _remark_text(remark: str) -> str:
    """A comment after what it is about."""
    return f" /**< {remark} */" if remark else ""


def _fold(line: str, indent: str, longest_line: int) -> list[str]:
    """A line that is too long, in several lines: it breaks after `||`, or else after commas and `&&`."""
    ends = (" || ",) if " || " in line else (", ", " && ")
    for end in ends:
        line = line.replace(end, f"{end}\n")
    lines = [indent]
    for piece in line.split("\n"):
        if len(lines[-1]) + len(piece.rstrip()) > longest_line and lines[-1].strip():
            lines.append(indent + _CONTINUATION)
        lines[-1] += piece
    return [part.rstrip() for part in lines]
