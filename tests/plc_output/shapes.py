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
    found = []
    for token in tokens("\n".join(lines)):
        if token.kind == "name":
            found.append(token.text.lower() if token.text.lower() in KEYWORDS else "name")
        elif token.kind == "typed":
            found.append(
                re.sub(r"[0-9A-F]+$", "0", token.text.split("#", 1)[0] + "#" + ("16#" if "#16#" in token.text else ""))
            )
        elif token.kind == "mark":
            found.append(token.text)
        else:
            found.append(token.kind)
    return tuple(found)


def statements(lines: Iterable[str]) -> Iterator[list[str]]:
    """The lines of each statement of a function."""
    held: list[str] = []
    for line in lines:
        if held and not INNER.match(line):
            yield held
            held = []
        held.append(line)
    if held:
        yield held


class Shapes:
    """Forms that were seen already."""

    def __init__(self) -> None:
        self._seen: set[tuple[str, ...]] = set()

    def new(self, lines: list[str]) -> bool:
        """Whether these lines have another form than all before them."""
        found = shape(lines)
        fresh = found not in self._seen
        self._seen.add(found)
        return fresh

    def statements(self, implementation: Iterable[str]) -> Iterator[list[str]]:
        """The statements of a new form. Within one, lines of one form that follow each other are one line."""
        for some in statements(implementation):
            kept: list[str] = []
            for line in some:
                whole = line.endswith(";") and "END_" not in line and kept and kept[-1].endswith(";")
                if not (whole and shape([line]) == shape([kept[-1]])):
                    kept.append(line)
            if self.new(kept):
                yield kept

    def head(self, declaration: Iterable[str]) -> list[str]:
        """The declaration of a function with the variables of a new form; nothing where nothing is new."""
        kept: list[str] = []
        section = ""
        fresh = False
        for line in declaration:
            if line.startswith("VAR"):
                section = line
            new = self.new([section, line]) if line.startswith("    ") else False
            fresh |= new
            if new or not line.startswith("    "):
                kept.append(line)
        return kept if self.new([line for line in kept if not line.startswith("    ")]) or fresh else []

    def listed(self, lines: Iterable[str]) -> list[str]:
        """A type or a list of constants without further members of a form that it has already."""
        inside: set[tuple[str, ...]] = set()
        kept: list[str] = []
        for line in lines:
            form = shape([line])
            if line.startswith("    ") and form in inside:
                continue
            inside = {form} if line.endswith("[") else inside | {form}
            kept.append(line)
        return kept if self.new(kept) else []
