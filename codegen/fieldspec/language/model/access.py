"""Access to a value: `ro`, `rw`, `wo`, or empty where the manual does not state it."""

from __future__ import annotations

_READS, _WRITES = ("ro", "rw"), ("wo", "rw")


def readable(access: str) -> bool:
    """Whether the manual says that a value with this access can be read."""
    return access in _READS


def writable(access: str) -> bool:
    """Whether the manual says that a value with this access can be written."""
    return access in _WRITES


def narrowed(container: str, inner: str) -> str:
    """The access that a container and its content both allow. Where one of them is empty, the other one applies.

    Empty where nothing is left: a rule refuses `ro` within `wo`, and the reverse.
    """
    if not container or not inner:
        return container or inner
    reads = readable(container) and readable(inner)
    writes = writable(container) and writable(inner)
    return ("rw" if writes else "ro") if reads else "wo" if writes else ""
