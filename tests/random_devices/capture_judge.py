"""`decode --to` as a judge: the rows of its tables, as files have them, are what the reference reads in the frames."""

from __future__ import annotations

import csv
import io
import json
import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from captures.bulk import Sent, decoded
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.codec.reference.frames import Decoded
from fieldspec.codec.reference.records import decoded_value
from fieldspec.codec.reference.structs import value_construct
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_array, is_real
from fieldspec.language.model.record import RegisterAccess
from fieldspec.tools.captures.decoding import Choices
from fieldspec.tools.captures.tables import record_batches
from fieldspec.tools.captures.writers import CsvTable, JsonTable, ParquetTable
from random_devices.inputs import header_values
from random_devices.meanings import Leaf, is_nearest, leaves, meaning_of
from random_devices.queries import Answer, Query

Row = dict[str, Any]
Asked = tuple[str, str]
"""A link, and the message of all frames where frames do not tell theirs."""


class Captures:
    """Says nothing about queries; raises AssertionError where a table has another row than the reference."""

    def __init__(self, layout: DeviceLayout, folder: Path, number: int) -> None:
        self.layout, self.folder, self.number = layout, folder, number
        self.codecs = codec(layout).links

    def answers(self, queries: list[Query]) -> list[Answer]:
        """Nothing about single queries."""
        groups: dict[Asked, list[Query]] = {}
        for query in queries:
            if query.kind == "frame" and query.values is None and query.data and not self._is_guessed(query):
                groups.setdefault((query.path[0], query.path[2]), []).append(query)
        for asked, own in groups.items():
            self._assert_frames(asked, own)
        for link in self.layout.links:
            self._assert_registers(link, [query for query in queries if query.kind == "register"])
        return [Answer(reason=None)] * len(queries)

    def _is_guessed(self, query: Query) -> bool:
        """Whether only the request tells which message a response with a code is."""
        link, direction, message = query.path
        has_code = self.layout.links[link].frame(direction).role("code") is not None
        return has_code and bool(message or self.layout.links[link].ambiguous_codes(direction))

    def _assert_frames(self, asked: Asked, queries: list[Query]) -> None:
        sent = [Sent(place, query.path[1], query.data) for place, query in enumerate(queries)]
        frames, values = self._tables(sent, Choices(*asked))
        assert len(frames) == len(queries), f"{asked} has {len(frames)} rows for {len(queries)} frames"
        for place, (query, row) in enumerate(zip(queries, frames, strict=True)):
            text = f"{' '.join(query.path)} {query.data.hex(' ')}"
            wanted = self._decoded(query)
            if isinstance(wanted, CodecError):
                is_refused = row["verdict"] not in ("ok", "mismatch", "no_request")
                assert is_refused, f"{text} is {row['verdict']}, and the reference refuses it: {wanted}"
                continue
            access = wanted.message.message.single_access if wanted.message is not None else None
            is_lone = query.path[1] == "response"
            allowed = ("ok", "no_request") if is_lone else ("ok",)
            assert row["verdict"] in allowed, f"{text} is {row['verdict']}, and the reference reads it"
            if row["verdict"] == "ok" and access is None:
                self._assert_values(text, wanted, [each for each in values if each["frame"] == place + 1])

    def _decoded(self, query: Query) -> Decoded | CodecError:
        """What the reference makes of a frame."""
        link, direction, message = query.path
        try:
            return self.codecs[link].decode(query.data, direction, message)
        except CodecError as error:
            return error

    def _assert_values(self, text: str, wanted: Decoded, rows: list[Row]) -> None:
        """The fields of a body are rows, each with its raw value, its quantity, its names and its unit."""
        assert wanted.body is not None
        name = "exception" if wanted.error else wanted.message.name if wanted.message is not None else ""
        parts = set(wanted.head)
        have = {row["register"]: row for row in rows if row["register"] not in parts}
        expected = {f"{name}.{leaf.path}": leaf for leaf in leaves(wanted.body, wanted.values)}
        assert have.keys() == expected.keys(), f"{text}: rows of {list(have)}, not {list(expected)}"
        for path, leaf in expected.items():
            assert_row(self.layout.device, f"{text}: {path}", leaf, have[path])

    # Registers

    def _assert_registers(self, link: str, queries: list[Query]) -> None:
        """Reads of registers give a row with the meaning of each."""
        sent: list[Sent] = []
        drawn: list[tuple[Query, RegisterLayout]] = []
        for query in queries:
            register = next(own for own in self.layout.registers if own.name == query.path[0])
            exchange = self._exchange(link, register, query.data)
            if query.values is None and exchange is not None:
                sent += [Sent(len(drawn), way, data) for way, data in exchange]
                drawn.append((query, register))
        if not drawn:
            return
        frames, values = self._tables(sent, Choices(link))
        assert {row["verdict"] for row in frames} == {"ok"}, f"{link}: {[row['verdict'] for row in frames]}"
        for place, (query, register) in enumerate(drawn):
            first = register.name if register.count == 1 else f"{register.name}[{register.register.index_from}]"
            rows = [row for row in values if row["frame"] == 2 * place + 2 and row["register"] == first]
            assert len(rows) == 1, f"{first} has {len(rows)} rows in {[row['register'] for row in values]}"
            self._assert_register(first, register, query.data, rows[0])

    def _exchange(self, link: str, register: RegisterLayout, data: bytes) -> list[tuple[str, bytes]] | None:
        """A request for a register and its response; None where no message reads it alone, or not on the link."""
        device = self.layout.device
        for message in self.layout.links[link].exchanged.values():
            access: RegisterAccess | None = device.register_access(message.message)
            if access is None or access.operation != "read":
                continue
            if device.space_name(access.space) != device.space_name(register.register.space):
                continue
            unit = device.space(access.space).unit_size
            units = [data[place : place + unit] for place in range(0, len(data), unit)]
            words = message.response.named(access.values)
            assert words is not None
            assert words.value is not None
            is_little = words.value.is_low_first if words.value.digits else words.order == "little"
            numbers = [int.from_bytes(each, "little" if is_little else "big") for each in units]
            asked = {access.start: register.address} | ({access.count: len(units)} if access.count else {})
            answered = {access.values: numbers if words.is_list else numbers[0]}
            dice = _Least(0)
            try:
                return [
                    (way, self.codecs[link].encode(way, message.name, {**self._head(link, way, dice), **values}))
                    for way, values in (("request", asked), ("response", answered))
                ]
            except CodecError:
                return None
        return None

    def _head(self, link: str, way: str, dice: Any) -> Mapping[str, Any]:
        return header_values(self.layout, link, self.layout.links[link].frame(way), dice)

    def _assert_register(self, name: str, register: RegisterLayout, data: bytes, row: Row) -> None:
        own = register.register
        value = own.value.as_answer(own.trigger)
        raw = value_construct(value, register.order, register.swapped).parse(data[: value.size])
        reason = ""
        try:
            raw = decoded_value(name, value, raw, self.layout.device, None)
        except CodecError as error:
            reason = error.reason
        if reason:
            assert row["verdict"] == reason, f"{name} {data.hex(' ')} is {row['verdict']}, not {reason}"
            return
        is_reserved = own.reserved and not isinstance(raw, str)
        leaf = Leaf(name, own.value, raw, register.order, register.swapped, is_reserved)
        assert_row(self.layout.device, f"{name} {data.hex(' ')}", leaf, row, own.trigger)

    # Tables

    def _tables(self, sent: list[Sent], choices: Choices) -> tuple[list[Row], list[Row]]:
        """The rows of both tables, as all forms of files have them."""
        tables: dict[str, list[Row]] = {"frames": [], "values": []}
        for device, batch in decoded(self.layout, sent, choices):
            for name, own in record_batches(batch, device.texts.texts, "log", "chance").items():
                tables[name] += self._file_rows(name, own)
        return sorted(tables["frames"], key=lambda row: row["frame"]), tables["values"]

    def _file_rows(self, name: str, batch: Any) -> list[Row]:
        """The rows of a file of JSON; those of CSV and of Parquet must be the same."""
        rows = [json.loads(line) for line in _file(JsonTable, name, batch).decode().splitlines()]
        every = [{key: row.get(key) for key in batch.schema.names} for row in rows]
        for place, row in enumerate(csv.DictReader(io.StringIO(_file(CsvTable, name, batch).decode()))):
            for key in ("frame", "raw", "value"):
                assert _is_same(every[place].get(key), row.get(key)), f"CSV has {row[key]} as {key}, not {every[place]}"
        assert _parquet(name, batch) == batch.num_rows
        return every


