"""Quantities as text: digits before the point are exact, and every count has a text of its own."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest

from fieldspec.codec.explain.percentages import percentage_text
from fieldspec.codec.explain.values import in_unit, range_in_unit
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.encoding import is_signed
from fieldspec.language.model.quantity import real_text
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.record import Field
from fieldspec.targets.js.backend import files, shared
from js_output.explanations import explained_by_node, explained_by_python
from layouts import SPECS, TEST_SPECS, layout_at, newest
from spec_files import gadget

SCALES = [
    ("i32", "1/60", "0"),
    ("u24", "7/9", "0"),
    ("u32", "100000/7", "0"),
    ("i32", "360/2^20", "-180"),
    ("u16", "90/4095", "-45"),
    ("u32", "1/10^9", "0.1"),
    ("i16", "0.1", "0.12345678912"),
    ("u24", "0.123456789", "0"),
    ("u48", "1/3", "0"),
    ("i64", "1/7", "0"),
    ("i64", "5/3", "-1000000.5"),
    ("i24", "-0.123456789", "0"),
    ("u32", "0.01", "0"),
]
LINK = """links:
  - {name: line, source: 1 L1, byte_order: big, word_order: big,
     request: &frame [{name: code, role: code, type: u8}, {name: data, role: body}], response: *frame}
messages:
"""


@cache
def device() -> DeviceLayout:
    """A device with a message for each scale."""
    rows = [
        f"  - {{name: scale_{number}, code: {number}, source: 1 L2, response: [], request: [{{name: value,"
        f" type: {type_}, scale: {scale}, offset: {offset}, unit: mm}}]}}\n"
        for number, (type_, scale, offset) in enumerate(SCALES)
    ]
    spec = gadget(LINK + "".join(rows))
    return layout_at(spec, spec.versions()[-1])


def field_of(number: int) -> Field:
    return device().messages[f"scale_{number}"].request.fields[0].field


def counts_of(number: int) -> Iterator[int]:
    """Counts of a scale, random ones and those at the ends, each with the next one."""
    value = field_of(number).value
    assert value is not None
    source = random.Random(number)
    ends = (value.low, -1, 0, 1, 10000001, value.high - 1)
    drawn = [source.randint(value.low, value.high - 1) >> source.randrange(8 * value.size) for _ in range(300)]
    for count in (*ends, *drawn):
        if value.low <= count < value.high:
            yield from (count, count + 1)


def text_of(number: int, count: int) -> str:
    value = field_of(number).value
    assert value is not None
    return in_unit(value, count).removesuffix(" mm")


def exact(number: int, count: int) -> Fraction:
    """The quantity by the text of the scale alone."""
    _, scale, offset = SCALES[number]
    above, _, below = scale.partition("/")
    base, _, power = below.partition("^")
    return count * Fraction(above) / Fraction(base or "1") ** int(power or "1") + Fraction(offset)


@pytest.mark.parametrize("number", range(len(SCALES)), ids=lambda number: "{} {} {}".format(*SCALES[number]))
def test_digits_before_the_point_are_those_of_the_exact_quantity(number: int) -> None:
    for count in counts_of(number):
        text, quantity = text_of(number, count), exact(number, count)
        assert int(text.partition(".")[0]) == int(quantity), (count, text)


@pytest.mark.parametrize("number", range(len(SCALES)), ids=lambda number: "{} {} {}".format(*SCALES[number]))
def test_a_text_is_within_half_a_digit_of_the_exact_quantity_and_its_last_digit_is_at_most_a_count(number: int) -> None:
    for count in counts_of(number):
        text, quantity = text_of(number, count), exact(number, count)
        last_digit = Fraction(1, 10 ** len(text.partition(".")[2]))
        assert abs(Fraction(text) - quantity) <= last_digit / 2, (count, text)
        coarsest = abs(Fraction(exact(number, 1) - exact(number, 0))) if Fraction(text) != quantity else last_digit
        assert last_digit <= coarsest


@pytest.mark.parametrize("number", range(len(SCALES)), ids=lambda number: "{} {} {}".format(*SCALES[number]))
def test_every_count_has_a_text_of_its_own(number: int) -> None:
    texts = {count: text_of(number, count) for count in counts_of(number)}
    assert len(set(texts.values())) == len(texts)


def test_bounds_of_ranges_are_quantities_of_counts() -> None:
    value = field_of(0).value
    assert value is not None
    assert range_in_unit(value, Ranges(((10000001, 10000002),))) == "166666.68..166666.7 mm"


def test_a_percentage_resolves_a_count_of_its_full_scale() -> None:
    layout = newest(TEST_SPECS, "totalizer")
    conversion = next(iter(layout.device.conversions.values()))
    texts = {percentage_text(layout.device, conversion, count) for count in range(5_000_000, 5_000_500)}
    assert len(texts) == 500


@pytest.mark.parametrize(
    ("number", "text"),
    [
        (25.0, "25"),
        (0.1 + 0.2, "0.3"),
        (166666.68333333332, "166666.683333333"),
        (-1234567.0, "-1234567"),
        (123456789012345678.0, "1.2345678901234568e+17"),
        (1e-7, "1e-07"),
    ],
)
def test_a_computed_number_has_all_digits_that_a_double_has(number: float, text: str) -> None:
    assert real_text(number) == text


def test_no_number_is_printed_with_six_digits() -> None:
    sources = (path for path in (SPECS.parent / "codegen" / "fieldspec").rglob("*.py"))
    rounding = [path.name for path in sources if re.search(r"\{[^{}\n]*:(?:\.[0-9])?[eg]\}", path.read_text("utf-8"))]
    assert rounding == []


@pytest.fixture(scope="module")
def explainer(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The explainer of the device in JavaScript."""
    folder = tmp_path_factory.mktemp("package")
    for path, text in {**shared(), **files([device()])}.items():
        place = folder / path
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, "utf-8")
    return next(folder.glob("gadget/*_explain.js"))


def test_a_browser_shows_the_same_texts(explainer: Path) -> None:
    jobs = []
    for number in range(len(SCALES)):
        value = field_of(number).value
        assert value is not None
        for count in counts_of(number):
            data = count.to_bytes(value.size, "big", signed=is_signed(value.encoding))
            jobs.append({"module": str(explainer), "frame": f"{number:02x}{data.hex()}", "options": {}, "request": ""})
    for job, (have,) in zip(jobs, explained_by_node(jobs), strict=True):
        assert have == explained_by_python(device(), job), job
