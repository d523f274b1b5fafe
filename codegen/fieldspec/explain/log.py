"""Frames as text: bytes in any spelling, and lines of a sniffer log."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from itertools import islice

from fieldspec.classes import dataclass
from fieldspec.model.link import Link

# Patterns are texts, which `re` compiles when they are first used: plain bytes need none of them.
_EACH_ENCLOSED = r"(?:\[[0-9A-Fa-f]{2}\]\s*)+|(?:<[0-9A-Fa-f]{2}>\s*)+"
_QUOTED = r"""(?s)b?(["'])(.*)\1[,;]?|\[(.*)\]|\{(.*)\}|\((.*)\)"""
_SEPARATOR = r"[\s,;:+_|-]+|(?<=[0-9A-Fa-f])(?=\\x)"
_PIECE = r"(?i)(?:0x|\\x|16#|&h|\$)?(?P<digits>[0-9a-f]+)|(?P<behind>[0-9a-f]+)h"

_LAST = r"(?i)(?:\\x(?P<code>[0-9a-f]{2})|[<\[]?(?P<name>crlf|cr|lf|\\r|\\n)[>\]]?|(?P<real>[\r\n]))\Z"
_CHARACTERS = {"\\r": "\r", "\\n": "\n", "cr": "\r", "lf": "\n", "crlf": "\r\n"}
_CONTROLS = {0x02: "STX", 0x03: "ETX", 0x0A: "LF", 0x0D: "CR"}


class Unreadable(ValueError):
    """A text that cannot be understood as bytes; says why."""


def is_hex_word(word: str) -> bool:
    """Whether a word without blanks may be bytes."""
    pieces = [piece for piece in re.split(_SEPARATOR, word) if piece]
    return bool(pieces) and all(re.fullmatch(_PIECE, piece) for piece in pieces)


def is_each_enclosed(text: str) -> bool:
    """Whether every byte stands in brackets of its own."""
    return re.fullmatch(_EACH_ENCLOSED, text.strip()) is not None


def unquoted(text: str) -> str:
    """A text without the quotes, brackets or braces around it; brackets around each byte are left."""
    match = None if is_each_enclosed(text) else re.fullmatch(_QUOTED, text.strip())
    return next(inner for inner in match.groups()[1:] if inner is not None) if match else text


def bytes_of(text: str) -> bytes:
    """The bytes of a text. Raises Unreadable."""
    text = unquoted(text)
    if is_each_enclosed(text):
        text = re.sub(r"[\[\]<>]+", " ", text)
    data = b""
    for piece in re.split(_SEPARATOR, text):
        if not piece:
            continue
        match = re.fullmatch(_PIECE, piece)
        if match is None:
            raise Unreadable(f"`{piece}` is no byte in hexadecimal digits")
        digits = match["digits"] or match["behind"]
        if len(digits) % 2 and len(digits) > 1:
            raise Unreadable(f"`{piece}` has an odd number of digits")
        data += bytes.fromhex(digits.zfill(2))
    if not data:
        raise Unreadable("there are no bytes in it")
    return data


def in_characters(text: str, links: Iterable[Link]) -> tuple[bytes, tuple[str, ...]] | None:
    """A frame that is written as its characters, with remarks on what the text lacks of its end.

    None where the text does not begin as the frames of one of the links that send characters.
    """
    text = unquoted(text).lstrip()
    for link in links:
        mark = link.start.decode("latin-1")
        if link.encoding == "hex_ascii" and mark.isprintable() and mark and text.startswith(mark):
            body, end = _ended(text)
            return _closed("".join(body.split()).encode("latin-1", "replace"), end.encode("latin-1"), link)
    return None


def _ended(text: str) -> tuple[str, str]:
    """The text without the control characters at its end, and these, which may be spelled."""
    end = ""
    while match := re.search(_LAST, text.rstrip(" \t")[-8:]):
        text = text.rstrip(" \t")
        text = text[: len(text) - len(match[0])]
        if match["code"]:
            end = chr(int(match["code"], 16)) + end
        else:
            end = (match["real"] or _CHARACTERS[match["name"].lower()]) + end
    return text, end


def _closed(body: bytes, end: bytes, link: Link) -> tuple[bytes, tuple[str, ...]]:
    """A frame with its whole end mark: what the text has of it, and what it lacks."""
    if end.endswith(link.end):
        return body + link.end, ()
    if not link.end.startswith(end):
        return body + end, ()
    lacking = link.end[len(end) :]
    named = " ".join(_CONTROLS.get(byte, f"{byte:02X}") for byte in lacking)
    return body + link.end, (f"the text lacks {named} at the end of the frame, which is taken as sent",)


# Before the bytes may stand times, words, and marks such as `RX:`, `Tx`, `>` or `<-`; behind them a comment.

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
class LogLine:
    """What a line holds. `frame` is empty where the line only says what comes next.

    `direction` is what a mark says: `request`, `response`, or empty. `remarks` say what the text lacks.
    """

    frame: bytes
    direction: str = ""
    remarks: tuple[str, ...] = ()


def log_line(text: str, links: Collection[Link]) -> LogLine | None:
    """The frame in a line, None for a blank one or a comment. Raises Unreadable."""
    if plain := _hex_bytes(text):
        return LogLine(plain)
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
        return LogLine(frame, _direction(text, marks[: number + 1], links), remarks)
    try:
        return LogLine(*_unmarked(text, links))
    except _NoBytes:
        direction = _direction(text, marks, links)
        if not direction:
            raise
        return LogLine(b"", direction)


def _hex_bytes(text: str) -> bytes:
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
            return bytes_of(text), ()
        before = re.match(_BEFORE, text)
        word = re.match(r"\S+", text)
        if before is not None:
            text = text[before.end() :]
        elif word is not None and not is_hex_word(word[0]):
            text = text[word.end() :]
        else:
            return bytes_of(re.sub(_BEHIND, "", text.rstrip())), ()
    raise _NoBytes("there are no bytes in it")