class _Least:
    """Dice that always fall on the first side, so that frames have the least numbers."""

    def __init__(self, _: int) -> None:
        pass

    def random(self) -> float:
        """The least number."""
        return 0.0

    def choice(self, options: Any) -> Any:
        """The first option."""
        return options[0]

    def randint(self, low: int, _: int) -> int:
        """The least number."""
        return low


def _file(kind: Any, name: str, batch: Any) -> bytes:
    file = io.BytesIO()
    table = kind(file, name)
    table.write(batch)
    table.close()
    return file.getvalue()


def _parquet(name: str, batch: Any) -> int:
    from pyarrow import parquet

    if not batch.num_rows:
        return 0
    table = parquet.read_table(io.BytesIO(_file(ParquetTable, name, batch)))
    for key in ("raw", "value", "text") if name == "values" else ("bytes", "verdict"):
        have, wanted = table[key].to_pylist(), batch.column(batch.schema.names.index(key)).to_pylist()
        assert repr(have) == repr(wanted), f"Parquet has {have} as {key}, not {wanted}"
    return int(table.num_rows)


def _is_same(wanted: Any, text: str | None) -> bool:
    """Whether CSV has the number of a JSON object, and nothing where that has none."""
    if wanted is None or not text:
        return wanted is None and not text
    number, own = float(text), float(wanted)
    return number == own or (math.isnan(number) and math.isnan(own))


