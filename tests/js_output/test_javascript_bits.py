"""Registers of single bits in the generated JavaScript: the requests that read and write them, and their values."""

from __future__ import annotations

import json
import subprocess

from external_tools import require_tool
from js_output.javascript import module_path
from layouts import TEST_SPECS, newest

PROGRAM = """
import * as station from "%s";
const requests = [
  ...station.readRequests(station.ENABLE),
  ...station.readRequests(station.FAULT),
  ...station.writeRequests(station.ENABLE, true),
  ...station.writeRequests(station.RELAYS.at(3), false),
].map(({ message, data }) => [message.name, data]);
const values = [
  station.readValue(station.ENABLE, { bits: [1] }),
  station.readValue(station.FAULT, { bits: [0xfe] }),
];
console.log(JSON.stringify({ requests, values }));
"""


def test_a_bit_is_read_and_written_by_the_messages_of_its_space() -> None:
    program = PROGRAM % module_path(newest(TEST_SPECS, "station"))
    command = [require_tool("node"), "--input-type=module", "--eval", program]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr
    output = json.loads(result.stdout)
    assert [data for _, data in output["requests"]] == [
        {"address": 8, "bitCount": 1},
        {"address": 16, "bitCount": 1},
        {"address": 8, "value": 0xFF00},
        {"address": 2, "value": 0},
    ]
    assert output["values"] == [True, False]
