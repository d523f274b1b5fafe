"""Reads frames from text: bytes in any usual spelling, and lines of a sniffer log."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from itertools import islice

from fieldspec.codec.explain import sentences
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.escape import can_frame_bytes
from fieldspec.language.model.link import Link

# The patterns are texts, which `re` compiles when they are first used; a line of nothing but digits needs none of them.
_EACH_ENCLOSED = r"(?:\[[0-9A-Fa-f]{2}\]\s*)+|(?:<[0-9A-Fa-f]{2}>\s*)+"
_QUOTED = r"""(?s)b?(["'])(.*)\1[,;]?|\[(.*)\]|\{(.*)\}|\((.*)\)"""
_SEPARATOR = r"[\s,;:+_|-]+|(?<=[0-9A-Fa-f])(?=\\x)"
_PIECE = r"(?i)(?:0x|\\x|16#|&h|\$)?(?P<digits>[0-9a-f]+)|(?P<suffixed>[0-9a-f]+)h"

_LAST = r"(?i)(?:\\x(?P<code>[0-9a-f]{2})|[<\[]?(?P<name>crlf|cr|lf|\\r|\\n)[>\]]?|(?P<real>[\r\n]))\Z"
_CHARACTERS = {"\\r": "\r", "\\n": "\n", "cr": "\r", "lf": "\n", "crlf": "\r\n"}
_CONTROLS = {0x02: "STX", 0x03: "ETX", 0x0A: "LF", 0x0D: "CR"}


class Unreadable(ValueError):
    """A text that is not bytes. The message says why."""


def is_hex_word(word: str) -> bool:
    """Whether a word can be read as bytes."""
    pieces = [piece for piece in re.split(_SEPARATOR, word) if piece]
    return bool(pieces) and all(re.fullmatch(_PIECE, piece) for piece in pieces)


def is_each_enclosed(text: str) -> bool:
    """Whether every byte has its own brackets."""
    return re.fullmatch(_EACH_ENCLOSED, text.strip()) is not None


def unquoted(text: str) -> str:
    """A text without the quotes, brackets or braces around it. Brackets around each byte stay."""
    match = None if is_each_enclosed(text) else re.fullmatch(_QUOTED, text.strip())
    return next(inner for inner in match.groups()[1:] if inner is not None) if match else text


def bytes_of(text: str) -> bytes:
    """The bytes of a text. Raises Unreadable."""
    if data := _hex_bytes(text):
        return data
    text = unquoted(text)
    if is_each_enclosed(text):
        text = re.sub(r"[\[\]<>]+", " ", text)
    data = b""
    pieces = [piece for piece in re.split(_SEPARATOR, text) if piece]
    # Programs that print a byte as one digit where they can print no other byte as 0 and a digit.
    is_padded = any(re.match("0[0-9A-Fa-f]", piece) for piece in pieces)
    for piece in pieces:
        match = re.fullmatch(_PIECE, piece)
        if match is None:
            raise Unreadable(sentences.NOT_A_BYTE.format(piece=piece))
        digits = match["digits"] or match["suffixed"]
        if len(digits) % 2 and len(digits) > 1:
            raise Unreadable(sentences.ODD_DIGITS.format(piece=piece))
        if len(piece) == 1 and is_padded:
            raise Unreadable(sentences.SINGLE_DIGIT.format(offset=len(data), piece=piece))
        data = data + bytes.fromhex(digits.zfill(2))
    if not data:
        raise Unreadable(sentences.NO_BYTES)
    return data


def _openings(links: Iterable[Link]) -> list[tuple[Link, str, str]]:
    """The characters with which frames begin: the link, the direction and the characters of each."""
    return [(link, direction, mark) for link in links for direction, mark in link.openings.items()]


def in_characters(text: str, openings: Iterable[tuple[Link, str, str]]) -> tuple[bytes, tuple[str, ...]] | None:
    """A frame that the text shows as characters, with a remark on what is missing at its end.

    None if the text does not begin like a frame.
    """
    text = unquoted(text).lstrip()
    for link, direction, mark in openings:
        if text.startswith(mark):
            body, ending = _ended(text)
            if link.transmission == "hex_ascii":
                body = "".join(body.split())
            _, end = link.marks(direction)
            return _split_end(body.encode("latin-1", "replace"), ending.encode("latin-1"), end)
    return None


def _ended(text: str) -> tuple[str, str]:
    """The text without the control characters at its end, which may be spelled as words, and these characters."""
    end = ""
    while match := re.search(_LAST, text.rstrip(" \t")[-8:]):
        text = text.rstrip(" \t")
        text = text[: len(text) - len(match[0])]
        if match["code"]:
            end = chr(int(match["code"], 16)) + end
        else:
            end = (match["real"] or _CHARACTERS[match["name"].lower()]) + end
    return text, end


def _split_end(body: bytes, end: bytes, mark: bytes) -> tuple[bytes, tuple[str, ...]]:
    """A frame with its whole end delimiter, and a remark if the text has only a part of the delimiter."""
    rest = next(mark[size:] for size in range(len(mark), -1, -1) if body.endswith(mark[:size]))
    if end.endswith(rest):
        return body + rest, ()
    if rest[: len(end)] != end:
        return body + end, ()
    missing = " ".join(_CONTROLS.get(byte, f"{byte:02X}") for byte in rest[len(end) :])
    return body + rest, (sentences.END_ASSUMED.format(characters=missing),)


# Times, words and marks such as `RX:`, `Tx`, `>` or `<-` may come before the bytes, and a comment after them.

_DIRECTIONS = {word: direction for direction, words in sentences.DIRECTION_WORDS for word in words}
# Each mark is tried, and a line of a log has few.
_MOST_MARKS = 8
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
_CANDUMP = (
    r"(?:^|\s)(?P<identifier>[0-7][0-9A-Fa-f]{2}|[01][0-9A-Fa-f]{7})"
    r"(?:#(?:(?P<remote>R)(?P<dlc>[0-8])?|(?P<data>(?:[0-9A-Fa-f]{2}){0,8}))(?:\s+[RT])?"
    r"|\s+\[(?P<count>[0-8])\](?:(?P<words>\s+remote request)|(?P<bytes>(?:\s+[0-9A-Fa-f]{2}){0,8})))\s*$"
)
_MISTYPED = r"[0-9][OoIl]|[OoIl][0-9]"
"""A byte with a letter that looks like a digit."""
_BEHIND = rf"\s(?:{_ENCLOSED}|\|.{{0,80}}\|)$"


@dataclass(frozen=True, slots=True)
class LogLine:
    """A line of a log. `frame` is empty if the line only announces the next one.

    `direction` is that of the mark in the line: `request`, `response`, or empty. `remarks` say what is missing.
    """

    frame: bytes
    direction: str = ""
    remarks: tuple[str, ...] = ()


def log_line(text: str, links: Collection[Link]) -> LogLine | None:
    """The frame in a line; None for a blank line or a comment. Raises Unreadable."""
    if data := _hex_bytes(text):
        return LogLine(data)
    if any(link.is_can for link in links) and (data := _can_frame(text)):
        return LogLine(data)
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
        frame, direction, remarks = _unmarked(text, links)
        return LogLine(frame, direction, remarks)
    except _NoBytes:
        direction = _direction(text, marks, links)
        if not direction:
            raise
        return LogLine(b"", direction)


def _hex_bytes(text: str) -> bytes:
    """The bytes of a text of only hexadecimal digits; empty for any other text."""
    try:
        return bytes.fromhex(text)
    except ValueError:
        return b""


def _can_frame(text: str) -> bytes:
    """The frame in a line of candump, `605#4041`, `605#R8`, or `605 [2] 40 41`; empty for any other text."""
    match = re.search(_CANDUMP, text)
    if match is None:
        return b""
    data = bytes.fromhex((match["data"] or match["bytes"] or "").strip())
    is_remote = bool(match["remote"] or match["words"])
    size = int(match["dlc"] or match["count"] or len(data))
    if not is_remote and size != len(data):
        return b""
    return can_frame_bytes(int(match["identifier"], 16), len(match["identifier"]) > 3, is_remote, size, data)


class _NoBytes(Unreadable):
    """The text has nothing that can be read as bytes."""


def _direction(text: str, marks: list[re.Match[str]], links: Collection[Link]) -> str:
    """The direction that marks tell; empty if they tell none.

    Words count more than arrows, and an arrow after a name is ignored, because it may point either way. A word that a
    link uses for the other direction is ignored too: the log may take either side's view.
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
    """The frame of a line without marks; brackets around each byte tell its direction."""
    frame, remarks = _frame(text, links)
    start = text.strip()[0]
    enclosed = text.count(start) == len(frame)
    return frame, {"[": "request", "<": "response"}.get(start, "") if enclosed else "", remarks


def _frame(text: str, links: Collection[Link]) -> tuple[bytes, tuple[str, ...]]:
    """The frame after times, labels and words, and remarks on what the text lacks of it."""
    text = text.lstrip(" \t")
    openings = _openings(links)
    while text:
        frame = in_characters(text, openings)
        if frame is not None:
            return frame
        if is_each_enclosed(text) or unquoted(text) != text:
            return bytes_of(text), ()
        before = re.match(_BEFORE, text)
        word = re.match(r"\S+", text)
        if before is not None:
            text = text[before.end() :]
        elif word is not None and re.fullmatch(_MISTYPED, word[0]):
            raise Unreadable(sentences.NOT_A_BYTE.format(piece=word[0]))
        elif word is not None and not is_hex_word(word[0]):
            text = text[word.end() :]
        else:
            return bytes_of(re.sub(_BEHIND, "", text.rstrip())), ()
    raise _NoBytes(sentences.NO_BYTES)
