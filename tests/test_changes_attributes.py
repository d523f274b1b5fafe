"""The diff overlooks no attribute of the model.

Every attribute of every class of the model is changed, in every kind of place where the class stands: some rule has to
notice it, or the attribute is listed here with the reason why none does.
"""

from __future__ import annotations

import dataclasses
import types
import typing
from collections.abc import Iterator, Mapping
from decimal import Decimal
from enum import Enum
from fractions import Fraction
from functools import cache
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules
from typing import Any

import pytest

import fieldspec.language.model
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.changes.table import changes
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Citation, Claim, Place, Report, Standard
from fieldspec.language.model.link import Part
from fieldspec.language.model.primitives import PRIMITIVES, Primitive
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.text_form import TextForm
from fieldspec.language.model.value import ParameterPart, Sentinel, Value
from fieldspec.language.reading.project import read
from shared_results import shared
from spec_files import gadget

TEST_SPECS = Path(__file__).parent / "specs"
SPECS = TEST_SPECS.parent.parent / "specs"

# Features that the made-up devices lack.
MORE = """
versions:
  - {line: firmware, builds: true, members: [{id: "1", source: L1}]}
registers:
  - group: all
    rows:
      - {at: 1, name: speed, type: u16, range: 0..9, source: L1, restated: [{source: L2, label: Speed, range: 0..9}]}
errata:
  - id: misprint
    fact: registers/speed
    printed: {range: 0..8}
    literal: 0-8
    reason: It goes to 9.
    confidence: certain
    effect: range
    proof: judgement
    source: L3
behaviour:
  - {name: servo, machine: ["off", "on"], source: L1}
  - name: enable
    rule: [{enter: servo, state: "on"}, {set: registers/speed, to: 1}]
    when: {write: registers/speed}
    if: {state/servo: "off", registers/speed: nonzero}
    assumed: It is always ready.
    source: L1
accepts:
  - {rule: range_widened, path: registers/speed, reason: It turns faster now., date: 2026-01-31}
"""

OVERLAY = """
overlay: {id: "2", line: firmware, based_on: "1"}
changes:
  - {fact: registers/speed, set: {range: {was: 0..9, is: 0..10}}, reason: Faster.}
"""

SAMPLES: dict[Any, Any] = {
    str: "other",
    int: 1,
    Claim: Claim(Place("", Span(SourceFile("", ""), 0, 0), {}), (), {"label": "Speed"}),
    Sentinel: Sentinel(3, "none", "", ()),
    Citation: Citation("9", ((1, 2),)),
    Report: Report(Place("", Span(SourceFile("", ""), 0, 0), {}), "A user", "Seen.", {"unit": "mm"}),
    Standard: Standard("A standard", "4.2"),
    ParameterPart: ParameterPart("servo", "value", "number"),
    TextForm: TextForm("latin_1", 0x20, False, None),
}

IGNORED = {
    "Device.id": "only versions of one device are compared",
    "Device.version": "it is what is compared",
    "Device.accepts": "it judges changes, and is none",
    "Device.stated_changes": "it gives changes their reasons, and is none",
    "Link/Escape.remote": "it is set where messages are remote requests, which are compared",
    "Part.prefix": "the algorithm that begins after it is compared",
    "Part.suffix": "the algorithm that ends after it is compared",
    "Part.stated_algorithm": "the algorithm is compared, which begins after the prefix",
    **{
        f"StatedChange.{name}": "it gives changes their reasons, and is none"
        for name in ("kind", "path", "to", "reason", "sources")
    },
    **{
        f"StatedChange/Citation.{name}": "it gives changes their reasons, and is none"
        for name in ("section", "lines", "mark")
    },
    **{f"Acceptance.{name}": "it judges changes, and is none" for name in ("rule", "path", "reason", "date", "since")},
    "RegisterGroup.space": "it is that of its registers",
    "RegisterGroup/Register.unit_size": "it is that of its space",
    "RegisterGroup.ascending": "it says how the table is checked, nothing about the device",
    "*.allowed": "it is for checks, no output shows it",
    "*.place": "a place in the spec says nothing about the device",
    "Message/Record.name": "it is made from the name of the message",
    "Message/Record.printed_name": "it is that of the message",
    "Message/Record.label": "it is that of the message",
    "Message/Record.doc": "data of messages have no text of their own",
    "Message/Record.sources": "they are those of the message",
    "Message/Record.notes": "data of messages have no text of their own",
    "Message/Record.inferred": "it is that of the message",
    "Message/Record.standard": "it is that of the message",
    "Message/Record.reported": "it is that of the message",
    "Message/Record.roles": "they are those of the message",
    "Message/Record.unverified": "it is that of the message",
    "Message/Record.restated": "data of messages have no text of their own",
    "Message/Record.since": "it is that of the message",
    "Message/Record.until": "it is that of the message",
    "Message/Record.only": "it is that of the message",
    "Message/Record.size": "it is printed for records alone",
    "Message/Record.words": "it is printed for records alone",
    "Message/Record.same_as": "it is said of records alone",
}
"""`Class.attribute`, `Holder/Class.attribute`, or `*.attribute` for all classes, and why no rule looks at it."""


