"""The lines of a manual: what an index stores of each, the file of the index, and the lines of other editions."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Sequence
from difflib import SequenceMatcher
from hashlib import sha256

from fieldspec.foundation.classes import dataclass, field
from fieldspec.foundation.source import SourceFile, Span

# An index has no sentences: words without a capital letter, a digit or an underscore, and everything that is not in
# Latin letters, become the mark `…`. So the index can be in a repository that must not have the manual.

LEFT = "…"
CELL = " | "
LONGEST = 4000
"""The most characters of a line; the rest is cut."""

_RAISED = {ord(raised): digit for raised, digit in zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", "0123456789+-", strict=True)}
_POWER = re.compile("[⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻]+")
_SIGNS = str.maketrans(
    {
        "、": ", ",
        "。": ".",
        "·": ".",
        "\N{EN DASH}": "-",
        "\N{EM DASH}": "-",
        "\N{MINUS SIGN}": "-",
        "\N{HYPHEN}": "-",
        "→": "->",
        "\N{MULTIPLICATION SIGN}": "x",
        "□": "_",
        "“": '"',
        "”": '"',
        "\N{LEFT SINGLE QUOTATION MARK}": "'",
        "\N{RIGHT SINGLE QUOTATION MARK}": "'",
        "《": '"',
        "》": '"',
        "「": '"',
        "」": '"',
    }
)
_CIRCLED = {ord("①") + index: f"({index + 1}) " for index in range(20)}
_NUMBER_WORD = _SIGNS | _CIRCLED
_CELL_TAG = re.compile(r"</?(?:td|th)\b[^<>]{0,100}>", re.IGNORECASE)
_TAG = re.compile(r"</?[a-zA-Z]+\b[^<>]{0,100}>")
_FOOTNOTE = re.compile(r"(?<![A-Za-z0-9])\^?\{? ?\*[0-9]{1,2}(?![0-9.,%])\}?")
_COMMAND = re.compile(r"\\[a-zA-Z]+")
_RULE = re.compile(r"[\s|:+=-]*")
_WORD = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_HEX = re.compile(r"[0-9][0-9A-Fa-f]{0,15} ?$|[A-Fa-f][0-9A-Fa-f]{0,14}[0-9][A-Fa-f]{0,4} ?$")
_FOREIGN = re.compile(r"[^\x20-\x7e]+")
_MARKS = re.compile(rf"{LEFT}(?:[\s,.;\"]*{LEFT})*")
_BLANKS = re.compile(r" {2,}")


def digest(line: str) -> str:
    """A hash of a line without its blanks, in eight hexadecimal digits; empty for an empty line."""
    text = "".join(unicodedata.normalize("NFKC", line).split())
    return sha256(text.encode()).hexdigest()[:8] if text else ""


def index_line(line: str) -> str:
    """The line as an index stores it: ` | ` between cells, `…` for omitted words."""
    text = _CELL_TAG.sub("|", line[:LONGEST])
    text = _TAG.sub(" ", text)
    text = _FOOTNOTE.sub("", text)
    if not text.isascii():
        text = _POWER.sub(lambda match: "^" + match[0].translate(_RAISED), text)
        text = unicodedata.normalize("NFKC", text.translate(_NUMBER_WORD)).translate(_SIGNS)
    text = _COMMAND.sub(" ", text).replace("$", "").replace("\t", "|")
    if _RULE.fullmatch(text):
        return ""
    if line.lstrip().startswith("|"):
        text = text.strip().removeprefix("|").removesuffix("|")
    cells = text.split("|")
    return CELL.join(map(_cell, cells)).rstrip(" |") if len(cells) > 1 else _cell(text)


def _cell(cell: str) -> str:
    text = _FOREIGN.sub(LEFT, cell)
    if not _WORD.fullmatch(text.strip()):
        text = _WORD.sub(lambda match: _word(match, text), text)
    return _BLANKS.sub(" ", _MARKS.sub(LEFT, text)).strip()


def _word(match: re.Match[str], cell: str) -> str:
    """A word that may be an identifier, or a unit or suffix of the number before it; else the mark."""
    word = match[0]
    if not word.islower() or any(char.isdigit() or char == "_" for char in word):
        return word
    before = cell[: match.start()]
    hangs = before[-1:].isdigit() or (word == "h" and _HEX.search(before) is not None)
    return word if hangs else LEFT


# The file of an index has a header, an empty line, and then one line for each line of the manual: the hash of the line,
# and the index line.

NAME = "manual.index"
_HEAD = (
    "# What of the manual can be a fact, line by line. Written by `fieldspec audit {device} --manual FILE --record`."
)
_FORM = re.compile(r"# [^\n]*\nsha256 ([0-9a-f]{64})\nlines ([0-9]{1,7})\n\n")
_LINE = re.compile(r"[0-9a-f]{8}(?: .+)?|")


class ManualError(Exception):
    """A text that cannot be a manual, or an index that cannot be read. The message says what to do."""


@dataclass(frozen=True, slots=True)
class ManualIndex:
    """The lines of a manual. Findings point to `file`: the index, or the text of the manual.

    `offset` is the number of lines in `file` before the first one of the manual.
    """

    sha256: str
    digests: Sequence[str]
    lines: Sequence[str]
    file: SourceFile = field(compare=False)
    offset: int = field(default=0, compare=False)

    def span(self, number: int) -> Span:
        """The place of a line of the manual, counted from 1."""
        starts = self.file.line_starts()
        index = min(number + self.offset, len(starts)) - 1
        text = self.file.line(index + 1)
        return Span(self.file, starts[index], starts[index] + max(len(text), 1))


def index_of(path: str, content: bytes) -> ManualIndex:
    """The index of a manual's text. Raises ManualError for bytes that are not UTF-8 text."""
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
    """The index line of each line; empty within a program, that is between lines of three backticks."""
    is_program = False
    for line in lines:
        fence = line.strip().startswith("```")
        is_program ^= fence
        yield "" if is_program or fence else index_line(line)


