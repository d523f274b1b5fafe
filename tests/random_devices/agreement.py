"""Compares all judges of a device with the reference. A judge that comes later is one more row of `JUDGES`."""

from __future__ import annotations

import os
import random
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.project import read
from fieldspec.tools.proofs.running import outcome
from matiec import VARIABLE
from random_devices.access_judge import Access
from random_devices.c_judge import C
from random_devices.capture_judge import Captures
from random_devices.command_judge import Command
from random_devices.devices import text_of
from random_devices.draft import Spec
from random_devices.explainer_judge import Explainer
from random_devices.forms_judge import forms_agree
from random_devices.framer_judge import Framers
from random_devices.javascript_judge import JavaScript
from random_devices.meaning_judge import Meanings
from random_devices.python_judge import Python
from random_devices.quantities import expected_answer, quantity_queries, state_queries
from random_devices.queries import Answer, Query, queries
from random_devices.queries_judge import Queries
from random_devices.reference_answers import Reference
from random_devices.script_judge import ScriptExplainer
from random_devices.selftest_judge import Selftest
from random_devices.simulator_judge import Simulator
from random_devices.spec_changes import examples_are_proven, identities_agree
from random_devices.structured_text_judge import StructuredText
from random_devices.tables_judge import Tables
from random_devices.wireshark_judge import Wireshark, has_tshark

