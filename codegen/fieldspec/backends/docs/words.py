"""Words of flags: drawn bit by bit, and as tables."""

from __future__ import annotations

from fieldspec.backends.docs.context import Context, names, sources
from fieldspec.backends.docs.document import (
    BitRow,
    Bits,
    Box,
    Column,
    Facts,
    Line,
    Row,
    Section,
    cell,
    code,
    joined,
    plain,
    styled,
    table,
)
from fieldspec.backends.docs.inferences import Inferences
from fieldspec.model.flags import Bit, Flags, State

COLUMNS = (
    Column("Bit", "number", kept=True),
    Column("Mask", "number", kept=True),
    Column("Name", kept=True),
    Column("0 means"),
    Column("1 means"),
    Column("Meaning", "wide"),
    Column("Source", "source"),
)
STATES = (
    Column("State", kept=True),
    Column("Bits that are 1"),
    Column("Bits that are 0"),
    Column("Word and mask", "number", kept=True),
    Column("Meaning", "wide"),
    Column("Source", "source"),
)
IN_A_ROW = 16
# A name fits upright into so many bits; into fewer it is turned.
UPRIGHT = 4


def words(context: Context) -> Section:
    """All words of flags."""
    inner = tuple(_word(context, word) for word in context.device.flags.values())
    return Section("flags", (plain("Words of bits"),), (), inner)


def _word(context: Context, word: Flags) -> Section:
    path = word.place.path
    blocks = context.opening(word)
    users = context.users(path)
    kind: Line = (code(word.type.name), plain(", bit 0 is the least significant"))
    facts: list[tuple[str, tuple[Line, ...]]] = [("Type", (kind,))]
    if word.ranges is not None:
        facts.append(("Range", ((plain(word.ranges.text()),),)))
    if users:
        facts.append(("Used by", (users,)))
    blocks.append(Facts(tuple(facts)))
    blocks.append(drawn(word))
    marks = Inferences(path)
    rows = [_row(context, word, bit, marks) for bit in word.bits]
    blocks.append(table(f"Bits of {word.name}", COLUMNS, rows, marks.footnotes(), heading=2))
    if word.states:
        rows = [_state(word, state) for state in word.states]
        blocks.append(table(f"States that {word.name} shows", STATES, rows, heading=0))
    return Section(path, (code(word.name), *context.section_title("", word)[1:]), tuple(blocks))


def _row(context: Context, word: Flags, bit: Bit, marks: Inferences) -> Row:
    more: list[Line] = []
    if bit.reserved:
        more.append((styled("reserved", "badge"),))
    if bit.edge:
        text = " The change of the bit has the effect, not its level."
        more.append((styled(f"{bit.edge} edge", "badge"), plain(text)))
    if bit.active == "low":
        more.append((styled("active low", "badge"), plain(" It is 0 while what its name says is so.")))
    if bit.when:
        more.append((styled("only when ", "strong"), plain(bit.when)))
    if bit.enum:
        more.append((styled("Values: ", "quiet"), code(bit.enum, f"#enums/{bit.enum}")))
    return Row(
        (
            cell(bits_text(bit)),
            cell(code(f"0x{bit.mask:0{2 * word.type.size}X}")),
            names(bit, bit.name, mark=marks.all_marks(bit.inferred)),
            cell(bit.zero),
            cell(bit.one),
            cell(*more, *context.about(bit)),
            sources(bit),
        ),
        bit.place.path,
    )


def _state(word: Flags, state: State) -> Row:
    mask, held = word.masked(state)
    digits = 2 * word.type.size
    return Row(
        (
            names(state, state.name),
            cell(joined((code(name),) for name in state.set)),
            cell(joined((code(name),) for name in state.clear)),
            cell(code(f"word & 0x{mask:0{digits}X} = 0x{held:0{digits}X}")),
            cell(state.doc),
            sources(state),
        ),
        state.place.path,
    )


def bits_text(bit: Bit) -> str:
    """`3`, or `9..10`"""
    return str(bit.first) if bit.width == 1 else f"{bit.first}..{bit.last}"


def drawn(word: Flags) -> Bits:
    """A word as boxes, and in characters."""
    width = 8 * word.type.size
    rows = tuple(_boxes(word, high) for high in range(width - 1, 0, -min(width, IN_A_ROW)))
    return Bits(rows, _characters(word, width))


def _boxes(word: Flags, high: int) -> BitRow:
    """The boxes of up to sixteen bits, from bit `high` down."""
    low = max(0, high - IN_A_ROW + 1)
    holders = {number: bit for bit in word.bits for number in range(bit.first, bit.last + 1)}
    boxes: list[Box] = []
    at = high
    while at >= low:
        bit = holders.get(at)
        last = max(low, bit.first) if bit else at
        boxes.append(_box(bit, at - last + 1))
        at = last - 1
    return BitRow(f"Layout of {word.name}, bits {high} to {low}", tuple(range(high, low - 1, -1)), tuple(boxes))


def _box(bit: Bit | None, width: int) -> Box:
    if bit is None or bit.reserved:
        return Box(width, "", "" if bit is None else f"#{bit.place.path}", "free")
    return Box(width, bit.name, f"#{bit.place.path}", "field" if width >= UPRIGHT else "bit")


def _characters(word: Flags, width: int) -> str:
    """Boxes of four characters a bit, and from each named bit a line down to its name."""
    named = [bit for bit in word.bits if not bit.reserved]
    held = {number for bit in named for number in range(bit.first, bit.last + 1)}
    numbers = range(width - 1, -1, -1)
    rule = "+---" * width + "+"
    boxes = "".join("| x " if number in held else "|   " for number in numbers) + "|"
    lines = ["".join(f"{number:>3} " for number in numbers).rstrip(), rule, boxes, rule]
    lines += [_leader(named, at, width) for at in range(len(named))]
    return "\n".join(lines)


def _leader(named: list[Bit], at: int, width: int) -> str:
    """The line to the name of one bit, past the lines of those above it."""

    def column(bit: Bit) -> int:
        return 4 * (width - 1 - bit.first) + 2

    line = [" "] * (column(named[at]) + 1)
    for later in named[at + 1 :]:
        line[column(later)] = "|"
    return "".join(line[:-1]) + f"+- {bits_text(named[at])} {named[at].name}"
