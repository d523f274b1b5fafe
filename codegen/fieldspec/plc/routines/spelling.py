"""How a dialect writes statements: rows of facts."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.classes import dataclass, field
from fieldspec.plc.routines.routine import SECTIONS


@dataclass(frozen=True, slots=True)
class Spelling:
    """What differs between dialects where a routine is written.

    `variable` and `routine` hold a name, `shift` holds the function, the value and the number of bits. `member` holds
    an enum, a member and its number; where `enums` is false, the dialect has none, and a variable has the type of the
    numbers. `struct` holds the name of a declared type. `sections` are the words for the roles of variables.
    """

    variable: str = "{}"
    routine: str = "{}"
    shift: str = "{}({}, {})"
    member: str = "{0}.{1}"
    struct: str = "{}"
    enums: bool = True
    sections: Mapping[str, str] = field(default_factory=lambda: SECTIONS)
    head: str = "FUNCTION {} : {}"
    begin: str = ""
    end: str = "END_FUNCTION"
    attributes: tuple[str, ...] = ()


STRUCTURED_TEXT = Spelling()
SCL = Spelling(
    variable="#{}",
    routine='"{}"',
    shift="{}(IN := {}, N := {})",
    member="{2}",
    struct='"{}"',
    enums=False,
    sections={
        "input": "VAR_INPUT",
        "output": "VAR_OUTPUT",
        "in_out": "VAR_IN_OUT",
        "local": "VAR_TEMP",
    },
    head="FUNCTION {} : {}",
    begin="BEGIN",
    attributes=("{ S7_Optimized_Access := 'TRUE' }", "VERSION : 0.1"),
)
