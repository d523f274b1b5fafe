"""Checksum algorithms as data, judged by crccheck and anycrc."""

from __future__ import annotations

import random
import zlib

import anycrc
import crccheck.crc
import pytest

from fieldspec.codec.layout.checksums import checksum
from fieldspec.codec.reference.checksums import checksum as reference_checksum
from fieldspec.foundation.classes import replace
from fieldspec.language.model.checksums import algorithm_name, catalogue_name, checksum_named
from fieldspec.language.schema import schema
from fieldspec.language.schema.crc_catalogue import CRC_CATALOGUE, OTHER_NAMES

ROWS = {line.split()[0]: line.split()[1:] for line in CRC_CATALOGUE.splitlines()}
OTHERS = dict(line.split() for line in OTHER_NAMES.splitlines())
SUMS = [f"{method}{width}" for method in ("sum", "xor") for width in (8, 16, 24, 32)]
CHANCE = random.Random(5)
DATA = [bytes(CHANCE.randrange(256) for _ in range(size)) for size in (0, 1, 2, 3, 7, 8, 9, 40)]


@pytest.mark.parametrize("name", ROWS)
def test_a_crc_of_the_catalogue_has_its_check_value(name: str) -> None:
    assert checksum(name, b"123456789") == reference_checksum(name, b"123456789") == int(ROWS[name][-1], 16)


@pytest.mark.parametrize("name", ROWS)
def test_a_crc_is_that_of_anycrc(name: str) -> None:
    kind = checksum_named(name)
    parameters = kind.width, kind.polynomial, kind.initial, kind.reflect_in, kind.reflect_out, kind.final_xor
    judge = anycrc.CRC(*parameters)
    for data in DATA:
        assert checksum(name, data) == reference_checksum(name, data) == judge.calc(data)


def test_the_catalogue_has_each_crc_of_crccheck_with_all_names() -> None:
    judges = [judge for judge in crccheck.crc.ALLCRCCLASSES if judge._width <= 64]  # a checksum is an integer
    assert len(judges) == len(ROWS)
    for judge in judges:
        names = {_name(name) for name in judge._names if name.upper().startswith("CRC")}
        (name,) = {catalogue_name(name) for name in names}
        assert names == {name, *(other for other, first in OTHERS.items() if first == name)}
        for data in DATA:
            assert checksum(name, data) == judge.calc(data)


def _name(text: str) -> str:
    name = text.lower().replace("-", "_").replace("/", "_")
    return f"crc{name[4:]}" if name[4].isdigit() else name


def test_the_schema_has_each_name() -> None:
    words = schema()["$defs"]["algorithm"]["enum"]
    assert sorted(words) == sorted({*ROWS, *OTHERS, *SUMS, "lrc", "fletcher16", "fletcher32", "adler32"})


@pytest.mark.parametrize(
    ("name", "order", "expected"),
    [
        ("sum8", "big", 0x0A),
        ("sum16", "big", 0x030A),
        ("sum24", "big", 0x00030A),
        ("sum32", "big", 0x0000030A),
        ("sum16_of2", "big", 0x0309),
        ("sum16_of2", "little", 0x0903),
        ("sum8_ones", "big", 0xF5),
        ("lrc", "big", 0xF6),
        ("sum16_twos", "big", 0xFCF6),
        ("sum8_from_ff", "big", 0x09),
        ("xor8", "big", 0x04),
        ("xor16", "big", 0x0301),
        ("xor16", "little", 0x0103),
        ("xor8_ones", "big", 0xFB),
    ],
)
def test_a_sum_is_that_of_its_definition(name: str, order: str, expected: int) -> None:
    data = {"sum16_of2": bytes((1, 3, 2, 6)), "xor16": bytes((1, 3, 2, 2))}.get(name, bytes((0xFF, 0xFF, 0xFF, 13)))
    if name.startswith("xor8"):
        data = bytes((1, 3, 2, 4))
    assert checksum(name, data, order) == reference_checksum(name, data, order) == expected


@pytest.mark.parametrize(
    ("name", "data", "expected"),
    [
        ("fletcher16", b"abcde", 0xC8F0),
        ("fletcher16", b"abcdef", 0x2057),
        ("fletcher16", b"abcdefgh", 0x0627),
        ("fletcher32", b"abcde", 0xF04FC729),
        ("fletcher32", b"abcdef", 0x56502D2A),
        ("fletcher32", b"abcdefgh", 0xEBE19591),
        ("fletcher16_of1_modulo_100_from_0", bytes.fromhex("0A040000"), 0x340E),
    ],
)
def test_a_fletcher_checksum_is_that_of_public_examples(name: str, data: bytes, expected: int) -> None:
    assert checksum(name, data, "little") == reference_checksum(name, data, "little") == expected


