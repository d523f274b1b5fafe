"""Judgements that need the spec: examples of its own frames are proven, and an identity is equal where the wire is."""

from __future__ import annotations

import copy
import random
from collections.abc import Callable, Iterator
from typing import Any

from fieldspec.codec.explain.readings import FrameOptions, read_frame
from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.project import read as read_project
from fieldspec.tools.proofs.running import outcome
from random_devices.devices import text_of
from random_devices.draft import SIZES, Spec
from random_devices.queries import Answer, Query, is_stable
from random_devices.reference_answers import Reference

_ALIKE = {"u8": "i8", "u16": "i16", "u32": "i32", "u64": "i64", "i8": "u8", "i16": "u16", "i32": "u32", "i64": "u64"}


def layouts_of(spec: Spec) -> list[DeviceLayout] | str:
    """The layouts of all versions of a spec; the first finding where it has some."""
    project = read_project({"chance/device.yaml": text_of(spec).encode()})
    findings = list(project.findings)
    if not has_errors(findings):
        findings += outcome(project.devices["chance"]).findings
    if has_errors(findings):
        return next(f"{f.code}: {f.message}" for f in findings if f.severity.name == "ERROR")
    device = project.devices["chance"]
    return [device_layout(device.at(version)[0]) for version in device.versions()]


# Examples


def with_examples(spec: Spec, layout: DeviceLayout, queries: list[Query], most: int = 12) -> Spec:
    """The spec with frames of the reference as examples."""
    reference = Reference(layout)
    examples = []
    for query in queries:
        if query.kind != "frame" or query.values is None or len(examples) >= most or _addresses(layout, query):
            continue
        if not is_stable(query.values) or not _is_writable(query.values):
            continue
        answer = reference.answer(query)
        if answer.reason:
            continue
        link, direction, message = query.path
        example: Spec = {"id": f"frame-{len(examples)}", "link": link, "direction": direction, "message": message}
        if query.error:
            example["exception_response"] = True
        frame = bytes.fromhex(answer.again or "")
        if not frame:
            continue
        values = {name: _entered(value) for name, value in query.values.items()}
        examples.append(
            {**example, "frame": frame.hex(" "), "values": values, "origin": "computed", "notes": "By chance."}
        )
        if layout.device.version != "1":
            examples[-1]["only"] = [layout.device.version]
    return {**spec, "examples": [*spec.get("examples", ()), *examples]}


def _addresses(layout: DeviceLayout, query: Query) -> bool:
    """Whether a frame accesses registers, of which not all addresses exist."""
    return layout.messages[query.path[2]].message.single_access is not None


def _is_writable(value: Any) -> bool:
    if isinstance(value, dict):
        return all(map(_is_writable, value.values()))
    if isinstance(value, list):
        return all(map(_is_writable, value))
    if isinstance(value, str):
        return value.isprintable() and value == value.strip()
    return not isinstance(value, float) or (value.is_integer() and abs(value) < 1e6 and str(value) != "-0.0")


def _entered(value: Any) -> Any:
    if isinstance(value, dict):
        return {name: _entered(inner) for name, inner in value.items()}
    if isinstance(value, list):
        return [_entered(inner) for inner in value]
    if isinstance(value, bytes):
        return value.hex(" ")
    return int(value) if isinstance(value, float) else value


def examples_are_proven(spec: Spec, layouts: list[DeviceLayout], queries: list[Query]) -> Iterator[str]:
    """The findings of a spec with examples of its own frames."""
    enriched = with_examples(spec, layouts[-1], queries)
    if enriched["examples"]:
        result = layouts_of(enriched)
        if isinstance(result, str):
            yield f"examples: {result}"
            return
        for example in result[-1].device.examples.values():
            same = [other for other in result[-1].device.examples.values() if other.frame == example.frame]
            explanation = read_frame(result[-1], example.frame, FrameOptions()).explanation
            reading = explanation.link, explanation.direction, explanation.message, explanation.error
            if reading not in [(e.link, e.direction, e.message, e.exception_response) for e in same]:
                yield f"examples: {example.frame.hex(' ')} is explained as {reading}, not as {example.id}"


