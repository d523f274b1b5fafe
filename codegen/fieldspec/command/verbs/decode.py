"""`fieldspec decode`: explains a frame, or a log of frames, byte by byte."""

from __future__ import annotations

import argparse
import gc
import os
import shlex
import sys
from collections.abc import Iterator, Sequence

from fieldspec.codec.explain import sentences
from fieldspec.codec.explain.explanation import Explanation
from fieldspec.codec.explain.lines import LogLine, Unreadable, is_hex_word, log_line
from fieldspec.codec.explain.open_requests import OpenRequests
from fieldspec.codec.explain.readings import ChosenReading, FrameOptions, OpenRequest, read_frame, remarks_on
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.console.streams import print_error, print_json, print_line, print_note
from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.console.usage import UsageError
from fieldspec.command.frames.frame_hints import FrameHints, HintedReading
from fieldspec.command.frames.frame_options import frame_options
from fieldspec.command.rendering import explanation_text as texts
from fieldspec.command.rendering.blocks import Block, Line
from fieldspec.command.rendering.explanation_text import faults
from fieldspec.command.sources import layout_cache
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass

if TYPE_CHECKING:
    from typing import BinaryIO


class FramePrinter:
    """Prints explanations of frames at once. Notes and errata are printed only the first time.

    With `all_errata`, errata about other links and about the message or the link as a whole are printed too.
    """

    def __init__(self, layout: DeviceLayout, form: str, all_errata: bool = False) -> None:
        self.layout, self.form, self.all_errata = layout, form, all_errata
        self.said: set[str] = set()
        self.first = True
        self._known: ByIdentity[Explanation, _Body] = ByIdentity(_MOST_KNOWN)

    def explain(self, reading: ChosenReading, remarks: Sequence[str], number: int = 0) -> None:
        """Prints one frame; `number` is that of its line in a log, 0 where there is no log."""
        if self.form == "json":
            self._json(reading, remarks, number)
        else:
            self._print_text(reading, remarks, number)
        sys.stdout.flush()

    def _json(self, reading: ChosenReading, remarks: Sequence[str], number: int) -> None:

        from fieldspec.command.rendering.explanation_text import as_data

        data = as_data(self.layout, reading.explanation, reading.readings, reading.chosen, remarks, reading.wrong)
        if number:
            print_json({"line": number, **data})
        else:
            print_json(data, indent=1)

    def _print_text(self, reading: ChosenReading, remarks: Sequence[str], number: int) -> None:
        if not self.first:
            print_line("")
        self.first = False
        print_blocks(self._blocks(reading, remarks, number))

    def _blocks(self, reading: ChosenReading, remarks: Sequence[str], number: int) -> Iterator[Block]:
        yield from texts.head_blocks(self.layout, reading, remarks, f"line {number}: " if number else "")
        body = self._known.get_or_compute(reading.explanation, self._body)
        yield from body.blocks
        for line in body.footnotes:
            if line not in self.said:
                self.said.add(line)
                yield Line(line, "dim")

    def _body(self, explanation: Explanation) -> _Body:
        return _Body(
            tuple(texts.body_blocks(self.layout, explanation)),
            tuple(texts.footnotes(self.layout, explanation, self.all_errata)),
        )


@dataclass(frozen=True, slots=True)
class _Body:
    """The part of an explanation below its remarks."""

    blocks: tuple[Block, ...]
    footnotes: tuple[str, ...]


_MOST_KNOWN = 512
"""The newest explanations whose texts are kept: logs repeat their requests, and many of the answers."""

_LONGEST_KNOWN = 300

LONGEST_LINE = 8192


