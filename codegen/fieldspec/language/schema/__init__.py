"""The language: `spec.schema.json` is the one table of legal keys. It validates, completes, and writes the manual."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any, TypeAlias

Schema: TypeAlias = dict[str, Any]


ADDRESS = "fieldspec.schema.json"
"""The name of the schema beside the devices of a folder of specs, where the first line of a spec leads editors."""


PROJECT_ADDRESS = "fieldspec.project.schema.json"
"""The name of the schema of project files, beside that of specs."""


def schema_text() -> str:
    """The file of the schema."""
    return Path(__file__).with_name("spec.schema.json").read_text("utf-8")


def project_schema_text() -> str:
    """The file of the schema of project files."""
    return Path(__file__).with_name("project.schema.json").read_text("utf-8")


@cache
def schema() -> Schema:
    """The language as JSON Schema, draft 2020-12."""
    return json.loads(schema_text())  # type: ignore[no-any-return]


@cache
def project_schema() -> Schema:
    """The keys of a project file as JSON Schema, draft 2020-12."""
    return json.loads(project_schema_text())  # type: ignore[no-any-return]


@cache
def built_in_units() -> list[dict[str, Any]]:
    """The rows of `units.json`: the units that every spec may use."""
    text = Path(__file__).with_name("units.json").read_text("utf-8")
    return json.loads(text)  # type: ignore[no-any-return]


def resolved(part: Schema) -> Schema:
    """A part of the schema, or what it refers to: `#/$defs/fact/properties/label` is the key `label` of all facts."""
    while "$ref" in part:
        part = referred(part["$ref"])
    return part


def described(part: Schema) -> str:
    """The description of a part of the schema, or else that of the part to which it refers."""
    while "description" not in part and "$ref" in part:
        part = referred(part["$ref"])
    return str(part.get("description", ""))


@cache
def referred(reference: str) -> Schema:
    """The part of the schema that a reference names."""
    part: Any = schema()
    for key in reference.removeprefix("#/").split("/"):
        part = part[key]
    return part  # type: ignore[no-any-return]
