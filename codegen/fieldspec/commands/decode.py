"""`fieldspec decode`: explains a frame, or a log of frames, byte by byte."""

from __future__ import annotations

import argparse
import gc
import sys
from collections.abc import Iterator, Sequence

from fieldspec.classes import TYPE_CHECKING
from fieldspec.commands import compiled
from fieldspec.commands.frame_options import frame_options
from fieldspec.commands.output import print_blocks
from fieldspec.commands.usage import UsageError
from fieldspec.explain.log import LogLine, Unreadable, log_line
from fieldspec.explain.readings import ChosenReading, FrameOptions, OpenRequest, read, remarks
from fieldspec.layout.device import DeviceLayout
from fieldspec.render import explanation as shown
from fieldspec.render.blocks import Block, Line
from fieldspec.render.explanation import faults

if TYPE_CHECKING:
    from typing import BinaryIO


class FramePrinter:
    """Prints at once what it is given. Notes and errata that were printed once are not repeated."""

    def __init__(self, layout: DeviceLayout, form: str) -> None:
        self.layout, self.form = layout, form
        self.said: set[str] = set()
        self.first = True

    def explain(self, held: ChosenReading, remarks: Sequence[str], number: int = 0) -> None:
        """Prints one frame; `number` is that of its line in a log, 0 where there is no log."""
        if self.form == "json":
            self._json(held, remarks, number)
        else:
            self._text(held, remarks, number)
        sys.stdout.flush()

    def _json(self, held: ChosenReading, remarks: Sequence[str], number: int) -> None:
        import json

        from fieldspec.render.explanation import as_data

        data = as_data(self.layout, held.explanation, held.readings, held.chosen, remarks, held.wrong)
        if number:
            print(json.dumps({"line": number, **data}, ensure_ascii=False))
        else:
            print(json.dumps(data, ensure_ascii=False, indent=1))

    def _text(self, held: ChosenReading, remarks: Sequence[str], number: int) -> None:
        if not self.first:
            print()
        self.first = False
        print_blocks(self._blocks(held, remarks, number))

    def _blocks(self, held: ChosenReading, remarks: Sequence[str], number: int) -> Iterator[Block]:
        own = held.explanation
        where = f"line {number}: " if number else ""
        sure = all((link, direction) != (own.link, own.direction) for link, direction, _, _ in held.others)
        yield Line(where + shown.title(self.layout, own, sure), "bold")
        yield from (Line(remark, "red" if held.wrong else "yellow") for remark in remarks)
        yield shown.frame_table(self.layout, own)
        if own.registers:
            yield Line(shown.accessed(self.layout, own), "bold")
            yield shown.register_table(own)
        yield from (Line(fault, "red") for fault in shown.faults(own))
        yield from (Line(example, "dim") for example in shown.examples(self.layout, own))
        for line in shown.footnotes(self.layout, own):
            if line not in self.said:
                self.said.add(line)
                yield Line(line, "dim")


LONGEST_LINE = 8192


def run(arguments: argparse.Namespace) -> int:
    """Explains what is given, or each line of the standard input. Exit code 1 where anything is wrong."""
    layout = compiled.asked(arguments)
    if not layout.links:
        raise UsageError(f"{arguments.device} has no link, so there are no frames to decode")
    said = frame_options(layout, arguments)
    if arguments.request and "response" not in said.directions:
        raise UsageError(f"--request gives what a response answers, so --direction cannot be {arguments.direction}")
    asked = _asked(layout, said, arguments.request)
    printer = FramePrinter(layout, arguments.format)
    written = " ".join(arguments.frame)
    if written in ("", "-"):
        if sys.stdin is None:
            raise UsageError("there is no standard input to read frames from")
        if sys.stdin.isatty():
            print("reading frames from the terminal, one a line", file=sys.stderr)
        gc.enable()  # a log may be long
        return Log(layout, said, asked, printer).explain(sys.stdin.buffer)
    found = _frame(layout, written)
    held = read(layout, found.frame, said, found.direction, asked)
    printer.explain(held, [*found.remarks, *remarks(layout, held, 0, said)])
    return int(held.wrong)


