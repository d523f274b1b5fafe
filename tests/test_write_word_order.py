"""Registers that are read and written with their words in different orders."""

from __future__ import annotations

import pytest

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.explain.occupants import occupant_at
from fieldspec.targets import OUTPUTS
from fieldspec.tools.lists.orders import stated_order
from fieldspec.tools.live.writing import assignment
from layouts import TEST_SPECS, newest
from python_package import module_of
from simulators import Unit

WARMER = newest(TEST_SPECS, "warmer")
PYTHON = module_of(WARMER)
READ, WRITE = "read_registers", "write_registers"
SPECS = str(TEST_SPECS)

WORDS = {
    "energy_limit": (0, 70000, [0x1170, 0x0001]),
    "flow_temperature": (2, 45.5, [0x0000, 0x4236]),
    "hours": (4, -2, [0xFFFE, 0xFFFF, 0xFFFF, 0xFFFF]),
    "stages[2]": (10, 0x10000, [0x0000, 0x0001]),
}
"""What registers answer."""


def register(name: str) -> object:
    own, _, number = name.partition("[")
    constant = getattr(PYTHON, own.upper())
    return constant[int(number[:-1])] if number else constant


@pytest.mark.parametrize("name", WORDS)
def test_a_simulated_device_answers_what_was_written_in_the_other_order(name: str) -> None:
    address, _, words = WORDS[name]
    unit = Unit("warmer", "tcp", folder=SPECS)
    unit.ask(WRITE, transaction=1, address=address, values=words[::-1])
    assert unit.ask(READ, transaction=1, address=address, word_count=len(words))["values"] == words


def test_words_of_a_number_may_be_written_one_after_the_other() -> None:
    unit = Unit("warmer", "tcp", folder=SPECS)
    for address, word in ((0, 0x0001), (1, 0x1170)):
        unit.ask(WRITE, transaction=1, address=address, values=[word])
    assert unit.ask(READ, transaction=1, address=0, word_count=2)["values"] == [0x1170, 0x0001]


@pytest.mark.parametrize("name", WORDS)
def test_generated_code_and_live_write_one_order_and_read_the_other(name: str) -> None:
    address, value, words = WORDS[name]
    own = register(name)
    assert own.to_words(value) == words[::-1]
    assert own.from_words(words) == value
    occupant = occupant_at(WARMER, "", address)
    assert occupant is not None
    assert assignment(WARMER, "", occupant, str(value)).words == tuple(words[::-1])


@pytest.mark.parametrize(
    ("direction", "frame", "request_frame"),
    [
        ("request", "00 01 00 00 00 0B 01 10 00 00 00 02 04 00 01 11 70", ""),
        ("response", "00 01 00 00 00 07 01 03 04 11 70 00 01", "00 01 00 00 00 06 01 03 00 00 00 02"),
    ],
)
def test_an_explanation_reads_each_direction_in_its_order(direction: str, frame: str, request_frame: str) -> None:
    explanation = explained(WARMER, "tcp", direction, bytes.fromhex(frame), request=bytes.fromhex(request_frame))
    assert [(row.path, row.number) for row in explanation.registers] == [("energy_limit", 70000)]


def test_a_word_map_leaves_them_out_by_name() -> None:
    findings = OUTPUTS["kv"].refusals([WARMER])
    names = ["energy_limit", "flow_temperature", "hours", "stages"]
    order = "is written in another order of words than a word map has, that of a read"
    assert [finding.message for finding in findings] == [f"{name} {order}" for name in names]


@pytest.mark.parametrize(
    ("text", "order"),
    [
        ("CDAB, written ABCD", "CDAB, written ABCD"),
        ("little, written big", "DCBA, written ABCD"),
        ("CDAB, written", ""),
    ],
)
def test_a_list_states_both_orders_in_one_cell(text: str, order: str) -> None:
    assert stated_order(text) == order
