"""The parts of a frame before the body: what the caller gives, what is always the same, and what is refused."""

from __future__ import annotations

from fieldspec.backends.python.naming import Scope
from fieldspec.backends.python.slots import Words
from fieldspec.backends.python.text import literal
from fieldspec.backends.python.writing import packed, pairs, tuple_of, within
from fieldspec.classes import dataclass
from fieldspec.layout.frame import FrameLayout, LinkLayout, PartLayout
from fieldspec.model.ranges import Ranges


@dataclass(frozen=True, slots=True)
class PartView:
    """A plain part of the head: its attribute, its variable, its type, and the lines that make it from `head`."""

    name: str
    variable: str
    type: str
    made: str
    quickly: str


def variable(part: PartLayout) -> str:
    """The variable of a part of the head."""
    return "station" if part.role == "station" else f"part_{part.name}"


def number(part: PartLayout) -> str:
    """The expression of the number that fills the slot of a part of the head."""
    return f"{variable(part)}.raw" if part.value is not None and part.value.flags else variable(part)


def letter(part: PartLayout) -> str:
    """The letter of a part of the head."""
    assert part.value is not None
    return part.value.type.letter


def _plain(part: PartLayout, place: int, words: Words) -> PartView:
    flags = part.value.flags if part.value else ""
    made = f"{words.flags[flags]}({{}})" if flags else "{}"
    name = Scope(frozenset({"station", "message", "self", "frame", "request"})).take(part.name)
    return PartView(
        name=name,
        variable=variable(part),
        type=words.flags[flags] if flags else "int",
        made=made.format(f"head[{place}]"),
        quickly=made.format(variable(part)),
    )


def code_literal(code: int | None) -> str:
    """A code as Python writes it: `0x03`, `None`."""
    return "None" if code is None else f"{code:#04x}"


def head_value(part: PartLayout, code: str) -> str:
    """What a part of the head holds before its length is known."""
    if part.role in ("length", "check"):
        return "0"
    held = constant(part)
    return code if part.role == "code" else number(part) if held is None else str(held)


def _allowed(link: LinkLayout, part: PartLayout) -> tuple[tuple[tuple[int, int], ...], tuple[int, ...]]:
    """The intervals of a part of the head, and values beside them."""
    assert part.value is not None
    stations = link.link.stations if part.role == "station" else None
    if stations is not None and stations.ranges is not None:
        beside = () if stations.broadcast is None else (stations.broadcast,)
        return stations.ranges.intervals, beside
    return (part.value.ranges.intervals if part.value.ranges else ()), ()


def constant(part: PartLayout) -> int | None:
    """The one value that a plain part has when it is sent."""
    return part.constant


def is_simple(frame: FrameLayout) -> bool:
    """Whether a head of one byte order is followed by the body and, at most, a check of all before it.

    A length is then that of all parts. Any other frame takes the slower way, part by part.
    """
    check, length = frame.check, frame.role("length")
    return (
        len({part.order for part in frame.head if part.size > 1}) <= 1
        and not any(part.reserved for part in frame.head)
        and frame.tail == (() if check is None else (check,))
        and (check is None or (check.start, check.stop) == (0, check.offset))
        and (length is None or (length.unit_size, length.base) == (1, 0))
    )


def part_rows(parts: tuple[PartLayout, ...]) -> str:
    """Parts as the rows of a tuple: name, size, order, sign, what is always sent, and whether it is compared."""
    rows = [
        f"({literal(part.name)}, {part.size}, {literal(part.order)}, {_signed(part)}, {part.constant},"
        f" {part.constant is not None and not part.reserved})"
        for part in parts
    ]
    return tuple_of(rows) if rows else "()"


def _signed(part: PartLayout) -> bool:
    return part.value is not None and part.value.type.signed


def given(frame: FrameLayout) -> list[PartLayout]:
    """The parts of the head that the caller gives."""
    return [part for part in frame.head if part.is_argument]


def plain_views(frame: FrameLayout, words: Words) -> list[PartView]:
    """The parts beside the station that the caller gives."""
    return [_plain(part, frame.head.index(part), words) for part in given(frame) if part.role == "plain"]


def constants(frame: FrameLayout) -> list[str]:
    """The parts that are always the same: place, name, value and offset of each."""
    return [
        f"({place}, {literal(part.name)}, {held}, {part.offset})"
        for place, part in enumerate(frame.head)
        if (held := constant(part)) is not None
    ]


def head_tests(link: LinkLayout, frame: FrameLayout) -> list[str]:
    """What must hold of the parts that the caller gives."""
    tests = []
    for part in given(frame):
        intervals, beside = _allowed(link, part)
        if intervals:
            assert part.value is not None
            tests.append(within(number(part), Ranges(intervals), beside, packed(part.value.type)))
    return [test for test in tests if test]


def greatest_part(link: LinkLayout, part: PartLayout) -> int:
    """The greatest number that the conditions of a part of the head let pass, of a number without sign."""
    assert part.value is not None
    intervals, beside = _allowed(link, part)
    return max((*(high for _, high in intervals), *beside), default=packed(part.value.type)[1])


def head_refusals(link: LinkLayout, frame: FrameLayout) -> list[str]:
    """The expressions that say what is wrong with them."""
    found = []
    for part in given(frame):
        assert part.value is not None
        intervals, beside = _allowed(link, part)
        limits = [str(part.value.type.low), str(part.value.type.high)]
        if intervals:
            limits.append(pairs(Ranges(intervals)))
        if part.value.flags:
            found.append(f"_refused_flags({literal(part.name)}, {variable(part)}, {', '.join(limits[1:])})")
            continue
        if beside:
            limits.append(tuple_of(beside))
        found.append(f"_refused_number({literal(part.name)}, {variable(part)}, {', '.join(limits)})")
    return found
