"""Derives which outputs a key of the language changes: it changes the key in made-up devices, and compares the outputs.

A witness is one such change: a device, a spec file, the keys that lead to the place in it, and the text that stands
there instead, None where the key is taken away.
"""

from __future__ import annotations

import itertools
import json
import re
from collections import abc, defaultdict
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from capability_projects import MANUALS, PROJECTS
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.pipeline import layouts
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.behaviour.part import Part
from fieldspec.language.behaviour.reading import behaviour_of
from fieldspec.language.diagnostics import Severity, has_errors
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence
from fieldspec.language.reading.project import read
from fieldspec.language.reading.yaml_reader import decoded, parsed
from fieldspec.language.schema import Schema, resolved, schema
from fieldspec.language.schema.capabilities import AUDIT, CHECK, EXPORT, SIMULATOR
from fieldspec.targets import BUILT_IN, OUTPUTS
from fieldspec.tools.audit.manual_lines import index_of
from fieldspec.tools.audit.report import report
from fieldspec.tools.audit.section import Subject
from fieldspec.tools.facts import of_versions
from fieldspec.tools.lists.export import as_csv
from fieldspec.tools.lists.item import items
from fieldspec.tools.proofs.running import errata_proofs, proven

Key = tuple[str, str]
Way = tuple[str | int, ...]

WITNESSES = Path(__file__).with_name("capability_witnesses.json")


class Witness(NamedTuple):
    """A change of a spec that shows which outputs a key changes. `project` is a key of PROJECTS."""

    project: str
    path: str
    way: Way
    text: str | None


class Place(NamedTuple):
    """Where a mapping or a value stands: its project and file, the keys that lead there, and its part of the schema."""

    project: str
    path: str
    way: Way
    node: Node
    part: Schema


def name_of(part: Schema, name: str) -> str:
    """The name of a part of the schema: that of its definition, or the keys that lead to it."""
    return str(part.get("$ref", name)).removeprefix("#/$defs/").replace("/properties/", ".")


def legal_keys() -> dict[Key, Schema]:
    """All keys of the schema by the part that has them. The keys of every fact stand at `fact` alone."""
    keys: dict[Key, Schema] = {}
    seen: set[str] = set()

    def walk(part: Schema, name: str) -> None:
        name = name_of(part, name)
        if name in seen:
            return
        seen.add(name)
        part = resolved(part)
        for key, inner in part.get("properties", {}).items():
            if key == "name" or not str(inner.get("$ref", "")).startswith("#/$defs/fact/"):
                keys[name, key] = inner
            walk(inner, f"{name}.{key}")
        for more, suffix in (("items", "[]"), ("additionalProperties", "{}")):
            if isinstance(part.get(more), dict):
                walk(part[more], name + suffix)

    walk(schema(), "")
    for key, inner in schema()["$defs"]["fact"]["properties"].items():
        if key != "name":
            keys["fact", key] = inner
    return keys


def parsed_text(text: str) -> Node:
    """A text of a spec as a node."""
    node, _ = parsed(SourceFile("witness", text))
    assert node is not None
    return node


@cache
def trees(project: str) -> dict[str, Node]:
    """The spec files of a project, with untyped scalars."""
    result = {}
    for path, data in PROJECTS[project].items():
        file = decoded(path, data)[0]
        node = parsed(file)[0] if file is not None else None
        if node is not None:
            result[path] = node
    return result


@cache
def places() -> tuple[dict[Key, list[Place]], dict[str, list[Place]]]:
    """The values of all keys, and the mappings by the name of their part, in the order of the devices and files."""
    values: dict[Key, list[Place]] = defaultdict(list)
    mappings: dict[str, list[Place]] = defaultdict(list)

    def walk(project: str, path: str, node: Node, part: Schema, name: str, way: Way) -> None:
        name, whole = name_of(part, name), resolved(part)
        if isinstance(node, Sequence):
            for number, item in enumerate(node.items):
                walk(project, path, item, whole.get("items", {}), name + "[]", (*way, number))
        elif isinstance(node, Mapping):
            mappings[name].append(Place(project, path, way, node, part))
            known = whole.get("properties", {})
            for key, inner in node.values.items():
                inner_part = known.get(key) or whole.get("additionalProperties") or {}
                if key in known:
                    values[name, key].append(Place(project, path, (*way, key), inner, inner_part))
                walk(project, path, inner, inner_part, f"{name}.{key}" if key in known else name + "{}", (*way, key))

    for project in PROJECTS:
        for path, tree in trees(project).items():
            walk(project, path, tree, schema(), "", ())
    return values, mappings


def yaml_text(node: Node) -> str:
    """A node as YAML in one line."""
    if isinstance(node, Scalar):
        bare = not node.quoted and re.fullmatch(r"~|[-+.\w/]+( [-+.\w/]+)*", node.text)
        return node.text if bare else json.dumps(node.text, ensure_ascii=False) if node.text or node.quoted else "~"
    if isinstance(node, Sequence):
        return f"[{', '.join(map(yaml_text, node.items))}]"
    return "{" + ", ".join(f"{json.dumps(key)}: {yaml_text(value)}" for key, value in node.values.items()) + "}"


