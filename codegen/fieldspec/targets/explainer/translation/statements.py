"""Modules, classes, functions and statements of Python as text of JavaScript."""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cache

from fieldspec.targets.explainer.translation.expressions import Expressions
from fieldspec.targets.explainer.translation.names import Untranslatable, camel, is_data_class
from fieldspec.targets.explainer.translation.tables import LEFT_OUT

_ERRORS = {"ValueError": "RangeError", "KeyError": "RangeError", "Exception": "Error"}


class Statements:
    """The statements of one module."""

    def __init__(self, expressions: Expressions) -> None:
        self.expressions = expressions
        self.text = expressions.text
        self.declared: set[str] = set()

    def refuse(self, node: ast.AST, reason: str = "") -> Untranslatable:
        """The error of a node."""
        return self.expressions.refuse(node, reason)

    def top(self, node: ast.stmt) -> Iterator[str]:
        """The lines of a statement of the module. Raises Untranslatable."""
        match node:
            case ast.FunctionDef():
                is_private = node.name.startswith("_")
                yield from self._function(node, "" if is_private else "export ", f"function{_star(node)} ")
            case ast.ClassDef():
                yield from self._class(node)
            case ast.Assign(targets=[target]) | ast.AnnAssign(target=target) if node.value is not None:
                if isinstance(target, ast.Name) and target.id[0].isupper() and not target.id.isupper():
                    return  # a name of a type
                name = (
                    self.expressions.name(target.id)
                    if isinstance(target, ast.Name)
                    else self.expressions.target(target)
                )
                export = "" if isinstance(target, ast.Name) and target.id.startswith("_") else "export "
                yield f"{export}const {name} = {self.text(node.value)};"
            case ast.Expr(value=ast.Constant(value=str(text))):
                yield from _comment(text)
            case ast.Import() | ast.ImportFrom() | ast.If():
                return
            case _:
                raise self.refuse(node)

    # Functions

    def _function(self, node: ast.FunctionDef, export: str, keyword: str) -> Iterator[str]:
        outer_types, outer_declared = self.expressions.types.local, self.declared
        arguments = [argument for argument in [*node.args.args, *node.args.kwonlyargs] if argument.arg != "self"]
        self.expressions.types.local = {
            argument.arg: ast.unparse(argument.annotation) if argument.annotation is not None else ""
            for argument in arguments
        }
        yield from _comment(ast.get_docstring(node) or "")
        name = self.expressions.name(node.name) if keyword.startswith("function") else camel(node.name)
        yield f"{export}{keyword}{name}({self._parameters(node)}) {{"
        yield from self._body(node)
        yield "}"
        self.expressions.types.local, self.declared = outer_types, outer_declared

    def _parameters(self, node: ast.FunctionDef) -> str:
        arguments = [argument for argument in node.args.args if argument.arg != "self"]
        defaults = [*[None] * (len(arguments) - len(node.args.defaults)), *node.args.defaults]
        pairs = [*zip(arguments, defaults, strict=True), *zip(node.args.kwonlyargs, node.args.kw_defaults, strict=True)]
        return ", ".join(
            camel(argument.arg) + ("" if default is None else f" = {self.text(default)}") for argument, default in pairs
        )

    def _body(self, node: ast.FunctionDef) -> Iterator[str]:
        body = node.body[1:] if ast.get_docstring(node) else node.body
        counts = Counter(_stored(body))
        for name in counts:
            self.expressions.types.local.setdefault(name, "")
        parameters = {argument.arg for argument in [*node.args.args, *node.args.kwonlyargs]}
        self.declared = set(parameters)
        self.constant = {name for name, count in counts.items() if count == 1}
        targets = {inner.target.id for own in body for inner in ast.walk(own) if isinstance(inner, ast.NamedExpr)}
        is_early = {name: name in targets or not _is_declared_inline(name, body) for name in counts.keys() - parameters}
        early = sorted(name for name in is_early if is_early[name])
        if early:
            yield f"  let {', '.join(map(camel, early))};"
            self.declared |= set(early)
        yield from self.block(body)

    def block(self, body: Sequence[ast.stmt]) -> Iterator[str]:
        """Statements with their indentation."""
        for statement in body:
            for text in self.statement(statement):
                yield from (f"  {line}" for line in text.split("\n"))

    def statement(self, node: ast.stmt) -> Iterator[str]:
        """The lines of a statement within a function. Raises Untranslatable."""
        match node:
            case ast.Return():
                yield f"return {self.text(node.value)};" if node.value is not None else "return;"
            case ast.Expr(value=ast.Yield(value=value)) if value is not None:
                yield f"yield {self.text(value)};"
            case ast.Expr(value=ast.YieldFrom(value=value)):
                yield f"yield* {self.text(value)};"
            case ast.Expr():
                yield f"{self.text(node.value)};"
            case ast.Assign(targets=[target]):
                yield from self._assignment(target, self.text(node.value))
                if isinstance(target, ast.Name) and not self.expressions.types.local.get(target.id):
                    self.expressions.types.local[target.id] = self.expressions.types.of(node.value)
            case ast.AnnAssign(value=ast.expr() as value):
                if isinstance(node.target, ast.Name):
                    self.expressions.types.local[node.target.id] = ast.unparse(node.annotation)
                yield from self._assignment(node.target, self.text(value))
            case ast.AugAssign(op=ast.Add(), target=ast.Name(id=name)) if self._is_sum(name, node.value):
                yield f"{camel(name)} += {self.text(node.value)};"
            case ast.If():
                yield from self._conditional(node, "")
            case ast.For(orelse=[]):
                yield f"for (const {self.expressions.target(node.target) or '_'} of {self.text(node.iter)}) {{"
                yield from self._scoped(node.body, frozenset(_names(node.target)))
                yield "}"
            case ast.While(orelse=[]):
                yield f"while ({self.expressions.test(node.test)}) {{"
                yield from self._scoped(node.body)
                yield "}"
            case ast.Try(handlers=[handler], orelse=[], finalbody=[]):
                yield from self._try(node, handler)
            case ast.Raise():
                yield f"throw {self.text(node.exc) if node.exc is not None else 'error'};"
            case ast.Continue():
                yield "continue;"
            case ast.Assert() | ast.ImportFrom() | ast.Pass():
                return
            case _:
                raise self.refuse(node)

    def _scoped(self, body: Sequence[ast.stmt], names: frozenset[str] = frozenset()) -> Iterator[str]:
        declared, self.declared = self.declared, self.declared | names
        yield from self.block(body)
        self.declared = declared

    def _assignment(self, target: ast.expr, value: str) -> Iterator[str]:
        if isinstance(target, ast.Subscript):
            yield f"py.put({self.text(target.value)}, {self.text(target.slice)}, {value});"
            return
        names = [
            inner.id for inner in ast.walk(target) if isinstance(inner, ast.Name) and isinstance(inner.ctx, ast.Store)
        ]
        new = [name for name in names if name not in self.declared and name != "_"]
        self.declared |= set(names)
        if names and len(new) == len([name for name in names if name != "_"]):
            keyword = "const" if all(name in self.constant for name in new) else "let"
            yield f"{keyword} {self.expressions.target(target)} = {value};"
            return
        if new:
            yield f"let {', '.join(map(camel, new))};"
        yield f"{self.expressions.target(target)} = {value};"

    def _conditional(self, node: ast.If, before: str) -> Iterator[str]:
        yield f"{before}if ({self.expressions.test(node.test)}) {{"
        yield from self._scoped(node.body)
        match node.orelse:
            case []:
                yield "}"
            case [ast.If() as other]:
                yield from self._conditional(other, "} else ")
            case _:
                yield "} else {"
                yield from self._scoped(node.orelse)
                yield "}"

    def _try(self, node: ast.Try, handler: ast.ExceptHandler) -> Iterator[str]:
        assert isinstance(handler.type, ast.Name)
        error = camel(handler.name or "error")
        yield "try {"
        yield from self._scoped(node.body)
        yield f"}} catch ({error}) {{"
        kind = _ERRORS.get(handler.type.id) or self.expressions.name(handler.type.id)
        yield f"  if (!({error} instanceof {kind})) throw {error};"
        self.expressions.types.local.setdefault(handler.name or "error", "")
        yield from self._scoped(handler.body)
        yield "}"

    def _is_sum(self, name: str, value: ast.expr) -> bool:
        """Whether a name stands for a number or a text to which a value is added, not for a series."""
        is_series = isinstance(value, ast.List | ast.Tuple | ast.ListComp)
        return not is_series and self.expressions.types.local.get(name) != "bytes"

    # Classes

    def _class(self, node: ast.ClassDef) -> Iterator[str]:
        yield from _comment(ast.get_docstring(node) or "")
        bases = [base.id for base in node.bases if isinstance(base, ast.Name)]
        parent = f" extends {_ERRORS.get(bases[0]) or self.expressions.name(bases[0])}" if bases else ""
        yield f"{'' if node.name.startswith('_') else 'export '}class {self.expressions.name(node.name)}{parent} {{"
        lines: list[str] = []
        if is_data_class(node):
            lines += self._fields(node)
        if bases:
            lines += ["get name() {", f'  return "{node.name.strip("_")}";', "}", ""]
        for statement in node.body:
            match statement:
                case ast.FunctionDef(name=name) if name in LEFT_OUT:
                    pass
                case ast.FunctionDef():
                    lines += [*self._method(statement), ""]
                case ast.Expr() | ast.AnnAssign() | ast.Assign():
                    pass
                case _:
                    raise self.refuse(statement)
        while lines and not lines[-1]:
            lines.pop()
        yield from (f"  {line}" if line else line for line in lines)
        yield "}"

    def _fields(self, node: ast.ClassDef) -> list[str]:
        parameters = {}
        for own in node.body:
            if isinstance(own, ast.AnnAssign):
                has_default = own.value is not None and not isinstance(own.value, ast.Call)
                name = self.text(own.target)
                parameters[name] = f"{name} = {self.text(own.value)}" if has_default and own.value else name
        assignments = [f"  this.{name} = {name};" for name in parameters]
        return [f"constructor({{ {', '.join(parameters.values())} }}) {{", *assignments, "}", ""]

    def _method(self, node: ast.FunctionDef) -> Iterator[str]:
        is_property = any(isinstance(own, ast.Name) and own.id == "property" for own in node.decorator_list)
        keyword = "get " if is_property else _star(node)
        if node.name == "__init__":
            lines = list(self._function(node, "", ""))
            yield from (_THIS.sub("this", line.replace("__init__(", "constructor(", 1)) for line in lines)
            return
        for line in self._function(node, "", keyword):
            yield _THIS.sub("this", line)


