"""The syntax of Structured Text with slots, before anything is known of a device.

The generator fills the slots in braces: `{name}` is a slot, `{Action(argument)}` writes an action in its place.
"""

from __future__ import annotations

import re

from fieldspec.targets.controllers.sources.nodes import (
    Action,
    Applied,
    Argument,
    Assigned,
    Block,
    Chosen,
    Commented,
    Entry,
    File,
    Headed,
    Indexed,
    Insertion,
    Inverted,
    Iteration,
    Joined,
    Literal,
    Named,
    Section,
    Selected,
    Source,
    Step,
    Term,
    Timed,
    Token,
    wrong,
)

_TOKEN = re.compile(
    r"(?P<comment>//[^\n]*)|(?P<space>\s+)|(?P<time>T#\w+)|(?P<number>(?:[A-Z]+#)?(?:16#[0-9A-F_]+|\d+))"
    r"|(?P<word>[A-Za-z_]\w*)|(?P<mark>:=|=>|<>|<=|>=|[-+*/=<>()\[\]{},;:.])"
)
_ROLES = {"VAR_INPUT": "input", "VAR_IN_OUT": "in_out", "VAR_OUTPUT": "output", "VAR": "local"}
_ENDS = frozenset({"ELSIF", "ELSE", "END_IF", "END_FOR", "END_REGION", "END_ACTION", "END_FUNCTION_BLOCK"})
_LEVELS = (("OR",), ("AND",), ("=", "<>"), ("<", ">", "<=", ">="), ("+", "-"), ("*", "/", "MOD"))
_CHAINED = ("AND", "OR", "+")


