"""What may be done with a value: `ro`, `rw` or `wo`, and an empty text where the manual does not say it."""

from __future__ import annotations

_READS, _WRITES = ("ro", "rw"), ("wo", "rw")


def readable(access: str) -> bool:
    """Whether the manual says that it can be read."""
    return access in _READS


def writable(access: str) -> bool:
    """Whether the manual says that it can be written."""
    return access in _WRITES


def narrowed(container: str, inner: str) -> str:
    """The access of what lies in a container: what both allow. Where one of them says nothing, the other holds.

    Empty where nothing is left: a check refuses `ro` within `wo`, and the other way round.
    """
    if not container or not inner:
        return container or inner
    reads = readable(container) and readable(inner)
    writes = writable(container) and writable(inner)
    return ("rw" if writes else "ro") if reads else "wo" if writes else ""