EPOS4 = {
    "60 02 01 B0 30 00": 0x622E,
    "60 02 01 E4 60 01": 0xB420,
    "60 02 01 51 31 00": 0x8051,
    "60 02 01 51 31 01": 0xB360,
    "68 04 01 40 60 00 0F 00 00 00": 0x07B3,
    "A8 04 C0 17 00 00 80 ED 00 00": 0x960B,
}
"""Frames of drivers for the EPOS4 without their marks, as such programs and its Communication Guide have them."""


@pytest.mark.parametrize("data", EPOS4)
def test_a_crc_of_words_takes_the_highest_byte_of_each_first(data: str) -> None:
    frame = bytes.fromhex(data)
    assert checksum("crc16_1021_0_ff_0_of2", frame) == EPOS4[data]
    assert reference_checksum("crc16_1021_0_ff_0_of2", frame) == EPOS4[data]


@pytest.mark.parametrize("name", ["crc16_modbus", "crc32_iso_hdlc", "crc8_smbus", "crc12_umts"])
@pytest.mark.parametrize("unit_size", [2, 4])
def test_a_crc_of_numbers_is_that_of_anycrc_over_their_bytes_in_the_other_order(name: str, unit_size: int) -> None:
    kind = replace(checksum_named(name), unit_size=unit_size)
    parameters = kind.width, kind.polynomial, kind.initial, kind.reflect_in, kind.reflect_out, kind.final_xor
    judge = anycrc.CRC(*parameters)
    for data in DATA:
        filled = data + bytes(-len(data) % unit_size)
        pieces = [filled[at : at + unit_size][::-1] for at in range(0, len(filled), unit_size)]
        expected = judge.calc(b"".join(pieces))
        assert checksum(algorithm_name(kind), data) == reference_checksum(algorithm_name(kind), data) == expected


VOLTRONIC = {
    "QPIGS": 0xB7A9,
    "QPIRI": 0xF854,
    "QMOD": 0x49C1,
    "QPI": 0xBEAC,
    "POP02": 0xE20B,
    "POP01": 0xD269,
    "(NAK": 0x7373,
    "(ACK": 0x3920,
}
"""Lines of inverters by Voltronic Power with their checksums, as programs for them have them."""


@pytest.mark.parametrize("line", VOLTRONIC)
def test_a_checksum_avoids_the_bytes_that_are_marks(line: str) -> None:
    name = "crc16_xmodem_but_280d0a_as_290e0b"
    assert checksum(name, line.encode()) == reference_checksum(name, line.encode()) == VOLTRONIC[line]


@pytest.mark.parametrize(
    ("name", "order", "expected"),
    [("sum16_of2l", "big", 0x0903), ("sum16_of2b", "little", 0x0309), ("xor16_of2l", "big", 0x0402)],
)
def test_numbers_may_have_another_order_than_their_checksum(name: str, order: str, expected: int) -> None:
    data = bytes((1, 3, 2, 6)) if name.startswith("sum") else bytes((1, 3, 3, 7))
    assert checksum(name, data, order) == reference_checksum(name, data, order) == expected


@pytest.mark.parametrize("data", DATA)
def test_adler32_is_that_of_zlib(data: bytes) -> None:
    assert checksum("adler32", data) == reference_checksum("adler32", data) == zlib.adler32(data)


@pytest.mark.parametrize("width", [16, 32, 48, 64])
@pytest.mark.parametrize("order", ["big", "little"])
def test_both_computations_of_a_fletcher_checksum_agree(width: int, order: str) -> None:
    half = 1 << width // 2
    for modulus, start in ((half, half | 1), (half - 1, 0), (251, 250 * half + 250)):
        for unit_size in range(1, width // 16 + 1):
            name = f"fletcher{width}_of{unit_size}_modulo_{modulus:x}_from_{start:x}"
            for data in DATA:
                assert checksum(name, data, order) == reference_checksum(name, data, order)


@pytest.mark.parametrize(
    "name",
    [
        *ROWS,
        *SUMS,
        *("lrc", "sum24_of3_from_1_twos", "crc16_8005_1_fr_2"),
        *("adler32", "fletcher16", "fletcher32", "fletcher48_of2_modulo_ffff_from_1"),
        *("crc16_1021_0_ff_0_of2", "crc16_xmodem_but_280d0a_as_290e0b", "crc16_modbus_then_03_but_0a_as_0b"),
        *("sum16_of2l", "xor16_of2b", "fletcher32_of2b_modulo_ffff_from_0"),
    ],
)
def test_a_name_says_everything_about_its_algorithm(name: str) -> None:
    assert algorithm_name(checksum_named(name)) == name
