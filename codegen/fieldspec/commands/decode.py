"""`fieldspec decode`: explains a frame, or a log of frames, byte by byte."""

from __future__ import annotations

import argparse
import gc
import sys
from collections.abc import Iterator

from fieldspec.classes import TYPE_CHECKING
from fieldspec.commands import compiled
from fieldspec.commands.frame_printer import FramePrinter
from fieldspec.commands.given import Given, given
from fieldspec.commands.logged import Logged, logged
from fieldspec.commands.readings import Asked, Read, read
from fieldspec.commands.remarks import remarks
from fieldspec.commands.spelled import Unreadable
from fieldspec.commands.usage import UsageError
from fieldspec.layout.device import DeviceLayout
from fieldspec.render.explanation import faults

if TYPE_CHECKING:
    from typing import BinaryIO

LONGEST_LINE = 8192


def run(arguments: argparse.Namespace) -> int:
    """Explains what is given, or each line of the standard input. Exit code 1 where anything is wrong."""
    layout = compiled.asked(arguments)
    said = given(layout, arguments)
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


def _asked(layout: DeviceLayout, said: Given, text: str | None) -> Asked | None:
    """The request that the user names."""
    if text is None:
        return None
    places = tuple((link, "request") for link in layout.links if said.goes(link, "response"))
    request = read(layout, _frame(layout, text).frame, Given(places, said.message))
    if request.wrong and request.explanation.reasons != ("unknown_code",):
        why = "; ".join(faults(request.explanation))
        raise UsageError(f"--request is no good request of {layout.device.id}: {why}")
    return Asked(request.explanation, True)


def _frame(layout: DeviceLayout, text: str) -> Logged:
    try:
        found = logged(text, [laid.link for laid in layout.links.values()])
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

    def __init__(self, layout: DeviceLayout, said: Given, asked: Asked | None, printer: FramePrinter) -> None:
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
                found = logged(line, self.links)
            except Unreadable as error:
                print(f"fieldspec: line {number}: {error}", file=sys.stderr, flush=True)
                self.wrong = True
                continue
            if found is not None:
                self._line(number, found)
        return int(self.wrong)

    def _line(self, number: int, found: Logged) -> None:
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

    def _request(self, held: Read) -> Asked | None:
        """What the next response answers: the frame, where it is a request, and not for all stations."""
        request = held.explanation
        if request.direction != "request" or (held.wrong and request.reasons != ("unknown_code",)):
            return None
        link = self.layout.links[request.link]
        if held.chosen == "likeliest" and link.response.role("code") is None and link.request.role("code") is None:
            return None  # nothing says that it is a request at all
        station, stations = link.request.role("station"), link.link.stations
        if station and stations and request.values.get(station.name) == stations.broadcast:
            return None
        return Asked(request, False)


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
