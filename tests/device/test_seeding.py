"""A dump that a simulated device begins with is its words afterwards, however the dump has them."""

from __future__ import annotations

import pytest

from fieldspec.tools.lists.dump import dump
from fieldspec.tools.lists.text_sheet import text_sheet
from fieldspec.tools.simulator.engine import Engine
from fieldspec.tools.simulator.seeding import seed
from simulators import parts_of

BEFORE = "address,value\n0x2002,17\n0x2003,34\n"


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        pytest.param("address,value\n0x2002,7\n", (7, 34), id="a word"),
        pytest.param("address,value\n0x2002,0xFFFF\n", (0xFFFF, 34), id="the greatest word"),
        pytest.param("address,value\n0x2002,0x10000\n", (1, 0), id="more than a word has"),
        pytest.param("address,value\n0x2002,-2\n", (0xFFFF, 0xFFFE), id="less than a word has"),
        pytest.param("address,words,value\n0x2002,2,7\n", (0, 7), id="a number of two words"),
        pytest.param("address,words,value\n0x2002,1,7\n", (7, 34), id="a number of one word"),
        pytest.param("address,value\n0x2002,3 4\n", (3, 4), id="two words in a row"),
    ],
)
def test_a_number_in_a_dump_is_as_many_words_as_it_needs_or_as_the_dump_says(rows: str, words: tuple[int, int]) -> None:
    engine = Engine(*parts_of("tc100"))
    for text in (BEFORE, rows):
        assert seed(engine, dump(text_sheet(text.encode()), {}))[1] == 0
    space = engine.layout.device.space_name("")
    assert tuple(engine.memory.words[space, address] for address in (0x2002, 0x2003)) == words
