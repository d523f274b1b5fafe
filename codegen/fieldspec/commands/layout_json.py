"""A layout as lines of JSON, and back; an object is rebuilt when it is first accessed."""

from __future__ import annotations

import json
from enum import Enum
from importlib import import_module

from fieldspec.classes import TYPE_CHECKING, attributes
from fieldspec.source import SourceFile, Span

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


_NODES = "fieldspec.reading.nodes"
HOMES = ("fieldspec.model.", "fieldspec.layout.", "fieldspec.names:")
"""Where the classes of a layout come from."""


def to_json(root: object) -> bytes:
    """The lines of an object and of all that it holds. Of source files, the paths are kept alone."""
    return _Freezing().lines(root)


def from_json(content: bytes, source: Callable[[str], SourceFile]) -> Any:
    """The object that was frozen. `source` gives the files that it was read from, by their paths.

    Raises ValueError where these are no such lines, or where they name a class that no layout has.
    """
    head, *lines = content.decode().split("\n")
    classes, files = _read(head)
    if not all(name.startswith(HOMES) for name in classes):
        raise ValueError("these are no classes of a layout")
    return _Thawing(classes, files, lines, source).object(0, len(lines) - 1)


class _Freezing:
    """Writes what an object holds before the object itself. The class of the root has the number 0."""

    def __init__(self) -> None:
        self.classes: dict[type, int] = {}
        self.files: dict[str, int] = {}
        self.numbers: dict[int, int] = {}
        self.written: list[str] = []

    def lines(self, root: object) -> bytes:
        self.classes[root.__class__] = 0
        self.value(root)
        names = [f"{cls.__module__}:{cls.__qualname__}" for cls in self.classes]
        return "\n".join([_json([names, [*self.files]]), *self.written]).encode()

    def value(self, held: Any) -> object:
        kind = held.__class__
        if held is None or kind in (bool, int, str):
            return held
        if kind in (tuple, list, frozenset):
            return [kind.__name__, *map(self.value, held)]
        if kind is dict:
            return ["dict", *(self.value(one) for pair in held.items() for one in pair)]
        if kind is bytes:
            return ["bytes", held.hex()]
        # Most of all objects, and each of them in one place: a line would be too much. Of nodes, nothing else counts.
        if kind is Span or kind.__module__ == _NODES:
            return ["span", self.files.setdefault(held.file.path, len(self.files)), held.start, held.end]
        if isinstance(held, Enum):
            return ["enum", self.class_number(kind), held.name]
        if kind.__name__ == "Decimal":
            return ["decimal", str(held)]
        return [self.class_number(kind), self.line_number(held)]

    def class_number(self, cls: type) -> int:
        return self.classes.setdefault(cls, len(self.classes))

    def line_number(self, held: object) -> int:
        number = self.numbers.get(id(held))
        if number is None:
            line = _json([self.value(getattr(held, name)) for name in attributes(held.__class__)])
            number = self.numbers[id(held)] = len(self.written)
            self.written.append(line)
        return number


_json = json.JSONEncoder(ensure_ascii=False, separators=(",", ":")).encode
_scan = json.JSONDecoder().scan_once  # type: ignore[attr-defined]


def _read(line: str) -> list[Any]:
    held: list[Any] = _scan(line, 0)[0]
    return held


class _Thawing:
    """Makes objects by the numbers of their lines, each of them once.

    At first an object has no attributes, and is of a class that takes them from its line when one is asked for.
    """

    def __init__(
        self, names: list[str], paths: list[str], lines: list[str], source: Callable[[str], SourceFile]
    ) -> None:
        self.names, self.paths, self.lines, self.source = names, paths, lines, source
        self.objects: dict[int, object] = {}
        self.numbers: dict[int, int] = {}
        self.waiting: dict[int, type] = {}
        self.files: dict[str, SourceFile] = {}

    def object(self, cls: int, number: int) -> object:
        held = self.objects.get(number)
        if held is None:
            waiting = self.waiting.get(cls) or self.waits(cls)
            held = self.objects[number] = object.__new__(waiting)
            self.numbers[id(held)] = number
        return held

    def cls(self, number: int) -> Any:
        """A class of data, or an enum."""
        module, _, name = self.names[number].partition(":")
        return getattr(import_module(module), name)

    def waits(self, number: int) -> type:
        """The class of objects that have no attributes yet."""
        final = self.cls(number)
        names = attributes(final)

        puts = [getattr(final, name).__set__ for name in names]  # past what forbids to set them

        def fill(held: Any) -> Any:
            for put, value in zip(puts, _read(self.lines[self.numbers[id(held)]]), strict=True):
                put(held, self.value(value) if value.__class__ is list else value)
            object.__setattr__(held, "__class__", final)
            return held

        made = type(
            final.__name__,
            (final,),
            {
                "__slots__": (),
                "__module__": final.__module__,
                "__getattr__": lambda held, name: getattr(fill(held), name) if name in names else _none(held, name),
                "__setattr__": lambda held, name, value: setattr(fill(held), name, value),
                "__eq__": lambda held, other: fill(held) == other,
                "__hash__": lambda held: hash(fill(held)),
                "_replaced": staticmethod(lambda held, **changes: final._replaced(fill(held), **changes)),
            },
        )
        self.waiting[number] = made
        return made

    def value(self, held: Any) -> Any:
        if held.__class__ is not list:
            return held
        kind = held[0]
        return self.object(kind, held[1]) if kind.__class__ is int else _VALUES[kind](self, held[1:])

    def file(self, number: int) -> SourceFile:
        path = self.paths[number]
        if path not in self.files:
            self.files[path] = self.source(path)
        return self.files[path]

    def pairs(self, held: list[Any]) -> dict[Any, Any]:
        values = [self.value(one) for one in held]
        return dict(zip(values[::2], values[1::2], strict=True))


def _none(held: object, name: str) -> Any:
    raise AttributeError(f"{held.__class__.__name__} has no attribute {name}")


def _decimal(text: str) -> object:
    from decimal import Decimal

    return Decimal(text)


_VALUES: dict[str, Callable[[_Thawing, list[Any]], Any]] = {
    "tuple": lambda own, held: tuple(map(own.value, held)),
    "list": lambda own, held: [*map(own.value, held)],
    "frozenset": lambda own, held: frozenset(map(own.value, held)),
    "dict": lambda own, held: own.pairs(held),
    "bytes": lambda own, held: bytes.fromhex(held[0]),
    "span": lambda own, held: Span(own.file(held[0]), held[1], held[2]),
    "enum": lambda own, held: own.cls(held[0])[held[1]],
    "decimal": lambda own, held: _decimal(held[0]),
}
