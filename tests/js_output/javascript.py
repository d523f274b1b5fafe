"""The generated JavaScript, built once, and the judge that runs frames through it in Node."""

from __future__ import annotations

import json
import math
import subprocess
import tempfile
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from external_tools import require_tool
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.reference import CodecError, DeviceCodec
from fieldspec.codec.reference.frames import Decoded
from fieldspec.foundation.names import Name, version_word
from fieldspec.language.model.encoding import is_count
from fieldspec.targets.js.backend import files, shared
from fieldspec.targets.js.members import members_of
from layouts import SPECS, TEST_SPECS, layouts

JUDGE = Path(__file__).with_name("judge.mjs")


@cache
def package() -> Path:
    """The folder with the modules of all devices, the real and the made-up ones."""
    folder = Path(tempfile.mkdtemp(prefix="fieldspec-js-"))
    texts = dict(shared())
    for root in (SPECS, TEST_SPECS):
        for versions in layouts(root).values():
            texts |= files(versions)
    for path, text in texts.items():
        place = folder / path
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, "utf-8")
    return folder


def module_path(layout: DeviceLayout) -> str:
    """The module of a version, or of the version that it is equal to."""
    device = layout.device
    return str(package() / Name.of(device.id).snake().replace("_", "-") / f"{version_word(device.version)}.js")


def judged(jobs: Iterable[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """What the generated modules make of some frames, in order."""
    node = require_tool("node")
    with tempfile.NamedTemporaryFile("w", suffix=".jsonl", encoding="utf-8") as file:
        for job in jobs:
            file.write(json.dumps(job) + "\n")
        file.flush()
        run = subprocess.run([node, str(JUDGE), file.name], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return [json.loads(line) for line in run.stdout.splitlines()]


def portable(value: Any) -> Any:
    """A value of the reference codec as the judge prints it."""
    if isinstance(value, bytes):
        return {"$b": value.hex()}
    if isinstance(value, float):
        if math.isnan(value):
            return {"$f": "NaN"}
        if math.isinf(value):
            return {"$f": "Infinity" if value > 0 else "-Infinity"}
        if value == 0 and math.copysign(1, value) < 0:
            return {"$f": "-0"}
        return int(value) if value == int(value) else value
    return value


def values_of(record: RecordLayout, values: Mapping[str, Any]) -> dict[str, Any]:
    """The values of a record as the object that the generated code returns."""
    if record.selector is not None:
        record = record.of_number(values[record.selector.name]) or record
    expected = {}
    for member in members_of(record):
        if not member.key:
            continue
        field, value = member.field, values[member.field.name]
        if field.selector is not None:
            field = field.form_of(values[field.selector.name]) or field

        def element(item: Any, field: Any = field) -> Any:
            if field.record is not None:
                return values_of(field.record, item)
            if is_count(field.value.encoding) and field.value.number_size(field.size) > 6:
                return {"$n": str(item)}
            return portable(item)

        expected[member.key] = [element(item) for item in value] if field.is_list else element(value)
    return dict(sorted(expected.items()))


def expectation(
    layout: DeviceLayout, codec: DeviceCodec, link: str, direction: str, message: str, frame: bytes
) -> dict[str, Any]:
    """What the judge must say of a frame, by the reference codec."""
    try:
        decoded = codec.links[link].decode(frame, direction, message)
    except CodecError as error:
        return {"error": [error.reason, error.offset]}
    return {"value": meaning(layout, decoded)}


def meaning(layout: DeviceLayout, decoded: Decoded) -> dict[str, Any]:
    """The meaning of a frame as the judge prints it."""
    header = {}
    for part in layout.links[decoded.link].frame(decoded.direction).header:
        if part.is_argument and not part.reserved:
            key = "unitAddress" if part.role == "unit_address" else Name.of(part.name).camel()
            header[key] = decoded.head[part.name]
    assert decoded.body is not None
    return {
        "kind": "exception" if decoded.error else decoded.direction,
        "message": decoded.message.name if decoded.message is not None else None,
        "header": dict(sorted(header.items())),
        "data": values_of(decoded.body, decoded.values),
    }
