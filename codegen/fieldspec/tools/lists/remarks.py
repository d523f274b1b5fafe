"""The facts that the remarks and the descriptions of a row have: its access, and states at the ends of its type."""

from __future__ import annotations

import re
from collections.abc import Sequence

from fieldspec.language.model.encoding import is_count, is_signed
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.tools.lists.cells import access
from fieldspec.tools.lists.naming import snake
from fieldspec.tools.lists.type_words import Typed

_SPOKEN_ACCESS = re.compile(
    r"(read[ -]?only|read[ /]*(?:and |& )?write|write[ -]?only|R/W|RO|RW|WO|[RW](?=$))(?=$|\s*[,;.)(])", re.IGNORECASE
)
"""The access at the beginning of a description."""

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