SANITIZED = ["gcc", "-std=c99", "-w", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
BIG_ENDIAN = ["m68k-linux-gnu-gcc", "-std=c99", "-w", "-static"]


@dataclass(frozen=True)
class Judge:
    """A codec that is compared with the reference: one of `every` devices is asked.

    `build` makes it for a layout in a folder, with a number that no other device of the process has. A language that
    `drops_bits` has its own NaN, and texts that end at a zero. What `has_quantities` is asked about these too.
    """

    name: str
    every: int
    build: Callable[[DeviceLayout, Path, int], Any]
    drops_bits: bool = False
    has_quantities: bool = False


def has_matiec() -> bool:
    """Whether there is a compiler of Structured Text; `CONTRIBUTING.md` says how to get it."""
    return Path(os.environ.get(VARIABLE) or "/nowhere").exists()


JUDGES = (
    Judge("python", 1, Python),
    Judge("access", 1, Access),
    Judge("javascript", 3, JavaScript, has_quantities=True),
    Judge("framers", 4, Framers),
    Judge("explainer", 1, lambda layout, folder, number: Explainer(layout, folder)),
    Judge("script", 3, ScriptExplainer),
    Judge("captures", 2, Captures),
    Judge("meanings", 2, Meanings),
    Judge("tcc", 1, lambda layout, folder, number: C(layout, folder, ["tcc", "-std=c99", "-w"]), True, True),
    Judge("command", 5, Command),
    Judge("tables", 1, lambda layout, folder, number: Tables(layout)),
    Judge("simulator", 4, lambda layout, folder, number: Simulator(layout)),
    Judge("selftest", 25, Selftest),
    Judge("sanitized", 20, lambda layout, folder, number: C(layout, folder, SANITIZED), True, True),
    Judge("structured_text", 8, lambda layout, folder, number: StructuredText(layout, folder)),
    *([Judge("matiec", 60, lambda layout, folder, number: StructuredText(layout, folder, True))] * has_matiec()),
    Judge("duckdb", 6, lambda layout, folder, number: Queries(layout, "duckdb")),
    Judge("polars", 6, lambda layout, folder, number: Queries(layout, "polars")),
    *([Judge("wireshark", 30, lambda layout, folder, number: Wireshark(layout))] * has_tshark()),
    Judge("big_endian", 50, lambda layout, folder, number: C(layout, folder, BIG_ENDIAN, ("qemu-m68k",)), True, True),
)
"""All judges. A codec in another language is added here, and nowhere else."""

_NUMBERS = iter(range(1 << 60))


@dataclass
class Comparison:
    """The result for one device: its findings where it has some, else the disagreements with the reference."""

    findings: tuple[str, ...] = ()
    disagreements: list[str] = field(default_factory=list)
    frames: int = 0
    asked: dict[str, int] = field(default_factory=dict)


def compare(spec: Spec, seed: int, frames: int, judges: tuple[Judge, ...] = JUDGES) -> Comparison:
    """Checks a device; where it has no findings, asks all judges the same questions."""
    project = read({"chance/device.yaml": text_of(spec).encode()})
    findings = list(project.findings)
    if not has_errors(findings):
        device = project.devices["chance"]
        findings += outcome(device).findings
    if has_errors(findings):
        return Comparison(tuple(finding.code for finding in findings))
    result = Comparison()
    layouts = [device_layout(device.at(version)[0]) for version in device.versions()]
    for layout in layouts:
        compare_layout(layout, seed, frames, judges, result)
    asked = queries(layouts[-1], seed, 12)
    if seed % 4 == 0:
        result.asked["forms"] = 1
        result.disagreements += forms_agree(spec, layouts, random.Random(seed))
    if seed % 4 == 1:
        result.disagreements += examples_are_proven(spec, layouts, asked)
    if seed % 4 == 2:
        reference = Reference(layouts[-1])
        expected = [reference.answer(query) for query in asked]
        result.disagreements += identities_agree(spec, layouts[-1], asked, expected, random.Random(seed))
    return result


def layouts_of(text: str) -> list[DeviceLayout]:
    """The layouts of all versions of a device that has no errors."""
    device = read({"chance/device.yaml": text.encode()}).devices["chance"]
    return [device_layout(device.at(version)[0]) for version in device.versions()]


def compare_layout(layout: DeviceLayout, seed: int, frames: int, judges: tuple[Judge, ...], result: Comparison) -> None:
    """Asks all judges about one layout."""
    asked = queries(layout, seed, frames)
    reference = Reference(layout)
    expected = [reference.answer(query) for query in asked]
    measured = [*quantity_queries(layout, random.Random(seed)), *state_queries(layout, random.Random(seed))]
    quantities = [expected_answer(query) for query in measured]
    result.frames += sum(query.kind == "frame" for query in asked)
    with tempfile.TemporaryDirectory(prefix="fieldspec-chance-") as folder:
        for judge in judges:
            if seed % judge.every != 1 % judge.every:
                continue
            result.asked[judge.name] = result.asked.get(judge.name, 0) + 1
            own = [*asked, *measured] if judge.has_quantities else asked
            try:
                answers = judge.build(layout, Path(folder), next(_NUMBERS)).answers(own)
            except Exception as error:
                result.disagreements.append(f"{judge.name}: {type(error).__name__}: {str(error)[-1500:]}")
                continue
            result.disagreements += _disagreements(layout, judge, own, [*expected, *quantities], answers)


def _disagreements(
    layout: DeviceLayout, judge: Judge, asked: list[Query], expected: list[Answer], answers: list[Answer]
) -> list[str]:
    disagreements = []
    for query, wanted, answer in zip(asked, expected[: len(asked)], answers, strict=True):
        if answer.reason is None:
            continue
        reasons = (answer.reason or "").split()
        if judge.name == "explainer" and wanted.reason and wanted.reason in reasons:
            continue
        if judge.name == "explainer" and "wrong_length" in reasons and _may_move(layout, query, wanted):
            continue
        if judge.name == "javascript" and query.values is not None and _has_no_constant(wanted, answer):
            continue
        if not wanted.is_stable and judge.drops_bits:
            answer.again = None
        differences = wanted.differences(answer)
        if differences:
            about = query.data.hex(" ") if query.values is None else repr(query.values)
            disagreements.append(
                f"{judge.name}: {query.kind} {' '.join(query.path)}: {'; '.join(differences)} for {about}"
            )
    return disagreements


def _may_move(layout: DeviceLayout, query: Query, wanted: Answer) -> bool:
    """Whether codecs read a trailer at the end of a frame, which the explainer has where the data ends.

    Where a frame has a wrong length, only codecs take other bytes for the digits of a trailer, or for a checksum after
    escaped bytes.
    """
    if query.kind != "frame":
        return False
    link, direction, _ = query.path
    shape = layout.links[link].frame(direction)
    if wanted.reason == "wrong_checksum":
        return shape.escape is not None and bool(shape.escape.last)
    return wanted.reason == "unknown_value" and any(part.form for part in shape.trailer)


def _has_no_constant(wanted: Answer, answer: Answer) -> bool:
    """Whether a constant that a selector has chosen is wrong: objects of JavaScript do not have it."""
    return wanted.reason == "wrong_const" and not answer.reason


__all__ = ["JUDGES", "Comparison", "Judge", "compare"]