def _decoded(content: bytes) -> str:
    """The text of a file with line feeds only and no byte order mark. Raises ManualError."""
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
        raise ManualError("is empty; it must be the text of the manual")
    return text.replace("\r\n", "\n")


def index_text(index: ManualIndex, device: str) -> str:
    """The text of the file of an index."""
    rows = (f"{digest} {line}".rstrip() for digest, line in zip(index.digests, index.lines, strict=True))
    head = f"{_HEAD.format(device=device)}\nsha256 {index.sha256}\nlines {len(index.lines)}\n\n"
    return head + "".join(f"{row}\n" for row in rows)


def parsed(path: str, text: str) -> ManualIndex:
    """The index in a text. Raises ManualError for any other text."""
    head = _FORM.match(text)
    rows = text[head.end() :].split("\n")[:-1] if head else []
    if head is None or len(rows) != int(head[2]) or not all(map(_LINE.fullmatch, rows)):
        raise ManualError("is not an index of a manual; record it again with --manual FILE --record")
    parts = [row.partition(" ") for row in rows]
    offset = head[0].count("\n")
    return ManualIndex(
        head[1], [part[0] for part in parts], [part[2] for part in parts], SourceFile(path, text), offset
    )


@dataclass(frozen=True, slots=True)
class AlignedManual:
    """A text at hand, with its lines by their numbers in the edition that the spec cites.

    `known` has the cited number of each line at hand, `here` the line at hand of a cited number. A line that only the
    text at hand has is in `new`, and has the number of the cited line before it. Cited lines that are missing are in
    `gone`; those with another text at the same place, in `changed`. `same` of `whole` lines with text are unchanged.
    """

    index: ManualIndex
    known: Sequence[int]
    here: dict[int, int]
    new: frozenset[int]
    gone: frozenset[int]
    changed: frozenset[int]
    same: int
    whole: int

    def line(self, cited: int) -> str:
        """The text of a cited line; empty where it is gone."""
        number = self.here.get(cited)
        return self.index.lines[number - 1] if number else ""


def unmoved(index: ManualIndex) -> AlignedManual:
    """A text in the edition that the spec cites."""
    numbers = range(1, len(index.lines) + 1)
    whole = sum(map(bool, index.digests))
    return AlignedManual(
        index, numbers, {number: number for number in numbers}, frozenset(), frozenset(), frozenset(), whole, whole
    )


def aligned(cited: ManualIndex, index: ManualIndex) -> AlignedManual:
    """The lines of `index`, an available text, by the lines of `cited`, the edition that the spec cites."""
    if list(cited.digests) == list(index.digests):
        return unmoved(index)
    old = [number for number, digest in enumerate(cited.digests, 1) if digest]
    new = [number for number, digest in enumerate(index.digests, 1) if digest]
    new_lines: dict[int, int] = {}
    changed: set[int] = set()
    added: set[int] = set()
    same = 0
    matcher = SequenceMatcher(
        None,
        [cited.digests[number - 1] for number in old],
        [index.digests[number - 1] for number in new],
        autojunk=False,
    )
    for tag, first, last, begin, end in matcher.get_opcodes():
        new_lines.update(zip(old[first:last], new[begin:end], strict=False))
        if tag == "equal":
            same += last - first
        else:
            changed.update(old[first : first + min(last - first, end - begin)])
            added.update(new[begin + min(last - first, end - begin) : end])
    by_line = {line: number for number, line in new_lines.items()}
    known = []
    before = 1
    for number in range(1, len(index.lines) + 1):
        before = by_line.get(number, before)
        known.append(before)
    removed = frozenset(old) - new_lines.keys()
    return AlignedManual(index, known, new_lines, frozenset(added), removed, frozenset(changed), same, len(old))
