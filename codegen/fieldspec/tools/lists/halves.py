"""Rows of the high and of the low word of one value as one row: `Power H` and `Power L`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise
from operator import attrgetter

from fieldspec.foundation.classes import replace
from fieldspec.tools.lists.assumption import Assumption
from fieldspec.tools.lists.row_reading import ListRow
from fieldspec.tools.lists.type_words import Typed
from fieldspec.tools.lists.words import pattern

_HALF = re.compile(
    r"(?:[\s_(\[,-]+|(?=[高低]))(?P<half>h|l|msw|lsw|(?:high|hi|upper|low|lo|lower)[\s_-]*(?P<word>word|16|half)?"
    r"(?:[\s_-]*bits?)?(?: of (?P<real>float|real))?|[高低](?P<sign>字|16位|位))[)\]]*$",
    re.IGNORECASE,
)
_LONGEST_HALF = 30
_FACTS = attrgetter("space", "type", "scale", "factor", "offset", "unit", "access", "low", "high")
_WORDS = 2
_FEWEST = 2
"""The number of pairs that names of one letter need, which may stand for a high and a low limit."""


def with_halves_joined(rows: Sequence[ListRow], assumptions: list[Assumption]) -> list[ListRow]:
    """The rows; two rows with the words of one value are joined as the first row. Joining is an assumption."""
    pairs = {low.row: pair for pair in pairwise(rows) if (low := pair[0]) and _halves(*pair)}
    certain = [pair for pair in pairs.values() if _half(_names(*pair)[0])[1]]
    if not pairs or (not certain and len(pairs) < _FEWEST):
        return list(rows)
    joined = list(_joined(rows, pairs))
    examples = ", ".join(
        f"`{first}` and `{second}`" for first, second in [_names(*pair) for pair in [*pairs.values()][:2]]
    )
    reading = f"two rows are the words of one in {len(pairs)} {'case' if len(pairs) == 1 else 'cases'}"
    assumptions.append(Assumption("words", reading, f"the names, as in {examples}"))
    return joined


def _joined(rows: Sequence[ListRow], pairs: dict[int, tuple[ListRow, ListRow]]) -> Iterator[ListRow]:
    used: set[int] = set()
    for row in rows:
        if row.row in used:
            continue
        if row.row not in pairs:
            yield row
            continue
        second = pairs[row.row][1]
        used.add(second.row)
        texts = {
            role: _stem(text) if role in ("name", "printed_name", "label") else text for role, text in row.texts.items()
        }
        half_name, _ = _names(row, second)
        match = _match(half_name)
        kind = "f" if match and match["real"] else row.type.name[0] if row.type is not None and row.type.name else "u"
        yield replace(
            row,
            words=2,
            type=Typed(f"{kind}32"),
            names=tuple(map(_stem, row.names)),
            texts=texts,
            order="ABCD" if _half(half_name)[0] == "high" else "CDAB",
            doubts=(*row.doubts, *(doubt for doubt in second.doubts if doubt not in row.doubts)),
            gap=second.gap + 1 if second.gap else 0,
            parts=(*row.parts, second.row, *second.parts),
        )


def _halves(first: ListRow, second: ListRow) -> bool:
    """Whether two rows are the words of one value: neighbours of one word, with equal facts. Their type may be
    that of the whole value."""
    names = _names(first, second)
    if second.address != first.address + 1 or first.is_own or not any(names):
        return False
    is_bounded = first.low is not None or first.high is not None
    is_whole = first.type is not None and bool(first.type.name) and first.type.size == _WORDS and _half(names[0])[1]
    is_word = first.bits is None and first.words in (None, 1)
    is_word = is_word and (is_whole or first.type in (None, Typed("u16"), Typed("i16")))
    have_equal_facts = _FACTS(first) == _FACTS(second) and (first.words or 1) == (second.words or 1)
    return have_equal_facts and is_word and not is_bounded


def _names(first: ListRow, second: ListRow) -> tuple[str, str]:
    """The names of two rows that say which halves of one value they are; empty for none."""
    pairs = ((name, other) for name in first.names for other in second.names)
    fitting = (pair for pair in pairs if {_half(name)[0] for name in pair} == {"high", "low"})
    return next((pair for pair in fitting if _stem(pair[0]) == _stem(pair[1])), ("", ""))


def _half(name: str) -> tuple[str, bool]:
    """Which half the row with a name is, empty if none, and whether the name says so: a letter may be of a limit."""
    match = _match(name)
    if match is None:
        return "", False
    half = match["half"].casefold()
    is_word = bool(match["word"] or match["sign"]) or half in ("msw", "lsw")
    if not is_word and (len(half) > 1 or pattern("limit").search(name)):
        return "", False
    return "high" if half[0] in "hmu高" else "low", is_word


def _stem(text: str) -> str:
    """A name without the half at its end."""
    match = _match(text)
    return text[: len(text) - len(match[0])].strip() if match else text


def _match(text: str) -> re.Match[str] | None:
    """The half at the end of a name. Only the longest text that a half can have is searched."""
    return _HALF.search(text[-_LONGEST_HALF:])
