"""The tools of `fieldspec mcp`, by the client of the protocol's SDK over standard input and output."""

from __future__ import annotations

import asyncio
import json
import sys
from typing import Any

import pytest

from fieldspec.cli import main
from fieldspec.testing import simulation
from simulators import SPECS

READS = {"devices", "show", "decode", "audit"}


def called(calls: list[tuple[str, dict[str, Any]]], *options: str) -> tuple[set[str], list[tuple[bool, str]]]:
    """The tools that a server has, and for each call whether it is an error, and its text."""
    from mcp import ClientSession, StdioServerParameters, stdio_client  # which takes long to load

    async def work() -> tuple[set[str], list[tuple[bool, str]]]:
        command = ["-m", "fieldspec", "mcp", "--specs", SPECS, *options]
        server = StdioServerParameters(command=sys.executable, args=command)
        async with stdio_client(server) as (reader, writer), ClientSession(reader, writer) as session:
            await session.initialize()
            tools = {tool.name for tool in (await session.list_tools()).tools}
            results: list[Any] = [await session.call_tool(name, arguments) for name, arguments in calls]
            return tools, [(bool(result.is_error), result.content[0].text) for result in results]

    return asyncio.run(work())


def test_specs_are_explained_and_no_device_is_offered_without_a_place() -> None:
    tools, results = called(
        [
            ("devices", {}),
            ("show", {"device": "tc100", "item": "motion_command"}),
            ("decode", {"device": "tc100", "frame": "01 03 10 00 00 01 80 ca"}),
            ("decode", {"device": "tc100", "frame": "01 03"}),
            ("show", {"device": "--help"}),
            ("show", {"device": "tc100", "item": "nonsense"}),
        ]
    )
    assert tools == READS
    texts = [text for _, text in results]
    assert [error for error, _ in results] == [False, False, False, True, True, True]
    assert "esc11" in texts[0]
    assert "0x201E" in texts[1]
    assert "read_registers" in texts[2]
    assert "`--help` is not a name" in texts[4]
    assert "there is no item of tc100 nonsense" in texts[5]


def test_a_device_is_read_and_written_only_where_that_is_permitted() -> None:
    with simulation("tc100", ports={"ascii": "tcp://127.0.0.1:0"}, folder=SPECS) as device:
        port = f"tc100={device.place.replace('tcp://', 'socket://')}"
        read = ("read", {"device": "tc100", "names": ["actual_position"]})
        tools, results = called([read, ("read", {"device": "ck10", "names": ["x"]})], "--port", port)
        assert tools == {*READS, "read", "connected"}
        assert json.loads(results[0][1])[0]["value"] == 5000
        assert results[1] == (True, "Error executing tool read: ck10 is not connected; connected are tc100")
        speed = ("write", {"device": "tc100", "assignments": ["motion_speed=50%"]})
        homing = {"device": "tc100", "assignments": ["command=homing"]}
        tools, results = called(
            [speed, ("write", homing), ("write", {**homing, "confirmed": True})], "--port", port, "--allow-writes"
        )
        assert tools == {*READS, "read", "connected", "write"}
        assert [error for error, _ in results] == [False, True, False]
        assert "confirm the list above" in results[1][1]
        assert device.value("registers/motion_speed") == 50


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        (["--allow-writes"], "--allow-writes needs a device"),
        (["--port", "tc100"], "`tc100` is not a place"),
        (["--port", "tc999=x"], "there is no device tc999"),
    ],
)
def test_wrong_use_is_refused(options: list[str], expected: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mcp", "--specs", SPECS, *options]) == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert expected in printed.err
