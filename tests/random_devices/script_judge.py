"""The explainer in JavaScript as a judge: it explains frames, damaged ones and accesses to registers as Python does."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import Any

from fieldspec.codec.explain.occupants import Occupant, occupants
from fieldspec.codec.explain.spans import Span
from fieldspec.codec.layout.device import DeviceLayout, MessageLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.language.model.record import RegisterAccess
from fieldspec.targets.js.backend import shared
from fieldspec.targets.js.explainer import explainer_files
from js_output.explanations import explained_by_node, explained_by_python
from random_devices.inputs import header_values, record_values, spoiled
from random_devices.queries import Answer, Query

ACCESSES = 12
"""The accesses to registers of each message."""


class ScriptExplainer:
    """Says nothing about queries; raises AssertionError where an explanation is not that of Python."""

    def __init__(self, layout: DeviceLayout, folder: Path, number: int) -> None:
        self.layout, self.folder = layout, folder / f"script_{number}"
        for path, text in {**shared(), **explainer_files(layout, "device/explain")}.items():
            place = self.folder / path
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(text, "utf-8")

    def answers(self, queries: list[Query]) -> list[Answer]:
        """Nothing about single queries."""
        dice = random.Random(len(queries))
        jobs = [self.job(*entry) for entry in (*self._queried(queries, dice), *self._accesses(dice))]
        for job, (have,) in zip(jobs, explained_by_node(jobs), strict=True):
            wanted = explained_by_python(self.layout, job)
            assert have == wanted, f"{_difference(have, wanted)} for {job['options']} {job['request']} {job['frame']}"
        return [Answer(reason=None)] * len(queries)

    def job(self, path: tuple[str, ...], frame: bytes, request: bytes = b"") -> dict[str, Any]:
        """What Node is asked about a frame, the answer to a request if there is one."""
        names = ("link", "direction", "message")
        options = {name: value for name, value in zip(names, path, strict=False) if value}
        module = str(self.folder / "device/explain.js")
        return {"module": module, "frame": frame.hex(), "options": options, "request": request.hex()}

    def _queried(self, queries: list[Query], dice: random.Random) -> Iterator[tuple[Any, ...]]:
        """The frames of the queries: as what they are, as anything, and responses as answers to some request."""
        frames = [query for query in queries if query.kind == "frame" and query.values is None]
        for query in frames:
            yield query.path, query.data
            if dice.random() < 0.3:
                yield (), query.data
            asks = [other for other in frames if other.path[:2] == (query.path[0], "request")]
            if query.path[1] == "response" and asks and dice.random() < 0.5:
                yield query.path, query.data, dice.choice(asks).data

    def _accesses(self, dice: random.Random) -> Iterator[tuple[Any, ...]]:
        """Requests that access registers, and their responses, whole and damaged."""
        for link in self.layout.links.values():
            for message in link.messages.values():
                access = self.layout.device.register_access(message.message)
                access = access or self.layout.device.bit_access(message.message)
                if access is None or not link.request.parts:
                    continue
                for request, response in islice(accessed(self.layout, link, message, access, dice), ACCESSES):
                    known = (link.link.name, "request"), (link.link.name, "response")
                    yield known[0], request
                    yield known[0], spoiled(request, dice)
                    if response:
                        yield known[1], response, request
                        yield known[1], spoiled(response, dice), request


def accessed(
    layout: DeviceLayout, link: LinkLayout, message: MessageLayout, access: RegisterAccess, dice: random.Random
) -> Iterator[tuple[bytes, bytes]]:
    """Requests for registers that there are, with their responses."""
    present = list(occupants(layout, Span(access.space, 0, 1 << 16, 0, b"")))
    reference = codec(layout).links[link.link.name]
    for _ in range(8 * ACCESSES if present else 0):
        frames = []
        first: Occupant = dice.choice(present)
        fixed = {access.start: max(0, first.address - dice.choice((0, 0, 1)))}
        for direction in ("request", "response"):
            if message.name not in link.carried(direction):
                continue
            shape, record = link.frame(direction), message.data(direction)
            values = record_values(layout, record, dice)
            own = {name: number for name, number in fixed.items() if record.named(name) is not None}
            head = header_values(layout, link.link.name, shape, dice)
            try:
                frames.append(reference.encode(direction, message.name, {**head, **values, **own}))
            except CodecError:
                break
        else:
            yield frames[0], frames[1] if len(frames) > 1 else b""


def _difference(have: dict[str, Any], wanted: dict[str, Any]) -> str:
    """The first part of two explanations that differs."""
    if "error" in have and len(have) == 1:
        return f"it throws {have['error']}"
    for key, value in wanted.items():
        rows = zip(value, have.get(key, ()), strict=False) if isinstance(value, list) else ()
        for row, other in rows:
            if row != other:
                return f"{key}: {json.dumps(other)} instead of {json.dumps(row)}"
        if have.get(key) != value:
            return f"{key}: {json.dumps(have.get(key))} instead of {json.dumps(value)}"
    return "another key"
