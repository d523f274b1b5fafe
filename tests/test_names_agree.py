"""One name for one fact: the generated Python, C and JavaScript name it alike, but for the case of their languages."""

from __future__ import annotations

import inspect
import json
import keyword
import re
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from external_tools import require_tool
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.names import Name
from fieldspec.targets.c.backend import files as c_files
from fieldspec.targets.js.backend import files as js_files
from fieldspec.targets.python.backend import files as python_files
from fieldspec.targets.python.naming import Scope
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


@pytest.mark.proof(6)
@pytest.mark.parametrize("name", LAYOUTS)
def test_outputs_name_a_fact_alike(name: str) -> None:
    for fact in facts(LAYOUTS[name]):
        word = fact.replace("_", "").lower()
        for output in OUTPUTS:
            own = word.removesuffix("fromraw").removesuffix("toraw") if output == "js" else word
            assert own in defined(name, output), f"{output} does not name {fact}"


def parameters(layout: DeviceLayout, output: str, link: str) -> list[str]:
    """The parts of a request that its encoder takes in an output, in snake case and in their order on the wire."""
    texts = [text for text in OUTPUTS[output][0]([layout]).values() if isinstance(text, str)]
    if output == "python":
        names = list(
            inspect.signature(
                getattr(module_of(layout), Scope(frozenset(keyword.kwlist)).take(link)).encode_request
            ).parameters
        )
        return [name.removesuffix("_") for name in names if name != "message"]
    pattern = {
        "c": rf"_{link}_request_close\(([^)]*)\)\n?\s*\{{",
        "js": rf"declare const {Name.of(link).camel()}(?:Link)?: Link<(\{{[^}}]*\}}|Record)",
    }[output]
    text = next(match for text in texts for match in re.findall(pattern, text))
    if output == "js":
        return [re.sub("([A-Z])", r"_\1", name).lower() for name in re.findall(r"readonly (\w+)", text)]
    names = [item.split()[-1].strip("*") for item in text.split(",")]
    return [
        name.removesuffix("_") for name in names if name not in ("code", "body_length", "out", "capacity", "length")
    ]


LINKS = [
    (name, link.name) for name, layout in LAYOUTS.items() for link in layout.links.values() if link.carried("request")
]


@pytest.mark.proof(11)
@pytest.mark.parametrize(("name", "link"), LINKS)
def test_encoders_of_requests_take_parts_of_the_same_names(name: str, link: str) -> None:
    layout = LAYOUTS[name]
    taken = {output: sorted(parameters(layout, output, link)) for output in OUTPUTS}
    parts = [part for part in layout.links[link].request.header if part.is_argument and not part.reserved]
    names = sorted(part.role if part.role == "unit_address" else part.name for part in parts)
    assert taken == dict.fromkeys(OUTPUTS, names)


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
