"""Numbers whose bits lie apart in a word, as devices send them: with the frames and formulas that others publish."""

from __future__ import annotations

import random
from collections.abc import Callable

import pytest

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.reference import codec
from layouts import TEST_SPECS, newest
from python_package import class_of, module_of

LEVER = newest(TEST_SPECS, "lever")

FRAMES = {
    # Pololu Tic user's guide, "Command encoding", 32-bit write: set target position.
    "E0 05 52 02 16 49": ("set_target", "target", "target=1234567890"),
    # Pololu Maestro user's guide, "Set Target": servo 2 to 1500 us, in quarters of a microsecond.
    "84 02 70 2E": ("set_servo", "pulse", "pulse=6000"),
    # Pololu Simple Motor Controller user's guide, "Motor Forward": full speed is 3200, as speed % 32 and speed / 32.
    "85 00 64": ("motor_forward", "speed", "speed=3200"),
}


@pytest.mark.parametrize("frame", FRAMES)
def test_a_published_frame_has_the_number_whose_bits_lie_apart(frame: str) -> None:
    message, field, entry = FRAMES[frame]
    explanation = explained(LEVER, "line", "request", bytes.fromhex(frame))
    row = next(row for row in explanation.rows if row.path == field)
    assert (explanation.message, [meaning.name for meaning in row.meanings]) == (message, [entry])


def pololu(number: int) -> bytes:
    """The data of a 32-bit write, as the Tic user's guide computes it."""
    low = [number >> 8 * byte & 0x7F for byte in range(4)]
    return bytes([sum((number >> 8 * byte + 7 & 1) << byte for byte in range(4)), *low])


def nunchuk(x: int, y: int, z: int) -> bytes:
    """The low two bits of each axis share the last byte: wiibrew.org, "Wiimote/Extension Controllers/Nunchuk"."""
    return bytes([0, 0, x >> 2, y >> 2, z >> 2, (z & 3) << 6 | (y & 3) << 4 | (x & 3) << 2])


def mouse(x: int, y: int) -> bytes:
    """The signs of a PS/2 mouse are in the first byte: IBM PS/2 Hardware Interface Technical Reference."""
    return bytes([(x < 0) << 4 | (y < 0) << 5, x & 0xFF, y & 0xFF])


def humidity(h4: int, h5: int) -> bytes:
    """dig_H4 and dig_H5 of a BME280 share a byte: Bosch BST-BME280-DS001, table 16, 0xE4 to 0xE6."""
    return bytes([h4 >> 4 & 0xFF, h4 & 15 | (h5 & 15) << 4, h5 >> 4 & 0xFF])


def modes(mode: int) -> bytes:
    """A number with its highest bit in the first byte, and the others at the end of the second one."""
    return bytes([(mode >> 4) << 6, mode & 15])


BODIES: dict[str, tuple[Callable[..., bytes], list[range]]] = {
    "target": (pololu, [range(-(1 << 31), 1 << 31)]),
    "axes": (nunchuk, [range(1024)] * 3),
    "moved": (mouse, [range(-256, 256)] * 2),
    "trim": (humidity, [range(-2048, 2048)] * 2),
    "setting": (modes, [range(32)]),
}
NAMES = {"target": ["target"], "axes": ["x", "y", "z"], "moved": ["x", "y"], "trim": ["h4", "h5"], "setting": ["mode"]}


@pytest.mark.parametrize("word", BODIES)
def test_random_numbers_are_read_and_written_where_the_manual_has_them(word: str) -> None:
    body_of, bounds = BODIES[word]
    dice = random.Random(word)
    kind = class_of(module_of(LEVER), word, "Flags")
    order = "big" if word == "setting" else "little"
    for _ in range(300):
        numbers = [dice.choice((own[0], own[-1], dice.choice(own))) for own in bounds]
        body = body_of(*numbers)
        own = kind(0, **dict(zip(NAMES[word], numbers, strict=True)))
        assert own.raw.to_bytes(len(body), order) == body
        assert [own.flags()[name] for name in NAMES[word]] == numbers


def test_the_reference_refuses_a_number_outside_of_the_range_of_bits_that_lie_apart() -> None:
    link = codec(LEVER).links["line"]
    with pytest.raises(ValueError, match=r"speed of speed is 3201, not in 0\.\.3200"):
        link.encode("request", "motor_forward", {"speed": 0x6401})
