"""The generated JavaScript as a judge: one process of Node answers all queries about a device."""

from __future__ import annotations

import json
import math
import subprocess
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import Any

from external_tools import require_tool
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.foundation.names import Name
from fieldspec.language.model.encoding import is_real, is_truth
from fieldspec.language.model.value import Value
from fieldspec.targets.js.backend import shared
from fieldspec.targets.js.framing import WIDE
from fieldspec.targets.js.members import Member, members_of
from javascript_modules import module_code
from random_devices.quantities import Measured, StatedValue
from random_devices.queries import (
    ABSENT_OFFSET,
    EXPONENT,
    UNKNOWN,
    Answer,
    Query,
    flat,
    flat_value,
    has_quantity,
    quantity_text,
)

SCRIPT = Path(__file__).with_name("javascript_judge.mjs")


class JavaScript:
    """The answers of generated JavaScript."""

    def __init__(self, layout: DeviceLayout, folder: Path, number: int) -> None:
        self.layout, self.folder = layout, folder / f"javascript_{number}"
        for path, text in {**shared(), "device/module.js": module_code(layout)}.items():
            place = self.folder / path
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(text, "utf-8")

    def answers(self, queries: list[Query]) -> list[Answer]:
        """The answer to each query."""
        jobs = [self._job(query) for query in queries]
        (self.folder / "jobs.json").write_text(json.dumps(_finite(jobs), default=_bytes), "utf-8")
        command = [require_tool("node"), str(SCRIPT), str(self.folder / "device/module.js"), "jobs.json"]
        run = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False)
        if run.returncode:
            raise RuntimeError(run.stderr)
        return [self._answer(query, result) for query, result in zip(queries, json.loads(run.stdout), strict=True)]

    def _quantity_job(self, query: Query) -> dict[str, Any]:
        """What is asked about a count or a quantity: the record with the property of a field, else the names."""
        assert query.values is not None
        kind, *names = query.path
        job: dict[str, Any] = {"kind": query.kind, "noun": kind, "path": names, **query.values}
        if query.kind == "share":
            raw = _number(query.values["raw"], query.shape.type.size)
            return {**job, "path": [Name.of(names[0]).camel()], "raw": raw}
        if query.kind == "state":
            stated: StatedValue = query.shape
            if kind == "record":
                job["key"] = next(member.key for member in self._members[names[0]] if member.field.name == names[1])
            return {**job, "raw": _element(stated.value, query.values["raw"], stated.size)}
        measured: Measured = query.shape
        if kind == "record":
            job["key"] = next(member.key for member in self._members[names[0]] if member.field.name == names[1])
        if query.kind == "quantity":
            job["raw"] = _element(measured.value, query.values["raw"], measured.size)
        job["exponent"] = [] if query.values["power"] is None else [query.values["power"]]
        return job

    @cached_property
    def _members(self) -> dict[str, list[Member]]:
        """The properties of all records, by their names."""
        bodies = (body for message in self.layout.messages.values() for body in message.bodies)
        return {record.name: members_of(record) for record in (*self.layout.records.values(), *bodies)}

    def _job(self, query: Query) -> dict[str, Any]:
        if query.kind in ("quantity", "count", "share", "state"):
            return self._quantity_job(query)
        job: dict[str, Any] = {"kind": query.kind, "path": query.path, "data": query.data.hex(), "error": query.error}
        coded = query.kind == "frame" and self.layout.links[query.path[0]].frame(query.path[1]).role("code") is not None
        job["carriesCode"] = coded
        job["encodes"] = query.values is not None
        if query.values is None:
            if query.kind in ("register", "parameter") and has_quantity(query.shape[0]):
                job["exponent"] = [EXPONENT] if query.shape[0].scale_by else []
            return job
        if query.kind == "frame":
            parts = self._parts(query)
            names = {part.name for part in self.layout.links[query.path[0]].frame(query.path[1]).header}
            job["header"] = {key: _number(query.values[name], size) for name, key, size in parts}
            values = {name: value for name, value in query.values.items() if name not in names}
            job["values"] = object_of(query.shape, values)
            job["code"] = {"$n": str(query.code)} if (query.code or 0) >= 2**53 else query.code
        elif query.kind == "record":
            job["values"] = object_of(query.shape, query.values)
        else:
            value, size = query.shape[0], query.shape[4]
            job["values"] = _element(value, query.values[query.path[-1]], size)
        return job

    def _parts(self, query: Query) -> list[tuple[str, str, int]]:
        """The name, the property and the size of each part of the header that users supply."""
        frame = self.layout.links[query.path[0]].frame(query.path[1])
        return [
            (part.name, "unitAddress" if part.role == "unit_address" else Name.of(part.name).camel(), part.size)
            for part in frame.header
            if part.is_argument
        ]

    def raised(self, result: dict[str, Any]) -> Answer:
        """The answer where an exception is not a refusal, which is a mistake of the codec or of a judge. Raises it."""
        raise RuntimeError(result["stack"])

    def _answer(self, query: Query, result: dict[str, Any]) -> Answer:
        if "raises" in result:
            return self.raised(result)
        if "error" in result:
            reason, offset = result["error"]
            placed = query.kind in ("frame", "record")
            return Answer(reason, (ABSENT_OFFSET if offset is None else offset) if placed else None)
        if query.kind == "count":
            again = _scalar(result["again"])
            return Answer(reason=None) if again is None else Answer(again=str(again))
        if query.kind == "state":
            return Answer(quantity=str(result["state"]))
        if query.kind in ("quantity", "share"):
            number = _scalar(result["quantity"])
            text = float(number["$f"]) if isinstance(number, dict) else number
            return Answer(quantity=quantity_text(text, result["state"]))
        if query.values is not None or query.kind == "subindex":
            return Answer(again=result["again"])
        quantity = None
        if "quantity" in result:
            number = _scalar(result["quantity"])
            quantity = quantity_text(float(number["$f"]) if isinstance(number, dict) else number, result["state"])
        values: str
        if query.kind == "frame":
            data = result["value"]
            link = self.layout.links[query.path[0]]
            exception = link.link.exception_response
            if data["kind"] == "exception" and exception is not None:
                record = self.layout.records[exception.record]
            else:
                record = self.layout.messages[data["name"]].data(query.path[1])
            head = "".join(f"{_scalar(data['header'][key])};" for _, key, _ in self._parts(query))
            code = data["code"] if link.frame(query.path[1]).role("code") is not None else None
            values = f"{head}|{int(data['kind'] == 'exception')}|{code}|"
            values += flat(record, values_of(record, data["data"]))
        elif query.kind == "record":
            values = flat(query.shape, values_of(query.shape, result["value"]))
        else:
            values = flat_value(query.shape[0], _typed(query.shape[0], result["value"]))
        # Which NaN an engine writes is its own choice, and it may change while a program runs.
        again = UNKNOWN if json.dumps({"$f": "NaN"}) in json.dumps(result["value"]) else result["again"]
        return Answer(values=values, again=again, quantity=quantity)


