"""Runs functions of Structured Text: checked strictly as typed code, made into Python, and run.

Nothing is converted silently: both sides of every operator and of every assignment must have one type, or one is a
literal that fits. Sums, differences and products that leave their type, and indexes outside an array, are errors at
run time, so what runs here needs neither wrapping nor luck. `rounding` says what LREAL_TO_<whole> does, which differs
between makers of controllers: `even`, `away` or `cut`.
"""

from __future__ import annotations

from typing import Any

from st_declared import check_constant, check_constants, size_of
from st_syntax import Function, StError, Unit
from st_values import (
    BITS,
    ELEMENTARY,
    NUMBERS,
    REALS,
    SIZES,
    WHOLE,
    at,
    bounds,
    conversion,
    divided,
    remainder,
    single,
    wrapped_number,
)

SYMBOLS = {"AND": "&", "OR": "|", "XOR": "^"}


class Machine:
    """The functions of a unit. `call` runs one of them; arrays and structs are lists and dicts, and are changed."""

    def __init__(self, unit: Unit, rounding: str = "even", *, only: str = "") -> None:
        self.unit, self.rounding = unit, rounding
        self.scope: dict[str, Any] = {"_at": at, "_div": divided, "_rem": remainder, "_single": single}
        self.scope |= {f"_wrapped_{kind}": wrapped_number(kind) for kind in WHOLE}
        self.members = {
            (enum, member): self._member(enum, member, value)
            for enum, (base, members) in unit.enums.items()
            for member, value in members.items()
            if base in WHOLE
        }
        check_constants(unit)
        for struct in unit.structs.values():
            for _, kind, _ in struct:
                self.kind(kind)
        for function in unit.functions.values():
            if not only or function.name == only:
                source = Compiled(self, function).source()
                exec(compile(source, function.name, "exec"), self.scope)

    def _member(self, enum: str, member: str, value: Any) -> int:
        assert value[0] == "number", (enum, member)
        low, high = bounds(self.unit.enums[enum][0])
        if not low <= value[1] <= high:
            raise StError(f"{enum}.{member} is {value[1]}, which {self.unit.enums[enum][0]} does not hold")
        return int(value[1])

    def kind(self, declared: Any) -> Any:
        """A type that is declared: ("array", low, high, type) with numbers, or a name that there is."""
        if isinstance(declared, tuple) and declared[0] == "array":
            _, low, high, of = declared
            if isinstance(low, int):
                return declared
            return "array", self.constant(low), self.constant(high), self.kind(of)
        if isinstance(declared, tuple):
            return declared
        if declared not in ELEMENTARY and declared not in self.unit.enums and declared not in self.unit.structs:
            raise StError(f"{declared} is declared nowhere")
        return declared

    def constant(self, expression: Any) -> int:
        """A bound of an array: a number."""
        if expression[0] != "number":
            raise StError(f"{expression} is not a number")
        return int(expression[1])

    def fresh(self, kind: Any) -> Any:
        """The value that a variable begins with."""
        kind = self.kind(kind)
        if isinstance(kind, tuple) and kind[0] == "array":
            numbers = range(kind[1], kind[2] + 1)
            if isinstance(kind[3], tuple) or kind[3] in self.unit.structs:
                return [self.fresh(kind[3]) for _ in numbers]
            return [self.fresh(kind[3])] * len(numbers)
        if kind in self.unit.structs:
            return {name: self.fresh(of) for name, of, _ in self.unit.structs[kind]}
        if kind in self.unit.enums:
            return 0
        return 0.0 if kind in REALS else False if kind == "bool" else 0

    def call(self, name: str, **arguments: Any) -> tuple[Any, ...]:
        """What a function returns, and after it its outputs in the order of their declaration."""
        function = self.unit.functions[name.lower()]
        arguments = {key.lower(): value for key, value in arguments.items()}
        wanted = [variable for role, variable, _, _ in function.variables if role in ("VAR_INPUT", "VAR_IN_OUT")]
        assert sorted(arguments) == sorted(wanted), (name, sorted(arguments), sorted(wanted))
        result = self.scope[f"f_{function.name}"](*(arguments[item] for item in wanted))
        return tuple(result)

    def named(self, name: str, **value: Any) -> dict[str, Any]:
        """The same, by the names of the outputs; what the function returns is under its own name."""
        function = self.unit.functions[name.lower()]
        outputs = [variable for role, variable, _, _ in function.variables if role == "VAR_OUTPUT"]
        return dict(zip((function.name, *outputs), self.call(name, **value), strict=True))

    def number(self, enum: str, member: str) -> int:
        """The number of a member."""
        return self.members[enum.lower(), member.lower()]