# Identities


def changed(spec: Spec, dice: random.Random) -> tuple[Spec, bool] | None:
    """The spec with one change, and whether only documentation has changed."""
    other = copy.deepcopy(spec)
    places = list(_mappings(other))
    if dice.random() < 0.4:
        fact = dice.choice([fact for fact in places if "name" in fact and "source" in fact])
        fact[dice.choice(("doc", "label"))] = "Other words."
        return other, True
    change: Callable[[Spec], bool]
    candidates = [(fact, change) for fact in places for change in CHANGES if change(copy.deepcopy(fact))]
    if not candidates:
        return None
    fact, change = dice.choice(candidates)
    change(fact)
    return other, False


def _mappings(node: Any) -> Iterator[Spec]:
    if isinstance(node, dict):
        yield node
    for inner in node.values() if isinstance(node, dict) else node if isinstance(node, list) else ():
        yield from _mappings(inner)


def _other_sign(fact: Spec) -> bool:
    if fact.get("type") not in _ALIKE or {"enum", "flags", "const", "range", "sentinels", "role", "bits"} & set(fact):
        return False
    fact["type"] = _ALIKE[fact["type"]]
    return True


def _other_order(fact: Spec) -> bool:
    if SIZES.get(fact.get("type", ""), 0) < 2 or "byte_order" not in fact:
        return False
    fact["byte_order"] = "little" if fact["byte_order"] == "big" else "big"
    return True


def _other_padding(fact: Spec) -> bool:
    if fact.get("digits") != "decimal" or "padding" not in fact:
        return False
    del fact["padding"]
    return True


def _other_constant(fact: Spec) -> bool:
    if "const" not in fact:
        return False
    fact["const"] = fact["const"] + (1 if fact["const"] < 1 else -1)
    return True


def _other_code(fact: Spec) -> bool:
    if "code" not in fact:
        return False
    fact["code"] = (fact["code"] + 1) % 128
    return True


def _other_plus(fact: Spec) -> bool:
    if "plus" not in fact:
        return False
    fact["plus"] += 1
    return True


def _other_algorithm(fact: Spec) -> bool:
    if fact.get("algorithm") not in ("sum8", "lrc"):
        return False
    fact["algorithm"] = "lrc" if fact["algorithm"] == "sum8" else "sum8"
    return True


def _other_mark(fact: Spec) -> bool:
    if "start" not in fact or "transmission" not in fact:
        return False
    fact["start"] = "7E"
    return True


def _other_open(fact: Spec) -> bool:
    if "members" not in fact:
        return False
    fact["open"] = not fact.get("open", False)
    return True


CHANGES = (
    _other_sign,
    _other_order,
    _other_padding,
    _other_constant,
    _other_code,
    _other_plus,
    _other_algorithm,
    _other_mark,
    _other_open,
)
"""Changes of one fact that a frame may show: each changes it in place and says whether it could."""


def identities_agree(
    spec: Spec, layout: DeviceLayout, queries: list[Query], expected: list[Answer], dice: random.Random
) -> Iterator[str]:
    """Where a changed spec has the same identity, it answers the same; words of documentation never change one."""
    change = changed(spec, dice)
    result = layouts_of(change[0]) if change is not None else ""
    if change is None or isinstance(result, str):
        return
    other = result[-1]
    if change[1]:
        if other.identity != layout.identity:
            yield "identity: other words of documentation change it"
        return
    if other.identity != layout.identity:
        return
    reference = Reference(other)
    for query, answer in zip(queries, expected, strict=True):
        if query.kind == "frame" and (differences := answer.differences(reference.answer(query))):
            yield f"identity: it is the same, but for {query.path} {query.data.hex(' ')}: {differences[0]}"
            return