_THIS = re.compile(r"\bself\b")


def _star(node: ast.FunctionDef) -> str:
    inner = [child for child in _own_nodes(node.body) if isinstance(child, ast.Yield | ast.YieldFrom)]
    return "*" if inner else ""


def _own_nodes(body: Sequence[ast.AST]) -> Iterator[ast.AST]:
    """The nodes of a function, without nodes of inner functions."""
    waiting = [*reversed(body)]
    while waiting:
        node = waiting.pop()
        yield node
        if not isinstance(node, ast.FunctionDef | ast.Lambda):
            waiting += [*ast.iter_child_nodes(node)][::-1]


def _stored(body: Sequence[ast.AST]) -> Iterator[str]:
    """The names that are assigned, but not by comprehensions and loops."""
    nodes = list(_own_nodes(body))
    targets = [node.target for node in nodes if isinstance(node, ast.comprehension | ast.For)]
    bound = {id(inner) for target in targets for inner in ast.walk(target)}
    for node in nodes:
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store) and id(node) not in bound:
            yield node.id


@cache
def _names(node: ast.AST) -> frozenset[str]:
    return frozenset(inner.id for inner in ast.walk(node) if isinstance(inner, ast.Name))


def _is_declared_inline(name: str, body: Sequence[ast.stmt]) -> bool:
    """Whether a block has all uses of a name, and the first of its statements that uses the name assigns it."""
    first, *rest = [statement for statement in body if name in _names(statement)]
    if rest or isinstance(first, ast.Assign | ast.AnnAssign):
        return isinstance(first, ast.Assign | ast.AnnAssign) and name in _stored([first])
    heads = [value for _, value in ast.iter_fields(first) if isinstance(value, ast.expr)]
    blocks = [block for block in _blocks(first) if any(name in _names(statement) for statement in block)]
    return not any(name in _names(head) for head in heads) and all(_is_declared_inline(name, own) for own in blocks)


def _blocks(node: ast.stmt) -> Iterator[list[ast.stmt]]:
    for key in ("body", "orelse"):
        yield getattr(node, key, [])
    for handler in getattr(node, "handlers", ()):
        yield handler.body


def _comment(text: str) -> Iterator[str]:
    lines = text.strip().splitlines()
    if len(lines) == 1:
        yield f"/** {lines[0]} */"
    elif lines:
        yield "/**"
        for line in lines:
            yield f" * {line.strip()}".rstrip()
        yield " */"
