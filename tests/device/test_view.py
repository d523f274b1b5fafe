"""The view of a simulated device in a terminal."""

from __future__ import annotations

import asyncio

from fieldspec.command.serving.simulation_view import SimulationView
from fieldspec.testing import simulation
from fieldspec.tools.simulator.clock import ManualClock
from simulators import SPECS


def test_signals_motion_and_traffic_are_shown() -> None:
    with simulation("tc100", ports={"ascii": "pty"}, clock=ManualClock(), folder=SPECS) as device:
        view = SimulationView(device.simulation)

        async def look() -> None:
            async with view.run_test() as pilot:
                await pilot.pause()
                device.set(alarm_code="overcurrent")
                line = device.simulation.line("ascii")
                assert list(line.feed(0.0, b":010310000001EB\r\n"))
                view.refresh_values()
                await pilot.pause()
                table = view.signals
                assert [str(column.label) for column in table.ordered_columns] == ["role", "signal", "value"]
                assert table.get_row("registers/alarm") == ["alarm_code", "registers/alarm", "9"]
                assert "position         5000" in str(view.motion.render())
                assert not view.waiting
                await pilot.press("p")
                view.refresh_values()
                assert table.get_cell("registers/alarm", "value") == "0"

        asyncio.run(look())
