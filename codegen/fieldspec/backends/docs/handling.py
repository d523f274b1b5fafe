"""What whoever reads or writes a value must know, for the pages."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.docs.document import Line, code, plain, styled
from fieldspec.model.handling import NOTHING_SAID, Handling

_MEMORY = {"volatile": " It is lost with the power.", "nonvolatile": " It is kept without power."}
_ENDURANCE = {
    "limited": "It may be written a limited number of times, which is not printed.",
    "unlimited": "It may be written as often as one likes.",
}


def handled(said: Handling) -> Iterator[Line]:
    """A line for each thing that is said; none for most values."""
    if said == NOTHING_SAID:
        return
    if said.clears_on_read:
        yield (styled("cleared by reading", "badge"), plain(" Only the first reader gets it."))
    if said.memory:
        yield (styled(said.memory, "badge"), plain(_MEMORY[said.memory]))
    if said.saved_by:
        yield (plain("Saved by "), code(said.saved_by, f"#{said.saved_by}"))
    if said.endurance:
        yield (plain(_ENDURANCE.get(said.endurance, f"It may be written {said.endurance} times.")),)
    if said.opposite_of:
        yield (plain("The opposite sense of "), code(said.opposite_of, f"#{said.opposite_of}"))
