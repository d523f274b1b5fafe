"""A number in a word of bits that is left out is never sent as a quantity that nobody has asked for.

The word is that of a drive whose manual prints torque = count * 36 / 4095 - 18 Nm: count 0 is full torque.
"""

from __future__ import annotations

import importlib
import json
import subprocess
import sys
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from command_line import CommandLine
from external_tools import require_tool
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.values import MeaningError, raw_value
from fieldspec.command.pipeline import checked, load
from fieldspec.targets.c.backend import files as c_files
from fieldspec.targets.explainer.values import word_data
from fieldspec.targets.iec.backend import files as iec_files
from fieldspec.targets.js.backend import files as js_files
from fieldspec.targets.js.backend import shared as js_shared
from fieldspec.targets.kv.backend import files as kv_files
from fieldspec.targets.python.backend import PACKAGE, files, shared
from fieldspec.targets.python.client_cyclic import initial_bytes
from fieldspec.targets.python.client_names import NoTask
from fieldspec.tools.simulator.memory import default_raw
from layouts import layout_at
from python_package import write
from spec_files import DEVICE, gadget

SPEC = """
links:
  - name: line
    source: 1 L1
    byte_order: big
    request: &f [{{name: command, role: code, type: u8}}, {{name: data, role: body}}]
    response: *f
messages:
  - {{name: move, code: 1, source: 1 L2, answered_on: [], request: [{{name: setpoint, type: u24, flags: setpoint}}]}}
enums:
  - {{name: mode, source: 1 L3, members: [{{value: 1, name: jog}}, {{value: 2, name: run}}]}}
  - {{name: open_mode, open: true, source: 1 L3, members: [{{value: 1, name: fast, source: 1 L4}}]}}
flags:
  - name: setpoint
    type: u24
    source: 1 L3
    bits: [{bits}]
{more}"""
TORQUE = "bits: 0..11, name: torque, scale: 36/4095, offset: -18, unit: Nm"
NEEDED = {
    "an offset": (f"{{{TORQUE}}}", "torque", "0 is -18 Nm"),
    "a range without 0": ("{bits: 0..3, name: step, range: 1..9}", "step", "0 is not in 1..9"),
    "a closed enum without 0": ("{bits: 0..3, name: kind, enum: mode}", "kind", "0 is not a member of mode"),
}
HARMLESS = {
    "a scale alone": "{bits: 0..11, name: torque, scale: 0.5, unit: Nm}",
    "an open enum": "{bits: 0..3, name: kind, enum: open_mode}",
    "a range with 0": "{bits: 0..3, name: step, range: 0..9}",
    "reserved bits": "{bits: 0..3, reserved: true}",
}
ENABLED = ", {bit: 23, name: enabled}"


@cache
def layout(bits: str, more: str = "") -> DeviceLayout:
    spec = gadget(SPEC.format(bits=bits + ENABLED, more=more))
    return layout_at(spec, spec.versions()[-1])


def word_of(bits: str, text: str) -> Any:
    """The word that a text means for everything that takes values as people write them."""
    device = layout(bits).device
    value = layout(bits).messages["move"].request.fields[0].value
    assert value is not None
    return raw_value(device, "setpoint", value, text)


@pytest.mark.parametrize("why", NEEDED)
@pytest.mark.parametrize("text", ["enabled", ""])
def test_a_number_whose_0_means_something_has_to_be_given(why: str, text: str) -> None:
    bits, name, reason = NEEDED[why]
    with pytest.raises(
        MeaningError, match=f"`{name}` is not given, and its {reason}; give `{name}=`, or the whole word"
    ):
        word_of(bits, text)


@pytest.mark.parametrize("why", HARMLESS)
def test_a_number_whose_0_is_0_may_be_left_out(why: str) -> None:
    assert word_of(HARMLESS[why], "enabled") == 1 << 23


def test_a_word_is_given_as_a_whole_by_its_number() -> None:
    assert word_of(f"{{{TORQUE}}}", "0x800000") == 1 << 23


@pytest.mark.parametrize("default", ["default: 2730", "unit_default: 6"])
def test_a_number_that_is_left_out_has_its_default(default: str) -> None:
    bits = f"{{{TORQUE}, {default}}}"
    assert word_of(bits, "enabled") == 1 << 23 | 2730  # 2730 * 36 / 4095 - 18 = 6
    assert word_of(bits, "torque=4095") == 4095


