"""Random devices that are lists: registers in usual spaces, with quantities, names of values and bits, and a table."""

from __future__ import annotations

from typing import Any

import yaml
from hypothesis import strategies as st

MANUAL = {"title": "The manual of chance", "file": "chance.txt", "sha256": "0" * 64, "lines": 999}
SPACES = {"registers": "word", "input_registers": "word", "coils": "bit", "discrete_inputs": "bit"}
ONLY_READ = ("input_registers", "discrete_inputs")
WIDTHS = {"u16": 1, "i16": 1, "u32": 2, "i32": 2, "f32": 2, "u64": 4, "i64": 4, "f64": 4}
NAMES = ("speed", "target_position", "supply_voltage", "status_word", "phase_current", "heat_sink", "mode", "run_time")
PRINTED = ("", "Speed", "Soll-Position", "Versorgungsspannung", "Status word", "Strom Phase", "Kühlkörper", "转速")
LABELS = ("", "", "Value of the last cycle", "Written at the next start", "Gemessen am Eingang", "实际值")
UNITS = ("", "V", "A", "rpm", "°C", "mm/s", "Nm", "%", "kWh", "Hz")
SCALES = ("1", "1", "0.1", "0.01", "0.001", "10", "0.5", "0.25")
MEMBERS = ("off", "on", "automatic", "no_error", "over_current", "phase_lost", "standby")
BITS = ("ready", "fault", "remote", "in_position", "homed", "brake_released")


@st.composite
def list_devices(draw: Any) -> str:
    """The text of the spec of a device that is a list: registers with all that a list can have."""
    spaces = draw(st.sampled_from((("registers",), ("registers", "input_registers"), tuple(SPACES))))
    spec: dict[str, Any] = {"device": {"id": "chance", "name": "Chance", "vendor": "Nobody", "manual": MANUAL}}
    spec["spaces"] = [{"name": name, "unit": SPACES[name], "source": "1 L1"} for name in SPACES]
    spec |= {"enums": [], "flags": [], "registers": []}
    number = 0
    for space in spaces:
        address = draw(st.sampled_from((0, 0, 1, 99, 256, 1000, 4096, 35100, 40001)))
        rows = []
        for _ in range(draw(st.integers(2, 6))):
            number += 1
            row, size = _register(draw, spec, SPACES[space] == "bit", number)
            if space in ONLY_READ and draw(st.integers(0, 9)):
                row["access"] = "ro"
            rows.append({"at": address, **row, "source": "1 L2"})
            address += size + draw(st.sampled_from((0, 0, 0, 1, 8)))
        spec["registers"].append({"group": f"of_{space}", "space": space, "order": "as_listed", "rows": rows})
    if draw(st.integers(0, 3)) == 0:
        _table(draw, spec)
    if draw(st.integers(0, 3)) == 0:
        _parameters(draw, spec)
    return str(yaml.safe_dump({key: part for key, part in spec.items() if part}, sort_keys=False, allow_unicode=True))


def _table(draw: Any, spec: dict[str, Any]) -> None:
    """A table of records after all registers."""
    fields = [_register(draw, spec, False, 80 + number)[0] for number in range(draw(st.integers(1, 3)))]
    for row in fields:
        row["source"] = "1 L2"
        row.pop("checked", None)
    spec["records"] = [{"name": "point", "source": "1 L5", "fields": fields}]
    place = {"base": 50000, "stride": 40, "count": draw(st.integers(2, 4)), "index_from": draw(st.integers(0, 1))}
    spec["tables"] = [{"name": "points", "record": "point", "source": "1 L5", **place}]


def _parameters(draw: Any, spec: dict[str, Any]) -> None:
    """A set of numbered parameters, some of them lists, or objects whose elements have meanings of their own."""
    rows, number = [], draw(st.sampled_from((0, 1, 0x100, 0x2000)))
    for place in range(draw(st.integers(1, 4))):
        row = {"number": number, **_register(draw, spec, False, 90 + place)[0], "source": "1 L6"}
        row.pop("checked", None)
        row.pop("word_order", None)
        meaning = draw(st.sampled_from(("one", "one", "list", "object")))
        if meaning != "one" and row["type"] != "text":
            row = {key: row[key] for key in ("number", "name", "type", "access", "source")}
            row["elements"] = draw(st.integers(3, 5))
        if meaning == "object" and "elements" in row:
            indices = [0, draw(st.sampled_from((1, 2)))]
            names = ("highest_subindex", "first_value")
            row["subindices"] = [
                {"index": index, "name": name, "source": "1 L7"} for index, name in zip(indices, names, strict=True)
            ]
        rows.append(row)
        number += draw(st.sampled_from((1, 1, 2, 16)))
    numbers = f"{rows[0]['number']}..{rows[-1]['number']}"
    spec["parameters"] = [{"name": "settings", "source": "1 L6", "numbers": numbers, "rows": rows}]