def _asked(layout: DeviceLayout, said: FrameOptions, text: str | None) -> OpenRequest | None:
    """The request that the user names."""
    if text is None:
        return None
    places = tuple((link, "request") for link in layout.links if said.goes(link, "response"))
    request = read(layout, _frame(layout, text).frame, FrameOptions(places, said.message))
    if request.wrong and request.explanation.reasons != ("unknown_code",):
        why = "; ".join(faults(request.explanation))
        raise UsageError(f"--request is no good request of {layout.device.id}: {why}")
    return OpenRequest(request.explanation, True)


def _frame(layout: DeviceLayout, text: str) -> LogLine:
    try:
        found = log_line(text, [laid.link for laid in layout.links.values()])
    except Unreadable as error:
        raise UsageError(f"this is no frame: {error}") from None
    if found is None or not found.frame:
        raise UsageError("this is no frame: there are no bytes in it")
    return found


class Log:
    """Explains the frames of a log, one a line; what it keeps does not grow with the log.

    `asked` is the request, in line `asked_in`, that the next response answers. `mark` is the direction that a line
    without bytes gives to the next one.
    """

    def __init__(
        self, layout: DeviceLayout, said: FrameOptions, asked: OpenRequest | None, printer: FramePrinter
    ) -> None:
        self.layout, self.said, self.printer = layout, said, printer
        self.links = [laid.link for laid in layout.links.values()]
        self.asked, self.asked_in = asked, 0
        self.mark = ""
        self.wrong = False

    def explain(self, stream: BinaryIO) -> int:
        """Explains every line. What cannot be read is reported and passed over."""
        for number, line in _lines(stream):
            try:
                if len(line) >= LONGEST_LINE:
                    raise Unreadable(f"it has {LONGEST_LINE} characters or more")
                found = log_line(line, self.links)
            except Unreadable as error:
                print(f"fieldspec: line {number}: {error}", file=sys.stderr, flush=True)
                self.wrong = True
                continue
            if found is not None:
                self._line(number, found)
        return int(self.wrong)

    def _line(self, number: int, found: LogLine) -> None:
        self.mark = found.direction or self.mark
        if not found.frame:
            return
        held = read(self.layout, found.frame, self.said, self.mark, self.asked)
        self.printer.explain(held, [*found.remarks, *remarks(self.layout, held, self.asked_in, self.said)], number)
        self.wrong = self.wrong or held.wrong
        self.mark = ""
        if self.asked is None or not self.asked.sure:
            self.asked = self._request(held)
            self.asked_in = number if self.asked else 0

    def _request(self, held: ChosenReading) -> OpenRequest | None:
        """What the next response answers: the frame, where it is a request, and not for all stations."""
        request = held.explanation
        if request.direction != "request" or (held.wrong and request.reasons != ("unknown_code",)):
            return None
        link = self.layout.links[request.link]
        if held.chosen == "likeliest" and link.response.role("code") is None and link.request.role("code") is None:
            return None  # nothing says that it is a request at all
        station, stations = link.request.role("unit_address"), link.link.unit_addresses
        if station and stations and request.values.get(station.name) == stations.broadcast:
            return None
        return OpenRequest(request, False)


def _lines(stream: BinaryIO) -> Iterator[tuple[int, str]]:
    """The lines of a log with their numbers from 1. Long ones are cut; UTF-16, as Windows shells write it, is taken."""
    number = 0
    while line := stream.readline(LONGEST_LINE):
        number += 1
        rest = line
        while len(rest) == LONGEST_LINE and not rest.endswith(b"\n"):
            rest = stream.readline(LONGEST_LINE)
        if number == 1:
            for mark in (b"\xef\xbb\xbf", b"\xff\xfe", b"\xfe\xff"):
                line = line.removeprefix(mark)
        yield number, line.replace(b"\0", b"").decode("utf-8", "replace")
