"""Codecs of projects: numbers and checksums that the language cannot say, which installed packages give.

A spec names a codec and runs no code: `provide` says where codecs come from, and the first request for a name loads
them. Each has the texts that outputs print; the compiler itself runs the texts in Python.
"""

from __future__ import annotations

from contextlib import contextmanager

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping

MOST_EXACT = (1 << 53) - 1
"""The greatest whole number up to which all are exact in every target."""


@dataclass(frozen=True, slots=True)
class NumberCodec:
    """Whole numbers from `low` to `high` as `size` bytes, in the order of the wire. `version` says what they mean.

    `python` is the text of a module with `decode(data)`, the number of some bytes or None, and `encode(number)`. Other
    texts define the same, or are empty: `c` has `bool device_NAME_decode(const uint8_t *in, int64_t *number)` and
    `void device_NAME_encode(int64_t number, uint8_t *out)`, and all in it is static inline; `javascript` has functions
    `decode` of a Uint8Array, whose result is a number or null, and `encode`, whose result is an array. With `rounds`,
    not every number has bytes, and `encode` gives the bytes of a number near it.
    """

    version: str
    size: int
    low: int
    high: int
    python: str
    c: str = ""
    javascript: str = ""
    rounds: bool = False


@dataclass(frozen=True, slots=True)
class ChecksumCodec:
    """A checksum of `size` bytes. `version` says what it is.

    `python` is the text of a module with `checksum(data)`, a number. Other texts define the same, or are empty: `c` has
    `uint16_t device_NAME_checksum(const uint8_t *in, size_t size)` or the type of its size, and all in it is static
    inline; `javascript` has a function `checksum` of a Uint8Array, whose result is a number, or a bigint where it has
    more than four bytes.
    """

    version: str
    size: int
    python: str
    c: str = ""
    javascript: str = ""


Codec = NumberCodec | ChecksumCodec
"""The codec that a package gives under a name."""


@dataclass(frozen=True, slots=True)
class InstalledCodec:
    """A codec, the functions of its Python by their names, and what is wrong with it, empty for nothing."""

    codec: Codec
    functions: Mapping[str, Callable[..., object]]
    fault: str = ""


_installed: dict[str, InstalledCodec] = {}
_sources: list[Callable[[], Mapping[str, InstalledCodec]]] = []
_used: list[set[str]] = []


def provide(source: Callable[[], Mapping[str, InstalledCodec]]) -> None:
    """Sets the source of the codecs, and forgets the codecs of earlier sources."""
    _sources[:] = [source]
    _installed.clear()


def installed() -> Mapping[str, InstalledCodec]:
    """All codecs by name."""
    if _sources:
        _installed.update(_sources.pop()())
    return _installed


def are_loaded() -> bool:
    """Whether a spec has named one, so that packages which may change decide what it says."""
    return bool(_installed)


def number_codec(name: str) -> NumberCodec:
    """The codec of a number, which reading has found."""
    codec = installed()[name].codec
    assert isinstance(codec, NumberCodec)
    return codec


def checksum_codec(name: str) -> ChecksumCodec:
    """The codec of a checksum, which reading has found."""
    codec = installed()[name].codec
    assert isinstance(codec, ChecksumCodec)
    return codec


@contextmanager
def uses() -> Iterator[set[str]]:
    """The names of the codecs that run meanwhile."""
    names: set[str] = set()
    _used.append(names)
    try:
        yield names
    finally:
        _used.remove(names)


def _function(name: str, function: str) -> Callable[..., object]:
    for names in _used:
        names.add(name)
    return installed()[name].functions[function]


def decoded(name: str, data: bytes) -> int | None:
    """The number that bytes encode; None for invalid bytes."""
    codec, number = number_codec(name), _function(name, "decode")(data)
    return number if isinstance(number, int) and codec.low <= number <= codec.high else None


def encoded(name: str, number: int) -> bytes:
    """The bytes of a number from `low` to `high`."""
    data = _function(name, "encode")(number)
    assert isinstance(data, bytes)
    return data


def computed(name: str, data: bytes) -> int:
    """The checksum of some bytes."""
    number = _function(name, "checksum")(data)
    assert isinstance(number, int)
    return number
