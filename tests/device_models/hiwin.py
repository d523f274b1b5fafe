"""A HIWIN E drive by its manual: the states S1 to S4 of PROFIdrive, and telegrams 3, 9, 102 and 111.

The figures of 7.2, with the order of bits, are not in the text of the manual. What leads from a state to another is
that of PROFIdrive, which 1.1 [L143] names: out of S1 by bit 0 = 0 with bits 1 and 2 = 1, to S3 by bit 0, to S4 by
bit 3.
What is left open is drawn:

- "no control": with STW1 bit 10 = 0 [3.3.2 L613] the last telegram stays in force, or it counts as zeros.
- "target reached": ZSW1 bit 10 falls with the acknowledgement, or with the begin of the motion [3.5.2 L682].
- "stopped": bit 13 [3.5.2 L685] is 0 from the acknowledgement on, or from the begin of the motion on.
- "ignored move": an absolute move without a home is ignored [3.12 L820]; bit 12 follows bit 6 all the same, or not.
- "homed bit": it falls when homing begins, or stays until it ends.
- "acknowledgement": bit 12 follows bit 6 in the next telegram, or some time later.
"""

from __future__ import annotations

import struct

from device_models.axis import Axis, Event, State
from device_models.draws import Draws

ON, NO_COAST, NO_QUICK, ENABLE, TASK, NO_PAUSE, START, RESET = (1 << bit for bit in range(8))
JOG_1, JOG_2, CONTROL, HOMING = 1 << 8, 1 << 9, 1 << 10, 1 << 11
"""Bits of STW1 [3.3.2 L603-614]."""
S1, S2, S3, S4 = 1, 2, 3, 4
"""Switching on inhibited, ready for switching on, switched on, operation [7.2.3 L2053-2056]."""
MDI, ABSOLUTE = 1 << 15, 1 << 8
RECEIVED = {3: ">HiHH", 9: ">HHHiiHHH", 102: ">HiHHH", 111: ">HHHHHiiHHH"}
"""The words of each telegram that the drive receives [3.2 L536-563]."""
TOP_SPEED = 20000.0
JOG_SPEED = 5000.0