APART = {
    "choice": "what a project generates is not a part of a device",
    "attributes": "it describes the classes of the model",
    "encoding": "an encoding is what a primitive stands for, and primitives are compared by their names",
}
"""The modules whose classes are not a part of a device, and why."""


@cache
def devices() -> tuple[Device, ...]:
    """The newest versions of the made-up devices, which use every feature of the language; small ones first."""
    files = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in SPECS.glob("protocols/*.yaml")}
    files |= {path.relative_to(TEST_SPECS).as_posix(): path.read_bytes() for path in TEST_SPECS.rglob("*.yaml")}
    project = read(files)
    specs = (*project.devices.values(), gadget(MORE, **{"gadget/versions_2": OVERLAY}))
    newest = [spec.at(spec.versions()[-1])[0] for spec in specs]
    return tuple(sorted(newest, key=lambda device: len(device.place.whole.file.text)))


def classes() -> Iterator[type]:
    """All dataclasses of the model."""
    for module in iter_modules(fieldspec.language.model.__path__, "fieldspec.language.model."):
        if module.name.rpartition(".")[2] in APART:
            continue
        for member in vars(import_module(module.name)).values():
            if dataclasses.is_dataclass(member) and isinstance(member, type) and member.__module__ == module.name:
                yield member


Position = tuple[Device, str, Any, tuple[Any, ...]]


def walk(holder: Any, item: Any, path: tuple[Any, ...]) -> Iterator[tuple[str, Any, tuple[Any, ...]]]:
    """All dataclasses below one, each with the name of the class that contains it and the path to it."""
    if dataclasses.is_dataclass(item) and not isinstance(item, type | Primitive):
        yield type(holder).__name__, item, path
        for field in dataclasses.fields(item):
            if field.name != "place":
                yield from walk(item, getattr(item, field.name), (*path, field.name))
    elif isinstance(item, Mapping):
        for key, inner in item.items():
            yield from walk(holder, inner, (*path, key))
    elif isinstance(item, tuple):
        for number, inner in enumerate(item):
            yield from walk(holder, inner, (*path, number))


@cache
def positions() -> dict[tuple[str, type], list[Position]]:
    """The positions of the instances of every class, by the class that contains it."""
    by_class: dict[tuple[str, type], list[Position]] = {}
    for device in devices():
        for holder, item, path in walk(None, device, ()):
            by_class.setdefault((holder, type(item)), []).append((device, holder, item, path))
    return by_class


def with_changed(item: Any, values: Mapping[tuple[Any, ...], Any]) -> Any:
    """A copy of a device with other values at the ends of some paths."""
    if () in values:
        return values[()]
    inner: dict[Any, dict[tuple[Any, ...], Any]] = {}
    for (step, *rest), value in values.items():
        inner.setdefault(step, {})[tuple(rest)] = value
    if isinstance(item, Mapping):
        return {key: with_changed(old, inner[key]) if key in inner else old for key, old in item.items()}
    if isinstance(item, tuple):
        return tuple(with_changed(old, inner[at]) if at in inner else old for at, old in enumerate(item))
    return dataclasses.replace(item, **{step: with_changed(getattr(item, step), rest) for step, rest in inner.items()})


def others(value: Any, hint: Any) -> Iterator[Any]:
    """Values of an attribute that differ from its current one."""
    if isinstance(value, bool):
        yield not value
    elif isinstance(value, int | Decimal):
        yield value + 1
        yield value * 2 + 3
    elif isinstance(value, str):
        yield value + "_x" if value else "other"
        if value:
            yield ""
    elif isinstance(value, bytes):
        yield value + b"\x01"
    elif isinstance(value, Enum):
        yield next(other for other in type(value) if other is not value)
    elif isinstance(value, Ranges):
        yield (
            Ranges(((value.intervals[0][0] + 1, value.intervals[0][1] + 1),)) if value.intervals else Ranges(((0, 1),))
        )
    elif isinstance(value, Primitive):
        yield PRIMITIVES["u32" if value.name != "u32" else "i16"]
    elif isinstance(value, Mapping):
        if value:
            yield dict(list(value.items())[:-1])
        elif typing.get_args(hint)[-1] is str:
            yield {"key": "a reason"}
        elif typing.get_args(hint)[-1] in SAMPLES:
            yield {"key": SAMPLES[typing.get_args(hint)[-1]]}
    elif isinstance(value, tuple) and value:
        yield value[:-1]
        if len(value) == 2 and all(isinstance(number, int) for number in value):
            yield value[0] + 1, value[1] + 1
    elif value is None or value == ():
        yield from values_of_type(hint)
    elif type(None) in typing.get_args(hint):
        yield None