def run(arguments: argparse.Namespace) -> int:
    """Explains a frame, or each line of standard input. Exit code 1 where anything is wrong. Raises UsageError."""
    if arguments.to:
        if arguments.strict:
            raise UsageError("--strict goes without --to: the tables have each doubtful value as out_of_range")
        from fieldspec.command.bulk import bulk_decoding

        return bulk_decoding.run(arguments)
    for option in ("out", "port", "units", "part_frames"):
        if getattr(arguments, option) is not None:
            raise UsageError(f"--{option.replace('_', '-')} goes with --to, which decodes captures and logs in bulk")
    try:
        layout = layout_cache.requested_layout(arguments)
    except UsageError as error:
        if is_hex_word(arguments.device) and any(map(str.isspace, arguments.device)):
            raise UsageError(
                f"name the device before the frame: fieldspec decode DEVICE '{arguments.device}'"
            ) from error
        raise
    if not layout.links:
        raise UsageError(f"{arguments.device} has no link, so there are no frames to decode")
    options = frame_options(layout, arguments)
    if arguments.request and "response" not in options.directions:
        raise UsageError(f"--request is for responses, so --direction cannot be {arguments.direction}")
    open_request = _parse_request(layout, options, arguments.request)
    printer = FramePrinter(layout, arguments.format, arguments.errata)
    hints = FrameHints(layout, options, arguments)
    text = " ".join(arguments.frame)
    if arguments.frame and not text.strip():
        raise UsageError("this is not a frame: it has no bytes; leave it out to read lines of standard input")
    if text in ("", "-"):
        if sys.stdin is None:
            raise UsageError("there is no standard input to read frames from")
        if sys.stdin.isatty():
            print_note("reading frames from the terminal, one on each line")
        gc.enable()  # a log may be long
        return Log(layout, options, open_request, printer, hints, arguments.strict).explain(sys.stdin.buffer)
    line = _frame(layout, text, arguments.device)

    def reading(frame: bytes) -> tuple[ChosenReading, int]:
        return read_frame(layout, frame, options, line.direction, open_request), 0

    hinted_readings = hints.readings(line.frame, reading)
    for hinted in hinted_readings:
        frame_remarks = remarks_on(layout, hinted.reading, 0, options)
        printer.explain(hinted.reading, [*line.remarks, *frame_remarks, *hinted.hints])
    return int(_fail(hinted_readings, arguments.strict))


def _fail(hinted_readings: Sequence[HintedReading], strict: bool) -> bool:
    """Whether the exit code is 1: the bytes are not a valid frame or, with `--strict`, have a doubtful value."""
    return any(
        hinted.hints or hinted.reading.wrong or (strict and any(faults(hinted.reading.explanation)))
        for hinted in hinted_readings
    )


def _parse_request(layout: DeviceLayout, options: FrameOptions, text: str | None) -> OpenRequest | None:
    """The request in `--request`. Raises UsageError where it is wrong."""
    if text is None:
        return None
    places = tuple((link, "request") for link in layout.links if options.goes(link, "response"))
    request = read_frame(layout, _frame(layout, text, "").frame, FrameOptions(places, options.message))
    if request.wrong and request.explanation.reasons != ("unknown_code",):
        faults_text = "; ".join(faults(request.explanation))
        raise UsageError(f"--request is not a valid request of {layout.device.id}: {faults_text}")
    return OpenRequest(request.explanation, True)


def _frame(layout: DeviceLayout, text: str, device: str) -> LogLine:
    """The frame in a text that the user wrote. With the name of a `device`, it may be a path by mistake."""
    try:
        line = log_line(text, [link.link for link in layout.links.values()])
    except Unreadable as error:
        hint = "; write its bytes in hexadecimal, such as 01 03 10 00"
        if device and os.path.exists(text):
            hint = _path_hint(text, device)
        elif os.path.splitext(text)[1] and " " not in text:
            hint = f"; if it is a path, there is no file {text}"
        raise UsageError(f"this is not a frame: {error}{hint}") from None
    if line is None or not line.frame:
        raise UsageError("this is not a frame: it has no bytes")
    return line


