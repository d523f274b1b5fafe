"""Layouts of devices without errors, cached from one call to the next, so that a spec is judged once.

The key is a hash of the compiler, of the requested device and version, and of every byte of the spec files. A layout is
stored as lines of JSON, and an object is rebuilt when it is first accessed.
"""

from __future__ import annotations

import json
from enum import Enum
from importlib import import_module

from fieldspec.command.files import cache_folder
from fieldspec.command.sources import spec_files
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import TYPE_CHECKING, attributes
from fieldspec.foundation.source import SourceFile, Span

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable
    from typing import Any, TypeAlias

    from fieldspec.codec.layout.device import DeviceLayout

    Index: TypeAlias = tuple[list[list[str]], dict[str, list[str]]]

KIND = "devices"
INDEXES = "indexes"
MARK = b"\xef\xbb\xbf"
"""The byte order mark that some editors write before UTF-8."""


def requested_layout(arguments: argparse.Namespace) -> DeviceLayout:
    """The layout of the device that the arguments of a verb name. Raises UsageError."""
    return layout(arguments.specs, arguments.device, arguments.no_cache)


def layout(specs_option: str | None, text: str, anew: bool = False) -> DeviceLayout:
    """The layout of `DEVICE` or `DEVICE@VERSION`. With `anew`, the cache is not used. Raises UsageError."""
    name, version = spec_files.split(text)
    path, files = _files(specs_option, name)
    folder = spec_files.relative_path(path)
    origins = spec_files.origins(files)

    def source(path: str) -> SourceFile:
        display_path = origins.get(path) or (f"{folder}/{path}" if folder else path)
        return SourceFile(display_path, files[path].removeprefix(MARK).decode())

    key = "" if anew else spec_files.entry_key(text, files)
    content = cache_folder.cached(KIND, key) if key else None
    if content is not None:
        try:
            cached_layout: DeviceLayout = from_json(content, source)
            return cached_layout
        except ValueError:
            pass  # another program has written it
    content, depends_on_packages = _compiled(name, version, files, spec_files.entry_key(name, files) if key else "")
    if key and not depends_on_packages:
        cache_folder.store(KIND, key, content)
    new_layout: DeviceLayout = from_json(content, source)
    return new_layout


def index(specs_option: str | None, text: str, anew: bool, names: Callable[[], list[list[str]]]) -> Index:
    """The `names` of the items of `DEVICE` or `DEVICE@VERSION`, and the paths of what refers to each fact, by its path.

    They select the objects of a layout before any is rebuilt. Raises UsageError.
    """
    name, version = spec_files.split(text)
    _, files = _files(specs_option, name)
    key = "" if anew else spec_files.entry_key(text, files)
    content = cache_folder.cached(INDEXES, key) if key else None
    if content is None:
        from fieldspec.command.sources.specs import picked
        from fieldspec.language.reading.project import read
        from fieldspec.language.reading.references import used_by

        spec = read(files, frozenset([name])).devices[name]
        content = json.dumps([names(), used_by(spec.tree_at(picked(spec, version)))]).encode()
        if key:
            cache_folder.store(INDEXES, key, content)
    item_names, users = json.loads(content)
    return item_names, users


def _files(specs_option: str | None, device: str) -> tuple[str, dict[str, bytes]]:
    """The folder of the specs, and the files that a device is read from. Raises UsageError."""
    path, contents = spec_files.of_devices(specs_option, frozenset([device]))
    return path, {name: content for name, content in contents.items() if not name.endswith(f"/{spec_files.INDEX}")}


def _compiled(name: str, version: str, files: dict[str, bytes], key: str) -> tuple[bytes, bool]:
    """The layout of a device as lines of JSON, and whether packages decide what it is. Raises UsageError.

    The `key` is that of the verdict on the device.

    They do where checks of theirs have judged the spec, and where it names a codec: the key says nothing of these.
    """
    from fieldspec.codec.layout.package_codecs import coded_facts
    from fieldspec.command.sources.layout_cache import to_json
    from fieldspec.command.sources.specs import layout_of, picked, sound
    from fieldspec.language.checks.table import INSTALLED
    from fieldspec.language.reading.project import read

    spec = sound(read(files, frozenset([name])), name, key)
    layout = layout_of(spec, picked(spec, version))
    return to_json(layout), bool(INSTALLED) or any(True for _ in coded_facts(layout))


