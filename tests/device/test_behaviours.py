"""Simulated devices do over time what their manuals print."""

from __future__ import annotations

from typing import Any

import pytest

from simulators import Unit, parts_of

DEVICES = ("tc100", "tc100@before-2.0", "ck10", "esc11", "esc11@before-1.17", "hiwin-e")


@pytest.fixture
def tc100() -> Unit:
    return Unit("tc100", "rtu")


@pytest.fixture
def ck10() -> Unit:
    return Unit("ck10", "rtu")


@pytest.fixture
def esc11() -> Unit:
    return Unit("esc11", "serial", unit_address=3)


def homed(unit: Unit) -> Unit:
    """A TC100 that has done its homing."""
    unit.write(0x201E, 3)
    unit.wait(10)
    return unit


@pytest.mark.parametrize("device", DEVICES)
def test_every_part_rests_on_the_manual_or_is_marked_as_assumed(device: str) -> None:
    _, behaviour = parts_of(device)
    assert len(behaviour.parts) > 20
    assert [part.name for part in behaviour.parts if not (part.sources or part.assumed or part.standard)] == []


def test_homing_ends_at_the_origin(tc100: Unit) -> None:
    assert tc100.read(0x100A, 2) == [0, 5000]
    tc100.write(0x201E, 3)
    tc100.wait(0.2)
    assert tc100.read(0x1000) == [1]
    tc100.wait(10)
    assert (tc100.read(0x1000), tc100.read(0x100A, 2)) == ([0], [0, 0])


def test_a_move_before_homing_is_a_fault_and_moves_nothing(tc100: Unit) -> None:
    tc100.write(0x2002, 0, 100)
    tc100.write(0x201E, 1)
    tc100.wait(5)
    assert (tc100.read(0x100D), tc100.read(0x100A, 2)) == ([12], [0, 5000])


def test_a_move_takes_its_ramps_and_its_distance_over_its_speed(tc100: Unit) -> None:
    homed(tc100).write(0x2002, 0, 20000)
    tc100.write(0x2014, 20)
    tc100.write(0x201E, 1)
    # 20 % of 50000 pps; two ramps of 0.3 s that together cover 3000 pulses, and 17000 pulses at full speed.
    tc100.wait(0.3)
    assert tc100.read(0x100A, 2) == [0, 1500]
    tc100.wait(1.7)
    assert tc100.read(0x100A, 2) == [0, 18500]
    assert (tc100.read(0x1000), tc100.read(0x1001)) == ([1], [0])
    tc100.wait(0.31)
    assert (tc100.read(0x100A, 2), tc100.read(0x1000), tc100.read(0x1001)) == ([0, 20000], [0], [1])


def test_a_command_while_the_axis_moves_is_a_fault(tc100: Unit) -> None:
    homed(tc100).write(0x2002, 0, 60000)
    tc100.write(0x201E, 1)
    tc100.wait(0.1)
    tc100.write(0x201E, 3)
    assert tc100.read(0x100D) == [1]


def test_a_soft_limit_ends_a_move(tc100: Unit) -> None:
    homed(tc100).write(0x0813, 0, 3000)
    tc100.write(0x2002, 0, 60000)
    tc100.write(0x201E, 1)
    tc100.wait(10)
    assert (tc100.read(0x100A, 2), tc100.read(0x100D)) == ([0, 3000], [10])


def test_a_jog_goes_on_until_it_is_stopped(tc100: Unit) -> None:
    homed(tc100).write(0x201E, 11)
    tc100.wait(3)
    assert tc100.read(0x1000) == [1]
    tc100.write(0x201E, 8)
    tc100.wait(1)
    assert tc100.read(0x1000) == [0]
    # 300 ms from rest to 50000 pps, 2.7 s at that speed, 300 ms to rest
    high, low = tc100.read(0x100A, 2)
    assert high << 16 | low == 150000


