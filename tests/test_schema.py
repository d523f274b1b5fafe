"""The schema of the language is valid, complete and formatted, and two libraries agree on its meaning."""

from __future__ import annotations

import copy
import json
import random
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema
import jsonschema_rs
import pytest
from jsonschema.protocols import Validator

from example_counts import FACTOR
from fieldspec.language.reading.nodes import json_data
from fieldspec.language.reading.scalars import typed
from fieldspec.language.reading.yaml_reader import decoded, parsed
from fieldspec.language.schema import ADDRESS, described, schema

ROOT = Path(__file__).parent.parent
SCHEMA = ROOT / "codegen" / "fieldspec" / "language" / "schema" / "spec.schema.json"
BESIDE_THE_SPECS = ROOT / "specs" / ADDRESS
SPECS = sorted([*(ROOT / "specs").rglob("*.yaml"), *(ROOT / "tests" / "specs").rglob("*.yaml")])
WIDTH = 120
MUTATIONS = 8 * FACTOR
"""How many mutations of each spec file are judged."""


def formatted(value: Any, indent: int = 0, before: int = 0) -> str:
    """JSON with each value on one line where it fits, else with one item on each line."""
    line = json.dumps(value, ensure_ascii=False)
    if not isinstance(value, dict | list) or not value:
        return line
    if indent and indent + before + len(line) < WIDTH:
        return line
    blank = " " * (indent + 2)
    if isinstance(value, dict):
        heads = [f"{json.dumps(key)}: " for key in value]
        items = [
            head + formatted(item, indent + 2, len(head)) for head, item in zip(heads, value.values(), strict=True)
        ]
        return "{\n" + ",\n".join(blank + item for item in items) + "\n" + " " * indent + "}"
    if any(isinstance(item, dict | list) for item in value):
        items = [formatted(item, indent + 2) for item in value]
        return "[\n" + ",\n".join(blank + item for item in items) + "\n" + " " * indent + "]"
    rows = [""]
    for item in value:
        word = json.dumps(item, ensure_ascii=False) + ", "
        if rows[-1] and len(blank + rows[-1] + word) > WIDTH + 1:
            rows.append("")
        rows[-1] += word
    return "[\n" + "\n".join(blank + row.rstrip() for row in rows).removesuffix(",") + "\n" + " " * indent + "]"


def keys(part: dict[str, Any], path: str = "") -> Iterator[tuple[str, dict[str, Any]]]:
    """Every key of the language with its path in the schema."""
    for name, inner in part.get("properties", {}).items():
        yield f"{path}/{name}", inner
        yield from keys(inner, f"{path}/{name}")
    if "items" in part:
        yield from keys(part["items"], f"{path}[]")
    for name, inner in part.get("$defs", {}).items():
        yield from keys(inner, name)


def objects(part: Any) -> Iterator[dict[str, Any]]:
    """Every part of the schema that describes a mapping."""
    if isinstance(part, dict):
        if part.get("type") == "object":
            yield part
        for inner in part.values():
            yield from objects(inner)


def content(path: Path) -> object:
    """A spec file as plain data, typed as the reader types it."""
    file, findings = decoded(path.name, path.read_bytes())
    assert not findings
    node, findings = parsed(file)
    assert node is not None
    assert not findings
    return json_data(typed(node)[0])


def test_schema_is_formatted(accept: bool) -> None:
    text = formatted(schema()) + "\n"
    if accept:
        SCHEMA.write_text(text, "utf-8", newline="\n")
    assert SCHEMA.read_text("utf-8") == text


def test_the_schema_beside_the_specs_is_the_one_of_the_compiler(accept: bool) -> None:
    if accept:
        BESIDE_THE_SPECS.write_bytes(SCHEMA.read_bytes())
    assert BESIDE_THE_SPECS.read_bytes() == SCHEMA.read_bytes()


def test_schema_is_a_valid_schema_of_draft_2020_12() -> None:
    assert schema()["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    jsonschema.Draft202012Validator.check_schema(schema())


def test_every_key_has_a_description() -> None:
    texts = {path: described(part) for path, part in keys(schema())}
    assert len(texts) > 200
    assert [path for path, text in texts.items() if not re.fullmatch(r"[A-Z`].*\w.*\.", text)] == []


def test_every_definition_has_a_description() -> None:
    assert [name for name, part in schema()["$defs"].items() if not part.get("description")] == []


def test_every_mapping_says_which_keys_it_takes() -> None:
    groups = [schema()["$defs"][name] for name in ("fact", "value")]
    assert [part for part in objects(schema()) if "additionalProperties" not in part and part not in groups] == []


def test_every_definition_is_used() -> None:
    text = json.dumps(schema())
    assert [name for name in schema()["$defs"] if f'"#/$defs/{name}' not in text] == []


def mutated(data: Any, random: random.Random) -> Any:
    """A copy with one slip: a value of another kind, a key that is gone, misspelt or moved."""
    data = copy.deepcopy(data)
    holders = list(containers(data))
    holder = random.choice(holders)
    if isinstance(holder, list):
        at = random.randrange(len(holder))
        holder[at] = other(holder[at], random)
        return data
    key = random.choice(list(holder))
    slip = random.randrange(4)
    if slip == 0:
        del holder[key]
    elif slip == 1:
        holder[key + random.choice("xs_")] = holder.pop(key)
    elif slip == 2:
        elsewhere = random.choice([holder for holder in holders if isinstance(holder, dict)])
        elsewhere[key] = copy.deepcopy(holder[key])
    else:
        holder[key] = other(holder[key], random)
    return data


def containers(data: Any) -> Iterator[Any]:
    """The mappings and lists of some data that are not empty."""
    if isinstance(data, dict | list) and data:
        yield data
        for inner in data.values() if isinstance(data, dict) else data:
            yield from containers(inner)


def other(value: Any, random: random.Random) -> Any:
    """A value similar to another one, or a completely different one."""
    unlike = [None, True, -1, 0, 70000, 2**64, 0.5, 1e300, "", "X y", "0..", "a" * 200, [], [1], {}, {"name": "a"}]
    like = {str: [f"{value} ", f"{value}"[:-1], f"0{value}"], int: [f"{value}", -1], list: [[], {}]}
    return copy.deepcopy(random.choice([*unlike, *like.get(type(value), [])]))


def rust(data: object) -> set[tuple[str | int, ...]]:
    """The paths at which the library of the reader finds something."""
    return {tuple(error.instance_path) for error in rust_validator().iter_errors(data)}


@cache
def rust_validator() -> jsonschema_rs.Draft202012Validator:
    return jsonschema_rs.Draft202012Validator(schema())


def python(validator: Validator, data: object) -> set[tuple[str | int, ...]]:
    """The paths at which the other library finds something."""
    return {tuple(error.absolute_path) for error in validator.iter_errors(data)}


@pytest.mark.proof(23)
@pytest.mark.parametrize("path", SPECS, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_two_libraries_find_nothing_in_a_spec_and_the_same_in_mutated_ones(path: Path) -> None:
    data = content(path)
    validator = jsonschema.Draft202012Validator(schema())
    assert rust(data) == python(validator, data) == set()
    source = random.Random(path.name)
    refused = 0
    for _ in range(MUTATIONS):
        wrong = mutated(data, source)
        rejected = rust(wrong)
        assert rejected == python(validator, wrong)
        refused += bool(rejected)
    if FACTOR > 1:  # a few mutations of one file may all be harmless; of the many of a night, some are not
        assert refused > MUTATIONS / 10
