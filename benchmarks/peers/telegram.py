"""The process data of telegram 111, 24 bytes with five words of bits: by hand, and with construct."""

from __future__ import annotations

import struct

import construct as c

STRUCT = struct.Struct(">HHHHHiiHH2x")
_new = object.__new__


class Words:
    """The bare words; bits are properties of the first one."""

    __slots__ = (
        "fault_code", "message_word", "position_actual", "positioning_status_word_1", "positioning_status_word_2",
        "speed_actual", "status_word_1", "status_word_2", "warning_code",
    )  # fmt: skip

    @classmethod
    def decode(cls, data: bytes) -> Words:
        """The words of 24 bytes."""
        words = _new(cls)
        try:
            (
                words.status_word_1,
                words.positioning_status_word_1,
                words.positioning_status_word_2,
                words.status_word_2,
                words.message_word,
                words.position_actual,
                words.speed_actual,
                words.fault_code,
                words.warning_code,
            ) = STRUCT.unpack(data)
        except struct.error as error:
            raise ValueError(f"{len(data)} bytes") from error
        return words

    @property
    def operation_enabled(self) -> bool:
        """Bit 2 of status word 1."""
        return self.status_word_1 & 4 != 0


def with_construct(words: list[dict[str, int]]) -> c.Struct:
    """The same with the bits of each word by name, compiled; each of `words` has the masks of its bits by name."""
    flags = [c.FlagsEnum(c.Int16ub, **bits) for bits in words]
    numbers = [c.Int32sb, c.Int32sb, c.Int16ub, c.Int16ub]
    parts = [f"part_{number}" / part for number, part in enumerate([*flags, *numbers])]
    return c.Struct(*parts, c.Padding(2)).compile()