def put(node: Node, way: Way, new: Node | None) -> Node:
    """A tree with another node at the end of a way, or without it."""
    step, rest = way[0], way[1:]
    if isinstance(node, Mapping):
        assert isinstance(step, str)
        if not rest:
            return node.without(step) if new is None else node.with_value(step, new)
        return node.with_value(step, put(node.values[step], rest, new))
    assert isinstance(node, Sequence)
    inner = list(node.items)
    if rest:
        inner[int(step)] = put(inner[int(step)], rest, new)
    else:
        inner[int(step) : int(step) + 1] = [] if new is None else [new]
    return Sequence(node.file, node.start, node.end, tuple(inner))


def audit_text(project: str, spec: DeviceSpec, versions: list[DeviceLayout]) -> str:
    """The audit of the newest version, without places in the files of the spec; with its manual, also the findings."""
    path = MANUALS.get(project)
    manual = index_of(path.name, path.read_bytes()) if path is not None else None
    subject = Subject(spec, versions[-1], versions, of_versions(versions), errata_proofs(spec), manual=manual)
    sections = report(subject).sections
    findings = [finding.message for section in sections for finding in section.findings] if manual is not None else []
    rows: list[object] = [findings] if findings else []
    rows += [
        [*(table.columns for table in section.tables), section.paragraphs, section.figures, section.questions]
        + [["" if isinstance(cell, Span) else cell for cell in row] for table in section.tables for row in table.rows]
        for section in sections
    ]
    return repr(rows)


def behaviour_text(spec: DeviceSpec) -> str:
    """What the simulator knows of all versions, without the places in the files of the spec."""
    return repr([_placeless(behaviour_of(spec.tree_at(version)).parts) for version in spec.versions()])


def _placeless(value: object) -> object:
    if isinstance(value, Part):
        keys = {key: _placeless(inner) for key, inner in value.keys.items()}
        sources = [str(source) for source in value.sources]
        return value.kind, value.name, keys, value.assumed, sources, value.standard
    if isinstance(value, abc.Mapping):
        return {key: _placeless(inner) for key, inner in value.items()}
    return [_placeless(inner) for inner in value] if isinstance(value, tuple) else value


def spec_of(project: str, changed: dict[str, bytes], folders: tuple[str, str] = ("", "")) -> DeviceSpec | None:
    """The device of a project with other texts of some files; None if they cannot be read.

    `folders` are the old and the new name of the folder of a device with another identifier.
    """
    old, new = folders
    files = PROJECTS[project] | changed
    result = read({re.sub(rf"^{old}/", f"{new}/", path) if old else path: data for path, data in files.items()})
    return None if has_errors(result.findings) else next(iter(result.devices.values()), None)


def outputs_of(project: str, spec: DeviceSpec) -> dict[str, str]:
    """Everything that is made of the device of a project, by output, without the identity."""
    versions = layouts(spec)
    contents = {
        EXPORT: "".join(as_csv(items(layout)) for layout in versions),
        AUDIT: audit_text(project, spec, versions),
        SIMULATOR: behaviour_text(spec),
    }
    for name in sorted(BUILT_IN):
        refused = [finding for finding in OUTPUTS[name].refusals(versions) if finding.severity is Severity.ERROR]
        files: object = sorted(finding.code for finding in refused) if refused else OUTPUTS[name].files(versions)
        contents[name] = str(files) if isinstance(files, list) else json.dumps(files, default=repr)
    for layout in versions:
        contents = {name: text.replace(layout.identity, "identity") for name, text in contents.items()}
    return contents


def findings_of(spec: DeviceSpec) -> set[tuple[str, str]]:
    """The findings of a device without their places."""
    return {(finding.code, finding.message) for finding in proven(spec)}


@cache
def unchanged(project: str, path: str) -> tuple[DeviceSpec, dict[str, str]] | None:
    """A device as it is, with one of its files in the form in which changes are written, and its outputs."""
    spec = spec_of(project, {path: yaml_text(trees(project)[path]).encode()})
    return None if spec is None else (spec, outputs_of(project, spec))


def _changed_spec(witness: Witness, text: str) -> DeviceSpec | None:
    """The device of a changed file; the folder follows where its identifier changes."""
    folder = witness.path.partition("/")[0]
    folders = (folder, witness.text or "") if witness.way == ("device", "id") else ("", "")
    return spec_of(witness.project, {witness.path: text.encode()}, folders)


def is_refused(witness: Witness) -> bool:
    """Whether the findings refuse a change of a device that they do not refuse as it is."""
    new = None if witness.text is None else parsed_text(witness.text)
    present = unchanged(witness.project, witness.path)
    spec = _changed_spec(witness, yaml_text(put(trees(witness.project)[witness.path], witness.way, new)))
    return present is not None and (spec is None or (has_errors(proven(spec)) and not has_errors(proven(present[0]))))