class _Parser:
    def __init__(self, name: str, text: str) -> None:
        file = File(name, tuple(text.splitlines()))
        self.source = Source()
        self.tokens: list[Token] = []
        self.next = 0
        line, begin, index = 1, 0, 0
        while index < len(text):
            match = _TOKEN.match(text, index)
            if match is None:
                token = Token("mark", text[index], line, index - begin + 1, file)
                raise wrong(token, f"{text[index]!r} is nothing of Structured Text")
            kind, word = match.lastgroup or "", match.group()
            if kind != "space":
                self.tokens.append(Token(kind, word, line, index - begin + 1, file))
            if "\n" in word:
                line, begin = line + word.count("\n"), index + word.rindex("\n") + 1
            index = match.end()
        self.tokens.append(Token("end", "", line, 1, file))

    @property
    def here(self) -> Token:
        while self.tokens[self.next].kind == "comment":
            self.next += 1
        return self.tokens[self.next]

    def take(self, text: str = "", kind: str = "") -> Token:
        token = self.here
        if (text and token.text != text) or (kind and token.kind != kind):
            raise wrong(token, f"expected {text or kind}, not {token.text or 'the end'}")
        self.next += 1
        return token

    def taken(self, text: str) -> bool:
        if self.here.text != text:
            return False
        self.next += 1
        return True

    def remark(self) -> str:
        token = self.tokens[self.next]
        if token.kind != "comment":
            return ""
        self.next += 1
        return token.text[2:].strip()

    def comments(self) -> str:
        """The comments at this place, line by line; empty if an empty line follows the last comment."""
        texts: list[str] = []
        while self.tokens[self.next].kind == "comment":
            line = self.tokens[self.next].line
            texts.append(self.remark())
            if self.tokens[self.next].line > line + 1:
                texts.clear()
        return " ".join(texts)

    def file(self) -> Source:
        source = self.source
        begin = self.take("FUNCTION_BLOCK")
        if self.taken("EXTENDS"):
            source.extends = self.take(kind="word").text
        paragraphs: list[str] = []
        while self.tokens[self.next].kind == "comment":
            paragraphs.append(self.remark())
        source.remarks = tuple(" ".join(part.split()) for part in "\n".join(paragraphs).split("\n\n"))
        sections = source.sections
        while True:
            comment = self.comments()
            if not self.here.text.startswith(("VAR", "ACTION", "PROPERTY")):
                break
            if self.here.text.startswith("VAR"):
                sections.append(self.section())
                continue
            sections = source.late
            if self.taken("PROPERTY"):
                name = self.take(kind="word").text
                self.take(":=")
                source.properties[name] = self.term()
                self.take(";")
            else:
                self.action(comment)
        source.body = self.block(begin, "END_FUNCTION_BLOCK")
        self.take("END_FUNCTION_BLOCK")
        self.take(kind="end")
        return source

    def section(self) -> Section:
        word = self.take()
        role = "constant" if self.taken("CONSTANT") else _ROLES.get(word.text, "")
        if not role:
            raise wrong(word, f"{word.text} is not a section: there is {', '.join(_ROLES)}")
        condition: Term | None = None
        entries: list[Entry] = []
        while not self.taken("END_VAR"):
            token = self.here
            if token.text == "{":
                slot = self.slot()
                if not entries and condition is None and self.here.text != ";":
                    condition = slot
                    continue
                entries.append(Entry(slot.token, slot))
                self.take(";")
                continue
            name = Named(self.take(kind="word"))
            self.take(":")
            kind = self.slot() if self.here.text == "{" else Named(self.take(kind="word"))
            initial = self.take() if self.taken(":=") else None
            self.take(";")
            entries.append(Entry(token, name, kind, initial, self.remark()))
        return Section(role, condition, tuple(entries))

    def action(self, comment: str) -> None:
        begin = self.take("ACTION")
        name, parameter = self.take(kind="word"), ""
        if self.taken("("):
            parameter = self.take(kind="word").text
            self.take(")")
        self.source.actions[name.text] = Action(parameter, self.block(begin, "END_ACTION"), comment)
        self.take("END_ACTION")

    def block(self, begin: Token, *ends: str) -> Block:
        steps: list[Step] = []
        while True:
            token, comment = self.tokens[self.next], self.comments()
            if self.here.text in ends:
                break
            if self.here.kind == "end" or self.here.text in _ENDS:
                raise wrong(begin, f"{ends[-1]} is missing before line {self.here.line}")
            step = self.step()
            steps.append(Commented(token, comment, step) if comment else step)
        if comment:
            raise wrong(token, "a comment stands in front of a statement")
        return tuple(steps)

    def region(self, token: Token) -> Headed:
        words: list[str] = []
        while self.here.line == token.line:
            words.append(self.take(kind="word").text)
        body = self.block(token, "END_REGION")
        self.take("END_REGION")
        return Headed(token, " ".join(words), body)

    def step(self) -> Step:
        token = self.here
        result: Step
        if self.taken("REGION"):
            return self.region(token)
        if self.taken("IF"):
            result = self.choice(token)
        elif self.taken("CASE"):
            selector = self.term()
            self.take("OF")
            result = Selected(token, selector, self.slot())
            self.take("END_CASE")
        elif self.taken("FOR"):
            index = self.path()
            self.take(":=")
            first = self.term()
            self.take("TO")
            last = self.term()
            self.take("DO")
            result = Iteration(token, index, first, last, self.block(token, "END_FOR"))
            self.take("END_FOR")
        elif self.taken("{"):
            name, argument = self.path(), None
            if self.taken("("):
                argument = self.path()
                self.take(")")
            self.take("}")
            result = Insertion(name.token, name, argument)
        else:
            target = self.path()
            if self.here.text == "(":
                result = Timed(token, self.call(target))
            else:
                self.take(":=")
                result = Assigned(token, target, self.term())
        self.take(";")
        return result

    def choice(self, token: Token) -> Chosen:
        branches: list[tuple[Term | Insertion | None, Block]] = []
        while not branches or self.taken("ELSIF"):
            test = self.term()
            if isinstance(test, Named | Indexed) and self.taken(";"):
                branches.append((Insertion(test.token, test, None), ()))
                continue
            self.take("THEN")
            branches.append((test, self.block(token, "ELSIF", "ELSE", "END_IF")))
        if self.taken("ELSE"):
            branches.append((None, self.block(token, "END_IF")))
        self.take("END_IF")
        return Chosen(token, tuple(branches))

    def term(self, level: int = 0) -> Term:
        if level == len(_LEVELS):
            return self.single()
        left = self.term(level + 1)
        while self.here.text in _LEVELS[level]:
            operator = self.take()
            right = self.term(level + 1)
            continues = operator.text in _CHAINED and left.token.text == operator.text
            parts = left.parts if continues and isinstance(left, Joined) else (left,)
            left = Joined(operator, (*parts, right))
        return left

    def single(self) -> Term:
        token = self.here
        if self.taken("NOT"):
            return Inverted(token, self.single())
        if self.taken("("):
            inner = self.term()
            self.take(")")
            return inner
        if token.kind in ("number", "time"):
            return Literal(self.take())
        term = self.slot() if token.text == "{" else self.path()
        return self.call(term) if self.here.text == "(" else term

    def path(self) -> Named | Indexed:
        path: Named | Indexed = Named(self.take(kind="word"))
        self.source.names.add(path.token.text)
        while self.here.text in (".", "["):
            if self.taken("."):
                path = Named(self.take(kind="word"), path)
            else:
                path = Indexed(self.take("["), path, self.term())
                self.take("]")
        return path

    def call(self, routine: Term) -> Applied:
        self.take("(")
        arguments: list[Argument] = []
        while not arguments or self.taken(","):
            token, following = self.here, self.tokens[self.next + 1].text
            direction = following if following in (":=", "=>") else ""
            self.next += 2 if direction else 0
            arguments.append(Argument(token, direction, self.term()))
        self.take(")")
        return Applied(routine.token, routine, tuple(arguments))

    def slot(self) -> Named | Indexed:
        self.take("{")
        path = self.path()
        self.take("}")
        return path


def parsed(name: str, text: str) -> Source:
    """The source in a file. Raises SourceError for other input."""
    return _Parser(name, text).file()
