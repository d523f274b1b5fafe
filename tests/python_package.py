"""The Python output of all specs, built and imported as a package in a temporary folder, and helpers for its objects.

The package has another name here, so that it does not hide the committed one.
"""

from __future__ import annotations

import importlib
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.reference import CodecError
from fieldspec.foundation.names import Name
from fieldspec.language.model.encoding import is_exact
from fieldspec.targets.python.backend import PACKAGE, files, shared
from fieldspec.targets.python.naming import module_name, package_name
from layouts import SPECS, TEST_SPECS, layouts
from shared_results import shared as shared_by_all

NAME = "made_devices"
_FOLDER = tempfile.TemporaryDirectory(prefix="fieldspec-python-")


def texts(name: str = PACKAGE) -> dict[str, str]:
    """The files of the output for all specs, the real and the made-up ones, in a package with a name."""
    outputs = shared_by_all("python_package", _texts)
    return {path.replace(PACKAGE, name, 1): text for path, text in outputs.items()}


def _texts() -> dict[str, str]:
    outputs = shared()
    for root in (SPECS, TEST_SPECS):
        for versions in layouts(root).values():
            outputs |= files(versions)
    return outputs


def write(folder: Path, texts: Mapping[str, str]) -> None:
    """Writes files below a folder."""
    for path, text in texts.items():
        place = folder / path
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, encoding="utf-8", newline="\n")


@cache
def package() -> ModuleType:
    """The package with all devices."""
    write(Path(_FOLDER.name), texts(NAME))
    sys.path.insert(0, _FOLDER.name)
    return importlib.import_module(NAME)


def runtime(name: str) -> ModuleType:
    """One of the modules that all devices share."""
    return importlib.import_module(f"{package().__name__}.{name}")


def module_of(layout: DeviceLayout) -> ModuleType:
    """The module of a device's version."""
    device = package_name(layout.device.id)
    return importlib.import_module(f"{package().__name__}.{device}.{module_name(layout.device.version)}")


def module_apart(layout: DeviceLayout, name: str) -> ModuleType:
    """The module of a layout that is in no spec, in a subpackage with a name of its own."""
    module = module_name(layout.device.version)
    outputs = files([layout])
    text = outputs[f"{PACKAGE}/{package_name(layout.device.id)}/{module}.py"]
    folder = f"{package().__name__}/{name}"
    write(Path(_FOLDER.name), {f"{folder}/__init__.py": "", f"{folder}/{module}.py": text})
    importlib.invalidate_caches()
    return importlib.import_module(f"{package().__name__}.{name}.{module}")


def codec_error() -> type[Any]:
    """The exception of the output."""
    error: type[Any] = package().CodecError
    return error


def class_of(module: ModuleType, name: str, *suffixes: str) -> Any:
    """The class of a record, of a message's data, or of a word of flags."""
    pascal = Name.of(name).pascal()
    class_name = next(pascal + suffix for suffix in ("", *suffixes) if pascal + suffix in module.__all__)
    return getattr(module, class_name)


def record_class(module: ModuleType, record: RecordLayout) -> Any:
    """The class of a record or of a message's data."""
    return class_of(module, record.name, "Record", "Message")


def link_of(module: ModuleType, name: str) -> Any:
    """The object of a link."""
    return getattr(module, name if name in module.__all__ else f"{name}_")


def stored(record: RecordLayout) -> Iterator[FieldLayout]:
    """The fields that are attributes: all but constants, measures and reserved ones."""
    for field in record.sent_fields:
        number = field.value is not None and is_exact(field.value.encoding)
        if not (
            field.field.reserved or field.field.measures or (number and field.value and field.value.const is not None)
        ):
            yield field


def built(module: ModuleType, layout: DeviceLayout, record: RecordLayout, values: Mapping[str, Any]) -> Any:
    """The object with some raw values."""
    by = record.selector
    chosen = record.decided_by(values)
    fields = chosen.fields
    arguments = {
        field.name: _attribute(module, layout, field, values[field.name]) for field in fields if field.name in values
    }
    if by is not None and chosen.fields[-1].is_list:
        arguments[chosen.fields[-1].name] = tuple(arguments[chosen.fields[-1].name])
    chosen_class = record_class(module, record)
    names = zip(chosen_class.__match_args__, stored(record), strict=True)
    return chosen_class(**{name: arguments[field.name] for name, field in names})


def _attribute(module: ModuleType, layout: DeviceLayout, field: FieldLayout, value: Any) -> Any:
    if field.is_list:
        return [_element(module, layout, field, item) for item in value]
    return _element(module, layout, field, value)


def _element(module: ModuleType, layout: DeviceLayout, field: FieldLayout, value: Any) -> Any:
    if field.record is not None:
        return built(module, layout, field.record, value)
    if field.value is not None and field.value.flags:
        return class_of(module, field.value.flags, "Flags")(value)
    return value


def raw(value: Any) -> Any:
    """A value as the reference has it: numbers, texts, bytes, lists."""
    if isinstance(value, package().Flags):
        return value.raw
    if isinstance(value, list | tuple):
        return [raw(item) for item in value]
    return int(value) if isinstance(value, int) and not isinstance(value, bool) else value


def raws(message: Any, record: RecordLayout) -> dict[str, Any]:
    """The raw values of an object by the names of the spec."""
    values: dict[str, Any] = {}
    for field, name in zip(stored(record), message.__match_args__, strict=True):
        attribute = getattr(message, name)
        if field.record is None:
            values[field.name] = raw(attribute)
        elif field.is_list:
            values[field.name] = [raws(item, field.record) for item in attribute]
        else:
            values[field.name] = raws(attribute, field.record)
    return values


def only_stored(record: RecordLayout, values: Mapping[str, Any]) -> dict[str, Any]:
    """The values of those fields that are attributes."""
    result: dict[str, Any] = {}
    for field in stored(record):
        value = values[field.name]
        if field.record is not None:
            inner = field.record
            value = [only_stored(inner, item) for item in value] if field.is_list else only_stored(inner, value)
        result[field.name] = value
    return result


def outcome(call: Callable[[], Any]) -> tuple[str, Any]:
    """The outcome of a call of either codec: the reason and the offset of its error, or its result as a text.

    In a text, one NaN is like another. The reference leaves characters that are not ASCII to Python.
    """
    try:
        return "", repr(call())
    except (codec_error(), CodecError) as error:
        return error.reason, error.offset
    except UnicodeEncodeError:
        return "unknown_value", None
