"""The explanations of the generated JavaScript are those of `fieldspec decode`: frames, damaged ones, and logs."""

from __future__ import annotations

import io
import random
import re
import subprocess
from argparse import Namespace
from collections.abc import Iterator, Sequence
from itertools import islice
from pathlib import Path
from typing import Any

import pytest

from compiler_modules import PACKAGE
from external_tools import require_tool
from fieldspec.codec.explain import sentences
from fieldspec.codec.explain.readings import ChosenReading, FrameOptions
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.frames.frame_hints import FrameHints, HintedReading, ReadFrame
from fieldspec.command.rendering.explanation_text import as_data
from fieldspec.command.verbs.decode import FramePrinter, Log
from fieldspec.language.model.texts import Example
from fieldspec.targets.explainer import RUNTIME, SHARED, module_text
from fieldspec.targets.explainer.device import explainer_data
from js_output.explanations import explained_by_node, explained_by_python, portable
from js_output.javascript import module_path
from js_output.test_javascript_frames import frames_of
from layouts import SPECS, TEST_SPECS, all_layouts, layouts, newest
from test_cli_spelled import LADDER_CHARACTERS, REQUESTS, RESPONSES, SPELLINGS

LAYOUTS = {f"{layout.device.id}-{layout.device.version}": layout for layout in all_layouts() if layout.links}
NEWEST = [versions[-1] for root in (SPECS, TEST_SPECS) for versions in layouts(root).values()]
DAMAGED = 3
"""The damaged frames of each example, of the newest versions."""
UNKNOWN = 5
"""One in so many examples, and its damaged frames, are also explained without anything known of them."""


def jobs_of(layout: DeviceLayout, example: Example) -> Iterator[dict[str, Any]]:
    module = module_path(layout).replace(".js", "_explain.js")
    asked = layout.device.examples.get(example.reply_to)
    request = asked.frame.hex() if asked is not None and not asked.refused else ""
    known = {"link": example.link, "direction": example.direction, "message": example.message}
    if layout.links[example.link].frame(example.direction).role("code") is not None or not example.message:
        del known["message"]
    if example.message and example.message not in layout.links[example.link].messages:
        known.pop("message", None)
    damaged = DAMAGED if layout in NEWEST else 0
    for frame in islice(frames_of(layout, example), 1 + damaged):
        answers = request if example.direction == "response" else ""
        yield {"module": module, "frame": frame.hex(), "options": known, "request": answers}
        if damaged and len(example.id) % UNKNOWN == 0:
            yield {"module": module, "frame": frame.hex(), "options": {}, "request": ""}


@pytest.mark.proof(4)
@pytest.mark.parametrize("name", LAYOUTS)
def test_frames_are_explained_as_by_the_command_line(name: str) -> None:
    layout = LAYOUTS[name]
    jobs = [job for example in layout.device.examples.values() for job in jobs_of(layout, example)]
    results = explained_by_node(jobs)
    for job, (have,) in zip(jobs, results, strict=True):
        assert have == explained_by_python(layout, job), job


def test_exception_responses_that_do_not_say_what_they_answer_are_explained_as_by_the_command_line() -> None:
    named = (
        ("scanner", "3E4646303246460D", "read_state", "3A313046300D0A"),
        ("servo2", "FFFFFD000104005504BA8C", "read", ""),
    )
    jobs = [
        {"module": module_path(newest(TEST_SPECS, device)).replace(".js", "_explain.js"), **job}
        for device, frame, message, request in named
        for job in (
            {"frame": frame, "options": {}, "request": ""},
            {"frame": frame, "options": {"message": message}, "request": ""},
            {"frame": frame, "options": {}, "request": request},
        )
    ]
    for job, (have,) in zip(jobs, explained_by_node(jobs), strict=True):
        layout = newest(TEST_SPECS, "scanner" if "scanner" in job["module"] else "servo2")
        assert have == explained_by_python(layout, job), job


def test_frames_of_a_link_that_only_the_device_uses_are_explained_as_by_the_command_line() -> None:
    layout = newest(TEST_SPECS, "pedal")
    module = module_path(layout).replace(".js", "_explain.js")
    options: list[dict[str, str]] = [{}, {"link": "position"}, {"link": "position", "direction": "request"}]
    jobs = [
        {"module": module, "frame": frame, "options": known, "request": ""}
        for known in options
        for frame in ("0000012005000000 1A03E803".replace(" ", ""), "0000012105000000" + "1A03E80301")
    ]
    for job, (have,) in zip(jobs, explained_by_node(jobs), strict=True):
        assert have == explained_by_python(layout, job), job


class NoHints(FrameHints):
    """Says nothing: hints are read with other versions, which a page does not have."""

    def readings(self, frame: bytes, read_frame: ReadFrame) -> list[HintedReading]:
        """The reading of the bytes alone."""
        return [HintedReading(*read_frame(frame), ())]


class CollectingPrinter(FramePrinter):
    """Collects the explanations of a log instead of printing them."""

    def __init__(self, layout: DeviceLayout) -> None:
        super().__init__(layout, "json")
        self.results: list[dict[str, Any]] = []

    def explain(self, reading: ChosenReading, remarks: Sequence[str], number: int = 0) -> None:
        data = as_data(self.layout, reading.explanation, reading.readings, reading.chosen, remarks, reading.wrong)
        self.results.append({"line": number, **portable(data)})


def log_read_by_python(layout: DeviceLayout, log: str, capsys: pytest.CaptureFixture[str]) -> list[dict[str, Any]]:
    printer = CollectingPrinter(layout)
    options = FrameOptions()
    hints = NoHints(layout, options, Namespace())
    Log(layout, options, None, printer, hints, strict=False).explain(io.BytesIO(log.encode("utf-8")))
    faults = re.findall(r"^fieldspec: line (\d+): (.*)$", capsys.readouterr().err, re.MULTILINE)
    results = [*printer.results, *({"line": int(number), "error": text} for number, text in faults)]
    return sorted(results, key=lambda result: result["line"])


