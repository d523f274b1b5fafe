"""The states of a row, and the access and the states that its descriptions have."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal

from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.tools.lists.cells import access, whole
from fieldspec.tools.lists.naming import snake
from fieldspec.tools.lists.type_words import Typed, with_sign
from fieldspec.tools.lists.value_texts import value_meanings

_SPOKEN_ACCESS = re.compile(
    r"(read[ -]?only|read[ /]*(?:and |& )?write|write[ -]?only|R/W|RO|RW|WO|[RW](?=$))(?=$|\s*[,;.)(])", re.IGNORECASE
)
"""The access at the beginning of a description."""

_STATE = re.compile(r"(NaN 0x[0-9A-F]+|-?[0-9]+(?:\.\.-?[0-9]+)?) ([a-z0-9_]+)")
_PHRASE = re.compile(
    r"(0x[0-9a-f]{2,16}|-?[0-9]{1,20})\s*(?:=|:|->|→|\b(?:when|if|wenn|bei)\b)\s*([^\W\d][^=:;,/<>*+0-9]{1,40})",
    re.IGNORECASE,
)
_NO_VALUE = "no_value"
"""The name of a state whose number alone is in the list."""


def spoken_access(described: Sequence[str]) -> str:
    """The access at the beginning of one of the descriptions; empty if none has it."""
    phrases = [phrase for text in described if (phrase := _SPOKEN_ACCESS.match(text))]
    return access(phrases[0][1]) if phrases else ""


def special_states(texts: Mapping[str, str], own_type: Typed | None, doubts: list[str]) -> tuple[tuple[str, str], ...]:
    """The states of a column of special values, which may be a number alone."""
    text = texts.get("special", "")
    parts = [part.strip() for part in text.split(";") if part.strip()]
    if len(parts) == 1 and (count := _count(text, own_type)) is not None:
        return ((str(count), _NO_VALUE),)
    phrases = [_STATE.fullmatch(part) for part in parts]
    if not all(phrases):
        doubts.append(f"Special values in the list: {text}.")
    return tuple((phrase[1], phrase[2]) for phrase in phrases if phrase)


def described_states(own_type: Typed | None, described: Sequence[str]) -> Iterator[tuple[int, str, bool]]:
    """The numbers and the names of the states in descriptions, `0x7FFF = no sensor`, and whether they are counts:
    hexadecimal numbers and ends of the type are. Others may be in the unit."""
    texts = [text for text in described if (choice := value_meanings(text)) is None or len(choice.members) < 2]
    pieces = (piece.strip() for text in texts for piece in re.split(r"[;,.](?=\s|$)", text))
    for phrase in filter(None, map(_PHRASE.fullmatch, pieces)):
        count, name = _count(phrase[1], own_type), snake(phrase[2].casefold())
        if count is not None and name:
            high = PRIMITIVES[own_type.name].high if own_type is not None else 0
            yield count, name, "x" in phrase[1].casefold() or count in (high, ~high, high >> 1, (high >> 1) + 1)


def _count(text: str, own_type: Typed | None) -> int | None:
    """A count of a type in a text; the bits of a negative number may be written as a positive one."""
    kind = PRIMITIVES[own_type.name] if own_type is not None and own_type.name else None
    number = whole(text)
    if number is None or kind is None or not is_count(kind.encoding):
        return None
    count = int(with_sign(Decimal(number), kind))
    return count if kind.low <= count <= kind.high else None
