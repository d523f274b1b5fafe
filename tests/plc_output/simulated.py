"""Devices of the simulator on the other side of a port of blocks: by frames, or as the process data of a telegram."""

from __future__ import annotations

from typing import Any

from benches import Bench
from devices import TIMEOUT, Transport

from fieldspec.targets.controllers.routines.blocks.ports import axis_key
from simulators import Unit

MILLISECONDS = 10
"""The time from one scan to the next."""
ALARMS = {
    "ck10": "alarm_code",
    "tc100": "alarm_code",
    "esc11": "messages/read_alarm_code/response/alarm_code",
    "hiwin-e": "parameters/profidrive_parameters/alarm_codes",
}
"""The signal whose number is the alarm of a device."""


class Motion:
    """The motions of a simulated device: `starts` has the kind of each, in order."""

    def __init__(self, unit: Unit) -> None:
        self.starts: list[str] = []
        self._unit = unit
        unit.engine.listeners.append(self._heard)

    @property
    def moving(self) -> bool:
        """Whether the axis moves."""
        return self._unit.engine.axis.moving

    def _heard(self, kind: str, text: str) -> None:
        if kind != "move" or text.startswith("stop"):
            return
        name, _, speed, *_ = text.split()
        # A telegram with a speed commands it anew in each cycle: only what moves an axis at rest is a start.
        if not self._unit.message or name != "endless" or (float(speed) and not self.moving):
            self.starts.append(name)


class Simulated:
    """A device of the simulator. `message` is the telegram in use, or empty."""

    def __init__(self, device: str, link: str, message: str = "") -> None:
        self.device = device
        self.unit = Unit(device, link, message)
        self.engine = self.unit.engine
        self.motion = Motion(self.unit)
        self.engine.advance(0.0)

    def set(self, signal: str, value: int) -> None:
        """Changes a signal, as if by hand."""
        for cell in self.engine.cells.of(signal):
            cell.write(value)
        self.engine.follow()

    def value(self, signal: str) -> Any:
        """What a signal has."""
        return self.engine.cells.of(signal)[0].read()

    def alarm(self, number: int) -> None:
        """It has an alarm; 0 when what caused it is gone."""
        self.set(ALARMS[self.device], number)

    def home(self) -> None:
        """It knows its origin, as after homing: some devices refuse to move before."""
        self.engine.axis.homed = True
        self.engine.refresh()

    def power_cycle(self) -> None:
        """It is switched off and on."""
        self.engine.power_on()
        self.engine.refresh()

    def pass_scan(self) -> None:
        """The time of one scan goes by."""
        self.unit.wait(MILLISECONDS / 1000)

    def exchanged(self, transport: Transport) -> int:
        """Takes a frame out of the port and puts the answer into it."""
        answer = self.unit.answer_to(bytes(transport.of("frame")[: transport.of("send")])).frame
        data = list(transport.of("frame"))
        data[: len(answer)] = answer
        transport.put("frame", data)
        transport.put("received", len(answer))
        return 0 if answer else TIMEOUT


class ProcessData:
    """The port of a telegram, served by a device of the simulator. While `lost`, nothing comes and nothing goes."""

    def __init__(self, bench: Bench, device: Simulated, message: str) -> None:
        self.bench, self.device = bench, device
        layout = device.unit.engine.layout.messages[message]
        self.message, self.request, self.response = message, layout.request, layout.response
        self.key = axis_key(layout)
        struct = bench.world.names.structs[self.key]
        self.variable = next(
            bench.lent[name, declared.variable.name]
            for name, block in bench.blocks.items()
            for declared in block.of_role("in_out")
            if getattr(declared.variable.type, "name", "") == struct
        )
        self.lost = False

    def member(self, record: Any, field: str) -> str:
        """The name of a member of the request or the response, as it is in the port."""
        return self.bench.world.member(record.name, field).lower()

    def of(self, direction: str) -> dict[str, Any]:
        """The struct of the request or the response."""
        struct: dict[str, Any] = self.bench.ports[self.variable][self.bench.port(self.key, direction)]
        return struct

    def serve(self) -> None:
        """What happens between two scans."""
        if not self.lost:
            request, response = self.of("request"), self.of("response")
            values = {
                field.name: request[self.member(self.request, field.name)]
                for field in self.request.fields
                if not field.field.reserved
            }
            codec = self.device.unit.codec
            answer = self.device.unit.answer_to(codec.encode("request", self.message, values)).frame
            for name, value in codec.decode(answer, "response", self.message).values.items():
                if not self.response.named(name).field.reserved:
                    response[self.member(self.response, name)] = value
        self.bench.ports[self.variable][self.bench.port(self.key, "valid")] = not self.lost
