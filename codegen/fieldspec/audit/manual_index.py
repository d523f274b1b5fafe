"""The index of a manual: its hash, and of each line a hash and what on it can be a fact.

An index stands beside the spec in the repository, where the manual itself cannot be. As text it has a head, an empty
line, and then one line for each of the manual: the hash of the line, and the reduced line.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from hashlib import sha256

from fieldspec.audit.reduced import digest, reduced
from fieldspec.classes import dataclass, field
from fieldspec.source import SourceFile, Span

NAME = "manual.index"
_HEAD = (
    "# What of the manual can be a fact, line by line. Written by `fieldspec audit {device} --manual FILE --record`."
)
_FORM = re.compile(r"# [^\n]*\nsha256 ([0-9a-f]{64})\nlines ([0-9]{1,7})\n\n")
_LINE = re.compile(r"[0-9a-f]{8}(?: .+)?|")


class ManualError(Exception):
    """A text that cannot be a manual, or an index that cannot be read: what is wrong with it, and what to do."""


@dataclass(frozen=True, slots=True)
class ManualIndex:
    """The lines of a manual. `file` is where findings point: the index, or the manual's own text.

    `offset` is the number of lines in `file` before the first one of the manual.
    """

    sha256: str
    digests: Sequence[str]
    lines: Sequence[str]
    file: SourceFile = field(compare=False)
    offset: int = field(default=0, compare=False)

    def span(self, number: int) -> Span:
        """Where findings show a line of the manual, counted from 1."""
        starts = self.file.line_starts()
        at = min(number + self.offset, len(starts)) - 1
        text = self.file.line(at + 1)
        return Span(self.file, starts[at], starts[at] + max(len(text), 1))


def index_of(path: str, content: bytes) -> ManualIndex:
    """The index of a manual's text. Raises ManualError where the bytes are no UTF-8 text."""
    text = _decoded(content)
    lines = text.split("\n")
    if not lines[-1].strip():
        lines.pop()
    return ManualIndex(
        sha256(content).hexdigest(),
        [digest(line) for line in lines],
        list(_without_programs(lines)),
        SourceFile(path, text),
    )


def _without_programs(lines: Sequence[str]) -> Iterator[str]:
    """Each line reduced; of a program, between lines of three backticks, nothing is left, as all of it is text."""
    inside = False
    for line in lines:
        fence = line.strip().startswith("```")
        inside ^= fence
        yield "" if inside or fence else reduced(line)


def _decoded(content: bytes) -> str:
    """The text of a file, with line feeds alone; a byte order mark is no part of it."""
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise ManualError("is UTF-16; save it as UTF-8")
    if b"\0" in content:
        raise ManualError("is not a text; extract the text of the manual first, and save it as UTF-8")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        raise ManualError(
            f"is not UTF-8: line {line} has a byte {content[error.start]:02X}h; save it as UTF-8"
        ) from None
    if not text.strip():
        raise ManualError("is empty; give the text of the manual")
    return text.replace("\r\n", "\n")


def written(index: ManualIndex, device: str) -> str:
    """The index as text."""
    rows = (f"{digest} {line}".rstrip() for digest, line in zip(index.digests, index.lines, strict=True))
    head = f"{_HEAD.format(device=device)}\nsha256 {index.sha256}\nlines {len(index.lines)}\n\n"
    return head + "".join(f"{row}\n" for row in rows)


def parsed(path: str, text: str) -> ManualIndex:
    """The index that a text holds. Raises ManualError where it holds none."""
    head = _FORM.match(text)
    rows = text[head.end() :].split("\n")[:-1] if head else []
    if head is None or len(rows) != int(head[2]) or not all(map(_LINE.fullmatch, rows)):
        raise ManualError("is not an index of a manual; record it again with --manual FILE --record")
    parts = [row.partition(" ") for row in rows]
    offset = head[0].count("\n")
    return ManualIndex(
        head[1], [part[0] for part in parts], [part[2] for part in parts], SourceFile(path, text), offset
    )