def test_of_two_meanings_of_the_same_bits_any_gives_them() -> None:
    bits = f"{{{TORQUE}, when: the mode is torque}}, {{bits: 0..11, name: force, offset: -5, unit: N, when: else}}"
    assert word_of(bits, "force=7") == 7
    with pytest.raises(MeaningError, match="`torque` is not given"):
        word_of(bits, "enabled")


def test_a_number_that_is_given_twice_is_refused() -> None:
    with pytest.raises(MeaningError, match="`torque` has two values"):
        word_of(f"{{{TORQUE}}}", "torque=1, torque=2")


def test_the_command_line_sends_no_torque_that_nobody_has_asked_for(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    write(tmp_path, {"gadget/device.yaml": DEVICE + SPEC.format(bits=f"{{{TORQUE}}}{ENABLED}", more="")})
    run = CommandLine(capsys, monkeypatch, tmp_path)
    refused = run("encode", "gadget", "move", "setpoint=enabled")
    assert (refused.code, refused.out) == (2, "")
    assert "`torque` is not given, and its 0 is -18 Nm" in refused.err
    assert run("encode", "gadget", "move", "setpoint=enabled,torque=2730").lines == ["01 80 0A AA"]


def test_an_example_says_every_such_number() -> None:
    values = "{id: a, link: line, direction: request, message: move, frame: 01 80 00 00, values: {setpoint: [enabled]}"
    example = f"examples:\n  - {values}, source: 1 L9}}\n"
    text = DEVICE + SPEC.format(bits=f"{{{TORQUE}}}{ENABLED}", more=example)
    findings = checked(load({"gadget/device.yaml": text.encode()}))
    assert [finding.code for finding in findings] == ["meaning_matches_bytes"]
    assert "`torque` is not given" in findings[0].message


@pytest.fixture
def python_word(tmp_path: Path) -> Iterator[Callable[[str], Any]]:
    """The class of the word in the generated Python, by the bits of its spec."""
    names: list[str] = []

    def module(bits: str) -> Any:
        name = f"left_out_{abs(hash(bits))}"
        texts = {**shared(), **files([layout(bits)])}
        write(tmp_path, {path.replace(PACKAGE, name, 1): text for path, text in texts.items()})
        names.append(name)
        return importlib.import_module(f"{name}.gadget").Setpoint

    sys.path.insert(0, str(tmp_path))
    yield module
    sys.path.remove(str(tmp_path))
    for loaded in [key for key in sys.modules if key.partition(".")[0] in names]:
        del sys.modules[loaded]


@pytest.mark.parametrize("why", NEEDED)
def test_generated_python_refuses_a_word_without_such_a_number(python_word: Callable[[str], Any], why: str) -> None:
    bits, name, reason = NEEDED[why]
    word = python_word(bits)
    for arguments in ({}, {"enabled": True}):
        with pytest.raises(ValueError, match=f"{name} of Setpoint is not given, and its {reason}") as error:
            word(**arguments)
        assert error.value.reason == "missing_value"  # type: ignore[attr-defined]
    assert word(0, enabled=True).raw == 1 << 23
    assert word(**{name: 1}).raw == 1


def test_generated_python_takes_the_quantity_in_place_of_the_count(python_word: Callable[[str], Any]) -> None:
    assert python_word(f"{{{TORQUE}}}")(torque_nm=6.0, enabled=True).raw == 1 << 23 | 2730


def test_generated_python_fills_in_defaults(python_word: Callable[[str], Any]) -> None:
    word = python_word(f"{{{TORQUE}, default: 2730}}")
    assert (word().raw, word(enabled=True).raw, word(torque=0).raw, word(0).raw) == (2730, 1 << 23 | 2730, 0, 0)


def javascript_words(tmp_path: Path, bits: str, calls: list[tuple[Any, ...]]) -> list[Any]:
    """The numbers of words in the generated JavaScript, or the reason and the text of what it throws."""
    write(tmp_path, {**js_shared(), **js_files([layout(bits)])})
    program = """
        const { Setpoint } = await import(process.argv[1]);
        const outcome = (own) => {
          try { return Setpoint.raw(...own); } catch (error) { return [error.reason, error.message]; }
        };
        console.log(JSON.stringify(JSON.parse(process.argv[2]).map(outcome)));
    """
    module = next(tmp_path.glob("gadget/v*[0-9].js"))
    command = [require_tool("node"), "--input-type=module", "-e", program, str(module), json.dumps(calls)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    result: list[Any] = json.loads(run.stdout)
    return result


@pytest.mark.parametrize("why", NEEDED)
def test_generated_javascript_refuses_a_word_without_such_a_number(tmp_path: Path, why: str) -> None:
    bits, name, reason = NEEDED[why]
    (code, text), with_base, complete = javascript_words(
        tmp_path, bits, [({"enabled": True},), ({"enabled": True}, 0), ({name: 1},)]
    )
    assert code == "missing_value"
    assert f"{name} of setpoint is not given, and its {reason}" in text
    assert (with_base, complete) == (1 << 23, 1)


def test_generated_javascript_fills_in_defaults(tmp_path: Path) -> None:
    bits = f"{{{TORQUE}, default: 2730}}"
    calls = [({},), ({"enabled": True},), ({"torque": 0},), ({}, 0)]
    assert javascript_words(tmp_path, bits, calls) == [2730, 1 << 23 | 2730, 0, 0]


ENTRIES = [*(bits for bits, _, _ in NEEDED.values()), *HARMLESS.values(), f"{{{TORQUE}, default: 2730}}"]


def test_the_frame_lab_takes_the_same_words_as_the_command_line(tmp_path: Path) -> None:
    write(tmp_path, js_shared())
    jobs, expected = [], []
    for bits in ENTRIES:
        device = layout(bits).device
        for text in ("enabled", "", "torque=7", "step=2, enabled", "kind=run", "step=1, step=2"):
            jobs.append({"word": word_data(device.flags["setpoint"], device.enums), "text": text})
            try:
                expected.append([word_of(bits, text)])
            except MeaningError:
                expected.append([None])
    program = """
        const { rawOf } = await import(process.argv[1]);
        const value = { kind: "integer", size: 3, flags: "setpoint" };
        const mode = { members: [], names: new Map([["run", { value: 2 }]]) };
        const outcome = ({ word, text }) => {
          const enums = new Map([["mode", mode], ["open_mode", { members: [], names: new Map() }]]);
          const device = { flags: new Map([["setpoint", word]]), enums };
          try { return [rawOf(device, "setpoint", value, text)]; } catch (error) { return [null]; }
        };
        console.log(JSON.stringify(JSON.parse(process.argv[2]).map(outcome)));
    """
    entries = tmp_path / "runtime" / "explain" / "entries.js"
    command = [require_tool("node"), "--input-type=module", "-e", program, str(entries), json.dumps(jobs)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert json.loads(run.stdout) == expected


def test_headers_and_controllers_say_what_has_to_be_given() -> None:
    needed = layout(f"{{{TORQUE}}}")
    header = "\n".join(map(str, c_files([needed]).values()))
    assert "Set torque: its 0 is -18 Nm." in header
    structured = "\n".join(str(text) for text in iec_files([needed]).values())
    assert "To be given: its 0 is -18 Nm." in structured
    words = "\n".join(str(text) for text in kv_files([needed]).values())
    assert "to be given: 0 is -18 Nm" in words


def test_headers_have_the_word_of_which_nothing_is_given() -> None:
    header = "\n".join(map(str, c_files([layout(f"{{{TORQUE}, default: 2730}}")]).values()))
    assert "GADGET_SETPOINT_INITIAL 0x000AAAu" in header


def test_a_simulated_device_begins_with_the_defaults_of_its_bits() -> None:
    device = layout(f"{{{TORQUE}, default: 2730}}").device
    value = device.messages["move"].request.fields[0].value
    assert value is not None
    assert default_raw(device, value) == 2730


@pytest.mark.parametrize(
    ("bits", "field"),
    [(f"{{{TORQUE}}}", ""), ("{bit: 0, name: on}", "type: u24, scale: 0.5, offset: -18, unit: Nm")],
)
def test_a_cyclic_exchange_does_not_begin_with_a_quantity_that_nobody_has_asked_for(bits: str, field: str) -> None:
    own = layout(bits)
    if field:
        text = SPEC.format(bits=bits, more="").replace("type: u24, flags: setpoint", field)
        spec = gadget(text)
        own = layout_at(spec, spec.versions()[-1])
    with pytest.raises(NoTask, match="0 is -18 Nm"):
        initial_bytes(own.device, own.messages["move"].request)


def test_a_cyclic_exchange_begins_with_the_defaults_of_bits() -> None:
    own = layout(f"{{{TORQUE}, default: 2730}}")
    assert initial_bytes(own.device, own.messages["move"].request) == bytes.fromhex("000AAA")
