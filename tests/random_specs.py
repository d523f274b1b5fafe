"""Random specs that fit the schema: valid in form, without sense in content."""

from __future__ import annotations

import json
import random
import re
from typing import Any

from fieldspec.language.schema import Schema, resolved, schema

NAMES = ("a", "b", "c", "status", "point_2")
NUMBERS = (*range(-2, 9), 15, 16, 63, 64, 255, 256, 4000, 65535, 65536, 2**32, 2**64 - 1, 10**19, -(2**63))
TEXTS = ("", "x", "伺服", "on", "1", "-1", "0..5", "*/", "{{", "\n", "a=1", "20.00 mm", "010", "9" * 5000, "~", "\0")
NUMBER_TEXTS = ("0.01", "-0.5", "1", "0", "0.00000000000000000001", "99999999999999999999", "-40")
"""Numbers as texts, so that none is rounded before it is read."""

PATHS = ("registers/a", "axis/position")
"""Texts for keys with a form of their own that is not in `FORMS`: most of them are paths."""

FORMS: dict[str, tuple[str, ...]] = {
    "name": NAMES,
    "identifier": ("a", "b-1", "c.d"),
    "source": ("L1", "8.2 L1622", "5.1 L1160-1163, 1170", "9.1 L4; 10 L1-999999", "L9-1", "L0"),
    "ranges": ("0..5", "1", "-1..0x7F", "0..127, 10000..10127", "5..1", "0.5..1", "0..99999999999999999999", "-0x1"),
    "hex_bytes": ("00", "01 06 20 1E 00 03 A2 0D", "3A", "FF\nFF", "01 03 00 00 00 02 C4 0B"),
    "version": ("1", "2.0", "V1"),
    "span": ("1", "1-4", "4-1", "99999"),
    "word_span": ("1", "2-3"),
    "scale": ("100/2^14", "1/3", "1/0", "0.5/10", "1/7^99", "0/2"),
    "bound": ("1", "2.0"),
    "device_id": ("gadget",),
    "bits": ("0..1", "3..2", "9..99"),
    "at": ("0x9010", "0x0..0xFFFFFFFF"),
    "gaps": ("16: nothing", "0..99999999: all", "x: y"),
    "sha256": ("0" * 64,),
    "manual": ("0" * 64,),
    "url": ("https://example.com/manual",),
    "read": ("2026-01-31",),
    "state": ("0" * 16,),
    "endurance": ("limited", "unlimited"),
    "unit": ("mm", "%", "furlong", "*/", "0.1%"),
    "symbol": ("mm", "furlong", "{{"),
    "ucum": ("mm", "{step}"),
    "factor": ("1/1000", "7"),
    "section": ("8.2", "1"),
    "sections": ("8.2", "1"),
    "lines": ("1", "5-9, 12"),
    "date": ("2026-01-31",),
}


class NumberText(str):
    """A number as YAML writes it, without quotes."""

    __slots__ = ()


def spec(seed: int) -> str:
    """The text of one random spec file with the section `device`."""
    chance = random.Random(seed)
    data = _mapping(schema(), "", chance, 5)
    for key in ("protocol", "overlay", "adds", "changes", "removes", "renames", "audit"):
        data.pop(key, None)
    data["device"] = _of(schema()["properties"]["device"], "", chance, 5) | {"id": "gadget"}
    data["uses"] = [{"protocol": "wire"}] if chance.random() < 0.3 else []
    for line in data.get("versions", ())[1:]:
        line.pop("builds", None)
    return text_of(data)


def text_of(data: Any) -> str:
    """Data as YAML in flow style."""
    if isinstance(data, dict):
        return "{" + ", ".join(f"{key}: {text_of(value)}" for key, value in data.items()) + "}"
    if isinstance(data, list):
        return "[" + ", ".join(map(text_of, data)) + "]"
    return str(data) if isinstance(data, NumberText) else json.dumps(data)


def _of(part: Schema, key: str, chance: random.Random, depth: int) -> Any:
    part = resolved(part)
    defined = schema()["$defs"] if "properties" not in part else {}
    form = next((form for name, form in FORMS.items() if part is defined.get(name)), None)
    if form is None and "pattern" in part:
        form = tuple(text for text in FORMS.get(key, ()) if re.search(part["pattern"], text)) or PATHS
    if form is not None and part.get("type") == ["string", "array"] and chance.random() < 0.5:
        return [chance.choice(form)]
    if form is not None and part.get("type") == ["number", "string"] and chance.random() < 0.5:
        return NumberText(chance.choice(NUMBER_TEXTS))
    if form is not None:
        return chance.choice(form)
    if "enum" in part:
        return chance.choice(part["enum"])
    kinds = part.get("type", ("string", "integer", "number", "boolean", "null", "array", "object"))
    kind = kinds if isinstance(kinds, str) else chance.choice(kinds)
    if kind == "object":
        return _mapping(part, key, chance, depth)
    if kind == "string" and "then" in part:
        return _of(part["then"], key, chance, depth)
    if kind == "array":
        count = chance.choice((0, 1, 1, 2, 3)) if depth > 0 else 0
        return [_of(part.get("items", {}), key, chance, depth - 1) for _ in range(max(count, part.get("minItems", 0)))]
    if kind == "integer":
        low, high = part.get("minimum", -(10**20)), part.get("maximum", 10**20)
        return chance.choice([number for number in NUMBERS if low <= number <= high])
    if kind == "number":
        return NumberText(chance.choice(NUMBER_TEXTS))
    if kind == "boolean":
        return chance.random() < 0.5
    least = part.get("minLength", 0)
    return None if kind == "null" else chance.choice([text for text in TEXTS if len(text) >= least])


def _mapping(part: Schema, key: str, chance: random.Random, depth: int) -> dict[str, Any]:
    least, most = part.get("minProperties", 0), part.get("maxProperties", 100)
    known = part.get("properties", {})
    others = part.get("additionalProperties") or {}
    likely = 0.35 if depth > 0 else 0.0
    needed = part.get("required", ())
    names = [name for name in known if name in needed or chance.random() < likely]
    if not known:
        names = chance.sample(NAMES, max(least, chance.randrange(3)))
    names = names[:most] or list(known)[:least]
    return {name: _of(known.get(name, others), name, chance, depth - 1) for name in names}
