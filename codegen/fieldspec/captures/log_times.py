"""The times in lines of logs, in the forms that people and programs write."""

from __future__ import annotations

import re

DAY = 86_400 * 10**9

_CLOCK = r"(?P<hour>[01]?\d|2[0-3]):(?P<minute>[0-5]\d):(?P<second>[0-5]\d)(?:[.,:](?P<fraction>\d{1,9}))?"
_ZONE = r"(?P<zone>Z|[+-]\d\d:?\d\d)?"
_DATE = (
    r"(?:(?P<year>\d{4})[-/.](?P<month>\d{1,2})[-/.](?P<day>\d{1,2})"
    r"|(?P<day_first>\d{1,2})\.(?P<month_second>\d{1,2})\.(?P<year_last>\d{4}))"
)
_FULL = re.compile(rf"(?<![\w.]){_DATE}[T ,;]\s*{_CLOCK}\s?{_ZONE}")
_OF_DAY = re.compile(rf"(?<![\w.:]){_CLOCK}(?![\w:])")
_SECONDS = re.compile(
    r"\s*[\[(]?(?P<sign>[-+]?)(?P<whole>\d{1,10})[.](?P<part>\d{1,9})(?:\s?(?P<unit>us|ms|s))?[\])]?[,;:]?\s"
)
_DAYS_BEFORE = (0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334)


class LogClock:
    """The times of the lines of one log. A line without a date is of the day of the line before it, or the next one.

    The day of a log without dates is 1 January 1970. `last` is the time of the last line with one, None before it.
    """

    def __init__(self, last: int | None = None) -> None:
        self.last = last

    def time(self, line: str) -> int | None:
        """The time of a line in nanoseconds since 1970, in UTC where it has no zone; None where it has no time."""
        time = self._time(line[:120])
        if time is not None:
            self.last = time
        return time

    def _time(self, line: str) -> int | None:
        match = _FULL.search(line)
        if match is not None:
            day = _day(match)
            return None if day is None else day * DAY + _of_clock(match) - _zone(match["zone"])
        match = _OF_DAY.search(line)
        if match is not None:
            time = _of_clock(match)
            if self.last is not None:
                time += self.last // DAY * DAY
                if time < self.last - DAY // 2:
                    time += DAY
            return time
        match = _SECONDS.match(line)
        if match is None or match["sign"] == "-":
            return None
        unit = {"us": 1000, "ms": 10**6}.get(match["unit"] or "", 10**9)
        divisor = int("1".ljust(len(match["part"]) + 1, "0"))
        return int(match["whole"]) * unit + int(match["part"]) * unit // divisor


def _of_clock(match: re.Match[str]) -> int:
    """The nanoseconds since midnight of a time of day."""
    fraction = int((match["fraction"] or "").ljust(9, "0"))
    return (int(match["hour"]) * 3600 + int(match["minute"]) * 60 + int(match["second"])) * 10**9 + fraction


def _zone(text: str | None) -> int:
    if not text or text == "Z":
        return 0
    minutes = int(text[1:3]) * 60 + int(text[-2:])
    return (minutes if text[0] == "+" else -minutes) * 60 * 10**9


def _day(match: re.Match[str]) -> int | None:
    """The days since 1970 of a date of the Gregorian calendar; None for a date that does not exist."""
    year = int(match["year"] or match["year_last"])
    month = int(match["month"] or match["month_second"])
    day = int(match["day"] or match["day_first"])
    if not (1 <= month <= 12 and 1970 <= year < 2262):
        return None
    is_leap = year % 4 == 0 and (year % 100 != 0 or year % 400 == 0)
    length = (_DAYS_BEFORE[month] if month < 12 else 365) - _DAYS_BEFORE[month - 1] + (is_leap and month == 2)
    if not 1 <= day <= length:
        return None
    before = year - 1
    leap_days = before // 4 - before // 100 + before // 400 - 477
    return (year - 1970) * 365 + leap_days + _DAYS_BEFORE[month - 1] + (is_leap and month > 2) + day - 1