def test_an_alarm_releases_the_servo_and_is_reset_with_the_servo_off_alone(tc100: Unit) -> None:
    tc100.engine.cells.of("alarm_code")[0].write(9)
    tc100.engine.follow()
    assert (tc100.read(0x100C), tc100.read(0x1005), tc100.read(0x1060, 2)) == ([0], [9], [9, 0])
    tc100.write(0x201E, 6)
    assert (tc100.read(0x1005), tc100.read(0x100D)) == ([9], [8])
    tc100.write(0x2011, 1)
    tc100.write(0x201E, 6)
    assert (tc100.read(0x1005), tc100.read(0x100D)) == ([0], [0])
    tc100.write(0x2011, 0)
    assert tc100.read(0x100C) == [1]


def test_points_follow_each_other(tc100: Unit) -> None:
    homed(tc100)
    for number, (position, wait, following) in {1: (4000, 500, 5), 5: (9000, 0, 0xFFFF)}.items():
        base = 0x9010 + (number - 1) * 0x10
        tc100.write(base, 1, 0, position, 50, 1000, 0, 0, 0, 0, 0, 100, 100, wait, following)
    tc100.write(0x2040, 1 << 4 | 1 << 3)  # PRGSEL0 and START
    tc100.wait(0.4)
    assert (tc100.read(0x100E), tc100.read(0x100A, 2)) == ([1], [0, 4000])
    tc100.wait(0.4)  # the move takes 0.26 s, and the point waits for 0.5 s after it
    assert (tc100.read(0x100E), tc100.read(0x1000)) == ([5], [1])
    tc100.wait(2)
    assert tc100.read(0x100A, 2) == [0, 9000]


def test_what_is_saved_outlasts_the_power(tc100: Unit) -> None:
    tc100.write(0x0805, 777)
    tc100.write(0x9999, 0)
    tc100.write(0x0805, 888)
    tc100.engine.power_on()
    assert tc100.read(0x0805) == [777]


def test_a_register_that_the_firmware_lacks_does_not_exist() -> None:
    assert Unit("tc100", "rtu").exception("read_registers", address=0x1002, word_count=1) == 2
    layout, _ = parts_of("esc11@before-1.17")
    assert "reset_alarm" not in layout.messages
    old = Unit("esc11@before-1.17", "serial", unit_address=0)
    answer = old.server.answer("serial", bytes.fromhex("04 00 4E 52"))
    assert answer.frame == bytes.fromhex("04 00 20 24")


@pytest.mark.parametrize(
    ("message", "values", "number"),
    [
        ("read_registers", {"address": 0x999B, "word_count": 4}, 2),
        ("write_register", {"address": 0x1000, "value": 1}, 2),
        ("write_register", {"address": 0x7000, "value": 1}, 2),
        ("write_register", {"address": 0x2014, "value": 101}, 3),
        ("write_registers", {"address": 0x999B, "values": [0x4C76, 0x3031, 0x5479, 0x5668]}, 3),
        ("write_registers", {"address": 0x2014, "values": [5, 5]}, 2),
    ],
)
def test_what_the_device_does_not_permit_is_refused(
    tc100: Unit, message: str, values: dict[str, Any], number: int
) -> None:
    assert tc100.exception(message, **values) == number


def test_too_many_words_are_refused_but_a_wrong_address_comes_first(tc100: Unit) -> None:
    too_many, nowhere = "count_invalid: word_count is out of range", "unknown_address: no register is at 0x1002"
    for address, number, reason in ((0x0900, 3, too_many), (0x1002, 2, nowhere)):
        parts = bytes([1, 3]) + address.to_bytes(2, "big") + (61).to_bytes(2, "big") + b"\0\0"
        frame = tc100.codec.joined_parts("request", tc100.codec.with_checksum("request", parts))
        answer = tc100.server.answer("rtu", frame)
        assert tc100.codec.decode(answer.frame, "response").values == {"exception_code": number}
        assert answer.text.endswith(reason), answer.text


