"""Writes expressions of C as text, with parentheses where they bind less than what is around them."""

from __future__ import annotations

from collections.abc import Callable
from operator import attrgetter
from typing import Any

from fieldspec.targets.c.expressions import (
    Call,
    Cast,
    Conditional,
    Element,
    Expression,
    Group,
    Identifier,
    Initializer,
    Literal,
    Local,
    Member,
    Operation,
    PointerMember,
    SizeOf,
    Unary,
)

_PRECEDENCE = {"&": 7, "^": 6, "|": 5, "&&": 4, "||": 3} | {
    **dict.fromkeys(("*", "/", "%"), 12),
    **dict.fromkeys(("+", "-"), 11),
    **dict.fromkeys(("<<", ">>"), 10),
    **dict.fromkeys(("<", "<=", ">", ">="), 9),
    **dict.fromkeys(("==", "!="), 8),
}
_UNARY, _CONDITIONAL = 13, 2
_ASSOCIATIVE = ("+", "&", "^", "|", "&&", "||")


class ExpressionPrinter:
    """Writes expressions. It notes which local variables it has written."""

    def __init__(self) -> None:
        self._used: set[str] = set()
        # Leaves are most of a tree, so nothing of ours is called for them.
        self._expressions: dict[type, Callable[[Any], str]] = {
            Identifier: attrgetter("name"),
            Local: self._local,
            Literal: attrgetter("text"),
            Call: self._call,
            Member: self._member,
            PointerMember: self._pointer_member,
            Element: self._element,
            Unary: self._unary,
            Cast: self._cast,
            SizeOf: self._size_of,
            Operation: self._operation,
            Group: self._group,
            Conditional: self._conditional,
            Initializer: self._initializer,
        }

    def _expression_text(self, expression: Expression) -> str:
        return self._expressions[expression.__class__](expression)

    def _local(self, node: Local) -> str:
        self._used.add(node.name)
        return node.name

    def _call(self, node: Call) -> str:
        texts = self._expressions
        return f"{node.function}({', '.join([texts[argument.__class__](argument) for argument in node.arguments])})"

    def _member(self, node: Member) -> str:
        return f"{self._expression_text(node.structure)}.{node.name}"

    def _pointer_member(self, node: PointerMember) -> str:
        return f"{self._expression_text(node.pointer)}->{node.name}"

    def _element(self, node: Element) -> str:
        return f"{self._expression_text(node.array)}[{self._expression_text(node.index)}]"

    def _unary(self, node: Unary) -> str:
        return f"{node.operator}{self._operand(node.operand, _UNARY)}"

    def _cast(self, node: Cast) -> str:
        return f"({node.type}){self._operand(node.operand, _UNARY)}"

    def _size_of(self, node: SizeOf) -> str:
        return f"sizeof {self._operand(node.operand, _UNARY)}"

    def _group(self, node: Group) -> str:
        return f"({self._expression_text(node.content)})"

    def _initializer(self, node: Initializer) -> str:
        return f"{{{', '.join([self._expression_text(value) for value in node.values])}}}"

    def _operation(self, node: Operation) -> str:
        operator, texts = node.operator, self._expressions
        strength = _PRECEDENCE[operator]
        parts: list[str] = []
        for operand in node.operands:
            text = texts[operand.__class__](operand)
            if isinstance(operand, Operation):
                text = f"({text})" if _PRECEDENCE[operand.operator] < strength else text
            elif isinstance(operand, Conditional):
                text = f"({text})"
            if not parts and operator not in _ASSOCIATIVE:
                strength += 1
            parts.append(text)
        return f" {operator} ".join(parts)

    def _conditional(self, node: Conditional) -> str:
        test = self._operand(node.test, _CONDITIONAL + 1)
        return f"{test} ? {self._expression_text(node.positive)} : {self._expression_text(node.negative)}"

    def _operand(self, node: Expression, strength: int) -> str:
        """An operand, in parentheses where it binds less than `strength`."""
        text = self._expressions[node.__class__](node)
        if isinstance(node, Operation):
            return f"({text})" if _PRECEDENCE[node.operator] < strength else text
        return f"({text})" if isinstance(node, Conditional) else text
