"""A line of a sniffer's log -> the frame in it, and which way it went.

Before the bytes may stand times, words, and marks such as `RX:`, `Tx`, `>` or `<-`; behind them a comment.
"""

from __future__ import annotations

import re
from collections.abc import Collection
from itertools import islice

from fieldspec.classes import dataclass
from fieldspec.commands.spelled import Unreadable, in_characters, is_each_enclosed, is_spelled, spelled, unquoted
from fieldspec.model.link import Link

_WORDS = {
    "request": ("tx", "send", "sending", "sent", "transmit", "transmitted", "request", "req"),
    "response": ("rx", "recv", "receive", "received", "response", "resp", "rsp", "reply", "answer"),
}
_DIRECTIONS = {word: direction for direction, words in _WORDS.items() for word in words}
# More marks are no log, and each is tried.
_MOST_MARKS = 8

# Patterns are texts, which `re` compiles when they are first used: plain bytes need none of them.
_MARK = (
    rf"(?i)(?<![\w.])(?P<word>{'|'.join(_DIRECTIONS)})(?![\w.])(?:\s*[\[(][^\])]{{0,40}}[\])])?(?:\s*[:=](?=\s|\w|$))?"
    r"|(?:^|(?<=[\s\]]))(?P<arrow>[-=]{0,2}>{1,3}|<{1,3}[-=]{0,2})(?=[\s:\w\[]|$)(?![0-9A-Fa-f]{2}>)"
)
_COMMENT = r"(?s)(?:^|(?<=\s))(?:#|//).*"
_CLOCK = r"(?:[01]?\d|2[0-3]):[0-5]\d:[0-5]\d(?:[.,]\d{1,9}|:\d{3,6})?Z?"
_DATE = r"(?:\d{4}[-/.]\d{1,2}[-/.]\d{1,2}|\d{1,2}[-/.]\d{1,2}[-/.]\d{4})"
_TIME = rf"(?:{_DATE}T{_CLOCK}|{_DATE}|{_CLOCK}|[-+]?\d+\.\d+(?:s|ms|us)?)[,;]?(?=\s)"
_NUMBER_OF_LINE = r"\d{4,}[-:](?=[0-9A-Fa-f]{2}\b)"
_OFFSET_OF_DUMP = r"0000[0-9A-Fa-f]{4}:?\s+(?=[0-9A-Fa-f]{2}\b)"
_ENCLOSED = r"\[[^\]]{0,80}\]|\([^)]{0,80}\)"
_LABEL = r"[^\s:]+:"
_BEFORE = rf"[\s,;|=-]+|{_TIME}|{_NUMBER_OF_LINE}|{_OFFSET_OF_DUMP}|(?:{_ENCLOSED}|{_LABEL})(?=\s)"
_BEHIND = rf"\s(?:{_ENCLOSED}|\|.{{0,80}}\|)$"


@dataclass(frozen=True, slots=True)
class Logged:
    """What a line holds. `frame` is empty where the line only says what comes next.

    `direction` is what a mark says: `request`, `response`, or empty. `remarks` say what the text lacks.
    """

    frame: bytes
    direction: str = ""
    remarks: tuple[str, ...] = ()


def logged(text: str, links: Collection[Link]) -> Logged | None:
    """The frame in a line, None for a blank one or a comment. Raises Unreadable."""
    if plain := _plain(text):
        return Logged(plain)
    if text.endswith("\n") and not text.endswith("\r\n"):
        text = text[:-1]
    text = re.sub(_COMMENT, "", text)
    if not text.strip():
        return None
    marks = list(islice(re.finditer(_MARK, text), _MOST_MARKS))
    for number in reversed(range(len(marks))):
        try:
            frame, remarks = _frame(text[marks[number].end() :], links)
        except Unreadable:
            continue
        return Logged(frame, _direction(text, marks[: number + 1], links), remarks)
    try:
        return Logged(*_unmarked(text, links))
    except _NoBytes:
        direction = _direction(text, marks, links)
        if not direction:
            raise
        return Logged(b"", direction)


def _plain(text: str) -> bytes:
    """The bytes of a text that has nothing but them; none for any other."""
    try:
        return bytes.fromhex(text)
    except ValueError:
        return b""


class _NoBytes(Unreadable):
    """Nothing in the text may be bytes."""


def _direction(text: str, marks: list[re.Match[str]], links: Collection[Link]) -> str:
    """What marks say. Words go before arrows, which point from one name to the other where names stand before.

    A word that a link uses the other way round says nothing: nobody knows who wrote the log.
    """
    words = [mark["word"].lower() for mark in marks if mark["word"]]
    if words:
        direction = _DIRECTIONS[words[-1]]
        other = "response" if direction == "request" else "request"
        return "" if any(link.direction_name(other) == words[-1] for link in links) else direction
    if not marks or re.search(r"[A-Za-z]", re.sub(_TIME, "", text[: marks[-1].start()])):
        return ""
    return "request" if ">" in marks[-1]["arrow"] else "response"


def _unmarked(text: str, links: Collection[Link]) -> tuple[bytes, str, tuple[str, ...]]:
    """The frame of a line without marks; brackets around each byte are marks themselves."""
    frame, remarks = _frame(text, links)
    start = text.strip()[0]
    enclosed = text.count(start) == len(frame)
    return frame, {"[": "request", "<": "response"}.get(start, "") if enclosed else "", remarks


def _frame(text: str, links: Collection[Link]) -> tuple[bytes, tuple[str, ...]]:
    """The frame behind what may stand before it, and what the text lacks of it."""
    text = text.lstrip(" \t")
    while text:
        found = in_characters(text, links)
        if found is not None:
            return found
        if is_each_enclosed(text) or unquoted(text) != text:
            return spelled(text), ()
        before = re.match(_BEFORE, text)
        word = re.match(r"\S+", text)
        if before is not None:
            text = text[before.end() :]
        elif word is not None and not is_spelled(word[0]):
            text = text[word.end() :]
        else:
            return spelled(re.sub(_BEHIND, "", text.rstrip())), ()
    raise _NoBytes("there are no bytes in it")
