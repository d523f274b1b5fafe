"""Checksum algorithms as data, judged by crccheck and anycrc."""

from __future__ import annotations

import random
import zlib

import anycrc
import crccheck.crc
import pytest

from fieldspec.codec.layout.checksums import checksum
from fieldspec.codec.reference.checksums import checksum as reference_checksum
from fieldspec.language.model.checksums import algorithm_name, catalogue_name, checksum_named
from fieldspec.language.model.crc_catalogue import CRC_CATALOGUE, OTHER_NAMES
from fieldspec.language.schema import schema

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
    ],
)
def test_a_name_says_everything_about_its_algorithm(name: str) -> None:
    assert algorithm_name(checksum_named(name)) == name