class Compiled:
    """One function as Python."""

    def __init__(self, machine: Machine, function: Function) -> None:
        self.machine, self.unit, self.function = machine, machine.unit, function
        self.kinds = {name: machine.kind(kind) for _, name, kind, _ in function.variables}
        self.kinds[function.name] = machine.kind(function.returns)
        self.readable = {
            name for role, name, _, value in function.variables if role == "VAR_INPUT" or value is not None
        }

    def source(self) -> str:
        """The text of a Python function that returns its result and its outputs."""
        variables = self.function.variables
        value = [name for role, name, _, _ in variables if role in ("VAR_INPUT", "VAR_IN_OUT")]
        outputs = [name for role, name, _, _ in variables if role == "VAR_OUTPUT"]
        for role, name, _, initial in variables:
            composite = isinstance(self.kinds[name], tuple) or self.kinds[name] in self.unit.structs
            if initial is not None:
                check_constant(self.unit, name, self.kinds[name], initial)
            elif (role == "VAR_IN_OUT") != (composite and role != "VAR"):
                raise StError(f"{self.function.name}.{name}: {role} {self.kinds[name]}")
        lines = [f"def f_{self.function.name}({', '.join(f'v_{name}' for name in value)}):"]
        own = {name: initial for role, name, _, initial in variables if role == "VAR"}
        for name, initial in {**dict.fromkeys((self.function.name, *outputs)), **own}.items():
            value = self.machine.fresh(self.kinds[name]) if initial is None else initial[1]
            lines.append(f" v_{name} = {value!r}")
        self.given_back = ", ".join(f"v_{name}" for name in (self.function.name, *outputs))
        lines += self._body(self.function.body, 1)
        lines.append(f" return ({self.given_back},)")
        return "\n".join(lines)

    def _fail(self, line: int, text: str) -> StError:
        return StError(f"{self.function.name}, line {line}: {text}")

    def _body(self, body: list[Any], depth: int) -> list[str]:
        lines = [line for statement in body for line in self._statement(statement, depth)]
        return lines or [f"{' ' * depth}pass"]

    def _statement(self, statement: Any, depth: int) -> list[str]:
        pad, line = " " * depth, statement[1]
        if statement[0] == "return":
            return [f"{pad}return ({self.given_back},)"]
        if statement[0] == "assign":
            target, kind = self._target(line, statement[2])
            return [f"{pad}{target} = {self._of(line, statement[3], kind)}"]
        if statement[0] == "if":
            lines = []
            for word, (test, body) in zip(["if", *["elif"] * len(statement[2])], statement[2], strict=False):
                lines += [f"{pad}{word} {self._of(line, test, 'bool')}:", *self._body(body, depth + 1)]
            return [*lines, *([f"{pad}else:", *self._body(statement[3], depth + 1)] if statement[3] else [])]
        if statement[0] == "for":
            _, _, index, first, last, body = statement
            if self.kinds.get(index) != "int":
                raise self._fail(line, f"{index} counts")
            ends = f"{self._of(line, first, 'int')}, {self._of(line, last, 'int')} + 1"
            return [f"{pad}for v_{index} in range({ends}):", *self._body(body, depth + 1)]
        return self._case(statement, depth)

    def _case(self, statement: Any, depth: int) -> list[str]:
        _, line, of, branches, other = statement
        pad = " " * depth
        kind = self._kind(line, of)
        if kind not in NUMBERS and kind not in self.unit.enums:
            raise self._fail(line, f"CASE of {kind}")
        lines = [f"{pad}_case = {self._of(line, of, kind)}"]
        seen: set[int] = set()
        for number, (labels, body) in enumerate(branches):
            tests = []
            for low, high in labels:
                first, last = (int(self._of(line, end, kind)) for end in (low, high))
                if seen & set(range(first, min(last, first + 10_000) + 1)):
                    raise self._fail(line, f"{first} has two branches")
                seen |= set(range(first, min(last, first + 10_000) + 1))
                tests.append(f"{first} <= _case <= {last}")
            lines += [f"{pad}{'elif' if number else 'if'} {' or '.join(tests)}:", *self._body(body, depth + 1)]
        return [*lines, f"{pad}else:", *self._body(other, depth + 1)]

    def _target(self, line: int, target: Any) -> tuple[str, Any]:
        """A place that is assigned to, and its type."""
        root = target
        while root[0] in ("member", "element"):
            root = root[1]
        if root[0] != "name" or root[1] not in self.kinds or root[1] in self.readable:
            raise self._fail(line, f"{target} cannot be assigned to")
        return self._text(line, target), self._kind(line, target)

    def _of(self, line: int, expression: Any, kind: Any) -> str:
        """An expression where a type is expected."""
        if expression[0] == "number":
            return self._literal(line, expression, kind)
        actual = self._kind(line, expression)
        if actual != kind:
            raise self._fail(line, f"{actual} where {kind} is expected: {expression}")
        return self._text(line, expression, kind)

    def _literal(self, line: int, literal: Any, kind: Any) -> str:
        _, value, typed = literal
        if (typed and typed != kind) or kind not in (*WHOLE, *REALS) or (kind in BITS and not typed):
            raise self._fail(line, f"the literal {value} {typed} where {kind} is expected")
        if kind in REALS:
            if not isinstance(value, float):
                raise self._fail(line, f"{value} is not a literal of {kind}")
            return repr(single(value) if kind == "real" else value)
        low, high = bounds(kind)
        if isinstance(value, float) or not low <= value <= high:
            raise self._fail(line, f"{value} is not in {kind}")
        return repr(value)

    def _kind(self, line: int, of: Any) -> Any:
        """The type of an expression; None for a literal that may have several."""
        if of[0] == "number":
            return of[2] or None
        if of[0] in ("truth", "not"):
            return "bool"
        if of[0] == "name":
            if of[1] not in self.kinds:
                raise self._fail(line, f"{of[1]} is declared nowhere")
            return self.kinds[of[1]]
        if of[0] == "member":
            if of[1][0] == "name" and of[1][1] in self.unit.enums and of[1][1] not in self.kinds:
                if (of[1][1], of[2]) not in self.machine.members:
                    raise self._fail(line, f"{of[1][1]} has no {of[2]}")
                return of[1][1]
            value = self._kind(line, of[1])
            result = [kind for name, kind, _ in self.unit.structs.get(value, ()) if name == of[2]]
            if not result:
                raise self._fail(line, f"{value} has no {of[2]}")
            return self.machine.kind(result[0])
        if of[0] == "element":
            value = self._kind(line, of[1])
            if not isinstance(value, tuple) or value[0] != "array":
                raise self._fail(line, f"{value} has no elements")
            return value[3]
        if of[0] == "call":
            return self._call_kind(line, of)
        _, operator, left, right = of
        if operator in ("=", "<>", "<", ">", "<=", ">="):
            return "bool"
        return self._kind(line, left) or self._kind(line, right)

    def _call_kind(self, line: int, of: Any) -> Any:
        if of[1] in self.unit.functions:
            return self.machine.kind(self.unit.functions[of[1]].returns)
        if of[1] in ("shl", "shr"):
            return self._kind(line, of[2][0][2])
        if of[1] == "sizeof":
            return "udint"
        return of[1].partition("_to_")[2]

    def _text(self, line: int, of: Any, kind: Any = None) -> str:
        if of[0] == "truth":
            return repr(of[1])
        if of[0] == "not":
            return f"(not {self._of(line, of[1], 'bool')})"
        if of[0] == "name":
            return f"v_{of[1]}"
        if of[0] == "member":
            if of[1][0] == "name" and of[1][1] in self.unit.enums and of[1][1] not in self.kinds:
                return repr(self.machine.members[of[1][1], of[2]])
            return f"{self._text(line, of[1])}[{of[2]!r}]"
        if of[0] == "element":
            _, low, high, _ = self._kind(line, of[1])
            index = self._of(line, of[2], "int")
            return f"{self._text(line, of[1])}[_at({index}, {low}, {high})]"
        if of[0] == "call":
            return self._call(line, of)
        return self._binary(line, of, kind)

    def _binary(self, line: int, of: Any, kind: Any) -> str:
        _, operator, left, right = of
        value = self._kind(line, left) or self._kind(line, right) or kind
        texts = self._of(line, left, value), self._of(line, right, value)
        if operator in ("=", "<>", "<", ">", "<=", ">="):
            ordered = operator not in ("=", "<>")
            if (value not in ELEMENTARY and (ordered or value not in self.unit.enums)) or (ordered and value in BITS):
                raise self._fail(line, f"{value} {operator} {value}")
            return f"({texts[0]} {({'=': '==', '<>': '!='}).get(operator, operator)} {texts[1]})"
        if operator in ("AND", "OR", "XOR"):
            # Both sides are always worked out: the language does not promise to stop at the first.
            if value == "bool":
                return f"({texts[0]} {SYMBOLS[operator]} {texts[1]})"
            if value not in BITS:
                raise self._fail(line, f"{value} {operator} {value}")
            return f"({texts[0]} {SYMBOLS[operator]} {texts[1]})"
        if value in REALS and operator != "MOD":
            text = f"({texts[0]} {operator} {texts[1]})"
            return f"_single{text}" if value == "real" else text
        if value not in NUMBERS:
            raise self._fail(line, f"{value} {operator} {value}")
        if operator == "MOD":
            return f"_rem({texts[0]}, {texts[1]})"
        text = f"_div({texts[0]}, {texts[1]})" if operator == "/" else f"{texts[0]} {operator} {texts[1]}"
        return f"_wrapped_{value}({text})"

    def _call(self, line: int, of: Any) -> str:
        _, name, arguments = of
        if name in self.unit.functions:
            return self._function_call(line, name, arguments)
        if name in ("shl", "shr"):
            (_, _, value), (_, _, count) = arguments
            kind = self._kind(line, value)
            if kind not in BITS or count[0] != "number" or not 0 < count[1] < 8 * SIZES[kind]:
                raise self._fail(line, f"{name} of {kind} by {count}")
            text = self._of(line, value, kind)
            return f"({text} >> {count[1]})" if name == "shr" else f"(({text} << {count[1]}) & {bounds(kind)[1]})"
        if name == "sizeof":
            return repr(size_of(self.unit, self._kind(line, arguments[0][2]))[0])
        source, _, target = name.partition("_to_")
        if source not in ELEMENTARY or target not in ELEMENTARY or source == target or len(arguments) != 1:
            raise self._fail(line, f"{name} is not a function")
        self.machine.scope[f"_{name}"] = conversion(source, target, self.machine.rounding)
        return f"_{name}({self._of(line, arguments[0][2], source)})"

    def _function_call(self, line: int, name: str, value: list[Any]) -> str:
        """A call; what it returns is its first value, the others go to the places that are given for the outputs."""
        if self.unit.order.index(name) >= self.unit.order.index(self.function.name):
            raise self._fail(line, f"{name} is declared after its use")
        called = self.unit.functions[name]
        ways = {"VAR_INPUT": ":=", "VAR_IN_OUT": ":=", "VAR_OUTPUT": "=>"}
        wanted = {variable: (ways[role], role, kind) for role, variable, kind, _ in called.variables if role in ways}
        if sorted(variable for _, variable, _ in value) != sorted(wanted):
            raise self._fail(line, f"{name} wants {sorted(wanted)}")
        texts: dict[str, str] = {}
        for way, variable, expression in value:
            wanted_way, role, declared = wanted[variable]
            kind = self.machine.kind(declared)
            if way != wanted_way:
                raise self._fail(line, f"{name}: {variable} {way}")
            if role == "VAR_INPUT":
                texts[variable] = self._of(line, expression, kind)
            else:
                texts[variable], lent_value = self._lent(line, expression, role)
                if lent_value != kind:
                    raise self._fail(line, f"{name}: {variable} is {kind}, not {lent_value}")
        inputs = ", ".join(texts[item] for item, (_, role, _) in wanted.items() if role != "VAR_OUTPUT")
        outputs = [texts[item] for item, (_, role, _) in wanted.items() if role == "VAR_OUTPUT"]
        if not outputs:
            return f"f_{name}({inputs})[0]"
        setters = ", ".join(_setter(place, at) for at, place in enumerate(outputs, 1))
        return f"(_r := f_{name}({inputs}), {setters}, _r[0])[-1]"

    def _lent(self, line: int, expression: Any, role: str) -> tuple[str, Any]:
        root = expression
        while root[0] in ("member", "element"):
            root = root[1]
        if root[0] != "name" or root[1] not in self.kinds or (root[1] in self.readable and role == "VAR_OUTPUT"):
            raise self._fail(line, f"{expression} cannot be changed")
        return self._text(line, expression), self._kind(line, expression)


def _setter(place: str, at: int) -> str:
    """An expression that puts an output into a variable, an element or a member."""
    if place.isidentifier():
        return f"{place} := _r[{at}]"
    holder, _, key = place[:-1].rpartition("[") if place.endswith("']") else place[:-1].partition("[_at")
    if place.endswith("']"):
        return f"{holder}.__setitem__({key}, _r[{at}])"
    return f"{holder}.__setitem__(_at{key}, _r[{at}])"
