"""Files and places in them. Lines and columns are computed only when they are printed."""

from __future__ import annotations

from bisect import bisect_right

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass, field

if TYPE_CHECKING:
    from typing import Protocol

    class Spanned(Protocol):
        """An object that has a place in a file."""

        @property
        def span(self) -> Span:
            """The place in the file."""


class Refused(bytes):
    """The content of a file that was not read: the reason as text. `code` is the rule, `help` what to do."""

    code: str
    help: str

    @classmethod
    def because(cls, code: str, reason: str, help: str) -> Refused:
        """A file that was refused for a reason."""
        refused = cls(reason.encode("utf-8", "backslashreplace"))
        refused.code, refused.help = code, help
        return refused


@dataclass(slots=True, eq=False)
class SourceFile:
    """A text and the path by which users know it, with forward slashes.

    It is `past` when the file was read again, and the nodes of what has not changed were moved to their new places.
    """

    path: str
    text: str = field(repr=False)
    _line_starts: list[int] = field(default_factory=list, repr=False)
    past: bool = field(default=False, repr=False)

    def line_starts(self) -> list[int]:
        """Offsets of the first character of every line."""
        if not self._line_starts:
            self._line_starts.append(0)
            newline = self.text.find("\n")
            while newline >= 0:
                self._line_starts.append(newline + 1)
                newline = self.text.find("\n", newline + 1)
        return self._line_starts

    def line(self, number: int) -> str:
        """The text of a line, counted from 1, without its end."""
        starts = self.line_starts()
        end = starts[number] - 1 if number < len(starts) else len(self.text)
        return self.text[starts[number - 1] : end].rstrip("\r")


@dataclass(frozen=True, slots=True)
class Span:
    """Characters `start` to `end` (exclusive) of a file."""

    file: SourceFile
    start: int
    end: int

    @property
    def span(self) -> Span:
        """The span itself, which makes it `Spanned`."""
        return self

    def position(self) -> tuple[int, int]:
        """Line and column of the start, both counted from 1."""
        starts = self.file.line_starts()
        line = bisect_right(starts, self.start)
        return line, self.start - starts[line - 1] + 1

    def end_position(self) -> tuple[int, int]:
        """Line and column of the end, both counted from 1; the column is exclusive."""
        starts = self.file.line_starts()
        line = bisect_right(starts, max(self.start, self.end - 1))
        return line, self.end - starts[line - 1] + 1

    def order(self) -> tuple[str, int, int]:
        """A key that sorts spans by file and place."""
        return self.file.path, self.start, self.end