def changed_outputs(witness: Witness) -> set[str] | None:
    """The outputs that a change changes; None where it leaves no device. Findings count where nothing else changes."""
    new = None if witness.text is None else parsed_text(witness.text)
    text = yaml_text(put(trees(witness.project)[witness.path], witness.way, new))
    try:
        present = unchanged(witness.project, witness.path)
        spec = _changed_spec(witness, text)
        if spec is None or present is None:
            return None
        original, before = present
        changed = {name for name, text in outputs_of(witness.project, spec).items() if text != before[name]}
    except (AssertionError, KeyError, IndexError, TypeError, ValueError, AttributeError):
        return None  # a device with findings may have no layout
    return changed or ({CHECK} if findings_of(spec) != findings_of(original) else set())


def candidates(key: Key) -> Iterator[Witness]:
    """Changes of a key where it stands, and additions where it does not."""
    values, mappings = places()
    own = values[key] if key[0] != "fact" else values["register", key[1]] + values["message", key[1]]
    for place in own[:4]:
        for text in itertools.islice(_other_texts(place, [other.node for other in own]), 6):
            yield Witness(place.project, place.path, place.way, text)
    known = [place.node for (_, name), all_places in values.items() if name == key[1] for place in all_places]
    for place in mappings[key[0] if key[0] != "fact" else "register"][:4]:
        assert isinstance(place.node, Mapping)
        if key[1] not in place.node.values and place.way:
            for text in _new_texts(key[1], legal_keys()[key], known):
                yield Witness(place.project, place.path, (*place.way, key[1]), text)


def _other_texts(place: Place, known: list[Node]) -> Iterator[str | None]:
    node, part = place.node, resolved(place.part)
    if isinstance(node, Scalar):
        text = node.text
        if "enum" in part:
            yield from (word for word in part["enum"] if word != text)
        elif text in ("true", "false"):
            yield "false" if text == "true" else "true"
        elif re.fullmatch(r"-?(0x[0-9A-Fa-f]+|0|[1-9]\d*)", text):
            yield from (str(number) for number in (int(text, 0) + 1, max(0, int(text, 0) - 1), 2, 3))
        elif re.fullmatch(r"-?\d+\.\d+", text):
            yield str(float(text) * 2)
        elif match := re.fullmatch(r"(-?\d+)(\.\.|-)(\d+)", text):
            yield f"{match[1]}{match[2]}{int(match[3]) - 1}"
        elif re.search(r"L\d", text):
            yield re.sub(r"L(\d+)", lambda match: f"L{int(match[1]) + 1}", text, count=1)
        elif re.fullmatch(r"[a-z][a-z0-9_]*", text):
            yield f"{text}_other"
            yield from (yaml_text(other) for other in known if isinstance(other, Scalar) and other.text != text)
        else:
            yield json.dumps(f"{text} other")
    if isinstance(node, Sequence) and len(node.items) > 1:
        yield yaml_text(Sequence(node.file, node.start, node.end, node.items[:-1]))
    yield None


_NEW = {
    "source": "L7",
    "notes": "[A note that nobody reads.]",
    "label": "Etikett",
    "printed_name": "PrtName",
    "doc": "It does something else.",
    "section": '"3.3"',
    "title": "A title",
    "inferred": "{doc: because}",
    "standard": "{unit: {name: IEC 1, clause: '3'}}",
    "reported": "[{by: a user, how: by trying, unit: mm}]",
    "allow": "{bits_unique: A reason.}",
    "restated": "[{source: L9, printed_name: Other}]",
    "roles": "[busy]",
    "range": "1..2",
    "unit_range": "1..2",
    "write_range": "1",
    "scale": "0.5",
    "unit": "mm",
    "default": "1",
    "unit_default": "1",
    "const": "1",
    "sentinels": "[{value: 1, name: absent}]",
    "memory": "volatile",
    "endurance": "1000",
}


def _new_texts(key: str, part: Schema, known: list[Node]) -> Iterator[str]:
    part = resolved(part)
    if key in _NEW:
        yield _NEW[key]
    elif "enum" in part:
        yield from part["enum"][:2]
    elif part.get("type") == "boolean":
        yield "true"
    elif part.get("type") == "integer":
        yield from ("2", "1")
    yield from map(yaml_text, known[:2])


def derived(key: Key, most: int = 5) -> tuple[set[str], list[Witness]]:
    """The outputs that a key changes, of all tries together, and the changes that show it."""
    outputs: set[str] = set()
    witnesses: list[Witness] = []
    sound = 0
    for candidate in candidates(key):
        changed = changed_outputs(candidate)
        if changed is None:
            continue
        sound += 1
        if changed - outputs or (not witnesses and sound == 1):
            witnesses.append(candidate)
        outputs |= changed
        if sound == most:
            break
    return outputs, witnesses


def stored_witnesses() -> dict[Key, list[Witness]]:
    """The witnesses of each key that a file next to this one has."""
    data: dict[str, dict[str, list[Any]]] = json.loads(WITNESSES.read_text("utf-8"))
    return {
        (kind, key): [Witness(device, path, tuple(way), text) for device, path, way, text in rows]
        for kind, keys in data.items()
        for key, rows in keys.items()
    }