def _register(draw: Any, spec: dict[str, Any], in_bits: bool, number: int) -> tuple[dict[str, Any], int]:
    """The keys of a register, and the number of its addresses."""
    row: dict[str, Any] = {"name": f"{draw(st.sampled_from(NAMES))}_{number}"}
    printed, label = draw(st.sampled_from(PRINTED)), draw(st.sampled_from(LABELS))
    row |= {"printed_name": f"{printed} {number}"} if printed else {}
    row |= {"label": label} if label else {}
    row["access"] = draw(st.sampled_from(("ro", "rw", "rw", "wo")))
    if in_bits:
        return {**row, "type": "bit", "access": draw(st.sampled_from(("ro", "rw")))}, 1
    kind = draw(st.sampled_from((*WIDTHS, "u16", "i16", "u16", "u32", "text")))
    if kind == "text":
        words = draw(st.integers(2, 8))
        return {**row, "type": "text", "length": 2 * words}, words
    words = WIDTHS[kind]
    row |= {"type": kind, "checked": {"words": words}}
    if words > 1 and draw(st.integers(0, 3)) == 0:
        row["word_order"] = "little"
    meaning = draw(st.sampled_from(("plain", "quantity", "quantity", "quantity", "enum", "bits")))
    if meaning == "enum" and kind[0] != "f":
        _enum(draw, spec, row, kind)
    elif meaning == "bits" and kind[0] == "u":
        _bits(draw, spec, row, kind)
    elif meaning == "quantity":
        _quantity(draw, row, kind)
    return row, words


def _enum(draw: Any, spec: dict[str, Any], row: dict[str, Any], kind: str) -> None:
    lowest = -3 if kind[0] == "i" else 0
    values = draw(st.lists(st.integers(lowest, 40), min_size=2, max_size=5, unique=True))
    names = draw(st.permutations(MEMBERS))
    members = [{"value": value, "name": name} for value, name in zip(sorted(values), names, strict=False)]
    row["enum"] = f"states_{len(spec['enums'])}"
    spec["enums"].append({"name": row["enum"], "open": True, "sparse": True, "source": "1 L3", "members": members})


def _bits(draw: Any, spec: dict[str, Any], row: dict[str, Any], kind: str) -> None:
    numbers = draw(st.lists(st.integers(0, 16 * WIDTHS[kind] - 1), min_size=1, max_size=4, unique=True))
    bits = [{"bit": n, "name": name} for n, name in zip(sorted(numbers), draw(st.permutations(BITS)), strict=False)]
    row["flags"] = f"word_{len(spec['flags'])}"
    spec["flags"].append({"name": row["flags"], "type": kind, "source": "1 L4", "bits": bits})


def _quantity(draw: Any, row: dict[str, Any], kind: str) -> None:
    unit = draw(st.sampled_from(UNITS))
    row |= {"unit": unit} if unit else {}
    if kind[0] == "f":
        return
    scale, offset = draw(st.sampled_from(SCALES)), draw(st.sampled_from((0, 0, 0, -40, 100)))
    row |= {"scale": float(scale)} if scale != "1" else {}
    row |= {"offset": offset} if offset else {}
    if draw(st.booleans()):
        low = draw(st.sampled_from((0, 0, 1, 10) if kind[0] == "u" else (0, -100, -5)))
        high = draw(st.sampled_from((low + 1, 100, 1000, 30000)))
        row["range"] = f"{low}..{high}"
        row |= {"default": draw(st.sampled_from((low, high)))} if draw(st.booleans()) else {}
    if draw(st.integers(0, 3)) == 0:
        row["sentinels"] = [{"value": 32767, "name": "not_measured"}]
