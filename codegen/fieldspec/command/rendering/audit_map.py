"""The address map of an audit as drawings: the places and texts of all boxes.

A block has rows of sixteen addresses; equal empty rows are folded into one. The state of a box shows in its pattern, so
that it is visible on paper and without colours, and each drawing describes itself in words.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.html_text import clean
from fieldspec.tools.audit.address_map import DECLARED, STATES, UNDECLARED, UNDESCRIBED, UNLISTED, Block, Run, Space

A_ROW = 16
_BOX, _HIGH, _LEFT, _HEAD, _FOLDED = 60, 30, 62, 16, 20
_WIDE, _THIN, _LETTER = 8.8, 3.6, 5.6
"""The widths of wide letters, of thin ones, and of all others, in the fonts that browsers have."""

_LEAST_LETTERS = 3
_IDEOGRAPHS = 0x2E80
_LEADING = 11
_LINE = 0x1000
_OVERVIEW = 960
_EMPTY = (DECLARED, UNDECLARED, UNDESCRIBED, UNLISTED)


@dataclass(frozen=True, slots=True)
class Text:
    """A line of text in a box, and where its baseline begins."""

    x: int
    y: int
    text: str


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangle with the state of its addresses, one or two lines of text, and a longer title."""

    x: int
    y: int
    width: int
    height: int
    state: str
    lines: tuple[str, ...]
    title: str

    @property
    def texts(self) -> tuple[Text, ...]:
        """Its lines, centred in its height."""
        first = self.y + self.height // 2 + (4 if len(self.lines) == 1 else -2)
        return tuple(Text(self.x + 4, first + number * _LEADING, line) for number, line in enumerate(self.lines))


@dataclass(frozen=True, slots=True)
class Mark:
    """A text beside the boxes, with its baseline at `y`; `anchor` is `start`, `middle` or `end`."""

    x: int
    y: int
    text: str
    anchor: str


@dataclass(frozen=True, slots=True)
class Drawing:
    """A drawing with its size. `title` and `description` describe it in words, `caption` is the text above it."""

    anchor: str
    caption: str
    title: str
    description: str
    width: int
    height: int
    boxes: tuple[Box, ...]
    marks: tuple[Mark, ...]


@dataclass(frozen=True, slots=True)
class Map:
    """The drawings of a space, the overview first where there is one."""

    title: str
    drawings: tuple[Drawing, ...]


def maps(spaces: Sequence[Space]) -> tuple[Map, ...]:
    """The drawings of all spaces."""
    return tuple(Map(clean(space.title), tuple(_drawings(space))) for space in spaces)


def states(spaces: Sequence[Space]) -> list[tuple[str, str]]:
    """The states that occur in spaces, with the words for them."""
    present = {run.state for space in spaces for block in space.blocks for run in block.runs}
    return [(state, words) for state, words in STATES.items() if state in present]


def _drawings(space: Space) -> Iterator[Drawing]:
    if space.name == "registers":
        yield _overview(space)
    for block in space.blocks:
        yield _block(space, block)


