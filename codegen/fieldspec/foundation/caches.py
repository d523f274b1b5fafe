"""Caches by the identity of objects in memory.

Versions of a device share the objects that do not differ. Two objects may be equal and still belong to different places
of a spec, and comparing large ones takes longer than computing again; so the result computed from an object is stored
by its identity.
"""

from __future__ import annotations

from fieldspec.foundation.classes import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Any, Generic, TypeVar

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

    The cache keeps its keys alive: as long as an object is there, no other one gets its identity. With a `limit`, only
    that number of the newest entries stays.
    """

    __slots__ = ("_entries", "_most")

    def __init__(self, limit: int | None = None) -> None:
        self._entries: dict[int, tuple[Key, Value]] = {}
        self._most = limit

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


class ObjectsKey:
    """A key of several objects. It equals another one that has the same objects in the same order.

    Like `ByIdentity`, it keeps the objects alive.
    """

    __slots__ = ("_identities", "objects")

    def __init__(self, objects: Iterable[Any]) -> None:
        self.objects = tuple(objects)
        self._identities = tuple(map(id, self.objects))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ObjectsKey) and self._identities == other._identities

    def __hash__(self) -> int:
        return hash(self._identities)