def _path_hint(path: str, device: str) -> str:
    """How to decode what is at a path: each line of a log, a capture or a folder as tables."""
    command = f"fieldspec decode {device}"
    tables = f"{command} {shlex.quote(path)} --to parquet --out FOLDER"
    if os.path.isdir(path):
        return f"; it is a folder: decode the files in it with {tables}"
    from fieldspec.tools.captures.file_content import FileContent, is_capture

    with open(path, "rb") as file:
        content = FileContent(file)
        if is_capture(content.read(4)) or content.is_packed:
            return f"; it is {'packed' if content.is_packed else 'a capture'}: decode it with {tables}"
    return f"; it is a path: explain its lines with {command} - < {shlex.quote(path)}"


class Log:
    """Explains the frames of a log, one in each line, in constant memory.

    `mark` is the direction that a line without bytes announces for the next one.
    """

    def __init__(
        self,
        layout: DeviceLayout,
        options: FrameOptions,
        open_request: OpenRequest | None,
        printer: FramePrinter,
        hints: FrameHints,
        strict: bool,
    ) -> None:
        self.hints = hints
        self.layout, self.said, self.printer, self.strict = layout, options, printer, strict
        self.links = [link.link for link in layout.links.values()]
        self.requests = OpenRequests(layout, open_request, self._reading)
        self.mark = ""
        self.wrong = False
        self.readings: dict[object, ChosenReading] = {}

    def explain(self, stream: BinaryIO) -> int:
        """Explains every line, and reports those that it cannot read. Returns the exit code."""
        has_frames = False
        for number, line in _lines(stream):
            try:
                if len(line) >= LONGEST_LINE:
                    raise Unreadable(sentences.TOO_LONG.format(count=LONGEST_LINE))
                log_record = log_line(line, self.links)
            except Unreadable as error:
                print_error(f"line {number}: {error}")
                self.wrong = True
                continue
            if log_record is not None:
                has_frames = has_frames or bool(log_record.frame)
                self._line(number, log_record)
        if not has_frames and not self.wrong:
            print_error("standard input has no frames")
        return int(self.wrong)

    def _line(self, number: int, line: LogLine) -> None:
        self.mark = line.direction or self.mark
        if not line.frame:
            return
        hinted_readings = self.hints.readings(line.frame, self.requests.reading)
        for hinted in hinted_readings:
            frame_remarks = remarks_on(self.layout, hinted.reading, hinted.asked_in, self.said)
            self.printer.explain(hinted.reading, [*line.remarks, *frame_remarks, *hinted.hints], number)
            self.requests.remember(hinted.reading, number)
        self.wrong = self.wrong or _fail(hinted_readings, self.strict)
        self.mark = ""

    def _reading(self, frame: bytes, open_request: OpenRequest | None) -> ChosenReading:
        request = open_request.request if open_request is not None else None
        key = frame, self.mark, None if request is None else (request.link, request.message, request.frame)
        reading = self.readings.get(key)
        if reading is None:
            reading = read_frame(self.layout, frame, self.said, self.mark, open_request)
            if len(frame) <= _LONGEST_KNOWN:
                self.readings[key] = reading
            if len(self.readings) > _MOST_KNOWN:
                del self.readings[next(iter(self.readings))]
        return reading


def _refuse_packets(head: bytes) -> None:
    from fieldspec.tools.captures.file_content import MAGIC, is_capture

    if is_capture(head) or head.startswith(MAGIC):
        form = "a capture" if is_capture(head) else "packed"
        raise UsageError(f"standard input is {form}: name the file, with --to parquet --out FOLDER")


def _lines(stream: BinaryIO) -> Iterator[tuple[int, str]]:
    """The lines of a log, numbered from 1. Long lines are cut; UTF-16, which Windows shells write, is accepted."""
    number = 0
    while line := stream.readline(LONGEST_LINE):
        number += 1
        rest = line
        while len(rest) == LONGEST_LINE and not rest.endswith(b"\n"):
            rest = stream.readline(LONGEST_LINE)
        if number == 1:
            _refuse_packets(line)
            for mark in (b"\xef\xbb\xbf", b"\xff\xfe", b"\xfe\xff"):
                line = line.removeprefix(mark)
        yield number, line.replace(b"\0", b"").decode("utf-8", "replace")
