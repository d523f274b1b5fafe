"""Where a register lies."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.register import Register


@dataclass(frozen=True, slots=True)
class RegisterLayout:
    """A register: addresses and words; `order` and `swapped` as in a field."""

    register: Register
    name: str
    address: int
    words: int
    count: int
    stride: int
    order: str
    swapped: bool
