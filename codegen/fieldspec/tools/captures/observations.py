"""What captures show of a device, added up over the tables of frames and values, batch by batch."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np
import pyarrow as pa
from pyarrow import compute

from fieldspec.foundation.classes import dataclass, field

MOST_TEXTS = 12
"""The texts that are remembered of one register."""

Access = tuple[str, str, int | None, int | None]
"""The message, the space, the first address and the number of what a request asks for."""


@dataclass(slots=True)
class RegisterUse:
    """The use of one register by one operation: how often, the bounds of its values, its texts, and its verdicts."""

    space: str
    register: str
    operation: str
    address: int | None
    unit: str
    count: int = 0
    low: float | None = None
    high: float | None = None
    raw_low: int | None = None
    raw_high: int | None = None
    texts: set[str] = field(default_factory=set)
    verdicts: Counter[str] = field(default_factory=Counter)


@dataclass(slots=True)
class AccessUse:
    """One kind of request: how often it was sent, answered and refused, with the nanoseconds until the answers.

    `unchanged` counts the answers with the same data as the answer before, among `compared`. `first` and `last` are
    the times of the requests.
    """

    requests: int = 0
    answers: int = 0
    exceptions: Counter[str] = field(default_factory=Counter)
    delays: int = 0
    delay_sum: int = 0
    delay_high: int = 0
    compared: int = 0
    unchanged: int = 0
    first: int | None = None
    last: int | None = None


class Observations:
    """Everything seen so far. `broadcast` is the unit address that no device answers, None where there is none."""

    def __init__(self, broadcast: int | None) -> None:
        self.broadcast = broadcast
        self.registers: dict[tuple[str, str, str], RegisterUse] = {}
        self.accesses: dict[Access, AccessUse] = {}
        self.frames: Counter[str] = Counter()
        self.units: Counter[int] = Counter()
        self.sources: set[str] = set()

    def add_frames(self, batch: Any) -> None:
        """Adds a batch of the table of frames."""
        table = pa.Table.from_batches([batch])
        for row in table.group_by(["source", "verdict"]).aggregate([("frame", "count")]).to_pylist():
            self.frames[row["verdict"]] += row["frame_count"]
            self.sources.add(row["source"])
        valid = compute.is_in(table["verdict"].cast(pa.string()), pa.array(["ok", "mismatch"]))
        table = table.filter(valid)
        for row in table.group_by(["unit_address"]).aggregate([("frame", "count")]).to_pylist():
            if row["unit_address"] is not None:
                self.units[row["unit_address"]] += row["frame_count"]
        keys = ["message", "space", "address", "count"]
        own = table.append_column("moment", table["time"].cast(pa.int64()))
        is_request = compute.equal(own["direction"].cast(pa.string()), "request")
        requests = own.filter(is_request)
        if self.broadcast is not None:
            is_unicast = compute.not_equal(requests["unit_address"], self.broadcast)
            requests = requests.filter(compute.fill_null(is_unicast, True))
        totals_asked = requests.group_by(keys).aggregate([("frame", "count"), ("moment", "min"), ("moment", "max")])
        for row in totals_asked.to_pylist():
            use = self._use(row)
            use.requests += row["frame_count"]
            use.first = _least(use.first, row["moment_min"])
            use.last = _greatest(use.last, row["moment_max"])
        answers = own.filter(compute.and_(compute.invert(is_request), compute.is_valid(own["request"])))
        totals = [("frame", "count"), ("delay", "count"), ("delay", "sum"), ("delay", "max")]
        for row in answers.group_by([*keys, "exception"]).aggregate(totals).to_pylist():
            use = self._use(row)
            use.answers += row["frame_count"]
            if row["exception"] is not None:
                use.exceptions[row["exception"]] += row["frame_count"]
            use.delays += row["delay_count"]
            use.delay_sum += row["delay_sum"] or 0
            use.delay_high = max(use.delay_high, row["delay_max"] or 0)
        self._compare(answers, keys)

    def _compare(self, answers: Any, keys: list[str]) -> None:
        """Counts the answers with the same data as the answer before to the same request."""
        answers = answers.filter(compute.is_valid(answers["data"]))
        if not answers.num_rows:
            return
        places = [_codes(answers[key]) for key in ("source", "stream", "unit_address", *keys)]
        data = _codes(answers["data"])
        order = np.lexsort((np.arange(len(data)), *places))
        same = np.ones(len(order) - 1, np.bool_)
        for place in places:
            same &= place[order][1:] == place[order][:-1]
        equal = same & (data[order][1:] == data[order][:-1])
        rows = answers.select(keys).take(order[1:])
        rows = rows.append_column("same", pa.array(same.astype(np.int64)))
        rows = rows.append_column("equal", pa.array(equal.astype(np.int64)))
        for row in rows.group_by(keys).aggregate([("same", "sum"), ("equal", "sum")]).to_pylist():
            use = self._use(row)
            use.compared += row["same_sum"]
            use.unchanged += row["equal_sum"]

    def _use(self, row: dict[str, Any]) -> AccessUse:
        key = (row["message"] or "", row["space"] or "", row["address"], row["count"])
        return self.accesses.setdefault(key, AccessUse())

    def add_values(self, batch: Any) -> None:
        """Adds a batch of the table of values."""
        table = pa.Table.from_batches([batch])
        keys = ["space", "register", "operation", "verdict", "unit"]
        totals = [
            ("frame", "count"),
            ("address", "min"),
            ("raw", "min"),
            ("raw", "max"),
            ("value", "min"),
            ("value", "max"),
        ]
        for row in table.group_by(keys).aggregate(totals).to_pylist():
            use = self._register(row)
            use.count += row["frame_count"]
            use.verdicts[row["verdict"]] += row["frame_count"]
            use.low, use.high = _least(use.low, row["value_min"]), _greatest(use.high, row["value_max"])
            use.raw_low, use.raw_high = _least(use.raw_low, row["raw_min"]), _greatest(use.raw_high, row["raw_max"])
        text_rows = table.filter(compute.is_valid(table["text"]))
        for row in text_rows.group_by([*keys, "text"]).aggregate([("address", "min")]).to_pylist():
            texts = self._register(row).texts
            if len(texts) <= MOST_TEXTS:
                texts.add(row["text"])

    def _register(self, row: dict[str, Any]) -> RegisterUse:
        key = (row["space"] or "", row["register"], row["operation"] or "")
        if key not in self.registers:
            self.registers[key] = RegisterUse(*key, row["address_min"], row["unit"] or "")
        return self.registers[key]


def _codes(column: Any) -> Any:
    """Equal numbers for equal cells of a column."""
    combined = column.combine_chunks()
    if not pa.types.is_dictionary(combined.type):
        combined = combined.dictionary_encode(null_encoding="encode")
    return combined.indices.fill_null(-1).to_numpy(zero_copy_only=False)


def _least(left: Any, right: Any) -> Any:
    return left if right is None else right if left is None else min(left, right)


def _greatest(left: Any, right: Any) -> Any:
    return left if right is None else right if left is None else max(left, right)
