"""The framers of generated Python and JavaScript as a judge: what comes out of random streams of frames."""

from __future__ import annotations

import json
import random
import subprocess
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import accumulate
from pathlib import Path
from typing import Any, ClassVar

from external_tools import require_tool
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference.framing import Framing
from fieldspec.foundation.names import Name
from fieldspec.targets.js.backend import shared
from javascript_modules import module_code
from python_package import link_of
from random_devices.framer_streams import Stream, streams
from random_devices.python_judge import module_of_device
from random_devices.queries import Answer, Query

SCRIPT = Path(__file__).with_name("framer_judge.mjs")


@dataclass(frozen=True)
class Cut:
    """The frames that each piece of a stream completes, and the bytes that belong to none."""

    frames: tuple[tuple[bytes, ...], ...]
    dropped: int

    @property
    def all_frames(self) -> tuple[bytes, ...]:
        """The frames in their order."""
        return tuple(frame for frames in self.frames for frame in frames)


class Framers:
    """Says nothing about queries; raises AssertionError where a framer loses, joins or splits frames.

    `cut` counts the streams of all devices by what ends their frames.
    """

    cut: ClassVar[Counter[str]] = Counter()

    def __init__(self, layout: DeviceLayout, folder: Path, number: int) -> None:
        self.layout, self.folder = layout, folder / f"framers_{number}"
        self.module = module_of_device(layout, number)
        for path, text in {**shared(), "device/module.js": module_code(layout)}.items():
            place = self.folder / path
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(text, "utf-8")

    def answers(self, queries: list[Query]) -> list[Answer]:
        """Nothing about single queries."""
        drawn = list(streams(self.layout, random.Random(len(queries))))
        for stream, other in zip(drawn, self.javascript_cuts(drawn), strict=True):
            own = self.python_cut(stream)
            text = f"{stream.link} {stream.direction} {_text(stream)}"
            assert own is not None, f"Python has no framer for {text}"
            assert other is not None, f"JavaScript has no framer for {text}"
            _assert_promised(stream, own, text)
            same = f"{_list(own.all_frames)}, {own.dropped} dropped, and {_list(other.all_frames)}, {other.dropped}"
            _assert_cut(self.layout, stream, own, text)
            assert own == other, f"Python and JavaScript differ in {text}: {same}"
        return [Answer(reason=None)] * len(queries)

    def python_cut(self, stream: Stream) -> Cut | None:
        """What Python makes of a stream; None where it has no framer."""
        make = getattr(link_of(self.module, stream.link), f"{stream.direction}_framer", None)
        if make is None:
            return None
        framer, frames = make(), []
        places = accumulate(len(piece or b"") for piece in stream.pieces)
        for piece, place in zip(stream.pieces, places, strict=True):
            if piece is None:
                paused = framer.pause()
                frames.append(framer.idle())
                assert paused == frames[-1], f"`pause` shows {_list(paused)}, not {_list(frames[-1])}: {_text(stream)}"
            else:
                frames.append(framer.feed(piece))
            end = next((end for end in stream.ends if end > place), None)
            if end is not None:
                assert framer.missing <= end - place, f"{framer.missing} missing at {place}: {_text(stream)}"
        return Cut(tuple(map(tuple, frames)), framer.dropped)

    def javascript_cuts(self, drawn: list[Stream]) -> list[Cut | None]:
        """What JavaScript makes of streams; None where it has no framer."""
        jobs: list[dict[str, Any]] = [
            {
                "framer": Name.of(stream.link).camel() + stream.direction.capitalize() + "Framer",
                "pieces": [None if piece is None else piece.hex() for piece in stream.pieces],
            }
            for stream in drawn
        ]
        (self.folder / "streams.json").write_text(json.dumps(jobs), "utf-8")
        command = [require_tool("node"), str(SCRIPT), str(self.folder / "device/module.js"), "streams.json"]
        run = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False)
        if run.returncode:
            raise RuntimeError(run.stderr)
        return [
            result and Cut(tuple(tuple(map(bytes.fromhex, own)) for own in result["frames"]), result["dropped"])
            for result in json.loads(run.stdout)
        ]


def _assert_promised(stream: Stream, cut: Cut, text: str) -> None:
    """The frames of a stream come out of it, and the noise is counted."""
    if stream.expected is None:
        return
    frames = cut.all_frames[: len(stream.expected)] if stream.goes_on else cut.all_frames
    assert frames == stream.expected, f"{_list(frames)} in place of {_list(stream.expected)} from {text}"
    assert stream.noise in (None, cut.dropped), f"{cut.dropped} bytes dropped in place of {stream.noise} from {text}"


def _assert_cut(layout: DeviceLayout, stream: Stream, cut: Cut, text: str) -> None:
    """The frames of each block of a stream, and those that the silence after it shows, are those of the reference."""
    framing = Framing(layout, stream.link, stream.direction)
    assert framing.ending, f"the reference does not know what ends the frames of {text}"
    blocks = [b""]
    completed: list[tuple[tuple[bytes, ...], tuple[bytes, ...]]] = [((), ())]
    for piece, frames in zip(stream.pieces, cut.frames, strict=True):
        before, _ = completed[-1]
        completed[-1] = ((*before, *frames), ()) if piece is not None else (before, frames)
        blocks[-1] += piece or b""
        if piece is None:
            blocks.append(b"")
            completed.append(((), ()))
    Framers.cut[framing.ending] += 1
    wanted = [(tuple(before), tuple(behind)) for before, behind in framing.cut(blocks[:-1])]
    for block, expected, actual in zip(blocks, wanted, completed[:-1], strict=False):
        expected_text, actual_text = (" and, with the silence, ".join(map(_list, own)) for own in (expected, actual))
        assert actual == expected, f"{actual_text}; the reference: {expected_text}; in {block.hex(' ')} of {text}"


def _list(frames: Iterable[bytes]) -> str:
    return ", ".join(frame.hex(" ") for frame in frames) or "nothing"


def _text(stream: Stream) -> str:
    """`12 34|56|*`: a bar after each piece, and a star for a silence."""
    return "|".join("*" if piece is None else piece.hex(" ") for piece in stream.pieces)


__all__ = ["Framers"]