def assert_row(device: Device, text: str, leaf: Leaf, row: Row, is_lenient: bool = False) -> None:
    """A row has what the reference makes of a value. What starts something has no verdict."""
    for key, wanted in _columns(device, leaf, is_lenient):
        have = row.get(key)
        if key == "value" and wanted is not None and have is not None:
            assert is_nearest(leaf.value, leaf.raw, wanted, float(have)), f"{text}: {key} is {have!r}, not {wanted}"
            continue
        assert have == wanted, f"{text}: {key} is {have!r}, not {wanted!r} for {leaf.raw!r}"


def _columns(device: Device, leaf: Leaf, is_lenient: bool) -> Iterator[tuple[str, Any]]:
    value, raw, encoding = leaf.value, leaf.raw, leaf.value.encoding
    if is_array(encoding):
        yield "text", raw if isinstance(raw, str) and not leaf.is_reserved else _hexadecimal(raw)
        yield "verdict", "ok"
        return
    is_narrow = not is_real(encoding) and -(2**63) <= raw < 2**63
    yield "raw", int(raw) if is_narrow else None
    yield "unit", value.unit or None
    if leaf.is_reserved:
        return
    meaning = meaning_of(device, value, raw)
    yield "value", meaning.exact
    words = [*meaning.names, *(f"bit_{place}" for place in meaning.others)]
    digits = None if is_narrow or is_real(encoding) else str(raw)
    yield "text", "+".join(words) if words or value.flags else digits
    verdict = "ok" if meaning.is_within else "out_of_range"
    if verdict == "ok" and not meaning.is_member:
        verdict = "unlisted_member"
    if verdict == "ok" and meaning.others:
        verdict = "unlisted_bits"
    yield "verdict", "ok" if is_lenient else verdict


def _hexadecimal(raw: Any) -> str:
    return bytes(raw).hex(" ").upper()


__all__ = ["Captures"]