def object_of(record: RecordLayout, values: Mapping[str, Any]) -> dict[str, Any]:
    """The object of some values of a record, as JSON of the judge."""
    keys = {member.field.name: member for member in members_of(record)}
    chosen = record.decided_by(values)
    result: dict[str, Any] = {}
    for name, value in values.items():
        field = chosen.named(name) or record.named(name)
        member = keys.get(name)
        if field is None or member is None or not member.key:
            result[name] = value
            continue

        def element(item: Any, field: Any = field) -> Any:
            if field.record is not None and isinstance(item, Mapping):
                return object_of(field.record, item)
            if field.value is None:
                return item
            return _element(field.value, item, field.size)

        result[member.key] = [element(item) for item in value] if isinstance(value, list) else element(value)
    return result


def values_of(record: RecordLayout, data: Mapping[str, Any]) -> dict[str, Any]:
    """The values of a record from the object that the judge prints."""
    selectors = {own.name for own in (record.selector, *(field.selector for field in record.fields)) if own is not None}
    keys = {member.field.name: member.key for member in members_of(record) if member.key}
    chosen = record.decided_by({name: _scalar(data[keys[name]]) for name in selectors & keys.keys()})
    decided = {field.name for field in record.fields if field.cases}
    result = {}
    for member in members_of(chosen):
        field = member.field
        if not member.key:
            if field.name in decided and field.value is not None:
                # Objects do not have the constant that a selector has chosen.
                result[field.name] = field.value.const
            continue

        def element(item: Any, field: Any = field) -> Any:
            return values_of(field.record, item) if field.record is not None else _typed(field.value, item)

        item = data[member.key]
        result[field.name] = [element(inner) for inner in item] if field.is_list else element(item)
    return result


def _bytes(item: Any) -> dict[str, str]:
    """Bytes in place of a value that has none, as JSON of the judge."""
    return {"$b": item.hex()}


def _element(value: Value, item: Any, size: int) -> Any:
    encoding = value.encoding
    if is_truth(encoding) and item in (0, 1):
        return bool(item)
    if isinstance(item, bytes | bytearray):
        return {"$b": bytes(item).hex()}
    return _number(item, value.number_size(size))


def _number(item: Any, size: int) -> Any:
    if isinstance(item, int) and not isinstance(item, bool):
        return {"$n": str(item)} if size > WIDE else item if abs(item) < 1 << 53 else {"$f": str(item)}
    return item


def _finite(item: Any) -> Any:
    """Jobs with the numbers that JSON does not have by their names, wherever they stand."""
    if isinstance(item, Mapping):
        return {key: _finite(inner) for key, inner in item.items()}
    if isinstance(item, list | tuple):
        return [_finite(inner) for inner in item]
    if isinstance(item, float) and not math.isfinite(item):
        return {"$f": "NaN" if math.isnan(item) else "Infinity" if item > 0 else "-Infinity"}
    return item


def _scalar(item: Any) -> Any:
    if isinstance(item, dict) and "$n" in item:
        return int(item["$n"])
    return item


def _typed(value: Value, item: Any) -> Any:
    item = _scalar(item)
    if isinstance(item, dict):
        return bytes.fromhex(item["$b"]) if "$b" in item else float(item["$f"])
    return float(item) if is_real(value.encoding) else item
