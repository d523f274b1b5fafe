"""pymodbus' own server of Modbus RTU over TCP, with 8,192 registers: prints its port, and serves until it is ended."""

from __future__ import annotations

import asyncio

from pymodbus import FramerType
from pymodbus.server import ModbusTcpServer
from pymodbus.simulator import DataType, SimData, SimDevice


async def main() -> None:
    """Serves station 1."""
    device = SimDevice(id=1, simdata=[SimData(0x1000, values=[5000] * 0x2000, datatype=DataType.REGISTERS)])
    server = ModbusTcpServer(device, framer=FramerType.RTU, address=("127.0.0.1", 0))
    await server.listen()
    print(server.transport.sockets[0].getsockname()[1], flush=True)
    await asyncio.Event().wait()


if __name__ == "__main__":
    asyncio.run(main())
