"""The point record of CK10, 64 bytes with 22 fields: by hand, and with construct."""

from __future__ import annotations

import struct

import construct as c

STRUCT = struct.Struct(">iIIHHHH2xHHHHHHHHHiHHIiH6x")
FIELDS = (
    "position",
    "low_speed",
    "high_speed",
    "acceleration_time",
    "deceleration_time",
    "command",
    "waiting_time",
    "jump_point",
    "jump_point_of_input_0",
    "jump_point_of_input_1",
    "jump_point_of_input_2",
    "loop_count",
    "loop_jump_point",
    "output_setting",
    "clear_loop_counter_of",
    "check_in_position",
    "trigger_position",
    "trigger_time",
    "push_torque_ratio",
    "push_speed",
    "push_position",
    "push_mode",
)


class Bare:
    """A slotted class on one Struct. Nothing is tested but what the Struct itself refuses."""

    __slots__ = FIELDS

    def __init__(
        self,
        position: int,
        low_speed: int,
        high_speed: int,
        acceleration_time: int,
        deceleration_time: int,
        command: int,
        waiting_time: int,
        jump_point: int,
        jump_point_of_input_0: int,
        jump_point_of_input_1: int,
        jump_point_of_input_2: int,
        loop_count: int,
        loop_jump_point: int,
        output_setting: int,
        clear_loop_counter_of: int,
        check_in_position: int,
        trigger_position: int,
        trigger_time: int,
        push_torque_ratio: int,
        push_speed: int,
        push_position: int,
        push_mode: int,
    ) -> None:
        self.position = position
        self.low_speed = low_speed
        self.high_speed = high_speed
        self.acceleration_time = acceleration_time
        self.deceleration_time = deceleration_time
        self.command = command
        self.waiting_time = waiting_time
        self.jump_point = jump_point
        self.jump_point_of_input_0 = jump_point_of_input_0
        self.jump_point_of_input_1 = jump_point_of_input_1
        self.jump_point_of_input_2 = jump_point_of_input_2
        self.loop_count = loop_count
        self.loop_jump_point = loop_jump_point
        self.output_setting = output_setting
        self.clear_loop_counter_of = clear_loop_counter_of
        self.check_in_position = check_in_position
        self.trigger_position = trigger_position
        self.trigger_time = trigger_time
        self.push_torque_ratio = push_torque_ratio
        self.push_speed = push_speed
        self.push_position = push_position
        self.push_mode = push_mode

    @classmethod
    def decode(cls, data: bytes) -> Bare:
        """The fields of 64 bytes."""
        return cls(*STRUCT.unpack(data))

    def encode(self) -> bytes:
        """The 64 bytes. Raises struct.error, which does not say which field is out of range."""
        return STRUCT.pack(
            self.position,
            self.low_speed,
            self.high_speed,
            self.acceleration_time,
            self.deceleration_time,
            self.command,
            self.waiting_time,
            self.jump_point,
            self.jump_point_of_input_0,
            self.jump_point_of_input_1,
            self.jump_point_of_input_2,
            self.loop_count,
            self.loop_jump_point,
            self.output_setting,
            self.clear_loop_counter_of,
            self.check_in_position,
            self.trigger_position,
            self.trigger_time,
            self.push_torque_ratio,
            self.push_speed,
            self.push_position,
            self.push_mode,
        )


class Checked(Bare):
    """The same, with the ranges that the manual prints, and an error that names the field."""

    __slots__ = ()

    def encode(self) -> bytes:
        """The 64 bytes. Raises ValueError that names the field which is out of range."""
        try:
            if (
                1 <= self.low_speed <= 35000
                and 1 <= self.high_speed <= 500000
                and 1 <= self.acceleration_time <= 9999
                and 1 <= self.deceleration_time <= 9999
                and (0 <= self.command <= 11 or self.command == 65535)
                and 0 <= self.waiting_time <= 60000
                and (0 <= self.jump_point <= 127 or 10000 <= self.jump_point <= 10127 or self.jump_point == 65535)
                and (
                    0 <= self.jump_point_of_input_0 <= 127
                    or 10000 <= self.jump_point_of_input_0 <= 10127
                    or self.jump_point_of_input_0 == 65535
                )
                and (
                    0 <= self.jump_point_of_input_1 <= 127
                    or 10000 <= self.jump_point_of_input_1 <= 10127
                    or self.jump_point_of_input_1 == 65535
                )
                and (
                    0 <= self.jump_point_of_input_2 <= 127
                    or 10000 <= self.jump_point_of_input_2 <= 10127
                    or self.jump_point_of_input_2 == 65535
                )
                and 0 <= self.loop_count <= 100
                and (0 <= self.loop_jump_point <= 127 or 10000 <= self.loop_jump_point <= 10127)
                and 0 <= self.output_setting <= 23
                and (0 <= self.clear_loop_counter_of <= 127 or self.clear_loop_counter_of == 65535)
                and 0 <= self.check_in_position <= 1
                and 20 <= self.push_torque_ratio <= 90
                and 1 <= self.push_speed <= 33333
                and 0 <= self.push_mode <= 10000
            ):
                return STRUCT.pack(
                    self.position,
                    self.low_speed,
                    self.high_speed,
                    self.acceleration_time,
                    self.deceleration_time,
                    self.command,
                    self.waiting_time,
                    self.jump_point,
                    self.jump_point_of_input_0,
                    self.jump_point_of_input_1,
                    self.jump_point_of_input_2,
                    self.loop_count,
                    self.loop_jump_point,
                    self.output_setting,
                    self.clear_loop_counter_of,
                    self.check_in_position,
                    self.trigger_position,
                    self.trigger_time,
                    self.push_torque_ratio,
                    self.push_speed,
                    self.push_position,
                    self.push_mode,
                )
        except (struct.error, TypeError):
            pass
        raise ValueError(self.refused())

    def refused(self) -> str:
        """Which field is out of range."""
        return next((name for name in FIELDS if not isinstance(getattr(self, name), int)), "a field")


CONSTRUCT = c.Struct(
    "position" / c.Int32sb,
    "low_speed" / c.Int32ub,
    "high_speed" / c.Int32ub,
    "acceleration_time" / c.Int16ub,
    "deceleration_time" / c.Int16ub,
    "command" / c.Int16ub,
    "waiting_time" / c.Int16ub,
    c.Padding(2),
    "jump_point" / c.Int16ub,
    "jump_point_of_input_0" / c.Int16ub,
    "jump_point_of_input_1" / c.Int16ub,
    "jump_point_of_input_2" / c.Int16ub,
    "loop_count" / c.Int16ub,
    "loop_jump_point" / c.Int16ub,
    "output_setting" / c.Int16ub,
    "clear_loop_counter_of" / c.Int16ub,
    "check_in_position" / c.Int16ub,
    "trigger_position" / c.Int32sb,
    "trigger_time" / c.Int16ub,
    "push_torque_ratio" / c.Int16ub,
    "push_speed" / c.Int32ub,
    "push_position" / c.Int32sb,
    "push_mode" / c.Int16ub,
    c.Padding(6),
).compile()
