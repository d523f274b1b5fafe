"""A state machine as a drawing: states below each other, arrows beside them, each in a lane of its own."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from fieldspec.foundation.classes import dataclass
from fieldspec.targets.docs.document import Arrow, StateDrawing
from fieldspec.targets.templates import fill

# All lengths are in pixels.
_HEIGHT, _GAP = 44, 44
_CHARACTER = 8
"""The width of a character of the states; they are in a font in which all are equally wide."""
_LABEL = 7
_LEAST_LANE = 34
_TOP = 34
_TIP = 7
_PORT = 9
"""The distance of two arrows that touch the same side of a state."""


@dataclass(frozen=True, slots=True)
class _State:
    top: int
    height: int
    baseline: int
    text: str


@dataclass(frozen=True, slots=True)
class _Way:
    """The line of an arrow and its tip, as data of paths, with the place of its text."""

    line: str
    tip: str
    x: int = 0
    baseline: int = 0
    text: str = ""
    assumed: bool = False


def state_drawing(block: StateDrawing) -> str:
    """The drawing. Arrows that lead down are on the right, those that lead up on the left."""
    right, left = _lanes(block.arrows, down=True), _lanes(block.arrows, down=False)
    labels = [max([0, *(_LABEL * len(arrow.text) + 14 for arrow in lanes)]) for lanes in (left, right)]
    left_lane, right_lane = (max(_LEAST_LANE, label) for label in labels)
    box = _CHARACTER * max(map(len, block.states)) + 28
    before = left_lane * max(left.values(), default=0) + 8 + labels[0] // 2
    middle = before + box // 2
    ports = _ports(block.arrows, left, right)
    arrows = []
    for arrow in block.arrows:
        side = right if arrow.target > arrow.origin else left
        sign, edge = (1, before + box) if side is right else (-1, before)
        lane_x = edge + sign * side[arrow] * (right_lane if side is right else left_lane)
        start, end = (ports[arrow, place] for place in ("origin", "target"))
        line = f"M{edge} {start}H{lane_x}V{end}H{edge + sign * _TIP}"
        between = _top(arrow.origin) + (_HEIGHT + _GAP // 2 if side is right else -(_GAP // 2))
        arrows.append(_Way(line, f"M{edge} {end}l{sign * _TIP} -4v8z", lane_x, between + 5, arrow.text, arrow.assumed))
    return fill(
        "docs/drawing.html.j2",
        width=before + box + right_lane * max(right.values(), default=0) + 8 + labels[1] // 2,
        height=_TOP + len(block.states) * (_HEIGHT + _GAP) - _GAP + 12,
        description=_description(block),
        left=before,
        middle=middle,
        box=box,
        start=_Way(f"M{middle} 12V{_TOP - _TIP}", f"M{middle} {_TOP}l-4 -{_TIP}h8z"),
        states=[
            _State(_top(number), _HEIGHT, _top(number) + _HEIGHT // 2 + 5, state)
            for number, state in enumerate(block.states)
        ],
        arrows=arrows,
    )


def _description(block: StateDrawing) -> str:
    """The text that a screen reader reads instead of the drawing."""
    ways = [
        f"{block.states[arrow.origin]} to {block.states[arrow.target]}: {arrow.text}"
        + (", assumed" if arrow.assumed else "")
        for arrow in block.arrows
    ]
    return (
        f"{block.title}, {block.states[0]} at power-on. Transitions by their numbers in the table: {'; '.join(ways)}."
    )


def _top(number: int) -> int:
    return _TOP + number * (_HEIGHT + _GAP)


def _lanes(arrows: Iterable[Arrow], down: bool) -> dict[Arrow, int]:
    """The lanes of the arrows on one side, counted from the states: the shortest are the nearest, and none overlap."""
    own = [arrow for arrow in arrows if (arrow.target > arrow.origin) is down]
    lanes: dict[Arrow, int] = {}
    for arrow in sorted(own, key=lambda arrow: (abs(arrow.target - arrow.origin), arrow.origin, arrow.target)):
        low, high = sorted((arrow.origin, arrow.target))
        occupied = [lanes[other] for other in lanes if max(low, min(other[:2])) <= min(high, max(other[:2]))]
        touching = [
            lanes[other] for other in lanes if high == min(other[:2]) or low == max(other[:2])
        ]  # arrows that only touch a state have ports of their own there
        overlapping = [
            number for number in occupied if number not in touching or occupied.count(number) > touching.count(number)
        ]
        lanes[arrow] = max(overlapping, default=0) + 1
    return lanes


def _ports(
    arrows: Iterable[Arrow], left: Mapping[Arrow, int], right: Mapping[Arrow, int]
) -> dict[tuple[Arrow, str], int]:
    """How far down each arrow touches its states, so that none crosses another one that turns off before it."""
    heights: dict[tuple[Arrow, str], int] = {}
    for lanes in (left, right):
        touching: dict[int, list[tuple[tuple[int, int], Arrow, str]]] = {}
        for arrow in arrows:
            if arrow not in lanes:
                continue
            for place, own, other in (
                ("origin", arrow.origin, arrow.target),
                ("target", arrow.target, arrow.origin),
            ):
                lane = lanes[arrow]
                order = (0, lane) if other < own else (1, -lane)
                touching.setdefault(own, []).append((order, arrow, place))
        for state, ends in touching.items():
            ends.sort()
            first = _top(state) + (_HEIGHT - _PORT * (len(ends) - 1)) // 2
            for number, (_, arrow, place) in enumerate(ends):
                heights[arrow, place] = first + _PORT * number
    return heights
