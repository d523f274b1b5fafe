"""Numbers of half precision, and with sign and magnitude, in functions for controllers.

NumPy and the standard judge the halves. A compass without special values that are not a number has all other facts.
"""

from __future__ import annotations

import random
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy
import pytest

sys.path.insert(0, str(Path(__file__).parent))

import test_execution_registers
from comparisons import all_finite, compare_requests
from compiled import Compiled
from loaded import COMPUTING, programs
from proving import Proof, without
from st_machine import Machine
from st_syntax import parsed

from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.codec.reference import codec
from fieldspec.language.reading.project import read
from fieldspec.targets.controllers.structured.program import program
from fieldspec.targets.iec.backend import source
from fieldspec.targets.iec.backend import text as standard_text
from fieldspec.targets.scl.backend import refusals as scl_refusals
from fieldspec.targets.st.backend import refusals, text
from layouts import TEST_SPECS
from proofs import share

TRIES = 200
NAN = "{bits: 0x7E00, name: not_measured}"


@cache
def compass() -> DeviceLayout:
    """The made-up compass without special values that are a NaN."""
    spec = (TEST_SPECS / "compass" / "device.yaml").read_text("utf-8")
    spec = spec.replace(f"{NAN}, ", "").replace(f", sentinels: [{NAN}]", "")
    device, findings = read({"compass/device.yaml": spec.encode()}).devices["compass"].at("1")
    assert NAN not in spec
    assert findings == []
    return device_layout(device)


@pytest.fixture(params=COMPUTING, scope="module")
def prover(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Proof:
    """Its functions in machines that make whole numbers of fractions in different ways."""
    if request.param == "compiled":
        standard = source(compass())
        return Proof(standard.declared.world, Compiled(standard_text(standard), programs(tmp_path_factory)))
    structured = program(compass())
    return Proof(structured.declared.world, Machine(parsed(text(structured)), request.param))


@pytest.mark.proof
def test_every_half_is_the_number_that_numpy_reads(prover: Proof) -> None:
    name = prover.world.routine("real_from_half_bits")
    numbers = numpy.arange(1 << 16, dtype="u2").view("f2").astype("f4")
    for bits, number in share([*enumerate(numbers.tolist())], 6_007):
        status, (value,) = prover.positional(name, bits)
        if numpy.isfinite(number):
            assert (status, value) == ("ok", number), hex(bits)
        else:
            assert status == "no_number", hex(bits)


def singles() -> list[float]:
    """Numbers of 32 bits: all halves, the middles between them and what is next to these, and random ones."""
    finite = numpy.arange(0x7C00, dtype="u2").view("f2").astype("f4")
    middles = ((finite[:-1] + finite[1:]) / 2).astype("f4")
    limit = numpy.float32(65520)
    beside = [numpy.nextafter(middles, end, dtype="f4") for end in (numpy.float32(0), numpy.float32("inf"))]
    random_numbers = numpy.random.default_rng(1).integers(0, 0x7F800000, 2000, dtype="u4").view("f4")
    every = numpy.concatenate(
        [finite, middles, *beside, random_numbers, [numpy.nextafter(limit, numpy.float32(0)), limit]]
    )[::7]
    return [float(number) for number in numpy.concatenate([every, -every])]


@pytest.mark.proof
def test_every_real_becomes_the_half_that_numpy_rounds_it_to(prover: Proof) -> None:
    name = prover.world.routine("half_bits_from_real")
    for number in share(singles(), 5_003):
        status, (bits,) = prover.positional(name, number)
        with numpy.errstate(over="ignore"):
            half = numpy.float32(number).astype("f2")
        if numpy.isinf(half):
            assert status == "out_of_range", number
            continue
        # No function tells the zeros apart that nobody writes.
        assert (status, bits) == ("ok", 0 if number == 0 else int(half.view("u2"))), number


@pytest.mark.parametrize("number", [float("inf"), float("-inf"), float("nan")])
def test_what_is_infinite_or_no_number_becomes_no_half(prover: Proof, number: float) -> None:
    assert prover.positional(prover.world.routine("half_bits_from_real"), number)[0] == "no_number"


@pytest.mark.parametrize(
    ("bits", "number"), [(0, 0), (0x8000, 0), (1, 1), (0x8001, -1), (0x7FFF, 32767), (0xFFFF, -32767)]
)
def test_the_highest_bit_is_the_sign_of_a_magnitude(prover: Proof, bits: int, number: int) -> None:
    (actual,) = prover.machine.call(prover.world.routine("number_from_sm16"), wbits=bits)
    (sent,) = prover.machine.call(prover.world.routine("sm16_from_number"), ivalue=number)
    assert (actual, sent) == (number, bits if number else 0)


def test_requests_agree_with_the_reference(prover: Proof) -> None:
    compare_requests(prover, random.Random(1), TRIES)


def test_responses_of_any_numbers_agree_with_the_reference(prover: Proof) -> None:
    dice, link = random.Random(2), compass().links["packet"]
    message, reference = compass().messages["measure"], codec(compass()).links["packet"]
    statuses = []
    for _ in range(TRIES):
        body = bytes([2]) + dice.randbytes(29 + 2 * dice.randrange(5))
        frame = body + bytes([sum(body) & 0xFF])
        expected = without(message.response, reference.decode(frame, "response", "measure").values)
        status, values = prover.parse(link, message, frame)
        statuses.append(status)
        if all_finite(expected):
            assert (status, {name: values[name] for name in expected}) == ("ok", expected)
        else:
            assert status == "no_number"
    assert {*statuses} == {"ok", "no_number"}


@pytest.mark.parametrize(
    "compare",
    [
        test_execution_registers.test_groups_of_registers_are_read_as_the_reference_reads_them,
        test_execution_registers.test_groups_of_registers_are_written_as_the_reference_writes_them,
    ],
)
def test_registers_agree_with_the_reference(prover: Proof, compare: Callable[[Proof], None]) -> None:
    compare(prover)


def test_a_dialect_with_64_bits_refuses_nothing() -> None:
    assert refusals([compass()]) == []


def test_a_dialect_without_64_bits_refuses_a_magnitude_of_them() -> None:
    messages = [finding.message for finding in scl_refusals([compass()]) if finding.code == "plc_numbers_fit"]
    assert messages == [
        "wide is sm64, a number that the functions for SCL of TIA Portal, for S7-1200 and S7-1500 cannot convert"
    ]
