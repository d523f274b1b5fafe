"""What blocks compare and send has a name: addresses, masks, states, errors. The names have the numbers of the spec."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from fieldspec.foundation.names import Name, stem
from layouts import SPECS, layouts, newest

GENERATED = Path(__file__).parents[2] / "generated"
TARGETS = ("st", "iec", "scl", "plcopen", "twincat")
BARE = {
    "an error": r"\b(?:(?:ui|stat)(?:(?:First)?Reason|Refusal)|(?:stat)?ErrorID|(?:axis|frames)\.error|uiError)"
    r" (?::=|=|<>|&lt;&gt;) [1-9]",
    "a state of a port": r"\.(?:iS|s)tate (?::=|=|<>|&lt;&gt;) \d",
    "an urgency": r"\.(?:iU|u)rgent (?::=|>|<|>=|<=|&gt;|&lt;) [1-9]",
    "an address": r"\.(?:uiA|a)ddress := \d",
    "a state of an exchange": r"\b#?(?:iS|statS|s)tate (?::=|=|<>|&lt;&gt;) \d",
    "the code of a message": r"\b(?:usi|temp)Code (?::=|<>|&lt;&gt;) \d",
}
"""Numbers that stand where a name belongs; 0 is not an error and no bit."""
ADAPTER = re.compile(r'^FUNCTION_BLOCK "\w+_(?:ModbusMaster|PointToPoint|(?:Telegram\d+)?(?:Program|Input|Output))"')
"""What serves the port in TIA Portal."""
MASK = r"\bD?WORD#16#0*[1-9A-F]\w*"
"""What blocks of tasks call by a name; functions that convert, and codes of vendors, have such numbers of their own."""


@cache
def text_of(target: str, device: str) -> str:
    """All text of a device for a target, as it is delivered."""
    layout = newest(SPECS, device)
    name = stem(layout.device.id, layout.device.version)
    paths = sorted([*GENERATED.glob(f"{target}/{name}*"), *GENERATED.glob(f"{target}/{name}/**/*")])
    texts = [path.read_text("utf-8-sig") for path in paths if path.suffix in (".st", ".scl", ".xml", ".TcPOU")]
    return "\n".join(texts).replace("\r\n", "\n")


def blocks(target: str, device: str) -> list[str]:
    """The functions and blocks of a device, those of adapters included."""
    text = text_of(target, device)
    if target == "plcopen":
        return re.findall(r"<pou name=.*?</pou>", text, re.DOTALL)
    if target == "twincat":
        return re.findall(r"<POU Name=.*?</POU>", text, re.DOTALL)
    return re.findall(r"^FUNCTION(?:_BLOCK)? .*?^END_FUNCTION(?:_BLOCK)?$", text, re.DOTALL | re.MULTILINE)


CASES = [pytest.param(target, device, id=f"{device}-{target}") for target in TARGETS for device in layouts(SPECS)]


@pytest.mark.proof(7)
@pytest.mark.parametrize(("target", "device"), CASES)
def test_no_block_has_a_bare_number_where_a_name_belongs(target: str, device: str) -> None:
    bare = {
        kind: matches
        for kind, pattern in BARE.items()
        if (matches := [match for block in blocks(target, device) for match in re.findall(pattern, block)])
    }
    of_tasks = [
        block
        for block in blocks(target, device)
        if re.search(r'^\W*\w+ (?:Name=|name=)?"?FB_|^FUNCTION_BLOCK "\w+_', block) and not ADAPTER.search(block)
    ]
    assert bare == {}
    assert [match for block in of_tasks for match in re.findall(MASK, block)] == []


def stated(device: str) -> dict[str, int]:
    """The numbers that a spec states, by the names that blocks have for them."""
    layout = newest(SPECS, device)
    numbers = {f"{Name.of(item.name).upper()}_ADDRESS": item.address for item in layout.registers}
    for word in layout.device.flags.values():
        for bit in word.bits:
            mask = sum(1 << place for place in range(bit.first, bit.first + bit.width))
            numbers[f"{Name.of(f'{word.name}_{bit.name}').upper()}_MASK"] = mask
    for message in layout.messages.values():
        if message.message.code is not None:
            numbers[f"{Name.of(message.name).upper()}_CODE"] = message.message.code
    return numbers


def declared(device: str) -> Iterator[tuple[str, int]]:
    """The constants that the blocks of a device declare."""
    for block in blocks("iec", device):
        for section in re.findall(r"^VAR CONSTANT$(.*?)^END_VAR$", block, re.DOTALL | re.MULTILINE):
            for name, base, digits in re.findall(r"(\w+) : \w+ := (16#)?(\w+);", section):
                yield name, int(digits, 16 if base else 10)


@pytest.mark.parametrize("device", layouts(SPECS))
def test_constants_of_blocks_have_the_numbers_of_the_spec(device: str) -> None:
    numbers = stated(device)
    judged = {(name, number) for name, number in declared(device) if name.endswith(("_ADDRESS", "_MASK", "_CODE"))}
    assert judged
    assert {pair for pair in judged if numbers.get(pair[0]) != pair[1]} == set()


def test_the_name_of_a_block_begins_with_its_telegram() -> None:
    names = re.findall(r"^FUNCTION_BLOCK FB_HiwinE_(\w+)", text_of("st", "hiwin-e"), re.MULTILINE)
    assert names
    assert {name for name in names if "Telegram" in name and not re.match(r"Telegram\d+[A-Z]", name)} == set()


@pytest.mark.parametrize("device", layouts(SPECS))
def test_a_name_of_a_block_is_declared_where_it_is_used(device: str) -> None:
    for block in blocks("iec", device):
        head, _, body = block.rpartition("END_VAR\n")
        names = set(re.findall(r"^    ([A-Z][A-Z0-9_]+) : ", head, re.MULTILINE))
        words = set(re.findall(r"\b[A-Z][A-Z0-9]*_[A-Z0-9_]+\b(?!\()", re.sub(r"\(\*.*?\*\)", "", body)))
        assert {word for word in words if not word.startswith("END_")} == names
