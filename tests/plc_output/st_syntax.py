"""A small parser of Structured Text, as far as the outputs use it: written for the tests, apart from the printer."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from standard_text import anonymous

TOKEN = re.compile(
    r"""(?P<space>\s+|//[^\n]*|\(\*.*?\*\))
    |(?P<pragma>\{[^}]*\})
    |(?P<text>'(?:\$.|[^'$])*')
    |(?P<wide>"(?:\$.|[^"$])*")
    |(?P<typed>[A-Za-z]+\#(?:16\#[0-9A-Fa-f_]+|-?[0-9]+(?:\.[0-9]+(?:[Ee][+-]?[0-9]+)?)?))
    |(?P<hex>16\#[0-9A-Fa-f_]+)
    |(?P<real>[0-9]+\.[0-9]+(?:[Ee][+-]?[0-9]+)?)
    |(?P<int>[0-9][0-9_]*)
    |(?P<name>[A-Za-z_][A-Za-z0-9_]*)
    |(?P<mark>:=|=>|<>|<=|>=|\.\.|[-+*/=<>()\[\],;:.])""",
    re.VERBOSE | re.DOTALL,
)


class StError(Exception):
    """Text that is not Structured Text of the subset, or that means nothing."""


class Token(NamedTuple):
    """A word, a number, a text or a mark. `word` is that of a name or a mark in upper case."""

    kind: str
    text: str
    line: int
    word: str = ""


@dataclass
class Function:
    """A function: its variables as (role, name, type, initial value), and its statements as tuples."""

    name: str
    returns: Any
    variables: list[tuple[str, str, Any, Any]]
    body: list[Any]


@dataclass
class Unit:
    """What a text declares. Types: enums as (base, members), structs as lists of (name, type, initial value)."""

    enums: dict[str, tuple[str, dict[str, Any]]] = field(default_factory=dict)
    structs: dict[str, list[tuple[str, Any, Any]]] = field(default_factory=dict)
    globals: list[tuple[str, Any, Any]] = field(default_factory=list)
    functions: dict[str, Function] = field(default_factory=dict)
    pragmas: dict[str, list[str]] = field(default_factory=dict)
    order: list[str] = field(default_factory=list)
    blocks: list[str] = field(default_factory=list)


def tokens(text: str) -> list[Token]:
    """The tokens of a text, without blanks and comments."""
    tokens, at, line = [], 0, 1
    while at < len(text):
        match = TOKEN.match(text, at)
        if match is None:
            raise StError(f"line {line}: {text[at : at + 30]!r}")
        kind, token = match.lastgroup, match[0]
        assert kind
        if kind in ("name", "mark"):
            tokens.append(Token(kind, token, line, token.upper()))
        elif kind != "space":
            tokens.append(Token(kind, token, line))
        line += token.count("\n")
        at = match.end()
    return [*tokens, Token("end", "", line)]


class Parser:
    """Reads declarations, statements and expressions by recursive descent."""

    def __init__(self, text: str) -> None:
        self.found, self.at = tokens(text), 0

    @property
    def token(self) -> Token:
        """The token that is next."""
        return self.found[self.at]

    @property
    def word(self) -> str:
        """The word that is next, in upper case."""
        return self.found[self.at].word

    def take(self, *wanted: str) -> Token:
        """The next token, which must be one of some words or marks, or of some kind."""
        token = self.found[self.at]
        if wanted and token.word not in wanted and token.kind not in wanted:
            raise StError(f"line {token.line}: {token.text!r} instead of {' or '.join(wanted)}")
        self.at += 1
        return token

    def taken(self, *wanted: str) -> bool:
        """Whether the next token is one of some words or marks; if so it is passed over."""
        if self.found[self.at].word in wanted:
            self.at += 1
            return True
        return False

    def name(self) -> str:
        """The name that is next, in lower case: names have no case."""
        return self.take("name").text.lower()

    def unit(self) -> Unit:
        """The whole text."""
        unit, pragmas = Unit(), []
        while self.token.kind != "end":
            if self.token.kind == "pragma":
                pragmas.append(self.take().text)
                continue
            word = self.take("TYPE", "VAR_GLOBAL", "FUNCTION", "FUNCTION_BLOCK").text.upper()
            if word == "FUNCTION_BLOCK":
                # Blocks have timers, which the machine has not: they are compiled and run by others.
                unit.blocks.append(self.name())
                while not self.taken("END_FUNCTION_BLOCK"):
                    self.take()
                pragmas = []
                continue
            declare: dict[str, Callable[[Unit], str]] = {
                "TYPE": self._type,
                "VAR_GLOBAL": self._globals,
                "FUNCTION": self._function,
            }
            name = declare[word](unit)
            unit.pragmas[name] = pragmas
            unit.order.append(name)
            pragmas = []
        return unit

    def _once(self, unit: Unit, name: str) -> str:
        if name in unit.enums or name in unit.structs or name in unit.functions:
            raise StError(f"{name} is declared twice")
        return name

    def _type(self, unit: Unit) -> str:
        name = self._once(unit, self.name())
        self.take(":")
        if self.taken("STRUCT"):
            unit.structs[name] = self._variables("END_STRUCT")
            self.take(";")
        else:
            self.take("(")
            members: dict[str, Any] = {}
            while True:
                member = self.name()
                if member in members:
                    raise StError(f"{name}.{member} is there twice")
                self.take(":=")
                members[member] = self.expression()
                if not self.taken(","):
                    break
            self.take(")")
            base = self.name() if self.token.kind == "name" else "int"
            unit.enums[name] = (base, members)
            self.take(";")
        self.take("END_TYPE")
        return name

    def _globals(self, unit: Unit) -> str:
        self.take("CONSTANT")
        unit.globals += self._variables("END_VAR")
        return f"globals {len(unit.order)}"

    def _variables(self, end: str) -> list[tuple[str, Any, Any]]:
        result: list[tuple[str, Any, Any]] = []
        while not self.taken(end):
            while self.token.kind == "pragma":
                self.take()
            name = self.name()
            if any(other == name for other, _, _ in result):
                raise StError(f"line {self.token.line}: {name} is declared twice")
            self.take(":")
            kind = self.type()
            initial = self.initial() if self.taken(":=") else None
            self.take(";")
            result.append((name, kind, initial))
        return result

    def type(self) -> Any:
        """A type: a name, or ("array", low, high, type)."""
        if self.taken("ARRAY"):
            self.take("[")
            low = self.expression()
            self.take("..")
            high = self.expression()
            self.take("]")
            self.take("OF")
            return "array", low, high, self.type()
        name = self.name()
        if name in ("string", "wstring") and self.taken("(", "["):
            size = self.expression()
            self.take(")", "]")
            return name, size
        return name

    def initial(self) -> Any:
        """An initial value: an expression, ("list", [...]) or ("fields", {...})."""
        if self.taken("["):
            items = []
            while not self.taken("]"):
                items.append(self.initial())
                self.taken(",")
            return "list", items
        if self.word == "(" and self.found[self.at + 2].text == ":=":
            self.take("(")
            fields = {}
            while not self.taken(")"):
                name = self.name()
                self.take(":=")
                fields[name] = self.initial()
                self.taken(",")
            return "fields", fields
        return self.expression()

    def _function(self, unit: Unit) -> str:
        name = self._once(unit, self.name())
        self.take(":")
        returns = self.type()
        variables: list[tuple[str, str, Any, Any]] = []
        while self.word in ("VAR_INPUT", "VAR_IN_OUT", "VAR_OUTPUT", "VAR"):
            role, constant = self.take().text.upper(), self.taken("CONSTANT")
            section = self._variables("END_VAR")
            if any((initial is not None) != constant for _, _, initial in section):
                raise StError(f"{name}: what has a value at first is a constant, and nothing else")
            variables += [(role, *variable) for variable in section]
        names = [text for _, text, _, _ in variables]
        if len(set(names)) < len(names) or name in names:
            raise StError(f"{name} declares a variable twice")
        unit.functions[name] = Function(name, returns, variables, self.statements("END_FUNCTION"))
        self.take("END_FUNCTION")
        return name

    def statements(self, *ends: str) -> list[Any]:
        """Statements up to one of some words."""
        result = []
        while self.word not in ends:
            result.append(self._statement())
        return result

    def _statement(self) -> Any:
        line = self.token.line
        if self.taken("RETURN"):
            self.take(";")
            return "return", line
        if self.taken("IF"):
            branches, other = [(self._test(), self.statements("ELSIF", "ELSE", "END_IF"))], []
            while self.taken("ELSIF"):
                branches.append((self._test(), self.statements("ELSIF", "ELSE", "END_IF")))
            if self.taken("ELSE"):
                other = self.statements("END_IF")
            self.take("END_IF")
            self.take(";")
            return "if", line, branches, other
        if self.taken("FOR"):
            index = self.name()
            self.take(":=")
            first = self.expression()
            self.take("TO")
            last = self.expression()
            self.take("DO")
            body = self.statements("END_FOR")
            self.take("END_FOR")
            self.take(";")
            return "for", line, index, first, last, body
        if self.taken("CASE"):
            return self._case(line)
        target = self._postfix()
        self.take(":=")
        value = self.expression()
        self.take(";")
        return "assign", line, target, value

    def _test(self) -> Any:
        test = self.expression()
        self.take("THEN")
        return test

    def _case(self, line: int) -> Any:
        of = self.expression()
        self.take("OF")
        branches, other = [], []
        while self.word not in ("ELSE", "END_CASE"):
            labels = [self._label()]
            while self.taken(","):
                labels.append(self._label())
            self.take(":")
            branches.append((labels, self._branch()))
        if self.taken("ELSE"):
            other = self.statements("END_CASE")
        self.take("END_CASE")
        self.take(";")
        return "case", line, of, branches, other

    def _label(self) -> Any:
        low = self._sign()
        return (low, self._sign()) if self.taken("..") else (low, low)

    def _branch(self) -> list[Any]:
        """Statements up to the next label: that is a number, or a member of an enum before a colon or a comma."""
        result = []
        while self.word not in ("ELSE", "END_CASE") and self.token.kind != "int" and self.word != "-":
            ahead = [self.found[self.at + n].text for n in range(4)]
            if ahead[1] == "." and ahead[3] in (":", ","):
                break
            result.append(self._statement())
        return result

    def expression(self, level: int = 0) -> Any:
        """An expression, by the precedence of its operators."""
        levels = (("OR",), ("XOR",), ("AND",), ("=", "<>"), ("<", ">", "<=", ">="), ("+", "-"), ("*", "/", "MOD"))
        if level == len(levels):
            return self._sign()
        left = self.expression(level + 1)
        while self.word in levels[level]:
            operator = self.take().text.upper()
            left = ("binary", operator, left, self.expression(level + 1))
        return left

    def _sign(self) -> Any:
        if self.taken("-"):
            kind, value, name = self._sign()
            assert kind == "number"
            return kind, -value, name
        if self.taken("NOT"):
            return "not", self._sign()
        return self._postfix()

    def _postfix(self) -> Any:
        primary = self._primary()
        while self.word in (".", "["):
            if self.taken("."):
                primary = ("member", primary, self.name())
            else:
                self.take("[")
                primary = ("element", primary, self.expression())
                self.take("]")
        return primary

    def _primary(self) -> Any:
        token = self.take()
        if token.kind in ("int", "hex", "real", "typed"):
            kind, _, digits = token.text.rpartition("#") if token.kind == "typed" else ("", "", token.text)
            if token.kind == "hex" or kind.upper().endswith("#16"):
                return "number", int(token.text.rpartition("#")[2].replace("_", ""), 16), kind[:-3].lower()
            value = float(digits) if "." in digits else int(digits.replace("_", ""))
            return "number", value, kind.lower()
        if token.kind in ("text", "wide"):
            return "string", token.text, token.kind
        if token.text == "(":
            inner = self.expression()
            self.take(")")
            return inner
        if token.text.upper() in ("TRUE", "FALSE"):
            return "truth", token.text.upper() == "TRUE"
        if token.kind != "name":
            raise StError(f"line {token.line}: {token.text!r} is not an expression")
        if self.word != "(":
            return "name", token.text.lower()
        self.take("(")
        arguments = []
        while not self.taken(")"):
            way = self.found[self.at + 1].text
            if way in (":=", "=>"):
                name = self.name()
                self.take(way)
                arguments.append((way, name, self.expression()))
            else:
                arguments.append(("", "", self.expression()))
            self.taken(",")
        return "call", token.text.lower(), arguments


def parsed(text: str) -> Unit:
    """What a text declares."""
    return Parser(anonymous(text)).unit()
