"""Programs of the documentation, run scan by scan by the machine that runs functions.

A program keeps its variables; a function does not. So the variables become the members of a struct that a function
is lent, and what the program does becomes the function's statements. Only the counters of loops stay variables,
because they must. Function blocks of vendors are structs of their inputs and outputs: a call sets the inputs, and
whoever runs the scans plays the block between two of them.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

from st_machine import Machine
from st_syntax import StError, Token, parsed, tokens

STRUCT, FUNCTION, VARIABLE = "ST_Scan", "F_Scan", "stScan"


def of_siemens(text: str) -> str:
    """SCL as Structured Text: without the marks of names, and without the lines that only Siemens has."""
    text = re.sub(r'(?<!\w)#(?=[A-Za-z_])|"', "", text)
    text = re.sub(r"^\s*(BEGIN|VERSION : .*|\{ S7_.*)$", "", text, flags=re.MULTILINE)
    return re.sub(r"^(TYPE \w+)$", r"\1 :", text, flags=re.MULTILINE)


def constants(generated: str) -> dict[str, str]:
    """The constants of generated Structured Text as typed literals, by the name of their list and their own."""
    result = {}
    for name, body in re.findall(
        r"^// (GVL_\w+)\n(?:(?!END_VAR).)*?VAR_GLOBAL CONSTANT\n(.*?)END_VAR", generated, re.M | re.S
    ):
        for constant, kind, value in re.findall(r"^    (\w+) : (\w+) := ([\w#.-]+);", body, re.MULTILINE):
            whole = kind.endswith("INT")
            result[f"{name}.{constant}".lower()] = str(_value(value)) if whole else f"{kind}#{value}"
    return result


class Scans:
    """A program with its variables. `blocks` are the inputs and outputs of vendors' function blocks, as declarations.

    `given` are functions of vendors whose calls are passed over: what they return and give is set between two scans.
    """

    def __init__(
        self, generated: str, program: str, blocks: Mapping[str, str] | None = None, value: Sequence[str] = ()
    ) -> None:
        known = constants(generated)
        program = re.sub(r"\bGVL_\w+\.\w+", lambda match: known.get(match.group().lower(), match.group()), program)
        variable_text = [token for token in tokens(re.sub(r"T#[0-9A-Za-z_]+", "0", program)) if token.kind != "pragma"]
        self._inputs = {name.lower().replace(".", "_"): text.lower() for name, text in (blocks or {}).items()}
        self._blocks = {name.lower(): name.replace(".", "_") for name in blocks or {}}
        self._given = {name.lower() for name in value}
        declared, body = self._split(variable_text)
        counters = {after.text for before, after in pairwise(body) if before.text.upper() == "FOR"}
        local = " ".join(f"{name} : {declared.pop(name)[0]};" for name in sorted(counters))
        self._declared = declared
        stubs = "".join(
            f"TYPE {name.replace('.', '_')} : STRUCT {text} END_STRUCT; END_TYPE\n"
            for name, text in (blocks or {}).items()
        )
        members = " ".join(f"{name} : {kind};" for name, (kind, _) in declared.items())
        self.source = (
            f"{stubs}TYPE {STRUCT} : STRUCT {members} END_STRUCT; END_TYPE\n{generated}\n"
            f"FUNCTION {FUNCTION} : BOOL VAR_IN_OUT {VARIABLE} : {STRUCT}; END_VAR VAR {local} END_VAR\n"
            f"{self._rewritten(body)} END_FUNCTION\n"
        )
        self.machine = Machine(parsed(self.source))
        self.variables: dict[str, Any] = self.machine.fresh(STRUCT.lower())
        for name, (_, initial) in declared.items():
            if initial:
                self.variables[name.lower()] = _value(initial)

    def scan(self) -> None:
        """Runs the program once."""
        self.machine.call(FUNCTION, **{VARIABLE: self.variables})

    def _split(self, tokens: list[Token]) -> tuple[dict[str, tuple[str, str]], list[Token]]:
        """The variables with their types and initial values, and the statements."""
        if tokens[0].text.upper() not in ("PROGRAM", "FUNCTION_BLOCK"):
            raise StError(f"{tokens[0].text} is no program")
        at, declared = 2, {}
        while tokens[at].text.upper() in ("VAR", "VAR_INPUT", "VAR_OUTPUT", "VAR_TEMP"):
            at += 1
            while tokens[at].text.upper() != "END_VAR":
                end = next(n for n in range(at, len(tokens)) if tokens[n].text == ";")
                mark = next((n for n in range(at, end) if tokens[n].text == ":="), end)
                kind = " ".join(token.text for token in tokens[at + 2 : mark])
                text = kind.replace(" ", "").lower()
                declared[tokens[at].text] = (
                    self._blocks.get(text, kind),
                    " ".join(token.text for token in tokens[mark + 1 : end]),
                )
                at = end + 1
            at += 1
        last = next(n for n in range(len(tokens)) if tokens[n].text.upper() in ("END_PROGRAM", "END_FUNCTION_BLOCK"))
        return declared, tokens[at:last]

    def _rewritten(self, body: list[Token]) -> str:
        out: list[str] = []
        at = 0
        names = {name.lower(): kind for name, (kind, _) in self._declared.items()}
        while at < len(body):
            end = _statement_end(body, at)
            words = body[at:end]
            kind = names.get(words[0].text.lower(), "") if words else ""
            if kind in self._blocks.values() and len(words) > 1 and words[1].text == "(":
                out.append(self._block_call(words, names))
                at = end + 1
                continue
            if any(token.text.lower() in self._given for token in words):
                call = next(n for n, token in enumerate(words) if token.text.lower() in self._given)
                head = words[
                    : max((n for n in range(call) if words[n].text in (";", "THEN", ":", "ELSE")), default=-1) + 1
                ]
                out.append(self._named(head, names))
                at = end + 1
                continue
            out.append(self._named(body[at : end + 1], names))
            at = end + 1
        return " ".join(out)

    def _block_call(self, words: list[Token], names: Mapping[str, str]) -> str:
        """The inputs of a block, one assignment each; buffers and addresses are left to whoever plays the block."""
        result = []
        inputs = self._inputs[names[words[0].text.lower()].lower()]
        for value in _arguments(words[2:-1]):
            if not re.search(rf"\b{value[0].text.lower()} :", inputs):
                continue
            result.append(f"{VARIABLE}.{words[0].text}.{value[0].text} := {self._named(value[2:], names)};")
        return " ".join(result)

    def _named(self, words: Sequence[Token], names: Mapping[str, str]) -> str:
        """Tokens as text, with the program's variables as members of its struct."""
        out, depth = [], 0
        for at, token in enumerate(words):
            before = words[at - 1].text if at else ""
            after = words[at + 1].text if at + 1 < len(words) else ""
            depth += (token.text == "(") - (token.text == ")")
            parameter = depth > 0 and after in (":=", "=>") and before in ("(", ",")
            ours = token.kind == "name" and token.text.lower() in names and before != "." and not parameter
            out.append(f"{VARIABLE}.{token.text}" if ours else token.text)
        return " ".join(out)


def _statement_end(body: list[Token], at: int) -> int:
    """Where the statement that begins somewhere has its semicolon, or the words before one end."""
    for place in range(at, len(body)):
        if body[place].text == ";" or body[place].text.upper() in ("THEN", "ELSE", "OF"):
            return place
        if body[place].text == ":" and _is_label(body, place):
            return place
    return len(body)


def _is_label(body: list[Token], colon: int) -> bool:
    return body[colon - 1].kind in ("int", "name")


def _arguments(words: Sequence[Token]) -> list[list[Token]]:
    """What stands between the parentheses of a call, without the commas."""
    tokens: list[list[Token]] = [[]]
    depth = 0
    for token in words:
        depth += (token.text in "([") - (token.text in ")]")
        if token.text == "," and depth == 0:
            tokens.append([])
        else:
            tokens[-1].append(token)
    return [item for item in tokens if item]


def _value(text: str) -> Any:
    if text.upper() in ("TRUE", "FALSE"):
        return text.upper() == "TRUE"
    return int(text.split("#")[-1], 16 if "16#" in text else 10)
