"""Values that are stated once and lie in several messages, and what counts of them are a share of."""

from __future__ import annotations

from fieldspec.classes import TYPE_CHECKING, dataclass
from fieldspec.model.fact import Fact
from fieldspec.model.primitive import Primitive
from fieldspec.model.value import Value

if TYPE_CHECKING:
    from fractions import Fraction


@dataclass(frozen=True, slots=True, kw_only=True)
class Signal(Fact):
    """A value that fields of messages place. `direction` is request or response, empty where it is not printed."""

    value: Value
    direction: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Conversion(Fact):
    """quantity = reference * raw / full_scale; with `complement`, reference * (1 - raw / full_scale).

    `signals` are those for which it holds, `type` is that of the raw value, and `references` are the paths of the
    facts that hold the reference. `printed` is the formula as printed.
    """

    title: str
    signals: tuple[str, ...]
    type: Primitive
    full_scale: int
    complement: bool
    references: tuple[str, ...]
    printed: str

    def quantity(self, raw: int, reference: Fraction) -> Fraction:
        """The quantity that a count stands for."""
        share = reference * raw / self.full_scale
        return reference - share if self.complement else share