CHARACTERS = [
    r":010310000002EA\r\n",
    ":010310000002EA",
    ":010310000002EA\\r",
    ":010310000002EA<CR><LF>",
    ":010310000002EA[CR][LF]",
    r":010310000002EA\x0D\x0A",
    ": 01 03 10 00 00 02 EA CR LF",
    r"[12:00:01] > :010310000002EA\r\n  # a comment",
    r"':010310000002EA\r\n'",
    *(text for text, _, _ in LADDER_CHARACTERS),
    "RX:",
    "> 2026/01/31 12:00:01.000123  length=8 from=0 to=7",
    "605#4041600000000000",
    "(1436509052.249713) vcan0 605#4041600000000000 R",
    "  can0  605   [8]  40 41 60 00 00 00 00 00",
    "can0 18FEE521#1400000007000000",
    "can0 605 [3] 40 41",
    "605#R",
    "hello",
    "01 06 ?? 1E",
    "0106201",
    "01 " * 3000,
]
PIECES = [
    *("01", "03", "10", "0x06", "20h", "00 02", "C0CB", "010310000002C0CB", ":", "TX", "RX:", ">", "<-", "[", "]", "<"),
    *(
        "'",
        "(",
        ")",
        "\t",
        ",",
        "|",
        "#",
        "//",
        "12:00:01.5",
        "2026-01-31",
        "0000",
        "CR",
        "\\r\\n",
        "<LF>",
        "hello",
        "x",
    ),
    *("@10RD", "0010000157", "*", "%", "\\r"),
    *("x", "?", "é", "\x00", "send [8]", "00000010: ", "1.25", ";"),
]


def random_lines(count: int) -> Iterator[str]:
    chance = random.Random(17)
    for _ in range(count):
        yield chance.choice(("", " ")).join(chance.choices(PIECES, k=chance.randrange(1, 9))).replace("\n", " ")


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", ["widget-2.0", "glider-x-1.1", "axis-1", "ladder-1", "gateway-1"])
def test_logs_are_read_as_by_the_command_line(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    layout = LAYOUTS[name]
    frames = [example.frame.hex(" ") for example in layout.device.examples.values()]
    lines = [*SPELLINGS, *REQUESTS, *RESPONSES, *CHARACTERS, *random_lines(400), *frames]
    lines += random.Random(3).choices(frames, k=60)
    ends = ("\n", "\r\n")
    log = "".join(line.strip("\r\n") + ends[number % 2] for number, line in enumerate(lines))
    job = {"module": module_path(layout).replace(".js", "_explain.js"), "log": log, "options": {}}
    (have,) = explained_by_node([job])
    want = log_read_by_python(layout, log, capsys)
    for result, expected in zip(have, want, strict=True):
        assert result == expected, lines[expected["line"] - 1]


@pytest.mark.parametrize(
    ("options", "why"),
    [
        ({"link": "no_link"}, "no_link is not a link of widget: rtu"),
        ({"direction": "sideways"}, "sideways is not a direction of"),
        ({"message": "no_message"}, "no_message is not sent on"),
    ],
)
def test_options_that_a_device_does_not_have_are_refused(options: dict[str, str], why: str) -> None:
    module = module_path(LAYOUTS["widget-2.0"]).replace(".js", "_explain.js")
    ((result,),) = explained_by_node([{"module": module, "text": "01", "options": options}])
    assert result["error"].startswith(why)


def test_both_explainers_use_every_sentence() -> None:
    names = {name for name in vars(sentences) if name.isupper()}
    used_within = {".py": {"SINGLE_BYTE", "BYTES", "BYTE_MISSING", "BYTES_MISSING"}, ".js": set()}
    modules = [file for folder in ("codec/explain", "command/verbs") for file in (PACKAGE / folder).rglob("*.py")]
    all_texts = {".py": "".join(file.read_text("utf-8") for file in modules), ".js": "".join(map(module_text, RUNTIME))}
    for suffix, texts in all_texts.items():
        assert set(re.findall(r"(?:sentences|SENTENCES)\.([A-Z_]+)\b", texts)) | used_within[suffix] == names


ENCODE = """
import {{ ExplainedDevice }} from "./explain/device.js";
import {{ encodeFrame }} from "./explain/encoding.js";
import {{ explained }} from "./explain/explanation.js";
const device = new ExplainedDevice({data});
for (const {{ link, direction, message, frame }} of device.data.examples) {{
  const bytes = Uint8Array.from(frame.match(/../g), (digits) => parseInt(digits, 16));
  const values = new Map(explained(device, link, direction, bytes, message).values.entries());
  console.log(Buffer.from(encodeFrame(device, {{ link, direction, message }}, values)).toString("hex"));
}}
"""


def test_the_lab_builds_frames_of_which_bits_say_that_a_field_is_not_sent(tmp_path: Path) -> None:
    layout = newest(TEST_SPECS, "armband")
    for folder, modules in (("", SHARED), ("explain", RUNTIME)):
        (tmp_path / folder).mkdir(exist_ok=True)
        for name in modules:
            (tmp_path / folder / f"{name}.js").write_text(module_text(name), "utf-8")
    (tmp_path / "package.json").write_text('{"type": "module"}')
    (tmp_path / "encode.mjs").write_text(ENCODE.format(data=explainer_data(layout)), "utf-8")
    command = [require_tool("node"), "encode.mjs"]
    run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert run.stdout.split() == [example.frame.hex() for example in layout.device.examples.values()], run.stderr
