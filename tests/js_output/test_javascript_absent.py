"""Sentinels in the generated JavaScript: null in the unit, with their names, and exact bits."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from javascript import module_path

from external_tools import require_tool
from layouts import TEST_SPECS, newest

PROGRAM = """
const { DISTANCE, WIDTH, Sample } = await import(process.argv[1]);
const { VOLTAGE, POWER, RATIO } = await import(process.argv[2]);
const hex = (bytes) => Buffer.from(bytes).toString("hex");
const refused = (call) => { try { return call(); } catch (error) { return error.reason; } };
const other = new DataView(new ArrayBuffer(8));
other.setBigUint64(0, 0xfff0000000000001n);
const absent = Sample.absent.distance;
console.log(JSON.stringify([
  [DISTANCE.units.inUnit(NaN), DISTANCE.units.inUnit(5.5), DISTANCE.absent.nameOf(NaN), DISTANCE.absent.nameOf(5.5)],
  [VOLTAGE.units.inUnit(-32768), VOLTAGE.absent.nameOf(-32768), VOLTAGE.absent.values.not_measured, RATIO.absent],
  [POWER.units.inUnit(9999), POWER.absent.nameOf(9999), POWER.absent.nameOf(NaN)],
  [absent.nameOf(NaN), absent.nameOf(9999), absent.nameOf(1), absent.nameOf("9999"), Object.keys(absent.values)],
  [hex(DISTANCE.encode(absent.values.not_measured)), hex(DISTANCE.encode(other.getFloat64(0))), hex(WIDTH.encode(NaN))],
  [9999, "9999.0001", 301, 1e39, "far", NaN].map((quantity) => refused(() => Sample.units.distance.fromUnit(quantity))),
  [DISTANCE.units.fromUnit("0.1"), Sample.units.exact.fromUnit("0.1")],
]));
"""


def test_states_have_names_and_are_no_quantities() -> None:
    run = subprocess.run(
        [
            *(require_tool("node"), "--input-type=module", "-e", PROGRAM),
            *(module_path(newest(TEST_SPECS, name)) for name in ("probe", "meter")),
        ],
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    nan, counts, real, record, bits, refusals, reals = json.loads(run.stdout)
    assert nan == [None, 5.5, "not_measured", None]
    # The ratio has a range and no special value.
    assert counts == [None, "not_measured", -0x8000, {"values": {}}]
    assert real == [None, "overflow", "out_of_range"]
    assert record == ["not_measured", "too_far", None, None, ["not_measured", "too_far"]]
    assert bits == ["00007fc0"] * 3
    assert refusals == ["out_of_range"] * 4 + ["wrong_type"] * 2
    assert reals == [0.10000000149011612, 0.1]
