"""Explanations of frames by the generated JavaScript in Node, and by the functions of `fieldspec decode`."""

from __future__ import annotations

import json
import re
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from external_tools import require_tool
from fieldspec.codec.explain.lines import LogLine
from fieldspec.codec.explain.readings import FrameOptions, OpenRequest, read_frame, remarks_on
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.rendering.explanation_text import as_data

SCRIPT = Path(__file__).with_name("explanations.mjs")
DIRECTIONS = ("request", "response")


def explained_by_node(jobs: Sequence[Mapping[str, Any]]) -> list[list[dict[str, Any]]]:
    """The explanations of each job: `module` is the path of an explainer, `frame`, `text` or `log` what it explains."""
    node = require_tool("node")
    with tempfile.NamedTemporaryFile("w", suffix=".jsonl", encoding="utf-8") as file:
        file.writelines(json.dumps(job) + "\n" for job in jobs)
        file.flush()
        run = subprocess.run([node, str(SCRIPT), file.name], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return [json.loads(line, object_hook=_whole, parse_int=_number) for line in run.stdout.split("\n") if line]


def _number(digits: str) -> int | float:
    """A number as JavaScript has it: a float where it is beyond the whole numbers that a float can count."""
    number = int(digits)
    return number if abs(number) <= 1 << 53 else float(digits)


def _whole(data: dict[str, Any]) -> Any:
    return int(data["$n"]) if list(data) == ["$n"] else data


def portable(data: object) -> Any:
    """Data of the compiler as JSON has them. Remarks name options, which have hyphens on the command line alone."""
    result = json.loads(json.dumps(data))
    if isinstance(result, dict) and "remarks" in result:
        result["remarks"] = [re.sub(r"--(?=[a-z])", "", remark) for remark in result["remarks"]]
    return result


def explained_by_python(layout: DeviceLayout, job: Mapping[str, Any]) -> dict[str, Any]:
    """The explanation of the frame of a job, as `fieldspec decode --format json` prints it."""
    known = job["options"]
    places = tuple(
        (name, direction)
        for name, link in layout.links.items()
        for direction in DIRECTIONS
        if known.get("link", name) == name and known.get("direction", direction) == direction
        if not known.get("message") or known["message"] in link.messages
    )
    options = FrameOptions(places if known else (), known.get("message", ""))
    asked = None
    if job["request"]:
        asks = tuple((link, "request") for link in layout.links if options.goes(link, "response"))
        request = read_frame(layout, bytes.fromhex(job["request"]), FrameOptions(asks, options.message))
        if request.wrong and request.explanation.reasons != ("unknown_code",):
            reasons = ", ".join(request.explanation.reasons)
            return {"error": f"request is not a valid request of {layout.device.id}: {reasons}"}
        asked = OpenRequest(request.explanation, True)
    line = LogLine(bytes.fromhex(job["frame"]))
    reading = read_frame(layout, line.frame, options, line.direction, asked)
    notes = [*line.remarks, *remarks_on(layout, reading, 0, options)]
    data = as_data(layout, reading.explanation, reading.readings, reading.chosen, notes, reading.wrong)
    result: dict[str, Any] = portable(data)
    return result
