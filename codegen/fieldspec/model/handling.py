"""What whoever reads or writes a value must know, beside what the value means."""

from __future__ import annotations

from fieldspec.classes import dataclass


@dataclass(frozen=True, slots=True)
class Handling:
    """Which memory a value is in, what reading does to it, and which fact says the same the other way round.

    `memory` is `volatile`, `nonvolatile`, or empty where the manual does not say it. `saved_by` is the path of what
    saves a value that would be lost with the power. `endurance` is how often it may be written: a number, `limited`,
    `unlimited`, or empty. `opposite_of` is a path, empty where there is none.
    """

    memory: str = ""
    saved_by: str = ""
    endurance: str = ""
    clears_on_read: bool = False
    opposite_of: str = ""


NOTHING_SAID = Handling()
"""What is known where the manual says nothing."""
