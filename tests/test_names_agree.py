"""One name for one fact: the generated Python, C and JavaScript name it alike, but for the case of their languages."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from external_tools import require_tool
from fieldspec.backends.c.backend import files as c_files
from fieldspec.backends.js.backend import files as js_files
from fieldspec.backends.python.backend import files as python_files
from fieldspec.layout.device import DeviceLayout
from layouts import SPECS, TEST_SPECS, has_digits, layouts, newest
from python_package import module_of

sys.path.insert(0, str(Path(__file__).parent / "js_output"))

from javascript import module_path

OUTPUTS = {
    "python": (python_files, r"^(?:class|def) (\w+)|^(\w+): _Final"),
    "c": (c_files, r"\b([A-Za-z]\w+)\b"),
    "js": (js_files, r"^export (?:const|function|class) (\w+)"),
}
"""By output: its files, and what it defines in them."""

LAYOUTS = {
    name: versions[-1]
    for root in (SPECS, TEST_SPECS)
    for name, versions in layouts(root).items()
    if not has_digits(versions[-1])
}


@cache
def defined(name: str, output: str) -> str:
    """The names that an output of a device defines, in lower case without underscores, one in each line."""
    files, pattern = OUTPUTS[output]
    texts = [text for text in files([LAYOUTS[name]]).values() if isinstance(text, str)]
    words = {"".join(groups) for text in texts for groups in re.findall(pattern, text, re.MULTILINE)}
    return "\n".join(["", *sorted(word.replace("_", "").lower() for word in words), ""])


def facts(layout: DeviceLayout) -> Iterator[str]:
    """The names of facts, with the word that says which of several functions or types of a fact is meant."""
    device = layout.device
    yield from device.enums
    yield from device.flags
    yield from layout.records
    yield from (register.name for register in layout.registers)
    yield from device.messages
    for name in device.conversions:
        yield from (f"{name}_from_raw", f"{name}_to_raw")


@pytest.mark.parametrize("name", LAYOUTS)
def test_outputs_name_a_fact_alike(name: str) -> None:
    for fact in facts(LAYOUTS[name]):
        word = fact.replace("_", "").lower()
        for output in OUTPUTS:
            own = word.removesuffix("fromraw").removesuffix("toraw") if output == "js" else word
            assert own in defined(name, output), f"{output} does not name {fact}"


PROGRAM = """
const { commandedSpeed, outputTorque } = await import(process.argv[1]);
const pairs = [[commandedSpeed, 536870912, 3000], [outputTorque, 4096, 2]];
const quantities = pairs.map(([conversion, raw, reference]) => conversion.fromRaw(raw, reference));
const raws = pairs.map(([conversion, , reference], at) => conversion.toRaw(quantities[at], reference));
console.log(JSON.stringify([quantities, raws]));
"""


def test_conversions_have_the_same_names_and_numbers_in_python_and_javascript() -> None:
    layout = newest(TEST_SPECS, "glider-x")
    module = module_of(layout)
    command = [require_tool("node"), "--input-type=module", "-e", PROGRAM, str(module_path(layout))]
    run = subprocess.run(command, capture_output=True, text=True, check=True)
    quantities, raws = json.loads(run.stdout)
    assert quantities == [module.commanded_speed_from_raw(1 << 29, 3000), module.output_torque_from_raw(4096, 2)]
    assert raws == [module.commanded_speed_to_raw(quantities[0], 3000), module.output_torque_to_raw(quantities[1], 2)]
