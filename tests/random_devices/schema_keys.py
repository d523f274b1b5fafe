"""The keys of the language that random devices do not have, with the reason for each, and those that they have."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any

from fieldspec.language.schema import Schema, resolved, schema

Key = tuple[str, str]
"""The definition or the path of a mapping in the schema, and a key of it."""

DOCUMENTATION = "It is documentation: no byte depends on it, and the tests of the pages cover it."
EXPANDED = "Reading a spec gives it to the copied registers, which state it themselves here."
COMPARED = "It is compared with another fact by a check, which has its own cases."
HANDLING = "It says how to handle a value and is in no codec."
FILES = "It is in a second file: a judge splits devices so, and compares the outputs of both forms."
PACKAGES = "A package gives it, and printed frames prove it; `cases/codecs.yaml` has each, for all judges."
SIMULATED = "It is what a simulator does, and is in no codec."
ANYWHERE = {
    "allow": "It permits a finding; one place is enough.",
    "inferred": DOCUMENTATION,
    "standard": DOCUMENTATION,
    "reported": DOCUMENTATION,
    "unverified": DOCUMENTATION,
    "restated": COMPARED,
    "roles": "It names facts for tasks and is in no codec.",
    "title": DOCUMENTATION,
    "label": DOCUMENTATION,
    "doc": DOCUMENTATION,
    "notes": DOCUMENTATION,
    "printed_name": DOCUMENTATION,
    "section": DOCUMENTATION,
    "source": DOCUMENTATION,
    "only": "Whether a fact has bounds does not depend on its kind; rows, fields, bits and messages have them.",
    "since": "Whether a fact has bounds does not depend on its kind; rows, fields, bits and messages have them.",
    "until": "Whether a fact has bounds does not depend on its kind; rows, fields, bits and messages have them.",
    "memory": HANDLING,
    "saved_by": HANDLING,
    "endurance": HANDLING,
    "opposite_of": HANDLING,
    "clears_on_read": HANDLING,
    "restart": HANDLING,
    "printed_as": COMPARED,
}
"""Keys that many facts may have."""
MAPPINGS = {
    "message.segments.abort": "A program sends it; codecs have it as any other message.",
    "behaviour": SIMULATED,
    "behaviour_action": SIMULATED,
    "behaviour_value": SIMULATED,
    "declared_unit": "A unit of a spec differs from a built-in one in words alone.",
    "claim": COMPARED,
    "standard": DOCUMENTATION,
    "report": DOCUMENTATION,
    "cause": DOCUMENTATION,
    "lookup": DOCUMENTATION,
    "limit": DOCUMENTATION,
    "note": DOCUMENTATION,
    "statement": DOCUMENTATION,
    "task": "Tasks are steps over facts and are in no codec.",
    "step": "Tasks are steps over facts and are in no codec.",
    "erratum": "An erratum is proven by the rule that it names.",
    "review": DOCUMENTATION,
    "audit": "It says how to read a manual, and random devices have none.",
    "manual_section": "It says how to read a manual, and random devices have none.",
    "manual_pattern": "It says how to read a manual, and random devices have none.",
    "left_out": "It says how to read a manual, and random devices have none.",
    "unprinted": "It says how to read a manual, and random devices have none.",
    "acceptance": "It is about changes of specs.",
    "was_is": FILES,
    "protocol": FILES,
    "uses": FILES,
    "overlay": FILES,
    "adds": FILES,
    "changes": FILES,
    "removes": FILES,
    "renames": FILES,
    "example": "Examples are made of the frames of the reference when a device is compared.",
    "device": DOCUMENTATION,
    "device.manual": DOCUMENTATION,
    "table.elements": COMPARED,
    "link.serial": DOCUMENTATION,
    "link.silence": "It is about time, and codecs see no time.",
    "link.direction_names": DOCUMENTATION,
    **dict.fromkeys(
        (
            "message.checked",
            "message.checked.frame_length",
            "message.checked.data_words",
            "field.checked",
            "table.checked",
            "parameter.checked",
        ),
        COMPARED,
    ),
}
"""Mappings of which no key must be in random devices."""
KEYS = {
    ("file", key): reason
    for key, reason in {
        **dict.fromkeys(("uses", "protocol", "overlay", "adds", "changes", "removes", "renames"), FILES),
        **dict.fromkeys(("lookups", "limits", "notes", "tasks"), DOCUMENTATION),
        **dict.fromkeys(("errata", "reviews", "audit", "accepts"), "It is about the manual or about changes of specs."),
        "examples": MAPPINGS["example"],
        "behaviour": SIMULATED,
        "units": MAPPINGS["declared_unit"],
    }.items()
} | {
    ("link.unit_addresses", "rule"): DOCUMENTATION,
    ("fact", "name"): "It is what the facts of the other mappings have.",
    ("link", "frame"): "A judge states equal requests and responses so, and compares the outputs of both forms.",
    ("link", "message_name"): DOCUMENTATION,
    ("link", "direction_names"): DOCUMENTATION,
    ("member", "problem"): DOCUMENTATION,
    ("member", "causes"): DOCUMENTATION,
    ("member", "remedies"): DOCUMENTATION,
    ("flags", "range"): COMPARED,
    ("bit", "when"): DOCUMENTATION,
    ("record", "same_as"): COMPARED,
    ("field", "at"): COMPARED,
    ("field", "checked"): COMPARED,
    ("field", "atomic"): "It bounds the requests for a register; registers have it.",
    ("copy", "trigger"): EXPANDED,
    ("copy.rows", "access"): EXPANDED,
    ("copy.rows", "checked"): COMPARED,
    ("message.segments", "abort"): "A program sends it; codecs have it as any other message.",
    ("message.segments", "unsized"): "It says when a size in an answer means nothing, which only clients look at.",
    ("register", "copy_of"): "Reading a spec adds it to the registers of a block that is copied.",
    ("register", "number"): COMPARED,
    ("register", "same_as"): COMPARED,
    ("register", "element_name"): DOCUMENTATION,
    ("register", "element_sources"): DOCUMENTATION,
    ("register_group", "order"): "It permits addresses in another order.",
    ("table", "checked"): COMPARED,
    ("table", "elements"): COMPARED,
    ("parameter", "checked"): COMPARED,
    ("value", "codec"): PACKAGES,
    ("parameter", "applies_to"): DOCUMENTATION,
    ("parameter", "messages"): DOCUMENTATION,
    ("version_line", "like"): "Lines beside the built one share its outputs; the tests of versions cover them.",
    ("parameter_set", "type"): "It is a default of rows, which state their own.",
    ("message", "group"): DOCUMENTATION,
    ("part", "same_as"): "A program compares the two parts; codecs read both alike.",
    ("message.segments", "size"): "Reading in pieces has none here.",
    ("message", "supplements"): "It says beside which messages one is sent.",
    ("message", "checked"): COMPARED,
    ("conversion", "complement"): "Conversions are of quantities; the tests of conversions cover them.",
    ("conversion", "type"): "Conversions are of quantities; the tests of conversions cover them.",
    ("conversion", "references"): "Conversions are of quantities; the tests of conversions cover them.",
    ("conversion", "printed"): DOCUMENTATION,
    ("signal", "direction"): COMPARED,
}
"""Single keys; those of a `value` are the same wherever a value is."""
WORDS = {
    ("part", "algorithm"): "Algorithms are rows of one table; the tests of checksums cover each row.",
    ("enum", "kind"): DOCUMENTATION,
    ("flags", "bit_0"): "`least` is the default: words without the key have it.",
}
"""Keys of which random devices need not have every word."""
FORMS = {"part.algorithm.method: codec": PACKAGES}
"""Single words that random devices need not have."""


def reason(key: Key) -> str:
    """Why random devices need not have a key; empty where they must."""
    owner, name = key
    if name in _value_keys() and owner != "value":
        return "A value is the same wherever it is."
    return KEYS.get(key) or ANYWHERE.get(name) or MAPPINGS.get(owner) or MAPPINGS.get(owner.split(".")[0], "")


@cache
def _value_keys() -> frozenset[str]:
    return frozenset(schema()["$defs"]["value"]["properties"])


@cache
def known_keys() -> dict[Key, Schema]:
    """All keys of all mappings of the schema, with what each may be."""
    keys: dict[Key, Schema] = {}
    seen: set[str] = set()

    def walk(part: Schema, owner: str) -> None:
        name, part = _named(part, owner)
        for key, inner in part.get("properties", {}).items():
            keys[name, key] = inner
            child, _ = _named(inner, f"{name}.{key}")
            if child not in seen:
                seen.add(child)
                walk(inner, f"{name}.{key}")
        if "items" in part:
            walk(part["items"], name)

    walk(schema(), "file")
    for name in schema()["$defs"]:
        walk({"$ref": f"#/$defs/{name}"}, name)
    return keys


def nodes_in(data: Any) -> Iterator[tuple[str, dict[str, Any], Schema]]:
    """The mappings in a spec, each with its name and its schema; one with keys of values is a value too."""

    def walk(part: Schema, owner: str, node: Any) -> Iterator[tuple[str, dict[str, Any], Schema]]:
        name, part = _named(part, owner)
        if isinstance(node, dict):
            yield name, node, part
            of_value = {key: node[key] for key in node if key in _value_keys() and key in part.get("properties", {})}
            if of_value:
                yield "value", of_value, schema()["$defs"]["value"]
            for key, inner in node.items():
                if key in part.get("properties", {}):
                    yield from walk(part["properties"][key], f"{name}.{key}", inner)
        for inner in node if isinstance(node, list) else ():
            yield from walk(part.get("items", {}), name, inner)

    yield from walk(schema(), "file", data)


def key_path(form: str) -> Key:
    """The key of a form such as `part.role: code`."""
    owner, _, key = form.partition(":")[0].rpartition(".")
    return owner, key


def _named(part: Schema, owner: str) -> tuple[str, Schema]:
    """The name of a definition, or the path of a mapping without one; for a list, that of its items."""
    items = part.get("items", {}) if "$ref" not in part else {}
    reference = part.get("$ref") or items.get("$ref")
    name = reference.removeprefix("#/$defs/").replace("/properties/", ".") if reference else owner
    return name.removeprefix("file."), resolved(part)