def _overview(space: Space) -> Drawing:
    """All blocks of a space, with a line for each 1000h addresses."""
    lines = sorted({line for block in space.blocks for line in range(block.first // _LINE, block.last // _LINE + 1)})
    rows = {line: _HEAD + number * _HIGH for number, line in enumerate(lines)}
    boxes = []
    for block in space.blocks:
        for line in range(block.first // _LINE, block.last // _LINE + 1):
            first, last = max(block.first, line * _LINE), min(block.last, line * _LINE + _LINE - 1)
            x = _LEFT + (first % _LINE) * _OVERVIEW // _LINE
            width = max(3, (last - first + 1) * _OVERVIEW // _LINE)
            title = f"{space.number_text(block.first)} to {space.number_text(block.last)}: {clean(block.title)}"
            lines_of = _fitting(clean(block.title), width, 1)
            boxes.append(Box(x, rows[line] + 5, width, _HIGH - 10, "used", lines_of, title))
    marks = [
        Mark(_LEFT + part * _OVERVIEW // 4, _HEAD - 4, f"+0x{part * _LINE // 4:03X}", "start") for part in range(4)
    ]
    marks += [Mark(_LEFT - 6, y + _HIGH // 2 + 4, f"0x{line * _LINE:04X}", "end") for line, y in rows.items()]
    names = "; ".join(
        f"{clean(block.title)} from {space.number_text(block.first)} to {space.number_text(block.last)}"
        for block in space.blocks
    )
    return Drawing(
        "map-overview",
        "All blocks of the address space",
        "The place of the blocks",
        f"A line for each 0x1000 addresses with a block. {names}.",
        _LEFT + _OVERVIEW + 2,
        _HEAD + len(lines) * _HIGH + 2,
        tuple(boxes),
        tuple(marks),
    )


def _block(space: Space, block: Block) -> Drawing:
    boxes: list[Box] = []
    marks = [Mark(_LEFT + column * _BOX + _BOX // 2, _HEAD - 4, f"{column:X}", "middle") for column in range(A_ROW)]
    y = _HEAD
    by_line = _by_line(block)
    for first, last in _lines(block, by_line):
        folded = last - first >= A_ROW
        marks.append(Mark(_LEFT - 6, y + (14 if folded else 19), space.number_text(first), "end"))
        if folded:
            run = next(run for run in by_line[first] if run.first <= first <= run.last)
            text = f"to {space.number_text(last)}: {_run_text(run)}"
            boxes.append(Box(_LEFT, y + 1, A_ROW * _BOX, _FOLDED - 2, run.state, _fitting(text, A_ROW * _BOX, 1), text))
            y += _FOLDED
            continue
        boxes += _pieces(space, by_line.get(first, ()), first, y)
        y += _HIGH
    if block.repeats > 1:
        text = f"and {block.repeats - 1} more elements, {block.stride} apart, to {space.number_text(block.last)}"
        marks.append(Mark(_LEFT, y + 12, text, "start"))
        y += _FOLDED
    counts = ", ".join(f"{count} {words}" for state, words in STATES.items() if (count := block.count(state)))
    ends = f"{space.number_text(block.first)} to {space.number_text(block.last)}"
    return Drawing(
        f"map-{space.name}-{block.name}".replace(" ", "-"),
        f"{clean(block.title)}, {ends}",
        f"{clean(block.title)}, {ends}",
        f"Of {space.what}: {counts}. The table of all addresses has the same in words.",
        _LEFT + A_ROW * _BOX + 2,
        y + 2,
        tuple(boxes),
        tuple(marks),
    )


def _by_line(block: Block) -> dict[int, list[Run]]:
    """The runs of each row by its first address; of a long empty run only the rows at its ends."""
    by_line: dict[int, list[Run]] = {}
    for run in block.runs:
        lines: Sequence[int] = range(run.first // A_ROW * A_ROW, run.last + 1, A_ROW)
        if run.state in _EMPTY and len(lines) > 4:
            lines = [*lines[:2], *lines[-2:]]
        for line in lines:
            by_line.setdefault(line, []).append(run)
    return by_line


def _lines(block: Block, by_line: Mapping[int, Sequence[Run]]) -> Iterator[tuple[int, int]]:
    """The first and last addresses of the rows of a block; rows within one empty run are folded into one."""
    end = block.runs[-1].last if block.repeats == 1 else max(run.last for run in block.runs)
    start = block.runs[0].first
    line = start // A_ROW * A_ROW
    while line <= end:
        run = next((run for run in by_line.get(line, ()) if run.first <= max(line, start) <= run.last), None)
        whole = (run.last + 1) // A_ROW * A_ROW if run is not None else line
        if run is not None and run.state in _EMPTY and line >= run.first and whole - line >= 2 * A_ROW:
            yield line, whole - 1
            line = whole
        else:
            yield line, line + A_ROW - 1
            line += A_ROW


def _pieces(space: Space, runs: Iterable[Run], line: int, y: int) -> Iterator[Box]:
    """The boxes of a row; a run over several rows has a box in each."""
    for run in runs:
        first, last = max(run.first, line), min(run.last, line + A_ROW - 1)
        width = (last - first + 1) * _BOX
        name = " and ".join(occupant.name for occupant in run.occupants)
        descriptions = " and ".join(dict.fromkeys(occupant.about for occupant in run.occupants if occupant.about))
        ends = space.number_text(run.first) + (f" to {space.number_text(run.last)}" if run.size > 1 else "")
        title = f"{ends}: {_run_text(run)}{f', {descriptions}' if descriptions else ''}"
        x = _LEFT + (first - line) * _BOX
        lines = _fitting(f"…{name}" if name and first > run.first else name, width, 2)
        yield Box(x, y + 1, width, _HIGH - 2, run.state, lines, clean(title))


def _run_text(run: Run) -> str:
    """The text of a run: its state and its names."""
    names = " and ".join(occupant.name for occupant in run.occupants)
    state = STATES[run.state]
    if run.occupants and run.state == "used":
        return names
    return f"{names} ({state})" if names else f"{state}{f', {clean(run.reason)}' if run.reason else ''}"


def _fitting(text: str, width: int, lines: int) -> tuple[str, ...]:
    """As much of a text as fits into a box: its beginning, and on a second line its end, where names differ most."""
    room = width - 6
    if _width(text) <= room:
        return (text,) if text else ()
    head = _beginning(text, room)
    if len(head) < _LEAST_LETTERS:
        return ()
    if lines == 1:
        return (f"{_beginning(text, room - _WIDE)}…",)
    breaks = [index for index in range(len(head), 0, -1) if text[index] == "_" and _width(text[index:]) <= room]
    if breaks:
        return text[: breaks[0]], text[breaks[0] :]
    if _width(text[len(head) :]) <= room:
        return head, text[len(head) :]
    tail = _beginning(text[::-1], room - _WIDE)[::-1]
    return f"{_beginning(text, room - _WIDE)}…", f"…{tail}"


def _beginning(text: str, room: float) -> str:
    """The letters of a text that fit into a width."""
    length = 0
    while length < len(text) and (room := room - _width(text[length])) >= 0:
        length += 1
    return text[:length]


def _width(text: str) -> float:
    """The approximate width of a text."""
    return sum(map(_letter, text))


def _letter(sign: str) -> float:
    if sign in "mwMW@%…" or ord(sign) >= _IDEOGRAPHS:
        return _WIDE
    return _THIN if sign in "iljtfr.,:[]() " else _LETTER
