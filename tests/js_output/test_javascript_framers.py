"""The framers of the generated JavaScript return the frames that those of the generated Python return."""

from __future__ import annotations

import json
import random
import subprocess
from pathlib import Path
from typing import Any

import pytest

from external_tools import require_tool
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.targets.js.backend import shared
from javascript_modules import module_code
from js_output.javascript import module_path
from layouts import all_layouts
from python_package import link_of, module_of, write
from streams import frames_of as link_frames
from streams import linker, linker_module, pieces_of

STREAMS_OF_EACH = 12
LAYOUTS = {f"{layout.device.id}-{layout.device.version}": layout for layout in all_layouts()}
DIRECTIONS = ("request", "response")

SCRIPT = """
import { readFileSync } from "node:fs";
const jobs = JSON.parse(readFileSync(process.argv[2], "utf8"));
const results = [];
for (const { module, framer, pieces } of jobs) {
  const make = (await import(module))[framer];
  if (make === undefined) { results.push(null); continue; }
  const instance = make();
  const frames = pieces.flatMap((piece) => instance.feed(new Uint8Array(Buffer.from(piece, "hex"))));
  frames.push(...instance.idle());
  results.push({ frames: frames.map((frame) => Buffer.from(frame).toString("hex")), dropped: instance.dropped });
}
console.log(JSON.stringify(results));
"""


def stream(layout: DeviceLayout, link: str, direction: str, chance: random.Random) -> list[bytes]:
    """Frames of a link with garbage between them, some of them damaged, in pieces of any size."""
    examples = [
        example.frame
        for example in layout.device.examples.values()
        if example.link == link and example.direction == direction and not example.refused
    ]
    data = bytearray()
    for _ in range(chance.randrange(1, 8)):
        if examples and chance.random() < 0.7:
            frame = bytearray(chance.choice(examples))
            if chance.random() < 0.2:
                frame[chance.randrange(len(frame))] ^= 1 << chance.randrange(8)
            data += frame
        else:
            data += chance.randbytes(chance.randrange(12))
    pieces = []
    while data:
        size = chance.randrange(1, len(data) + 1)
        pieces.append(bytes(data[:size]))
        del data[:size]
    return pieces


def camel(name: str) -> str:
    first, *rest = name.split("_")
    return first + "".join(word.capitalize() for word in rest)


@pytest.mark.parametrize("name", ["digits_of", "frames", "wrong_size"])
def test_a_link_may_have_the_name_of_a_helper_that_its_module_imports(name: str, tmp_path: Path) -> None:
    write(tmp_path, {**shared(), "device/module.js": module_code(linker(name))})
    command = [require_tool("node"), str(tmp_path / "device" / "module.js")]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.stderr == ""


def test_streams_are_cut_as_in_python_where_no_length_determines_the_end(tmp_path: Path) -> None:
    layout, module = linker(), linker_module()
    write(tmp_path, {**shared(), "device/module.js": module_code(layout)})
    jobs, expected = [], []
    for link in layout.links:
        for direction in DIRECTIONS:
            chance = random.Random(f"{link} {direction}")
            frames = link_frames(layout, link, direction, chance)
            for _ in range(STREAMS_OF_EACH):
                few = [damaged(frame, chance) for frame in chance.sample(frames, 6)]
                pieces = pieces_of(few, 3, chance)
                framer = getattr(getattr(module, link), f"{direction}_framer")()
                received = [frame for piece in pieces for frame in framer.feed(piece)] + framer.idle()
                expected.append({"frames": [frame.hex() for frame in received], "dropped": framer.dropped})
                names = f"{camel(link)}{direction.capitalize()}Framer"
                texts = [piece.hex() for piece in pieces]
                jobs.append({"module": (tmp_path / "device/module.js").as_uri(), "framer": names, "pieces": texts})
    assert cut(jobs, tmp_path) == expected


def damaged(frame: bytes, chance: random.Random) -> bytes:
    """A frame, now and then with an inverted bit."""
    changed = bytearray(frame)
    if chance.random() < 0.3:
        changed[chance.randrange(len(changed))] ^= 1 << chance.randrange(8)
    return bytes(changed)


def cut(jobs: list[dict[str, Any]], folder: Path) -> list[dict[str, Any]]:
    """What the framers of generated JavaScript return."""
    (folder / "jobs.json").write_text(json.dumps(jobs), "utf-8")
    (folder / "streams.mjs").write_text(SCRIPT, "utf-8")
    command = [require_tool("node"), str(folder / "streams.mjs"), str(folder / "jobs.json")]
    results: list[dict[str, Any]] = json.loads(
        subprocess.run(command, capture_output=True, text=True, check=True).stdout
    )
    return results


@pytest.mark.proof(8)
@pytest.mark.parametrize("name", LAYOUTS)
def test_streams_are_cut_as_in_python(name: str, tmp_path: Path) -> None:
    layout = LAYOUTS[name]
    chance = random.Random(name)
    jobs, expected = [], []
    for link in layout.links:
        for direction in DIRECTIONS:
            spoken = getattr(module_of(layout), link, None) and link_of(module_of(layout), link)
            make = getattr(spoken, f"{direction}_framer", None)
            if make is None:
                continue
            for _ in range(STREAMS_OF_EACH):
                pieces = stream(layout, link, direction, chance)
                framer = make()
                frames = [frame for piece in pieces for frame in framer.feed(piece)] + framer.idle()
                expected.append({"frames": [frame.hex() for frame in frames], "dropped": framer.dropped})
                module = Path(module_path(layout)).as_uri()
                names = f"{camel(link)}{direction.capitalize()}Framer"
                jobs.append({"module": module, "framer": names, "pieces": [piece.hex() for piece in pieces]})
    for job, have, want in zip(jobs, cut(jobs, tmp_path), expected, strict=True):
        assert have == want, job
