"""What is read of a trigger: nothing that was written, so neither its enum nor its range binds it; its type does."""

from __future__ import annotations

from contextlib import nullcontext
from pathlib import Path
from typing import Any

import pytest

from captures.bulk import Sent, decoded, values
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.tools.captures.decoding import Choices
from js_output.explanations import explained_by_node, explained_by_python
from python_package import codec_error, module_apart
from random_devices.agreement import layouts_of
from random_devices.script_judge import ScriptExplainer

CASE = Path(__file__).parent / "random_devices" / "cases" / "answers-of-triggers.yaml"
ANSWERS = (
    ("start", "0001", ""),
    ("start", "0002", "unknown_value"),
    ("named", "0000", ""),
    ("named", "0105", "unknown_value"),
    ("mode", "0001", ""),
    ("mode", "0009", ""),
    ("limit", "0032", ""),
    ("count", "0012", ""),
    ("count", "1234", ""),
    ("count", "00FA", "unknown_value"),
)
"""Registers, each with the word that is read, and the reason for which it is no value."""


@pytest.fixture(scope="module")
def layout() -> DeviceLayout:
    return layouts_of(CASE.read_text(encoding="utf-8"))[0]


@pytest.fixture(scope="module")
def module(layout: DeviceLayout) -> Any:
    return module_apart(layout, "answers_of_triggers")


def exchange(layout: DeviceLayout, name: str, word: str) -> tuple[bytes, bytes]:
    """The request for a register, and the response with a word."""
    register = next(register for register in layout.registers if register.name == name)
    return bytes([3, 0, register.address, 0, 1]), bytes([3, 2]) + bytes.fromhex(word)


@pytest.mark.parametrize(("name", "word", "reason"), ANSWERS)
def test_python_refuses_what_is_no_value_of_the_type(module: Any, name: str, word: str, reason: str) -> None:
    refused = pytest.raises(codec_error(), match=reason) if reason else nullcontext()
    with refused:
        getattr(module, name.upper()).decode(bytes.fromhex(word))


@pytest.mark.parametrize(("name", "word", "reason"), ANSWERS)
def test_an_explanation_has_the_verdict_of_the_codecs(layout: DeviceLayout, name: str, word: str, reason: str) -> None:
    request, response = exchange(layout, name, word)
    (row,) = explained(layout, "line", "response", response, "", request).registers
    assert (row.reason, row.verdict.startswith("wrong: should be ")) == (reason, bool(reason))


def test_javascript_explains_them_as_python_does(layout: DeviceLayout, tmp_path: Path) -> None:
    judge = ScriptExplainer(layout, tmp_path, 1)
    frames = [exchange(layout, name, word) for name, word, _ in ANSWERS]
    jobs = [judge.job(("line", "response"), response, request) for request, response in frames]
    assert [answer for (answer,) in explained_by_node(jobs)] == [explained_by_python(layout, job) for job in jobs]


def test_captures_have_the_same_verdicts(layout: DeviceLayout) -> None:
    frames = [
        Sent(stream, direction, frame)
        for stream, (name, word, _) in enumerate(ANSWERS)
        for direction, frame in zip(("request", "response"), exchange(layout, name, word), strict=True)
    ]
    rows = [(row.register, row.verdict) for row in values(decoded(layout, frames, Choices("line")))]
    assert rows == [(name, reason or "ok") for name, _, reason in ANSWERS]
