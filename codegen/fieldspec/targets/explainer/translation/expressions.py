"""Expressions of Python as expressions of JavaScript. `py` has what JavaScript lacks: see `runtime/python.js`."""

from __future__ import annotations

import ast
import json
from collections.abc import Sequence

from fieldspec.targets.explainer.translation.names import Names, Untranslatable, camel
from fieldspec.targets.explainer.translation.tables import (
    FUNCTIONS,
    METHODS,
    METHODS_OF_PYTHON,
    OF_DATA,
    OPERATORS,
    RENAMED,
    SAME_METHODS,
    TYPES,
)
from fieldspec.targets.explainer.translation.types import SAME, Types, is_sentence

_WIDEST = 80
"""The characters of an object in one line."""


class Expressions:
    """The expressions of one module. `used` are the names of other modules that they use; `locals` the types of the
    parameters of the function around them.
    """

    def __init__(self, module: str, names: Names, spellings: dict[str, str]) -> None:
        self.module, self.names, self.spellings = module, names, spellings
        self.used: set[str] = set()
        nodes = list(ast.walk(names.modules[module]))
        stored = {node.id for node in nodes if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)}
        self.bound = stored | {node.arg for node in nodes if isinstance(node, ast.arg)}
        self.bound |= {node.name for node in nodes if isinstance(node, ast.FunctionDef)}
        self.types = Types(names)

    def refuse(self, node: ast.AST, reason: str = "") -> Untranslatable:
        """The error of a node."""
        return Untranslatable(self.module, node, reason or f"{type(node).__name__} has no translation")

    def test(self, node: ast.expr) -> str:
        """An expression as a condition."""
        match node:
            case ast.BoolOp():
                joint = " && " if isinstance(node.op, ast.And) else " || "
                return joint.join(self._in_brackets(value, self.test(value)) for value in node.values)
            case ast.UnaryOp(op=ast.Not()):
                inner = self.test(node.operand)
                return f"!{inner}" if _is_atom(inner) else f"!({inner})"
            case _:
                kind = self.types.of(node)
                return self.text(node) if kind in SAME else f"py.truth({self.text(node)})"

    def _in_brackets(self, node: ast.expr, text: str) -> str:
        return f"({text})" if isinstance(node, ast.BoolOp | ast.IfExp | ast.Lambda) else text

    def _operand(self, node: ast.expr) -> str:
        text = self.text(node)
        return text if _is_atom(text) or isinstance(node, ast.Constant | ast.JoinedStr) else f"({text})"

    # Expressions

    def text(self, node: ast.expr) -> str:
        """An expression in JavaScript. Raises Untranslatable."""
        match node:
            case ast.Constant():
                return self._constant(node)
            case ast.Name(id=name) if name not in self.bound | self.types.local.keys() | self.spellings.keys():
                raise self.refuse(node, f"{name} is not known")
            case ast.Name():
                return self.name(node.id)
            case ast.Attribute():
                return self._attribute(node)
            case ast.Tuple() | ast.List():
                return f"[{self._series_text(node.elts)}]"
            case ast.Dict():
                return self._dict(node)
            case ast.JoinedStr():
                return self._joined(node)
            case ast.Starred(value=ast.Attribute()):
                return f"...({self.text(node.value)} ?? [])"
            case ast.Starred():
                return f"...{self._operand(node.value)}"
            case ast.BoolOp():
                return self._alternatives(node)
            case ast.UnaryOp():
                return self._unary(node)
            case ast.BinOp():
                return self._binary(node)
            case ast.Compare():
                return self._comparison(node)
            case ast.IfExp():
                test = self._in_brackets(node.test, self.test(node.test))
                return f"{test} ? {self._operand(node.body)} : {self.text(node.orelse)}"
            case ast.Subscript():
                return self._subscript(node)
            case ast.Lambda():
                parameters = ", ".join(camel(argument.arg) for argument in node.args.args)
                return f"({parameters}) => {self.text(node.body)}"
            case ast.GeneratorExp() | ast.ListComp():
                return self._comprehension(node.elt, node.generators)
            case ast.DictComp():
                pair = ast.Tuple([node.key, node.value])
                return f"py.dict({self._comprehension(pair, node.generators)})"
            case ast.NamedExpr():
                return f"({self.target(node.target)} = {self.text(node.value)})"
            case ast.Call():
                return self._call(node)
            case _:
                raise self.refuse(node)

    def _attribute(self, node: ast.Attribute) -> str:
        """An attribute; the path of a fact is its own in the data, and its sources are one text."""
        if is_sentence(node):
            self.used.add("SENTENCES")
            return f"SENTENCES.{node.attr}"
        owner = node.value.value if isinstance(node.value, ast.Attribute) and node.value.attr == "place" else node.value
        return f"{self._operand(owner)}.{OF_DATA.get(node.attr) or camel(node.attr)}"

    def name(self, name: str) -> str:
        """A name of the module, of another one, or of a function."""
        if name in self.types.local or name in self.bound - self.spellings.keys():
            return camel(name)
        self.used.add(self.spellings[name])
        return self.spellings[name]

    def _series_text(self, nodes: Sequence[ast.expr]) -> str:
        return ", ".join(map(self.text, nodes))

    def _constant(self, node: ast.Constant) -> str:
        value = node.value
        if isinstance(value, bytes):
            return f"Uint8Array.of({', '.join(map(str, value))})"
        if value is None or isinstance(value, bool | str | int):
            return json.dumps(value)
        raise self.refuse(node)

    def _dict(self, node: ast.Dict) -> str:
        items = []
        for key, value in zip(node.keys, node.values, strict=True):
            items.append(
                f"...{self.text(value)}.entries()" if key is None else f"[{self.text(key)}, {self.text(value)}]"
            )
        return f"py.dict([{', '.join(items)}])"

    def _joined(self, node: ast.JoinedStr) -> str:
        texts = []
        for value in node.values:
            match value:
                case ast.Constant():
                    text = json.dumps(value.value)[1:-1].replace('\\"', '"').replace("`", "\\`").replace("${", "\\${")
                    texts.append(text)
                case ast.FormattedValue(format_spec=None, conversion=-1):
                    texts.append(f"${{{self.text(value.value)}}}")
                case ast.FormattedValue(format_spec=ast.JoinedStr(values=[ast.Constant(value=str(form))])) if form[
                    -1:
                ] in ("X", "x"):
                    texts.append(f"${{py.hexadecimal({self.text(value.value)}, {json.dumps(form)})}}")
                case _:
                    raise self.refuse(value, f"this form of a text has no translation: {ast.unparse(value)}")
        return f"`{''.join(texts)}`"

    def _alternatives(self, node: ast.BoolOp) -> str:
        if self.types.of(node) == "bool" or isinstance(node.op, ast.And):
            if self.types.of(node) != "bool":
                raise self.refuse(node, "the value of `and` has no translation, except a truth value")
            return self.test(node)
        *before, last = node.values
        result = self._operand(last)
        for value in reversed(before):
            is_same = self.types.of(value) in SAME
            result = (
                f"{self._operand(value)} || {result}" if is_same else f"py.either({self.text(value)}, () => {result})"
            )
        return result

    def _unary(self, node: ast.UnaryOp) -> str:
        match node.op:
            case ast.Not():
                return self.test(node)
            case ast.USub():
                return f"-{self._operand(node.operand)}"
            case _:
                raise self.refuse(node)

    def _binary(self, node: ast.BinOp) -> str:
        match node.op:
            case ast.FloorDiv():
                return f"Math.floor({self._operand(node.left)} / {self._operand(node.right)})"
            case ast.Add() if "bytes" in (self.types.of(node.left), self.types.of(node.right)):
                return f"py.joined({self.text(node.left)}, {self.text(node.right)})"
            case ast.BitAnd() if isinstance(node.right, ast.UnaryOp):
                return f"py.without({self.text(node.left)}, {self.text(node.right.operand)})"
            case ast.BitAnd():
                return f"py.common({self.text(node.left)}, {self.text(node.right)})"
            case ast.Mult() if isinstance(node.left, ast.List):
                return f"py.repeated({self.text(node.left)}, {self.text(node.right)})"
        left, right = self._operand(node.left), self._operand(node.right)
        if type(node.op) not in OPERATORS:
            raise self.refuse(node)
        if (
            isinstance(node.left, ast.BinOp)
            and not isinstance(node.left.op, ast.FloorDiv)
            and isinstance(node.op, ast.Add | ast.Sub)
        ):
            left = self.text(node.left)
        return f"{left} {OPERATORS[type(node.op)]} {right}"

    def _comparison(self, node: ast.Compare) -> str:
        operands = [node.left, *node.comparators]
        pairs = zip(operands, node.ops, operands[1:], strict=False)
        return " && ".join(self._compared(left, operator, right) for left, operator, right in pairs)

    def _compared(self, left: ast.expr, operator: ast.cmpop, right: ast.expr) -> str:
        own, other = self._operand(left), self._operand(right)
        match operator:
            case ast.Is() | ast.IsNot():
                sign = "==" if isinstance(operator, ast.Is) else "!="
                is_none = isinstance(right, ast.Constant) and right.value is None
                return f"{own} {sign} null" if is_none else f"{own} {sign}= {other}"
            case ast.Eq() | ast.NotEq():
                sign = "===" if isinstance(operator, ast.Eq) else "!=="
                types = {self.types.of(left), self.types.of(right)}
                if types & {"str", "bool"} or (isinstance(left, ast.Call) and getattr(left.func, "id", "") == "len"):
                    return f"{own} {sign} {other}"
                return f"{'' if sign == '===' else '!'}py.equal({self.text(left)}, {self.text(right)})"
            case ast.In() | ast.NotIn():
                return f"{'' if isinstance(operator, ast.In) else '!'}py.has({self.text(right)}, {self.text(left)})"
            case _:
                return f"{own} {OPERATORS[type(operator)]} {other}"

    def _subscript(self, node: ast.Subscript) -> str:
        value, key = self._operand(node.value), node.slice
        match key:
            case ast.Slice(step=None):
                bounds = [self.text(bound) if bound is not None else "undefined" for bound in (key.lower, key.upper)]
                return f"py.slice({', '.join([self.text(node.value), *bounds][: 3 if key.upper is not None else 2])})"
            case ast.Slice(lower=None, upper=None, step=ast.UnaryOp()):
                return f"py.reversed({self.text(node.value)})"
            case ast.Constant(value=int(number)):
                return f"{value}[{number}]"
            case ast.UnaryOp(op=ast.USub(), operand=ast.Constant()):
                return f"{value}.at({self.text(key)})"
            case ast.Slice():
                raise self.refuse(node)
            case _:
                return f"py.item({self.text(node.value)}, {self.text(key)})"

    def _comprehension(self, element: ast.expr, generators: Sequence[ast.comprehension]) -> str:
        first, *rest = generators
        text, parameter = self._filtered(first)
        if rest:
            return f"{text}.flatMap(({parameter}) => {self._comprehension(element, rest)})"
        if ast.dump(element) == ast.dump(first.target).replace("Store()", "Load()"):
            return text
        return f"{text}.map(({parameter}) => {self.text(element)})"

    def _filtered(self, generator: ast.comprehension) -> tuple[str, str]:
        """The series of a generator that passes its conditions, and the name of an item."""
        text = self.text(generator.iter)
        if not isinstance(generator.iter, ast.GeneratorExp | ast.ListComp | ast.Tuple | ast.List):
            text = f"[...{text}]"
        parameter = self.target(generator.target)
        return text + "".join(f".filter(({parameter}) => {self.test(own)})" for own in generator.ifs), parameter

    def target(self, node: ast.expr) -> str:
        """The target of an assignment: a name, or several in brackets. Raises Untranslatable."""
        match node:
            case ast.Name():
                return "" if node.id == "_" else camel(node.id)
            case ast.Tuple() | ast.List():
                return f"[{', '.join(map(self.target, node.elts))}]"
            case ast.Attribute():
                return self.text(node)
            case _:
                raise self.refuse(node)

    # Calls

    def _call(self, node: ast.Call) -> str:
        match node.func:
            case ast.Name(id=name):
                return self._called_name(node, name)
            case ast.Attribute():
                return self._called_method(node, node.func)
            case _:
                raise self.refuse(node)

    def _called_name(self, node: ast.Call, name: str) -> str:
        if name == "isinstance":
            return self._instance_test(node)
        if name == "len":
            return f"{self._operand(node.args[0])}.length"
        if name == "replace":
            keywords = [ast.keyword(OF_DATA.get(own.arg or "", own.arg), own.value) for own in node.keywords]
            return f"py.replace({self.text(node.args[0])}, {self._object(keywords)})"
        if name in self.names.data_classes:
            return self._constructed(node, name)
        is_known = name in self.spellings or name in self.types.local
        if name in FUNCTIONS and not is_known:
            return self._builtin(node, name)
        function = self.name(name)
        new = "new " if name[0].isupper() or (name[0] == "_" and name[1].isupper()) else ""
        return f"{new}{function}({self._arguments(node)})"

    def _builtin(self, node: ast.Call, name: str) -> str:
        values = [self.text(argument) for argument in node.args]
        if name == "bool" and len(node.args) == 1:
            return f"py.truth({values[0]})"
        if name in ("any", "all") and isinstance(node.args[0], ast.GeneratorExp) and len(node.args[0].generators) == 1:
            text, parameter = self._filtered(node.args[0].generators[0])
            return f"{text}.{'some' if name == 'any' else 'every'}(({parameter}) => {self.test(node.args[0].elt)})"
        if name in ("tuple", "list") and isinstance(node.args[0], ast.GeneratorExp | ast.ListComp):
            return values[0]
        keywords = [self.text(keyword.value) for keyword in node.keywords if keyword.arg in ("key", "default")]
        return f"py.{name}({', '.join([*values, *keywords])})"

    def _instance_test(self, node: ast.Call) -> str:
        value, kinds = self.text(node.args[0]), node.args[1]
        tests = []
        for kind in [kinds.left, kinds.right] if isinstance(kinds, ast.BinOp) else [kinds]:
            assert isinstance(kind, ast.Name)
            tests.append(
                f"py.{TYPES[kind.id]}({value})" if kind.id in TYPES else f"{value} instanceof {self.name(kind.id)}"
            )
        return " || ".join(tests) if len(tests) == 1 else f"({' || '.join(tests)})"

    def _constructed(self, node: ast.Call, name: str) -> str:
        fields = self.names.data_classes[name]
        if any(isinstance(argument, ast.Starred) for argument in node.args):
            raise self.refuse(node, "the fields of an object need their names")
        by_place = [ast.keyword(own, value) for own, value in zip(fields, node.args, strict=False)]
        return f"new {self.name(name)}({self._object([*by_place, *node.keywords])})"

    def _object(self, keywords: Sequence[ast.keyword]) -> str:
        items = []
        for keyword in keywords:
            if keyword.arg is None:
                raise self.refuse(keyword, "the fields of an object need their names")
            key, value = camel(keyword.arg), self.text(keyword.value)
            items.append(key if key == value else f"{key}: {value}")
        if sum(map(len, items)) > _WIDEST:
            inner = "".join(f"  {item},\n" for item in items)
            return f"{{\n{inner}}}"
        return f"{{ {', '.join(items)} }}" if items else "{}"

    def _arguments(self, node: ast.Call) -> str:
        if node.keywords:
            raise self.refuse(node, "the arguments of a function need their places")
        return self._series_text(node.args)

    def _called_method(self, node: ast.Call, function: ast.Attribute) -> str:
        name = function.attr
        if isinstance(function.value, ast.Name) and function.value.id == "sentences" and not name.isupper():
            self.used.add(camel(name))
            return f"{camel(name)}({self._arguments(node)})"
        if isinstance(function.value, ast.Name) and function.value.id == "re":
            return f"py.re.{name}({self._series_text(node.args)})"
        if name == "fromhex":
            return f"py.bytesOfHex({self._series_text(node.args)})"
        if name == "fromkeys":
            keys, _ = self._filtered(ast.comprehension(ast.Name("_"), node.args[0], [], 0))
            return f"py.dict({keys}.map((key) => [key, null]))"
        owner = self._operand(function.value)
        if name == "format":
            return f"py.format({self.text(function.value)}, {self._object(node.keywords)})"
        if name == "get" and len(node.args) == 2:
            return f"({owner}.get({self.text(node.args[0])}) ?? {self.text(node.args[1])})"
        if name in METHODS:
            values = [owner, *map(self.text, node.args), *(self.text(keyword.value) for keyword in node.keywords)]
            return f"py.{name}({', '.join(values)})"
        if name in METHODS_OF_PYTHON.difference(RENAMED, SAME_METHODS):
            raise self.refuse(node, f"{name} has no translation")
        return f"{owner}.{RENAMED.get(name) or camel(name)}({self._arguments(node)})"


def _is_atom(text: str) -> bool:
    """Whether a text binds closer than `!`."""
    depth = 0
    for character in text:
        depth += (character in "([{") - (character in ")]}")
        if depth == 0 and character == " ":
            return False
    return True
