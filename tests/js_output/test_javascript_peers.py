"""The generated JavaScript talks with modbus-serial and jsmodbus over loopback, as their server and as their client."""

from __future__ import annotations

import subprocess
from pathlib import Path

from bounded import HANGING
from external_tools import NODE_TOOLS, require_tool, without
from js_output.javascript import module_path
from layouts import TEST_SPECS, newest

PEERS = ("modbus-serial", "jsmodbus")


def test_clients_and_servers_of_others_understand_the_generated_code() -> None:
    for peer in PEERS:
        if not (NODE_TOOLS.parent / peer).exists():
            without(peer)
    script = Path(__file__).with_name("peers.mjs")
    station = module_path(newest(TEST_SPECS, "station"))
    command = [require_tool("node"), str(script), station, str(NODE_TOOLS.parent.parent)]
    run = subprocess.run(command, capture_output=True, text=True, check=False, timeout=HANGING)
    assert (run.returncode, run.stderr) == (0, "")
    assert run.stdout == "asked by modbus-serial, by jsmodbus; asked modbus-serial, jsmodbus\n"
