"""The operations of programs: a closed set. They are in the order of the wire, and in that in which codecs refuse.

Places and offsets count from where the value, the element or the record begins that a program is about.
"""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.accepted import Condition
from fieldspec.codec.layout.inner_lists import InnerLists
from fieldspec.codec.layout.packing import Packing
from fieldspec.codec.layout.record import FieldLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.value import Value

Places = tuple[int, ...]
"""The bytes of a value, the most significant first; of a text and of bytes, in the order of characters and bytes."""


@dataclass(frozen=True, slots=True)
class Variable:
    """A variable for content: a value, which is neither checked nor named if it `is_reserved`.

    `field` is None for what is not a field. `exponent` is the field of the same record with the exponent of its scale;
    empty where no field has it.
    """

    name: str
    field: FieldLayout | None
    value: Value
    is_reserved: bool
    exponent: str = ""


@dataclass(frozen=True, slots=True)
class Load:
    """The content of a variable, a number, a text or bytes, from its places."""

    variable: Variable
    places: Places


@dataclass(frozen=True, slots=True)
class LoadPacked:
    """The content of a variable that is an element of a packed list, from the bytes with bits of it."""

    variable: Variable
    packing: Packing


@dataclass(frozen=True, slots=True)
class LoadVarying:
    """The content of a variable that varies in width, from all bytes up to the end."""

    variable: Variable


@dataclass(frozen=True, slots=True)
class Require:
    """Refuses the last content where it does not meet a condition."""

    condition: Condition


@dataclass(frozen=True, slots=True)
class Remark:
    """Says of the last content that it does not meet a condition; readers let it pass."""

    condition: Condition


@dataclass(frozen=True, slots=True)
class Inner:
    """A record as the content of a field; `lists` determine the offsets in a record that differs in size."""

    name: str
    program: Program
    lists: InnerLists | None = None


@dataclass(frozen=True, slots=True)
class Each:
    """The elements of a field of a record: one, or if it `is_list`, a counted number or all that fit.

    `size` is the size of each element in bytes, which packed numbers have in programs alone.
    """

    name: str
    size: int
    count: int | None
    is_list: bool
    element: Program
    packing: Packing | None = None


@dataclass(frozen=True, slots=True)
class Decided:
    """The one of several programs for a field that the number of another field of its record, `by`, decides.

    With a `mask`, these bits of the number decide.
    """

    name: str
    by: str
    forms: Mapping[int, Each]
    mask: int | None = None


Operation = Load | LoadPacked | LoadVarying | Require | Remark | Inner | Each | Decided
"""The operations of programs."""

Program = tuple[Operation, ...]
"""What reading some bytes is."""