def test_the_write_enable_key_is_taken(tc100: Unit) -> None:
    tc100.write(0x999B, 0x4C76, 0x3031, 0x5479, 0x5667)


def test_a_refused_write_changes_nothing(tc100: Unit) -> None:
    before = tc100.read(0x0800, 2)
    assert tc100.exception("write_registers", address=0x0800, values=[0, 7, 0, 9, 0]) == 3
    assert tc100.read(0x0800, 2) == before


def test_broadcasts_are_obeyed_in_silence_where_they_are_enabled(tc100: Unit) -> None:
    for enabled, expected in ((0, 100), (1, 33)):
        tc100.write(0x0A03, enabled)
        frame = tc100.codec.encode("request", "write_register", {"station": 0, "address": 0x2014, "value": 33})
        assert tc100.server.answer("rtu", frame).frame == b""
        assert tc100.read(0x2014) == [expected]


def test_other_stations_and_damaged_frames_get_no_answer(tc100: Unit) -> None:
    good = tc100.codec.encode("request", "read_registers", {"station": 2, "address": 0x1000, "word_count": 1})
    assert tc100.server.answer("rtu", good).frame == b""
    own = tc100.codec.encode("request", "read_registers", {"station": 1, "address": 0x1000, "word_count": 1})
    for place in range(len(own)):
        damaged = bytearray(own)
        damaged[place] ^= 0x40
        assert tc100.server.answer("rtu", bytes(damaged)).frame == b""


def test_a_drive_that_is_off_refuses_to_move(ck10: Unit) -> None:
    assert ck10.exception("write_register", address=0x07D8, value=2) == 4
    ck10.write(0x07F1, 5)  # every value but 0 switches it on
    ck10.write(0x07D6, 0, 30000)
    ck10.write(0x07D8, 2)
    ck10.wait(0.5)
    status = ck10.read(0x03E8, 2)
    assert status[0] >> 11 & 1 == 1
    assert status[0] >> 4 & 1 == 1
    ck10.wait(5)
    assert ck10.read(0x03EA, 2) == [0, 30000]


def test_triggers_read_as_the_manual_says(ck10: Unit) -> None:
    ck10.write(0x07F1, 1)
    ck10.write(0x07D8, 1)
    ck10.write(0x07F3, 1)
    assert (ck10.read(0x07D8), ck10.read(0x07F3)) == ([1], [0])


def test_parameters_and_points_are_copied_to_flash(ck10: Unit) -> None:
    ck10.write(0x138A, 0, 40000)
    ck10.write(0x2710 + 32 * 3, 0, 1234)
    assert ck10.read(0x1452, 2) != [0, 40000]
    ck10.write(0x07F4, 1)
    ck10.write(0x07F5, 1)
    assert (ck10.read(0x1452, 2), ck10.read(0x4E20 + 32 * 3, 2)) == ([0, 40000], [0, 1234])
    ck10.write(0x138A, 0, 50000)
    ck10.engine.power_on()
    assert (ck10.read(0x138A, 2), ck10.read(0x2710 + 32 * 3, 2)) == ([0, 40000], [0, 1234])


def test_a_gripper_runs_its_points(esc11: Unit) -> None:
    point = {"number": 7, "mode": 0x41, "distance": 1200, "speed": 50, "force": 0, "zone_limit_1": 0, "zone_limit_2": 0}
    esc11.ask("write_points", points=[point])
    assert esc11.ask("read_points", first_point=1)["points"] == [point]
    esc11.ask("start_homing")
    esc11.wait(1)
    esc11.ask("move_to_point", point_number=7, speed=100)
    esc11.wait(2)
    assert esc11.ask("read_current_position") == {"position": 1200}
    assert esc11.ask("read_current_point_number") == {"point_number": 7}
    esc11.ask("clear_points", first_point=7, point_count=1)
    assert esc11.answer("read_point", point_number=7).frame == bytes.fromhex("04 03 20 27")