_NODES = "fieldspec.language.reading.nodes"
HOMES = ("fieldspec.language.model.", "fieldspec.codec.layout.", "fieldspec.foundation.names:")
"""The modules that the classes of a layout may come from."""


def to_json(root: object) -> bytes:
    """An object, and all objects in it, as lines of JSON after their seal. Only the paths of source
    files are stored.
    """
    lines = _Freezing().lines(root)
    return _seal(lines) + b"\n" + lines


def _seal(lines: bytes) -> bytes:
    """The prefix that only `to_json` writes before lines, so that each line has the right shape when it is read."""
    return cache_folder.checksum(b"layout", lines).encode()


def from_json(content: bytes, source: Callable[[str], SourceFile]) -> Any:
    """The object that `to_json` stored. `source` returns the source file with a path.

    Raises ValueError for other content, and for a class that does not belong to a layout.
    """
    seal, _, sealed_lines = content.partition(b"\n")
    if seal != _seal(sealed_lines):
        raise ValueError("the lines are not a layout")
    head, *lines = sealed_lines.decode().split("\n")
    classes, files = _parse_line(head)
    if not all(name.startswith(HOMES) for name in classes):
        raise ValueError("the classes do not belong to a layout")
    return _Thawing(classes, files, lines, source).object(0, len(lines) - 1)


class _Freezing:
    """Writes the parts of an object before the object itself. The class of the root has the number 0."""

    def __init__(self) -> None:
        self.classes: dict[type, int] = {}
        self.files: dict[str, int] = {}
        self.numbers: ByIdentity[object, int] = ByIdentity()
        self.written: list[str] = []

    def lines(self, root: object) -> bytes:
        self.classes[root.__class__] = 0
        self.value(root)
        names = [f"{cls.__module__}:{cls.__qualname__}" for cls in self.classes]
        return "\n".join([_json([names, [*self.files]]), *self.written]).encode()

    def value(self, value: Any) -> object:
        kind = value.__class__
        if value is None or kind in (bool, int, float, str):
            return value
        if kind in (tuple, list, frozenset):
            return [kind.__name__, *map(self.value, value)]
        if kind is dict:
            return ["dict", *(self.value(element) for pair in value.items() for element in pair)]
        if kind is bytes:
            return ["bytes", value.hex()]
        if kind is range:
            return ["range", value.start, value.stop, value.step]
        # The most frequent objects, each used once: a line for each would be too much. Of nodes, only the span matters.
        if kind is Span or kind.__module__ == _NODES:
            return ["span", self.files.setdefault(value.file.path, len(self.files)), value.start, value.end]
        if isinstance(value, Enum):
            return ["enum", self.class_number(kind), value.name]
        if kind.__name__ in ("Decimal", "Fraction"):
            return [kind.__name__.lower(), str(value)]
        return [self.class_number(kind), self.line_number(value)]

    def class_number(self, cls: type) -> int:
        return self.classes.setdefault(cls, len(self.classes))

    def line_number(self, instance: object) -> int:
        return self.numbers.get_or_compute(instance, self.write_line)

    def write_line(self, instance: object) -> int:
        """Writes the line of an object after the lines of the objects in it, and returns its number."""
        self.written.append(_json([self.value(getattr(instance, name)) for name in attributes(instance.__class__)]))
        return len(self.written) - 1


_json = json.JSONEncoder(ensure_ascii=False, separators=(",", ":")).encode
_scan = json.JSONDecoder().scan_once  # type: ignore[attr-defined]


def _parse_line(line: str) -> list[Any]:
    values: list[Any] = _scan(line, 0)[0]
    return values


