"""Mutants of the compiler: each changes one condition, number, operator or statement of one function.

Neither mutmut nor cosmic-ray fits. They judge by tests alone, which take minutes for some folders, while the recorded
outputs tell most mutants from the right compiler within seconds. Many tests start processes of their own, in which the
switches of mutmut are not set.
"""

from __future__ import annotations

import ast
import random
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

COMPARISONS: dict[type[ast.cmpop], str] = {
    ast.Eq: "!=",
    ast.NotEq: "==",
    ast.Lt: "<=",
    ast.LtE: "<",
    ast.Gt: ">=",
    ast.GtE: ">",
    ast.In: "not in",
    ast.NotIn: "in",
    ast.Is: "is not",
    ast.IsNot: "is",
}
OPERATORS: dict[type[ast.operator], str] = {
    ast.Add: "-",
    ast.Sub: "+",
    ast.Mult: "//",
    ast.FloorDiv: "*",
    ast.Mod: "//",
    ast.LShift: ">>",
    ast.RShift: "<<",
    ast.BitOr: "&",
    ast.BitAnd: "|",
    ast.BitXor: "|",
}


@dataclass(frozen=True)
class Mutant:
    """One change of a source file: the offsets of its bytes, what stands there, and what takes its place."""

    path: str
    line: int
    kind: str
    start: int
    end: int
    right: str
    wrong: str

    def applied(self, source: bytes) -> bytes:
        """The source with the change."""
        assert source[self.start : self.end].decode() == self.right
        return source[: self.start] + self.wrong.encode() + source[self.end :]

    def __str__(self) -> str:
        right, wrong = (" ".join(text.split())[:70] for text in (self.right, self.wrong))
        return f"{self.path}:{self.line}: {self.kind}: {right} -> {wrong}"


class Source:
    """A source file with the offsets of its nodes."""

    def __init__(self, path: str, text: bytes) -> None:
        self.path, self.text = path, text
        self.starts = [0]
        for line in text.splitlines(keepends=True):
            self.starts.append(self.starts[-1] + len(line))

    def span(self, node: ast.expr | ast.stmt) -> tuple[int, int]:
        """The offsets of the bytes of a node."""
        assert node.end_lineno is not None
        assert node.end_col_offset is not None
        return self.starts[node.lineno - 1] + node.col_offset, self.starts[node.end_lineno - 1] + node.end_col_offset

    def segment(self, node: ast.expr | ast.stmt) -> str:
        """The text of a node."""
        start, end = self.span(node)
        return self.text[start:end].decode()

    def mutants(self) -> Iterator[Mutant]:
        """All mutants of the functions of the file."""
        for function in ast.walk(ast.parse(self.text)):
            if isinstance(function, ast.FunctionDef):
                body = function.body[1:] if ast.get_docstring(function) is not None else function.body
                for statement in body:
                    yield from self._of(statement)

    def _of(self, node: ast.AST) -> Iterator[Mutant]:
        if isinstance(node, ast.FunctionDef | ast.ClassDef | ast.JoinedStr | ast.AnnAssign | ast.Assert | ast.Raise):
            # Functions come on their own; a text is judged by whoever reads it; assertions are for people.
            return
        if isinstance(node, ast.keyword) and node.arg == "strict":
            # An assertion about lengths.
            return
        yield from self._mutants_at(node)
        for inner in ast.iter_child_nodes(node):
            yield from self._of(inner)

    def _mutants_at(self, node: ast.AST) -> Iterator[Mutant]:
        if isinstance(node, ast.If | ast.While | ast.IfExp):
            yield self._replaced("condition", node.test, f"(not ({self.segment(node.test)}))")
        elif isinstance(node, ast.Compare) and len(node.ops) == 1:
            yield from self._between("comparison", node.left, node.comparators[0], COMPARISONS.get(type(node.ops[0])))
        elif isinstance(node, ast.BoolOp):
            word = "or" if isinstance(node.op, ast.And) else "and"
            yield self._replaced(
                "logic", node, "(" + f" {word} ".join(f"({self.segment(v)})" for v in node.values) + ")"
            )
        elif isinstance(node, ast.BinOp):
            yield from self._between("operator", node.left, node.right, OPERATORS.get(type(node.op)))
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            yield self._replaced("negation", node, f"({self.segment(node.operand)})")
        elif isinstance(node, ast.Constant) and isinstance(node.value, bool):
            yield self._replaced("truth value", node, str(not node.value))
        elif isinstance(node, ast.Constant) and isinstance(node.value, int):
            yield self._replaced("number", node, f"({node.value + 1})")
        elif isinstance(node, ast.Return) and node.value is not None:
            if not isinstance(node.value, ast.Constant | ast.JoinedStr):
                yield self._replaced("result", node.value, "None")
        elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Call | ast.Yield | ast.YieldFrom):
            yield self._replaced("statement", node, "pass" if isinstance(node.value, ast.Call) else "yield from ()")
        elif isinstance(node, ast.Continue | ast.Break):
            yield self._replaced("statement", node, "pass")

    def _replaced(self, kind: str, node: ast.expr | ast.stmt, wrong: str) -> Mutant:
        start, end = self.span(node)
        return Mutant(self.path, node.lineno, kind, start, end, self.segment(node), wrong)

    def _between(self, kind: str, left: ast.expr, right: ast.expr, wrong: str | None) -> Iterator[Mutant]:
        """The operator between two operands, without the parentheses around them."""
        if wrong is None:
            return
        start, end = self.span(left)[1], self.span(right)[0]
        text = self.text[start:end].decode()
        word = text.strip(" \n()")
        if word and "\n" not in word and "#" not in word:
            at = start + text.encode().index(word.encode())
            yield Mutant(self.path, left.lineno, kind, at, at + len(word.encode()), word, wrong)


@cache
def mutants(package: Path, folder: str) -> tuple[Mutant, ...]:
    """All mutants of the modules in a folder of the compiler, not of folders inside it, in order."""
    result: list[Mutant] = []
    for path in sorted((package / folder).glob("*.py")):
        source = path.read_bytes()
        result += Source(path.relative_to(package).as_posix(), source).mutants()
    return tuple(result)


@cache
def changeable(package: Path, folder: str) -> tuple[str, ...]:
    """The modules in a folder of the compiler that have a mutant."""
    paths = {path.relative_to(package).as_posix(): path for path in sorted((package / folder).glob("*.py"))}
    return tuple(name for name in paths if any(True for _ in Source(name, paths[name].read_bytes()).mutants()))


def sample(package: Path, folder: str, count: int, seed: int) -> list[Mutant]:
    """So many mutants of a folder at random, the same for the same seed and the same source."""
    every = mutants(package, folder)
    return random.Random(f"{seed} {folder}").sample(every, min(count, len(every)))
