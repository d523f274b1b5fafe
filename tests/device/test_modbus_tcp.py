"""A made-up device with a link over TCP is served over TCP."""

from __future__ import annotations

from pathlib import Path

from pymodbus.client import ModbusTcpClient

from fieldspec.testing import simulation
from layouts import TEST_SPECS, newest


def test_a_client_over_tcp_reads_writes_and_is_refused() -> None:
    layout = newest(TEST_SPECS, "wattmeter")
    link = next(name for name, link in layout.links.items() if link.request.role("length") is not None)
    register = next(register for register in layout.registers if register.register.access in ("ro", "rw"))
    with simulation("wattmeter", ports={link: "tcp://127.0.0.1:0"}, folder=str(Path(TEST_SPECS))) as device:
        port = int(device.place.rpartition(":")[2])
        client = ModbusTcpClient("127.0.0.1", port=port, timeout=5)
        assert client.connect()
        unit = device.simulation.server.unit_address
        space = layout.device.space(register.register.space).name
        message = next(
            message.name
            for message in layout.device.messages.values()
            if (access := layout.device.register_access(message)) is not None
            and access.operation == "read"
            and layout.device.space_name(access.space) == layout.device.space_name(space)
        )
        read = client.read_input_registers if "input" in message else client.read_holding_registers
        assert len(read(register.address, count=register.words, device_id=unit).registers) == register.words
        assert read(0xFFF0, count=1, device_id=unit).exception_code == 2
        client.close()
