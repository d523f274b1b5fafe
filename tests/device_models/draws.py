"""What is drawn for a device from a seed: how late it begins, what it refuses, and how an open statement is read."""

from __future__ import annotations

import random
from collections.abc import Mapping

DELAYS = (0.0, 0.0, 0.0, 0.02, 0.1, 0.25, 0.38, 1.0)
"""Times between the acceptance of a command and the begin of its motion, in seconds. No manual prints one."""


class Draws:
    """The choices for one device. What a test states is not drawn.

    `delay` is the time until each motion begins. `readings` are answers to what a manual leaves open, by their names.
    `refusal` is how likely a command is refused without a reason that the controller could see before.
    """

    def __init__(
        self,
        seed: object,
        delay: float | None = None,
        readings: Mapping[str, str] | None = None,
        refusal: float = 0.0,
    ) -> None:
        self.dice = random.Random(f"{seed}")
        self.delay, self.refusal = delay, refusal
        self.readings = dict(readings or {})

    def start_delay(self) -> float:
        """The seconds until the next motion begins."""
        if self.delay is not None:
            return self.delay
        return self.dice.choice((*DELAYS, self.dice.random()))

    def reading(self, name: str, *choices: str) -> str:
        """How a device reads what its manual leaves open; it stays so. A choice that is named twice is more likely."""
        if name not in self.readings:
            self.readings[name] = self.dice.choice(choices)
        assert self.readings[name] in choices, (name, self.readings[name], choices)
        return self.readings[name]

    def refuses(self) -> bool:
        """Whether the device refuses the next command for no visible reason."""
        return self.dice.random() < self.refusal


def calm(**readings: str) -> Draws:
    """A device that begins at once and refuses nothing; what is not stated is read as seed 0 has it."""
    return Draws(0, delay=0.0, readings=readings)
