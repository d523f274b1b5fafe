"""The forms of Structured Text that a text consists of, each once, so that slow parsers judge every form.

A parser of a grammar without a memory takes a list of statements if it takes each of them, and it sees names and
numbers by their kind only. So a statement, a member or a variable that differs from an earlier one only in names and
numbers says nothing new, and is left out. What stays is text as it was generated.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from st_syntax import tokens

KEYWORDS = frozenset(
    re.findall(
        "[a-z_]+",
        """
        type end_type struct end_struct var_global constant var_input var_output var_in_out var end_var function
        end_function array of if then elsif else end_if for to do end_for case end_case return and or xor not mod true
        false string wstring bool byte word dword lword sint int dint lint usint uint udint ulint real lreal
        """,
    )
)
INNER = re.compile(r"\s|END_IF|END_FOR|END_CASE|ELSIF|ELSE")


def shape(lines: Iterable[str]) -> tuple[str, ...]:
    """The kinds of the tokens: words of the language and marks as they are, names and numbers as such."""
    result = []
    for token in tokens("\n".join(lines)):
        if token.kind == "name":
            result.append(token.text.lower() if token.text.lower() in KEYWORDS else "name")
        elif token.kind == "typed":
            result.append(
                re.sub(r"[0-9A-F]+$", "0", token.text.split("#", 1)[0] + "#" + ("16#" if "#16#" in token.text else ""))
            )
        elif token.kind == "mark":
            result.append(token.text)
        else:
            result.append(token.kind)
    return tuple(result)


def statements(lines: Iterable[str]) -> Iterator[list[str]]:
    """The lines of each statement of a function."""
    value: list[str] = []
    for line in lines:
        if value and not INNER.match(line):
            yield value
            value = []
        value.append(line)
    if value:
        yield value


class Shapes:
    """Forms that were seen already."""

    def __init__(self) -> None:
        self._seen: set[tuple[str, ...]] = set()

    def new(self, lines: list[str]) -> bool:
        """Whether these lines have another form than all before them."""
        actual = shape(lines)
        fresh = actual not in self._seen
        self._seen.add(actual)
        return fresh

    def statements(self, implementation: Iterable[str]) -> Iterator[list[str]]:
        """The statements of a new form. Within one, lines of one form that follow each other are one line."""
        for some in statements(implementation):
            remaining: list[str] = []
            for line in some:
                whole = line.endswith(";") and "END_" not in line and remaining and remaining[-1].endswith(";")
                if not (whole and shape([line]) == shape([remaining[-1]])):
                    remaining.append(line)
            if self.new(remaining):
                yield remaining

    def head(self, declaration: Iterable[str]) -> list[str]:
        """The declaration of a function with the variables of a new form; nothing where nothing is new."""
        remaining: list[str] = []
        section = ""
        fresh = False
        for line in declaration:
            if line.startswith("VAR"):
                section = line
            new = self.new([section, line]) if line.startswith("    ") else False
            fresh |= new
            if new or not line.startswith("    "):
                remaining.append(line)
        return remaining if self.new([line for line in remaining if not line.startswith("    ")]) or fresh else []

    def new_lines(self, lines: Iterable[str]) -> list[str]:
        """A type or a list of constants without further members of a form that it has already."""
        inside: set[tuple[str, ...]] = set()
        remaining: list[str] = []
        for line in lines:
            form = shape([line])
            if line.startswith("    ") and form in inside:
                continue
            inside = {form} if line.endswith("[") else inside | {form}
            remaining.append(line)
        return remaining if self.new(remaining) else []