class HiwinE:
    """A HIWIN E drive. `telegram` is the number of the one that it is set to."""

    def __init__(self, draws: Draws, telegram: int = 111) -> None:
        self.draws, self.telegram, self.axis = draws, telegram, Axis(draws)
        self.machine, self.alarm, self.cause, self.warning = S1, 0, 0, 0
        self.before = self.word = 0
        self.task: tuple[str, float, float | None, float] | None = None
        self.acknowledged = False
        self.acknowledge_in = 0.0
        self.stopping_to = 0
        self.setpoint = 0.0
        self.target: float | None = None

    homing_needed = True

    @property
    def servo(self) -> bool:
        """Whether operation is enabled."""
        return self.machine == S4

    @property
    def events(self) -> list[Event]:
        """What has happened."""
        return self.axis.events

    @property
    def state(self) -> State:
        """What is true of the axis now."""
        return self.axis.state(self.servo, bool(self.alarm))

    def exchanged(self, request: bytes) -> bytes:
        """Takes the telegram of the controller, and gives its own."""
        self.obey(struct.unpack(RECEIVED[self.telegram], request[: struct.calcsize(RECEIVED[self.telegram])]))
        return self.response()

    def meaning(self, values: tuple[int, ...], before: int) -> list[str]:
        """What a telegram asks for beyond the one before: starts, stops, the end of operation."""
        word = values[0]
        risen, fallen = word & ~before, before & ~word
        result = []
        if self.telegram in (9, 111):
            absolute = self._task(values)[0]
            result += ["start absolute" if absolute else "start relative"] * bool(risen & START)
            result += ["start home"] * bool(risen & HOMING)
            result += ["start jog_forward"] * bool(risen & JOG_1) + ["start jog_backward"] * bool(risen & JOG_2)
            result += ["stop"] * bool(fallen & (TASK | NO_PAUSE | HOMING | JOG_1 | JOG_2))
        return result + ["off"] * bool(fallen & (ON | NO_COAST | NO_QUICK | ENABLE))

    def obey(self, values: tuple[int, ...]) -> None:
        """Does what a telegram says."""
        word = values[0]
        if not word & CONTROL:
            if self.draws.reading("no control", "stays", "zeros") == "stays":
                return
            word = 0
        risen, self.before, self.word = word & ~self.before, word, word
        if risen & RESET and not self.cause:
            self.alarm = self.warning = 0
        self._switch(word)
        if self.telegram in (3, 102):
            self._follow(values[1])
        else:
            self._position(word, risen, values)

    def set_alarm(self, number: int) -> None:
        """It has an alarm: it coasts, and is inhibited [3.5.2 L675, 7.2.2]; 0 when what caused it is gone."""
        self.cause = number
        if not number:
            self.axis.record("cause gone", "alarm")
        else:
            self.alarm, self.machine = number, S1
            self.axis.record("alarm", f"{number}")
            self._cut()

    def power_cycle(self) -> None:
        """It is switched off and on."""
        self._cut()
        self.alarm = self.cause
        self.axis.homed = False
        self.machine, self.before, self.acknowledged = S1, 0, False

    def stop_outside(self) -> None:
        """Something outside stops the motion, such as an overtravel switch; the drive stays on."""
        self.axis.stop(outside=True)

    def move_outside(self) -> None:
        """The shaft is turned by hand, if nothing else moves it."""
        if not self.servo and not self.axis.expected:
            self.axis.accept("outside", 0.0, self.axis.position + 100.0, 500.0, outside=True)

    def pass_time(self, seconds: float) -> None:
        """Some time goes by."""
        self.axis.pass_time(seconds)
        self.acknowledge_in -= seconds
        if self.stopping_to and not self.axis.moving:
            self.machine, self.stopping_to = self.stopping_to, 0

    def _cut(self) -> None:
        self.axis.cut()
        self.stopping_to = 0
        self.task = None

    def _switch(self, word: int) -> None:
        """The state machine [7.2.3 L2053-2056]."""
        if not word & NO_COAST or self.alarm:
            if self.machine == S4 or self.axis.expected:
                self.axis.record("stop", "coast")
            self._cut()
            self.machine = S1
        elif not word & NO_QUICK:
            if self.machine == S4:
                self._ramp_to(S1, 160000.0, "quick stop")
            elif not self.stopping_to:
                self.machine = S1
            else:
                self.stopping_to = S1
        elif self.stopping_to:
            # A ramp by OFF1 may be taken back, one by OFF3 goes on to its end.
            if self.stopping_to == S2 and word & ON:
                self.machine, self.stopping_to = S4 if word & ENABLE else S3, 0
        elif self.machine == S1:
            self.machine = S1 if word & ON else S2
        elif not word & ON:
            if self.machine == S4:
                self._ramp_to(S2, 40000.0, "off")
            else:
                self.machine = S2
        elif self.machine == S2:
            self.machine = S3
        elif self.machine == S3 and word & ENABLE:
            self.machine = S4
        elif self.machine == S4 and not word & ENABLE:
            self.axis.record("stop", "disabled")
            self._cut()
            self.machine = S3

    def _ramp_to(self, machine: int, deceleration: float, about: str) -> None:
        self.machine, self.task = S3, None
        self.axis.record("stop", about)
        if self.axis.expected:
            self.axis.stop(deceleration)
            self.axis.waiting = None
        if self.axis.moving:
            self.stopping_to = machine
        else:
            self.machine = machine

    def _follow(self, raw: int) -> None:
        """The speed is a part of the reference [6.1 L1552-1556]."""
        speed = TOP_SPEED * raw / 0x40000000 if self.machine == S4 else 0.0
        axis = self.axis
        if speed and speed != self.setpoint:
            kind = "velocity"
            if axis.motion is None:
                axis.accept(kind, raw, None, speed)
                axis.wait = 0.0
            else:
                motion = axis.motion
                axis.motion = type(motion)(motion.number, kind, raw, None, speed)
                axis.stopping = False
        elif not speed and self.setpoint and axis.expected:
            axis.stop()
            axis.waiting = None
        self.setpoint = speed

    def _position(self, word: int, risen: int, values: tuple[int, ...]) -> None:
        axis = self.axis
        if self.machine != S4:
            self.acknowledged = False
            return
        if not word & TASK and axis.expected and self._kind() in ("absolute", "relative"):
            self.task = None
            axis.stop()
            axis.waiting = None
        if not word & NO_PAUSE and axis.motion and self._kind() in ("absolute", "relative"):
            # The rest of the way is gone when the bit comes back [3.3.2 L608].
            motion = axis.motion
            if not axis.stopping:
                self.task = (motion.kind, motion.value, motion.target, motion.speed)
                axis.stop()
        elif word & NO_PAUSE and self.task and not axis.expected:
            kind, value, target, speed = self.task
            self.task = None
            axis.accept(kind, value, target, speed)
        if risen & HOMING and not axis.expected:
            self._start("home", 0, None, 4000.0)
        elif risen & HOMING:
            axis.record("refused", "home")
        elif not word & HOMING and axis.expected and self._kind() == "home":
            axis.stop()
            axis.waiting = None
        self._jog(word, risen)
        if risen & START and word & TASK and word & NO_PAUSE:
            self._start_task(values)
        if not word & START:
            self.acknowledged = False

    def _kind(self) -> str:
        motion = self.axis.waiting or self.axis.motion
        return motion.kind if motion else ""

    def _jog(self, word: int, risen: int) -> None:
        both = JOG_1 | JOG_2
        if self._kind() in ("jog_forward", "jog_backward"):
            wanted = JOG_1 if self._kind() == "jog_forward" else JOG_2
            if word & both != wanted and not self.axis.stopping:
                self.axis.stop()
                self.axis.waiting = None
        elif risen & both and word & both != both:
            kind, sign = ("jog_forward", 1) if word & JOG_1 else ("jog_backward", -1)
            if self.axis.expected:
                self.axis.record("refused", kind, sign)
            else:
                self._start(kind, sign, None, sign * JOG_SPEED)

    def _start_task(self, values: tuple[int, ...]) -> None:
        """An MDI task at the edge of bit 6 [3.12 L805-822, 3.11 L794]."""
        absolute, enabled, target, velocity = self._task(values)
        kind = "absolute" if absolute else "relative"
        ignored = absolute and not self.axis.homed
        if ignored:
            self.warning = 0x980
        if not enabled or ignored or velocity <= 0 or self._kind() in ("home", "jog_forward", "jog_backward"):
            self.axis.record("refused", kind, target)
            follows = self.draws.reading("ignored move", "acknowledged", "not acknowledged") == "acknowledged"
            self.acknowledged = enabled and follows
            return
        if self.draws.refuses():
            self.axis.record("refused", kind, target)
            return
        speed = min(TOP_SPEED, velocity * 1000 / 60)
        self._start(kind, target, target if absolute else None, speed)
        self.acknowledged = True
        late = self.draws.reading("acknowledgement", "next", "later") == "later"
        self.acknowledge_in = self.draws.dice.uniform(0.0, 0.1) if late else 0.0

    def _task(self, values: tuple[int, ...]) -> tuple[bool, bool, int, int]:
        """Whether it is absolute, whether MDI is on, the target and the velocity."""
        if self.telegram == 111:
            return bool(values[1] & ABSOLUTE), bool(values[1] & MDI), values[5], values[6] * values[4] // 0x4000
        return bool(values[7] & 1), bool(values[1] & MDI), values[3], values[4]

    def _start(self, kind: str, value: float, target: float | None, speed: float) -> None:
        homed = self.axis.homed
        self.target = target
        self.axis.accept(kind, value, target, speed)
        if kind == "home" and homed and self.draws.reading("homed bit", "falls", "falls", "falls", "stays") == "stays":
            self.axis.homed = True

    def _status(self) -> int:
        """ZSW1 [3.5.2 L672-686]."""
        axis, machine = self.axis, self.machine
        bits = {S1: 1 << 6, S2: 1, S3: 3, S4: 7}[machine]
        if machine == S3 and self.stopping_to:
            bits = 3
        bits |= bool(self.alarm) << 3 | bool(self.word & NO_COAST) << 4 | bool(self.word & NO_QUICK) << 5
        bits |= bool(self.warning) << 7 | 1 << 8 | 1 << 9
        accepted = axis.moving or (
            axis.waiting is not None and self.draws.reading("target reached", "task", "begin") == "task"
        )
        if axis.motion is not None and axis.motion.target is not None:
            self.target = axis.motion.target
        reached = not accepted and (self.target is None or abs(self.target - axis.position) < 10)
        if self.telegram in (3, 102):
            return bits | (abs(axis.velocity - self.setpoint) < 100) << 10
        standing = not axis.moving and not (
            axis.waiting is not None and self.draws.reading("stopped", "task", "begin") == "task"
        )
        bits |= reached << 10 | axis.homed << 11 | standing << 13
        return bits | (self.acknowledged and self.acknowledge_in <= 0) << 12

    def response(self) -> bytes:
        """The telegram of the drive [3.2 L536-563]."""
        axis, status = self.axis, self._status()
        position = round(axis.position)
        if self.telegram == 9:
            return struct.pack(">HHHi", status, self.before and MDI, 0, position)
        speed = max(-(2**31), min(2**31 - 1, round(axis.velocity / TOP_SPEED * 0x40000000)))
        if self.telegram == 3:
            return struct.pack(">HiHHii", status, speed, 0, 0, position, position)
        if self.telegram == 102:
            return struct.pack(">HiHHHii", status, speed, 0, 0, 0, position, position)
        jogging = self._kind() in ("jog_forward", "jog_backward")
        first = MDI | jogging << 10 | (self._kind() == "home") << 11
        second = 1 << 2 | (axis.velocity > 0) << 4 | (axis.velocity < 0) << 5 | axis.expected << 15
        words = (status, first, second, 0, 1 << 11, position, speed, self.alarm, self.warning, 0)
        return struct.pack(">HHHHHiiHHH", *words)
