"""The states of a row, and the access and the states that its descriptions have."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from fieldspec.language.model.encoding import is_count, is_signed
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.tools.lists.cells import access
from fieldspec.tools.lists.naming import snake
from fieldspec.tools.lists.type_words import Typed

_SPOKEN_ACCESS = re.compile(
    r"(read[ -]?only|read[ /]*(?:and |& )?write|write[ -]?only|R/W|RO|RW|WO|[RW](?=$))(?=$|\s*[,;.)(])", re.IGNORECASE
)
"""The access at the beginning of a description."""

_STATE = re.compile(r"(NaN 0x[0-9A-F]+|-?[0-9]+(?:\.\.-?[0-9]+)?) ([a-z0-9_]+)")
_END_OF_TYPE = re.compile(r"(0x[0-9a-f]{2,16}|-?[0-9]{3,20})\s*(?:=|:|->|→)\s*([^=:;,]{2,40})", re.IGNORECASE)


def spoken_access(described: Sequence[str]) -> str:
    """The access at the beginning of one of the descriptions; empty if none has it."""
    phrases = [phrase for text in described if (phrase := _SPOKEN_ACCESS.match(text))]
    return access(phrases[0][1]) if phrases else ""


def states_at_ends(own_type: Typed | None, described: Sequence[str]) -> tuple[tuple[str, str], ...]:
    """The states in descriptions, `0x7FFF = no sensor`, at the ends of the type: others may be in the unit."""
    size = 8 * PRIMITIVES[own_type.name].size if own_type is not None and own_type.name else 0
    if own_type is None or not size or not is_count(PRIMITIVES[own_type.name].encoding):
        return ()
    ends = {(1 << size) - 1, 1 << (size - 1), (1 << (size - 1)) - 1}
    states = {}
    for phrase in filter(None, map(_END_OF_TYPE.fullmatch, described)):
        count = int(phrase[1], 0) % (1 << size)
        if count in ends and abs(int(phrase[1], 0)) < 1 << size and (name := snake(phrase[2].casefold())):
            is_negative = is_signed(PRIMITIVES[own_type.name].encoding) and count >= 1 << (size - 1)
            states[count - (1 << size) if is_negative else count] = name
    return tuple((str(number), name) for number, name in states.items())


def special_states(texts: Mapping[str, str], doubts: list[str]) -> tuple[tuple[str, str], ...]:
    """The states of a column of special values."""
    text = texts.get("special", "")
    states = [_STATE.fullmatch(part.strip()) for part in text.split(";") if part.strip()]
    if not all(states):
        doubts.append(f"Special values in the list: {text}.")
    return tuple((state[1], state[2]) for state in states if state)