def test_a_gripper_answers_no_damaged_packet_and_marks_an_unknown_command(esc11: Unit) -> None:
    assert esc11.server.answer("serial", bytes.fromhex("04 03 99 A1")).frame == b""
    assert esc11.server.answer("serial", bytes.fromhex("04 03 99 A0")).frame == bytes.fromhex("04 03 20 27")


TELEGRAMS = ("telegram_3", "telegram_5", "telegram_9", "telegram_102", "telegram_105", "telegram_111")


def exchange(unit: Unit, **values: int) -> dict[str, Any]:
    """The values that the drive sends for a telegram with some values, and 0 for all others."""
    record = unit.engine.layout.messages[unit.message].request
    zero = {field.name: 0 for field in record.fields if not field.field.reserved}
    result: dict[str, Any] = unit.ask(unit.message, **{**zero, **values})
    return result


@pytest.mark.parametrize("telegram", TELEGRAMS)
def test_the_drive_goes_through_its_states(telegram: str) -> None:
    unit = Unit("hiwin-e", "cyclic", telegram)
    states = [
        (0x0000, "switching_on_inhibited", 0b1000000),
        (0x0406, "ready_for_switching_on", 0b0000001),
        (0x0407, "switched_on", 0b0000011),
        (0x040F, "operation", 0b0000111),
        (0x0407, "switched_on", 0b0000011),
        (0x040F, "operation", 0b0000111),
        (0x040D, "switching_on_inhibited", 0b1000000),
        (0x040F, "switching_on_inhibited", 0b1000000),
    ]
    for control, state, bits in states:
        word = exchange(unit, control_word_1=control)["status_word_1"]
        assert unit.engine.states["drive"] == state
        assert word & 0b1000111 == bits


@pytest.mark.parametrize(
    ("telegram", "mdi"), [("telegram_9", "block_selection"), ("telegram_111", "positioning_control_word_1")]
)
def test_an_mdi_task_moves_once_for_each_edge(telegram: str, mdi: str) -> None:
    unit = Unit("hiwin-e", "cyclic", telegram)
    for control in (0, 0x406, 0x407, 0x40F, 0xC0F):
        exchange(unit, control_word_1=control)
    unit.wait(5)
    values = {"mdi_target_position": 5000, "mdi_velocity": 600, "mdi_acceleration": 0x4000, "mdi_deceleration": 0x4000}
    values |= {"velocity_override": 0x4000} if telegram == "telegram_111" else {}
    values |= {mdi: 0x8000}  # relative
    for start in (0x43F, 0x47F, 0x47F, 0x43F, 0x47F):
        sent = exchange(unit, control_word_1=start, **values)
        assert bool(sent["status_word_1"] >> 12 & 1) == (start == 0x47F)
        unit.wait(3)
    assert exchange(unit, control_word_1=0x43F, **values)["position_actual_a"] == 10000


def test_parameters_are_read_and_refused_by_number() -> None:
    unit = Unit("hiwin-e", "parameter_channel")
    unit.head = {"request_reference": 9}
    address = {"attribute": 0x10, "element_count": 0, "subindex": 0}
    assert unit.ask("read_parameter", **address, parameter_number=0x2534)["values"] == [100]
    unit.ask("write_parameter", **address, parameter_number=0x2534, format=6, values=[250])
    assert unit.ask("read_parameter", **address, parameter_number=0x2534)["values"] == [250]
    errors = {
        (0x2534, 6, 1): 2,
        (0x2534, 3, 250): 5,
        (922, 6, 1): 1,
        (1, 6, 1): 0,
    }
    for (number, form, value), error in errors.items():
        request = {**address, "parameter_number": number, "format": form, "values": [value]}
        assert unit.exception("write_parameter", **request) == error
    assert unit.exception("read_parameter", **{**address, "element_count": 8}, parameter_number=964) == 3
    assert unit.answer_to(bytes([9, 5, 0, 1])).frame.hex() == "09800001440100 21".replace(" ", "")
