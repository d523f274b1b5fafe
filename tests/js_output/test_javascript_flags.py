"""Fields of bits in the generated JavaScript: numbers with a sign, a scale and a unit, as the Python has them."""

from __future__ import annotations

import json
import random
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from javascript import module_path

from external_tools import require_tool
from layouts import TEST_SPECS, newest
from python_package import module_of

COUNTER = newest(TEST_SPECS, "counter")
MODULE = module_of(COUNTER)
SPEEDS = next(bit.ranges for bit in COUNTER.device.flags["drive"].bits if bit.name == "speed")
PROGRAM = """
import { readFileSync } from "node:fs";
const { Drive } = await import(process.argv[1]);
for (const text of JSON.parse(readFileSync(0, "utf8"))) {
  const raw = BigInt(text);
  const bits = Drive.of(raw);
  const speed = Drive.units.speed;
  const quantity = speed.inUnit(bits.speed);
  const sent = (write) => { try { return String(write()); } catch (error) { return error.reason; } };
  console.log(JSON.stringify([bits, quantity, sent(() => speed.fromUnit(quantity)), sent(() => Drive.raw(bits))]));
}
for (const bits of [{ speed: 2048 }, { speed: -2049 }, { serial: -1 }]) {
  try { Drive.raw(bits); } catch (error) { console.log(JSON.stringify(error.reason)); }
}
"""


def test_numbers_in_a_word_are_those_of_python() -> None:
    chance = random.Random(1)
    raws = [0, 2**64 - 1, *(chance.getrandbits(64) for _ in range(50))]
    run = subprocess.run(
        [require_tool("node"), "--input-type=module", "-e", PROGRAM, module_path(COUNTER)],
        input=json.dumps([str(raw) for raw in raws]),
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    *rows, first, second, third = map(json.loads, run.stdout.splitlines())
    assert (first, second, third) == ("out_of_range", "out_of_range", "out_of_range")
    for raw, (bits, speed, count, again) in zip(raws, rows, strict=True):
        word = MODULE.Drive(raw)
        assert bits == word.flags()
        assert speed == word.speed_rpm
        assert count == (str(word.speed) if word.speed in SPEEDS else "out_of_range")
        assert again == str(raw)
