"""A dictionary that counts its changes, so that no comparison with its old state is needed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeVar

Key = TypeVar("Key")
Value = TypeVar("Value")


class Noted(dict[Key, Value]):
    """A dictionary; `changes` is another number after everything that may have changed it.

    A single value that is set counts only under a watched key.
    """

    def __init__(self) -> None:
        super().__init__()
        self.changes = 0
        self._watched: set[Key] = set()

    def watch(self, keys: Iterable[Key]) -> None:
        """Counts changes of the values under some keys from now on."""
        self._watched.update(keys)

    def __setitem__(self, key: Key, value: Value) -> None:
        self.changes += key in self._watched and (key not in self or self[key] != value)
        super().__setitem__(key, value)

    def replace(self, content: Mapping[Key, Value]) -> None:
        """Takes other content instead of all that there is."""
        self.clear()
        self.update(content)


def _counting_changes(method: Callable[..., Any]) -> Callable[..., Any]:
    def call(noted: Noted[Any, Any], *arguments: Any, **keywords: Any) -> Any:
        noted.changes += 1
        return method(noted, *arguments, **keywords)

    return call


for _name in ("__delitem__", "__ior__", "clear", "pop", "popitem", "setdefault", "update"):
    setattr(Noted, _name, _counting_changes(getattr(dict, _name)))
