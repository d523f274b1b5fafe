"""Caches by the identity of objects in memory.

Versions of a device share the objects that do not differ. Two objects may be equal and still belong to different places
of a spec, and comparing large ones takes longer than computing anew; so what is computed from an object is stored by
its identity.
"""

from __future__ import annotations

from fieldspec.classes import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Generic, TypeVar

    Key = TypeVar("Key")
    Value = TypeVar("Value")
else:
    Key = Value = None

    class Generic:
        """Stands in for `typing.Generic`, whose import takes longer than many verbs run."""

        __slots__ = ()

        def __class_getitem__(cls, _):
            return cls


class ByIdentity(Generic[Key, Value]):
    """Values by objects, where only the same object is the same key.

    The cache keeps its keys alive: as long as an object is there, no other one gets its identity. With `most`, only so
    many of the newest entries stay.
    """

    __slots__ = ("_entries", "_most")

    def __init__(self, most: int | None = None) -> None:
        self._entries: dict[int, tuple[Key, Value]] = {}
        self._most = most

    def __contains__(self, key: Key) -> bool:
        return id(key) in self._entries

    def __getitem__(self, key: Key) -> Value:
        """The value of an object. Raises KeyError where there is none."""
        return self._entries[id(key)][1]

    def __setitem__(self, key: Key, value: Value) -> None:
        if id(key) not in self._entries and len(self._entries) == self._most:
            del self._entries[next(iter(self._entries))]
        self._entries[id(key)] = key, value

    def get_or_compute(self, key: Key, compute: Callable[[Key], Value]) -> Value:
        """The value of an object; what `compute` gives for it is stored where there is none."""
        entry = self._entries.get(id(key))
        if entry is None:
            self[key] = value = compute(key)
            return value
        return entry[1]
