"""The identity of a device differs from that of another exactly where a comparison finds more than documentation.

Random changes of random devices and of made-up ones: a key that goes, comes, or has another value, a list in another
order or without an item, and what a spec may leave out, written out.
"""

from __future__ import annotations

import copy
import random
import re
from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import yaml

from fieldspec.codec.layout.device import device_layout
from fieldspec.language.changes.change import Effect
from fieldspec.language.changes.table import changes
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.model.device import Device
from fieldspec.language.reading.project import read
from fieldspec.tools.proofs.running import outcome
from random_devices.devices import text_of
from random_devices.draft import Spec

CASES = Path(__file__).parent / "random_devices" / "cases"
Loader = yaml.CSafeLoader if yaml.__with_libyaml__ else yaml.SafeLoader
CHANGES = 30
"""How many changes each device gets."""

DOCUMENTATION = {"source", "doc", "label", "notes", "title", "id", "manual", "printed_name", "line"}
DEFAULTS: dict[str, tuple[Any, ...]] = {
    "byte_order": ("big", "little"),
    "word_order": ("big", "little"),
    "scale": (1, 1.0),
    "offset": (0,),
    "open": (False,),
    "active": ("high",),
    "index_from": (0,),
    "count": (1,),
    "atomic": (False,),
    "trigger": (False,),
    "access": ("rw",),
    "stride": (1, 2),
    "elements": (1,),
    "response_code": tuple(range(8)),
    "signed": (False,),
    "places": (0,),
}
"""Keys with values that mean in many places what is meant without them."""
WHOLE = {"u8": "0..255", "i8": "-128..127", "u16": "0..65535", "i16": "-32768..32767", "u32": "0..4294967295"}


TEXTS = {path.stem: path.read_text(encoding="utf-8") for path in sorted(CASES.glob("*.yaml"))}
NAMES = [name for name, text in TEXTS.items() if re.search("^device:", text, re.MULTILINE)]
"""The random devices that once broke something."""


@cache
def specs() -> dict[str, Spec]:
    """The specs of these devices."""
    return {name: yaml.load(TEXTS[name], Loader) for name in NAMES}


def facts(node: Any) -> Iterator[Spec]:
    """All mappings below the sections of a spec."""
    if isinstance(node, dict):
        yield node
    for inner in node.values() if isinstance(node, dict) else node if isinstance(node, list) else ():
        yield from facts(inner)


@cache
def values_by_key() -> dict[str, list[Any]]:
    """By key, the values that it has in some device."""
    values: dict[str, list[Any]] = defaultdict(list)
    for spec in specs().values():
        for fact in facts(spec):
            for key, value in fact.items():
                if key not in DOCUMENTATION and not isinstance(value, dict | list) and value not in values[key]:
                    values[key].append(value)
    return values


def change(spec: Spec, dice: random.Random) -> str:
    """Changes one thing in a spec, and says what."""
    sections = [spec[name] for name in spec if name not in ("device", "versions", "manual")]
    places = [fact for section in sections for fact in facts(section)]
    fact = dice.choice(places)
    keys = [key for key, value in fact.items() if key not in DOCUMENTATION and not isinstance(value, dict | list)]
    lists = [value for each in places for value in each.values() if isinstance(value, list) and len(value) > 1]
    kind = dice.choice(("whole range", "gone", "other", "default", "added", "order", "item"))
    if kind == "whole range" and fact.get("type") in WHOLE and "range" not in fact:
        fact["range"] = WHOLE[fact["type"]]
    elif kind == "gone" and keys:
        kind += f" {keys[0]}"
        del fact[keys[0]]
    elif kind == "other" and keys:
        key = dice.choice(keys)
        kind += f" {key}"
        value = fact[key]
        fact[key] = f"{value}_x" if key == "name" else dice.choice(values_by_key()[key])
    elif kind in ("default", "added"):
        known = DEFAULTS if kind == "default" else values_by_key()
        key = dice.choice([key for key in known if key not in fact])
        fact[key] = dice.choice(known[key])
        kind += f" {key}"
    elif kind == "order" and lists:
        dice.shuffle(dice.choice(lists))
    elif kind == "item" and lists:
        items = dice.choice(lists)
        del items[dice.randrange(len(items))]
    return kind


def device_of(spec: Spec) -> Device | None:
    """The newest version of the device of a spec; None where it has findings."""
    project = read({"chance/device.yaml": text_of({**spec, "device": {**spec["device"], "id": "chance"}}).encode()})
    device = project.devices.get("chance")
    if device is None or has_errors(project.findings) or has_errors(outcome(device).findings):
        return None
    return device.at(device.versions()[-1])[0]


def affect_programs(old: Device, new: Device) -> list[str]:
    """The changes between two devices, in either direction, that are more than documentation."""
    both = (*changes(old, new), *changes(new, old))
    return [f"{change.rule}: {change.message}" for change in both if change.effect is not Effect.DOCS]


@pytest.mark.proof(6)
@pytest.mark.parametrize("name", NAMES)
def test_an_identity_differs_where_programs_must_be_told_of_a_change(name: str) -> None:
    old = device_of(specs()[name])
    if old is None:
        pytest.skip("it has findings on purpose")
    dice = random.Random(name)
    for _ in range(CHANGES):
        spec = copy.deepcopy(specs()[name])
        kind = change(spec, dice)
        new = device_of(spec)
        if new is not None:
            differs = device_layout(new).identity != device_layout(old).identity
            assert differs == bool(noticed := affect_programs(old, new)), (kind, noticed)
