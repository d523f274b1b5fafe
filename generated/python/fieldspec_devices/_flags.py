"""Words whose bits have names."""

from __future__ import annotations

from operator import index

from ._conversions import counts
from ._error import CodecError
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Any, ClassVar, Final

    from ._typing import Quantity


def _bits() -> tuple[tuple[bool, ...], ...]:
    patterns: list[tuple[bool, ...]] = [()]
    for _ in range(8):
        patterns = [(*bits, value) for value in (False, True) for bits in patterns]
    return tuple(patterns)


BITS_OF = _bits()
"""The bits of each byte, the least significant first."""


class Flags:
    """A word with its bits as properties. Bits without a name are kept in `raw`.

    Arguments by name set bits of `raw`; fields of several bits take numbers, or by their name in the unit a
    quantity, which becomes the nearest count. Raises CodecError where a number does not fit its bits. An `IntFlag`
    would keep every value that it ever saw, and take several times as long.
    """

    __slots__ = ("raw",)
    _BITS: ClassVar[dict[str, tuple[int, int]]] = {}
    _RUNS: ClassVar[dict[str, tuple[tuple[int, int, int], ...]]] = {}
    """For bits that are not adjacent: the first bit of each run, its greatest number, and its bit in the number."""
    _SIGNED: ClassVar[frozenset[str]] = frozenset()
    _QUANTITIES: ClassVar[dict[str, tuple[str, tuple[int, int, int]]]] = {}
    """The field of bits of each name in a unit, and (a, b, c) of quantity = (count * a + b) / c."""

    def __init__(self, raw: int = 0, **bits: Quantity) -> None:
        self.raw: Final = self._changed(raw, bits) if bits else raw

    def _changed(self, raw: int, bits: dict[str, Any]) -> int:
        for argument, value in bits.items():
            name, ratio = self._QUANTITIES.get(argument, (argument, None))
            if name not in self._BITS:
                raise TypeError(f"{self.__class__.__name__} has no bit {name}")
            if ratio is not None and name in bits:
                raise TypeError(f"{self.__class__.__name__}() takes only one of {name!r} or {argument!r}")
            first, maximum = self._BITS[name]
            low, high = (~(maximum >> 1), maximum >> 1) if name in self._SIGNED else (0, maximum)
            count = index(value) if ratio is None else counts(name, value, ratio, ((low, high),))
            if not low <= count <= high:
                raise CodecError("out_of_range", f"{name} is {count}, not in {low}..{high}")
            for place, ones, weight in self._RUNS.get(name, ((first, maximum, 0),)):
                raw = raw & ~(ones << place) | (count >> weight & ones) << place
        return raw

    def __int__(self) -> int:
        return self.raw

    def __index__(self) -> int:
        return self.raw

    def __eq__(self, other: object) -> bool:
        if other.__class__ is self.__class__ and isinstance(other, Flags):
            return self.raw == other.raw
        return NotImplemented

    def __hash__(self) -> int:
        return hash((self.__class__, self.raw))

    def __repr__(self) -> str:
        texts = [name if value is True else f"{name}={int(value)}" for name, value in self.flags().items() if value]
        return f"<{self.__class__.__name__} {self.raw:#x}: {', '.join(texts) or 'none'}>"

    def flags(self) -> dict[str, bool | int]:
        """All bits and fields by name."""
        raise NotImplementedError


class PresetFlags(Flags):
    """A word with bits that are not simply 0 where they are left out.

    Without `raw` it begins as `_INITIAL`, which has the defaults. `_NEEDED` has the fields of bits that have to be
    given then, with the reason and the arguments of which any gives it. Raises CodecError where none does.
    """

    __slots__ = ()
    _INITIAL: ClassVar[int] = 0
    _NEEDED: ClassVar[dict[str, tuple[str, tuple[str, ...]]]] = {}

    def __init__(self, raw: int | None = None, **bits: Quantity) -> None:
        if raw is None:
            raw = self._INITIAL
            for name, (reason, names) in self._NEEDED.items():
                if not any(argument in bits for argument in names):
                    text = f"{name} of {self.__class__.__name__} is not given, and its {reason}"
                    raise CodecError("missing_value", text)
        super().__init__(raw, **bits)