def values_of_type(hint: Any) -> Iterator[Any]:
    """Values of a type for an attribute that has none."""
    for inner in typing.get_args(hint) if isinstance(hint, types.UnionType) else (hint,):
        if inner in (int, Decimal, bool):
            yield inner(1)
        elif inner is Ranges:
            yield Ranges(((0, 1),))
        elif inner in SAMPLES:
            yield SAMPLES[inner]
        elif typing.get_origin(inner) is tuple and (sample := SAMPLES.get(typing.get_args(inner)[0])):
            yield (sample, sample) if typing.get_args(inner)[1:] == (int,) else (sample,)


def ignored(holder: str, noun: type, attribute: str) -> bool:
    names = (f"*.{attribute}", f"{noun.__name__}.{attribute}", f"{holder}/{noun.__name__}.{attribute}")
    return any(name in IGNORED for name in names)


@cache
def hints(noun: type) -> dict[str, Any]:
    """The types of the attributes of a class."""
    return typing.get_type_hints(noun, localns={"Fraction": Fraction})


PAIRS: list[tuple[str, type]] = shared("pairs_of_classes", lambda: list(positions()))
"""The classes that occur in devices, each with a class that contains it."""

NEVER_ABSENT = {
    noun.__name__: [
        name
        for name, hint in hints(noun).items()
        if dataclasses.is_dataclass(hint) and hint is not Primitive and hint is not Place
    ]
    for _, noun in PAIRS
}
"""Attributes that always have a dataclass as their value; the attributes of that dataclass are changed."""

CASES = [
    pytest.param(holder, noun, field.name, id=f"{holder}/{noun.__name__}.{field.name}")
    for holder, noun in PAIRS
    for field in dataclasses.fields(noun)
    if field.name not in NEVER_ABSENT.get(noun.__name__, ())
]


NAMES = {"algorithm": ("lrc", "sum8"), "encoding": ("latin_1", "utf_8")}
"""Values of attributes that are names from a list."""


def changed_devices(holder: str, noun: type, attribute: str) -> Iterator[tuple[Device, Device]]:
    """Devices, each with a copy that has another value of an attribute, wherever the class occurs.

    What no rule looks at is changed at all positions of a device at once.
    """
    hint = hints(noun)[attribute]
    groups: dict[Any, list[tuple[tuple[Any, ...], list[Any]]]] = {}
    compared: dict[Any, Device] = {}
    for device, _, item, path in positions()[holder, noun]:
        old = getattr(item, attribute)
        # An algorithm without a name has no size, and an encoding without one no title.
        values = NAMES.get(attribute if noun in (Part, TextForm) else "", others(old, hint))
        group = id(device) if ignored(holder, noun, attribute) else (id(device), path)
        compared[group] = device
        groups.setdefault(group, []).append(((*path, attribute), [value for value in values if value != old]))
    for group, places in groups.items():
        for number in range(max(len(values) for _, values in places)):
            new = {path: values[number] for path, values in places if number < len(values)}
            yield compared[group], with_changed(compared[group], new)


def noticed(holder: str, noun: type, attribute: str) -> set[str]:
    """The rules that notice another value of an attribute."""
    for device, changed in changed_devices(holder, noun, attribute):
        rules = {change.rule for change in changes(device, changed)}
        if rules:
            return rules
    return set()


@pytest.mark.parametrize(("holder", "noun", "attribute"), CASES)
def test_every_attribute_of_the_model_is_compared_or_listed(holder: str, noun: type, attribute: str) -> None:
    rules = noticed(holder, noun, attribute)
    assert (rules == set()) is ignored(holder, noun, attribute), rules


def test_the_made_up_devices_have_every_class_of_the_model() -> None:
    missing = {noun.__name__ for noun in classes()} - {noun.__name__ for _, noun in positions()}
    # What checks make of a device is not a part of one.
    views = {"NumberPlace", "Operand", "Place", "Run", "TableRecord", "Watch"}
    codecs = {"ChecksumCodec", "InstalledCodec", "NumberCodec"}  # a package gives them
    assert missing == {*codecs, "Checksum", "Fact", "Primitive", "Shape", "Unit", *views}


def test_every_reason_to_ignore_an_attribute_is_about_an_attribute() -> None:
    names = {f"{noun.__name__}.{field.name}" for _, noun in positions() for field in dataclasses.fields(noun)}
    names |= {
        f"{holder}/{noun.__name__}.{field.name}" for holder, noun in positions() for field in dataclasses.fields(noun)
    }
    names |= {f"*.{field.name}" for noun in classes() for field in dataclasses.fields(noun)}
    assert set(IGNORED) - names == set()


def test_a_device_does_not_differ_from_itself() -> None:
    assert [changes(device, device) for device in devices()] == [[] for _ in devices()]


def test_values_occur_in_every_class_that_may_have_one() -> None:
    assert {holder for holder, noun in positions() if noun is Value} == {
        "Case",
        "Field",
        "Parameter",
        "Part",
        "Register",
        "Signal",
        "Subindex",
    }
