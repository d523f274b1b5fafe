"""The file of test vectors: example frames and reads of an idle device as data."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from typing import TypeAlias

from fieldspec.codec.explain.examples import explained_example, printed
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.values import Raw
from fieldspec.language.model.texts import Example
from fieldspec.targets.vectors.idle_reads import IdleRead, idle_reads

Json: TypeAlias = bool | int | float | str | list["Json"] | dict[str, "Json"] | None
Vector: TypeAlias = dict[str, Json]


def vectors(layouts: Sequence[DeviceLayout]) -> list[Vector]:
    """The examples of all versions in the order of the manual; equal ones in one, with the versions that have it."""
    vectors_of_device: list[tuple[tuple[bool, int], Vector, list[Json]]] = []
    for layout in layouts:
        for example in layout.device.examples.values():
            example_vector = vector(layout, example)
            same = next((versions for _, other, versions in vectors_of_device if other == example_vector), None)
            if same is None:
                same = []
                vectors_of_device.append((_order(example), example_vector, same))
            same.append(layout.device.version)
    vectors_of_device.sort(key=lambda entry: entry[0])
    return [
        {"id": example_vector.pop("id"), "versions": versions, **example_vector}
        for _, example_vector, versions in vectors_of_device
    ]


def _order(example: Example) -> tuple[bool, int]:
    return not example.sources, example.sources[0].first() if example.sources else 0


def vector(layout: DeviceLayout, example: Example) -> Vector:
    """One example at one version, without the versions that have it."""
    print_of = printed(layout.device, example)
    source = example.sources[0] if example.sources else None
    explanation = explained_example(layout, example)
    by_characters = layout.links[example.link].link.transmission != "binary"
    return {
        "id": example.id,
        "link": example.link,
        "direction": example.direction,
        "message": example.message or None,
        "error": example.exception_response,
        "refused": example.refused or None,
        "reply_to": example.reply_to or None,
        "origin": example.origin,
        "elided": list(example.elided),
        "printed": print_of.frame.lower() or None,
        "printed_characters": print_of.characters or None,
        "right": example.frame.hex(),
        "characters": example.frame.decode("latin-1") if by_characters else None,
        "values": None if example.refused else {name: _json_value(raw) for name, raw in explanation.values.items()},
        "section": source.section or None if source else None,
        "line": source.line() if source else None,
        "verdict": print_of.verdict,
        "errata": [erratum.id for erratum in print_of.errata],
    }


def idle_vectors(layouts: Sequence[DeviceLayout]) -> list[Vector]:
    """The reads of an idle device at all versions by address; equal ones in one, with the versions that have it."""
    versions_of: dict[str, list[Json]] = {}
    vectors_of_text: dict[str, tuple[str, int, Vector]] = {}
    for layout in layouts:
        for read in idle_reads(layout):
            read_vector = idle_vector(layout, read)
            text = json.dumps(read_vector)
            versions_of.setdefault(text, []).append(layout.device.version)
            vectors_of_text.setdefault(text, (read.block.space, read.block.start, read_vector))
    ordered = sorted(vectors_of_text.items(), key=lambda item: item[1][:2])
    return [{"versions": versions_of[text], **read_vector} for text, (_, _, read_vector) in ordered]


def idle_vector(layout: DeviceLayout, read: IdleRead) -> Vector:
    """The read of a block at one version, without the versions that have it."""
    by_characters = layout.links[read.link].link.transmission != "binary"

    def frame(data: bytes, values: dict[str, Raw]) -> Json:
        return {
            "right": data.hex(),
            "characters": data.decode("latin-1") if by_characters else None,
            "values": {name: _json_value(raw) for name, raw in values.items()},
        }

    return {
        "link": read.link,
        "message": read.block.message,
        "space": read.block.space or None,
        "address": read.block.start,
        "words": read.block.words,
        "request": frame(read.request, read.request_values),
        "response": frame(read.response, read.response_values),
        "registers": {name: _json_value(raw) for name, raw in read.values.items()},
    }


def _json_value(raw: Raw) -> Json:
    """A raw value as JSON has it: bytes as hexadecimal digits; what is not a number as its name."""
    if isinstance(raw, bytes):
        return raw.hex()
    if isinstance(raw, list):
        return [_json_value(item) for item in raw]
    if isinstance(raw, dict):
        return {name: _json_value(item) for name, item in raw.items()}
    if isinstance(raw, float) and not math.isfinite(raw):
        return str(raw)
    return raw


def files(layouts: Sequence[DeviceLayout]) -> dict[str, str]:
    """The vectors of all versions of one device, the oldest first, by path."""
    device = layouts[-1].device.id
    document = {
        "device": device,
        "identities": {layout.device.version: layout.identity for layout in layouts},
        "vectors": vectors(layouts),
        "idle_reads": idle_vectors(layouts),
    }
    return {f"{device}.json": json.dumps(document, ensure_ascii=False, allow_nan=False, indent=1) + "\n"}


def shared() -> dict[str, str]:
    """No file: every vector belongs to a device."""
    return {}
