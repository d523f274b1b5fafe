"""A line of a manual, reduced to what can be a fact: numbers, identifiers, frames, and the cells that they stand in.

What is left is no sentence: words without a capital letter, a digit or an underscore, and all that is not written in
Latin letters, become the mark `…`. So lines can be kept beside a spec although the manual cannot.
"""

from __future__ import annotations

import re
import unicodedata
from hashlib import sha256

LEFT = "…"
CELL = " | "
LONGEST = 4000
"""Characters of a line that are looked at."""

_RAISED = {ord(raised): plain for raised, plain in zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", "0123456789+-", strict=True)}
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
_CIRCLED = {ord("①") + at: f"({at + 1}) " for at in range(20)}
_SPELLED = _SIGNS | _CIRCLED
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
    """Eight hexadecimal digits that stand for a line, whatever blanks are in it; none for an empty one."""
    text = "".join(unicodedata.normalize("NFKC", line).split())
    return sha256(text.encode()).hexdigest()[:8] if text else ""


def reduced(line: str) -> str:
    """The line as an index keeps it: cells with ` | ` between them, `…` for what is left out."""
    text = _CELL_TAG.sub("|", line[:LONGEST])
    text = _TAG.sub(" ", text)
    text = _FOOTNOTE.sub("", text)
    if not text.isascii():
        text = _POWER.sub(lambda found: "^" + found[0].translate(_RAISED), text)
        text = unicodedata.normalize("NFKC", text.translate(_SPELLED)).translate(_SIGNS)
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
        text = _WORD.sub(lambda found: _word(found, text), text)
    return _BLANKS.sub(" ", _MARKS.sub(LEFT, text)).strip()


def _word(found: re.Match[str], cell: str) -> str:
    """A word that can be an identifier, or that hangs on a number as a unit or a suffix; else the mark."""
    word = found[0]
    if not word.islower() or any(char.isdigit() or char == "_" for char in word):
        return word
    before = cell[: found.start()]
    hangs = before[-1:].isdigit() or (word == "h" and _HEX.search(before) is not None)
    return word if hangs else LEFT
