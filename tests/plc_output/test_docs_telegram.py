"""The example of docs/plc.md for TIA Portal is run against a drive, through memory as an S7 lays it out."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parent))

from page import example
from scans import Scans, of_siemens

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference import codec
from fieldspec.targets.scl.backend import files as scl_files
from layouts import SPECS, newest

SIZES = {"word": 2, "uint": 2, "int": 2, "dint": 4, "udint": 4}


def packed(structs: dict[str, list[tuple[str, Any, Any]]], kind: str, value: dict[str, Any]) -> bytes:
    """A struct as an S7 with standard access lays it down: bits from the lowest one on, numbers the high byte first."""
    data, bit = bytearray(), 8
    for name, of, _ in structs[kind]:
        if of == "bool":
            if bit == 8:
                data.append(0)
                bit = 0
            data[-1] |= value[name] << bit
            bit += 1
            continue
        bit = 8
        if len(data) % 2:
            data.append(0)
        if of in structs:
            data += packed(structs, of, value[name])
        else:
            data += (value[name] % (1 << 8 * SIZES[of])).to_bytes(SIZES[of], "big")
    return bytes(data)


def unpacked(structs: dict[str, list[tuple[str, Any, Any]]], kind: str, data: bytes, value: dict[str, Any]) -> int:
    """Puts bytes into a struct; returns how many there were."""
    at, bit = 0, 8
    for name, of, _ in structs[kind]:
        if of == "bool":
            if bit == 8:
                at, bit = at + 1, 0
            value[name] = bool(data[at - 1] >> bit & 1)
            bit += 1
            continue
        bit = 8
        at += at % 2
        if of in structs:
            at += unpacked(structs, of, data[at:], value[name])
        else:
            value[name] = int.from_bytes(data[at : at + SIZES[of]], "big", signed=of in ("int", "dint"))
            at += SIZES[of]
    return at


def declared(texts: dict[str, str], names: list[str]) -> Iterator[str]:
    """The types with some names, those that they need before them."""
    types = next(content for path, content in texts.items() if path.endswith(".udt"))
    for name in names:
        match = re.search(rf'^TYPE "{name}".*?^END_TYPE$', types, re.MULTILINE | re.DOTALL)
        assert match, name
        yield from declared(texts, re.findall(r': "(\w+)";', match.group()))
        yield match.group()


class Drive:
    """A drive: its state follows the control words, and it moves for some cycles."""

    def __init__(self) -> None:
        self.values: dict[str, Any] = {}
        self.enabled, self.moving, self.position, self.started = 0, 0, 0, False
        self.alarm = False
        self.starts: list[dict[str, Any]] = []

    def cycle(self, got: dict[str, Any]) -> dict[str, Any]:
        word = got["control_word_1"]
        ready = word["no_off2"] and word["no_off3"] and word["control_by_plc"]
        on = ready and word["on"]
        operation = on and word["enable_operation"]
        if operation and word["start_traversing_task"] and not self.started:
            self.starts.append(got)
            self.moving = 5
        self.started = word["start_traversing_task"]
        self.moving = max(0, self.moving - 1)
        if not self.moving and self.starts:
            self.position = self.starts[-1]["mdi_target_position"]
        return {
            "ready_to_switch_on": ready,
            "ready_to_operate": on,
            "operation_enabled": operation,
            "alarm": self.alarm,
            "homing_complete": True,
            "traversing_task_acknowledged": self.started,
            "target_reached": not self.moving,
        }


def driven(drive: Drive, cycles: int = 40, **value: Any) -> Scans:
    """The example of the drive, run until it is done or has failed."""
    layout = newest(SPECS, "hiwin-e")
    texts = {
        path: content.replace("\r\n", "\n") for path, content in scl_files([layout]).items() if isinstance(content, str)
    }
    data = next(content for path, content in texts.items() if path.endswith(".db"))
    match = re.search(r'^DATA_BLOCK "HiwinETelegram111"\n.*?(STRUCT.*?END_STRUCT;)', data, re.MULTILINE | re.DOTALL)
    assert match
    findall = re.findall(r'(\w+) : "(\w+)";', match.group(1))
    types = "\n".join(dict.fromkeys(declared(texts, [kind for _, kind in findall])))
    members = " ".join(f"{name} : {kind};" for name, kind in findall)
    source = of_siemens(types) + f"\nTYPE typeBlock : STRUCT {members} END_STRUCT; END_TYPE\n"
    program = of_siemens(example("scl", "HiwinETelegram111Move")).replace("HW_IO", "WORD")
    program = program.replace("\nVAR\n", "\nVAR\n    HiwinETelegram111 : typeBlock;\n", 1)
    scans = Scans(source, program, value=["DPRD_DAT", "DPWR_DAT"])
    structs, block = scans.machine.unit.structs, scans.variables["hiwinetelegram111"]
    kinds = {name.lower(): kind.lower() for name, kind in findall}
    scans.variables.update({"enable": True, **value})
    for cycle in range(cycles):
        # The edge comes when the drive has been switched on.
        scans.variables["execute"] = cycle > 5
        scans.scan()
        sent = packed(structs, kinds["todevice"], block["todevice"])
        assert len(sent) == 24
        got = values_of(layout, sent)
        status = drive.cycle(got)
        frame = response(layout, status, drive.position, bool(drive.moving))
        assert unpacked(structs, kinds["fromdevice"], frame, block["fromdevice"]) == 24
        if scans.variables["done"] or scans.variables["error"]:
            return scans
    return scans


def masks(layout: DeviceLayout, flags: str) -> dict[str, int]:
    """The bits of a word of flags by name."""
    return {bit.name: 1 << bit.first for bit in layout.device.flags[flags].bits}


def values_of(layout: DeviceLayout, frame: bytes) -> dict[str, Any]:
    """The values of a request, by the reference; both control words bit by bit."""
    values = dict(codec(layout).links["cyclic"].decode(frame, "request", "telegram_111").values)
    for name, flags in (
        ("control_word_1", "control_word_1_positioning"),
        ("positioning_control_word_1", "positioning_control_word_1"),
    ):
        values[name] = {bit: bool(values[name] & mask) for bit, mask in masks(layout, flags).items()}
    return values


def response(layout: DeviceLayout, status: dict[str, Any], position: int, moving: bool) -> bytes:
    """A response, by the reference."""
    known = masks(layout, "status_word_1_positioning")
    active = masks(layout, "positioning_status_word_2")["traversing_command_active"]
    names = [field.name for field in layout.messages["telegram_111"].response.fields]
    values = dict.fromkeys(names, 0) | {
        "status_word_1": sum(known[name] for name, value in status.items() if value),
        "positioning_status_word_2": active if moving else 0,
        "position_actual_a": position,
    }
    return codec(layout).links["cyclic"].encode("response", "telegram_111", values)


def test_the_drive_is_switched_on_and_moves_once_to_the_target() -> None:
    drive = Drive()
    scans = driven(drive, target=-100000, velocity=250)
    assert (scans.variables["done"], scans.variables["error"]) == (True, False)
    (start,) = drive.starts
    assert (start["mdi_target_position"], start["mdi_velocity"]) == (-100000, 250)
    assert drive.position == -100000
    assert [start[name] for name in ("velocity_override", "mdi_acceleration", "mdi_deceleration")] == [16384] * 3
    word = start["positioning_control_word_1"]
    assert {name for name, value in word.items() if value} == {"absolute", "mdi"}


def test_an_alarm_of_the_drive_ends_the_move_with_an_error() -> None:
    drive = Drive()
    drive.alarm = True
    scans = driven(drive, target=1, velocity=1)
    assert scans.variables["error"]
    assert drive.starts == []


def test_a_drive_that_is_not_enabled_is_not_started() -> None:
    drive = Drive()
    driven(drive, target=1, velocity=1, enable=False)
    assert drive.starts == []
