"""A dictionary that counts its changes, so that no comparison with its old state is needed."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, TypeVar

Key = TypeVar("Key")
Value = TypeVar("Value")


class Noted(dict[Key, Value]):
    """A dictionary; `changes` is another number after everything that may have changed it."""

    def __init__(self) -> None:
        super().__init__()
        self.changes = 0

    def __setitem__(self, key: Key, value: Value) -> None:
        self.changes += key not in self or self[key] != value
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