class _Thawing:
    """Makes objects by the numbers of their lines, each only once.

    At first an object has no attributes; a class of its own reads them from its line when one is accessed. Its
    `__class__` is the final class from the start.
    """

    def __init__(
        self, names: list[str], paths: list[str], lines: list[str], source: Callable[[str], SourceFile]
    ) -> None:
        self.names, self.paths, self.lines, self.source = names, paths, lines, source
        self.objects: dict[int, object] = {}
        self.numbers: ByIdentity[object, int] = ByIdentity()
        self.waiting: dict[int, type] = {}
        self.files: dict[str, SourceFile] = {}

    def object(self, cls: int, number: int) -> object:
        instance = self.objects.get(number)
        if instance is None:
            waiting = self.waiting.get(cls) or self.waits(cls)
            instance = self.objects[number] = object.__new__(waiting)
            self.numbers[instance] = number
        return instance

    def cls(self, number: int) -> Any:
        """The class of data, or the enum, whose name has a number."""
        module, _, name = self.names[number].partition(":")
        return getattr(import_module(module), name)

    def waits(self, number: int) -> type:
        """The class of objects whose attributes have not been read yet."""
        final = self.cls(number)
        names = attributes(final)

        set_class = object.__dict__["__class__"].__set__
        puts = [getattr(final, name).__set__ for name in names]  # the class itself forbids assignment

        def fill(instance: Any) -> Any:
            for put, value in zip(puts, _parse_line(self.lines[self.numbers[instance]]), strict=True):
                put(instance, self.value(value) if value.__class__ is list else value)
            set_class(instance, final)
            return instance

        waiting = type(
            final.__name__,
            (final,),
            {
                "__slots__": (),
                "__module__": final.__module__,
                "__class__": property(lambda instance: final),
                "__getattr__": lambda instance, name: (
                    getattr(fill(instance), name) if name in names else _none(instance, name)
                ),
                "__setattr__": lambda instance, name, value: setattr(fill(instance), name, value),
                "__eq__": lambda instance, other: fill(instance) == other,
                "__hash__": lambda instance: hash(fill(instance)),
                "_replaced": staticmethod(lambda instance, **changes: final._replaced(fill(instance), **changes)),
            },
        )
        self.waiting[number] = waiting
        return waiting

    def value(self, json_value: Any) -> Any:
        if json_value.__class__ is not list:
            return json_value
        kind = json_value[0]
        return self.object(kind, json_value[1]) if kind.__class__ is int else _VALUES[kind](self, json_value[1:])

    def file(self, number: int) -> SourceFile:
        path = self.paths[number]
        if path not in self.files:
            self.files[path] = self.source(path)
        return self.files[path]

    def pairs(self, items: list[Any]) -> dict[Any, Any]:
        values = [self.value(json_value) for json_value in items]
        return dict(zip(values[::2], values[1::2], strict=True))


def _none(instance: object, name: str) -> Any:
    raise AttributeError(f"{instance.__class__.__name__} has no attribute {name}")


def _decimal(text: str) -> object:
    from decimal import Decimal

    return Decimal(text)


def _fraction(text: str) -> object:
    from fractions import Fraction

    return Fraction(text)


_VALUES: dict[str, Callable[[_Thawing, list[Any]], Any]] = {
    "tuple": lambda own, items: tuple(map(own.value, items)),
    "list": lambda own, items: [*map(own.value, items)],
    "frozenset": lambda own, items: frozenset(map(own.value, items)),
    "dict": lambda own, items: own.pairs(items),
    "bytes": lambda own, items: bytes.fromhex(items[0]),
    "range": lambda own, items: range(*items),
    "span": lambda own, items: Span(own.file(items[0]), items[1], items[2]),
    "enum": lambda own, items: own.cls(items[0])[items[1]],
    "decimal": lambda own, items: _decimal(items[0]),
    "fraction": lambda own, items: _fraction(items[0]),
}
