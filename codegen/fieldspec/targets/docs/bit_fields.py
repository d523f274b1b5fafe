"""Words of bit fields: drawn, with a table of their bits and of their states."""

from __future__ import annotations

from fieldspec.codec.explain.values import in_unit, range_in_unit
from fieldspec.language.model.enums import Bit, Flags, State
from fieldspec.targets.docs.context import Context, fact_row, names
from fieldspec.targets.docs.document import (
    BitRow,
    Bits,
    Box,
    Facts,
    Line,
    Section,
    TableColumn,
    TableRow,
    cell,
    code,
    joined,
    styled,
    table,
    text_piece,
)
from fieldspec.targets.docs.sources import Inferences
from fieldspec.targets.docs.value_cells import unit_lines

COLUMNS = (
    TableColumn("Bit", "number", unbroken=True, search="key"),
    TableColumn("Mask", "number", unbroken=True, search="key"),
    TableColumn("Name", unbroken=True),
    TableColumn("0 means", search="text"),
    TableColumn("1 means", search="text"),
    TableColumn("Meaning", "wide"),
    TableColumn("Source", "source"),
)
STATES = (
    TableColumn("State", unbroken=True),
    TableColumn("Bits that are 1"),
    TableColumn("Bits that are 0"),
    TableColumn("Word and mask", "number", unbroken=True),
    TableColumn("Meaning", "wide"),
    TableColumn("Source", "source"),
)
IN_A_ROW = 16
# A name fits upright into so many bits; into fewer it is turned.
UPRIGHT = 4


def words(context: Context) -> Section:
    """The section of all words of flags, each with the layout and the table of its bits."""
    inner = tuple(_word(context, word) for word in context.device.flags.values())
    return Section("flags", (text_piece("Bit fields"),), (), inner)


def _word(context: Context, word: Flags) -> Section:
    path = word.place.path
    blocks = context.opening(word)
    users = context.users(path)
    from_bit = "" if word.bit_0 == "least" else "; the manual counts from the most significant bit"
    kind: Line = (code(word.type.name), text_piece(f", bit 0 is the least significant{from_bit}"))
    facts: list[tuple[str, tuple[Line, ...]]] = [("Type", (kind,))]
    if word.ranges is not None:
        facts.append(("Range", ((text_piece(word.ranges.text()),),)))
    if users:
        facts.append(("Used by", (users,)))
    blocks.append(Facts(tuple(facts)))
    blocks.append(drawn(word))
    marks = Inferences(path)
    rows = [_bit_row(context, word, bit, marks) for bit in word.bits]
    blocks.append(table(f"Bits of {word.name}", COLUMNS, rows, marks.footnotes(), heading=2))
    if word.states:
        rows = [_state(word, state) for state in word.states]
        blocks.append(table(f"States that {word.name} shows", STATES, rows, heading=0))
    return Section(path, (code(word.name), *context.section_title("", word)[1:]), tuple(blocks))


def _bit_row(context: Context, word: Flags, bit: Bit, marks: Inferences) -> TableRow:
    lines: list[Line] = []
    if bit.reserved:
        lines.append((styled("reserved", "badge"),))
    if bit.edge:
        text = " The edge of the bit has the effect, not its level."
        lines.append((styled(f"{bit.edge} edge", "badge"), text_piece(text)))
    if bit.active == "low":
        lines.append((styled("active low", "badge"), text_piece(" It is 0 while what its name says is true.")))
    if bit.when:
        lines.append((styled("only when ", "strong"), text_piece(bit.when)))
    if bit.signed:
        lines.append((styled("signed", "badge"), text_piece(" A number in two's complement.")))
    if bit.is_number and (bit.unit or bit.as_value.scaled):
        first, *other_lines = unit_lines(bit.as_value)
        lines += [(styled("1 count: ", "quiet"), *first), *other_lines]
    if bit.ranges is not None:
        lines.append((styled("Range: ", "quiet"), text_piece(range_in_unit(bit.as_value, bit.ranges))))
    if bit.default is not None:
        initial = in_unit(bit.as_value, bit.default) or str(bit.default)
        lines.append((styled("Default: ", "quiet"), text_piece(initial)))
    if reason := bit.reason_to_give(context.device.enums.get(bit.enum)):
        lines.append((styled("has to be given", "badge"), text_piece(f" Its {reason}.")))
    if bit.enum:
        lines.append((styled("Values: ", "quiet"), code(bit.enum, f"#enums/{bit.enum}")))
    return fact_row(
        bit,
        cell(bit.number_text),
        cell(code(f"0x{bit.mask:0{2 * word.type.size}X}")),
        names(bit, bit.name, mark=marks.all_marks(bit.inferred)),
        cell(bit.zero),
        cell(bit.one),
        cell(*lines, *context.about(bit)),
    )


def _state(word: Flags, state: State) -> TableRow:
    mask, pattern = word.masked(state)
    digits = 2 * word.type.size
    return fact_row(
        state,
        names(state, state.name),
        cell(joined((code(name),) for name in state.set)),
        cell(joined((code(name),) for name in state.clear)),
        cell(code(f"word & 0x{mask:0{digits}X} = 0x{pattern:0{digits}X}")),
        cell(state.doc),
    )


def drawn(word: Flags) -> Bits:
    """A word as boxes, and in characters."""
    width = 8 * word.type.size
    rows = tuple(_boxes(word, high) for high in range(width - 1, 0, -min(width, IN_A_ROW)))
    return Bits(rows, _characters(word, width))


def _boxes(word: Flags, high: int) -> BitRow:
    """The boxes of up to sixteen bits, from bit `high` down."""
    low = max(0, high - IN_A_ROW + 1)
    holders = {number: bit for bit in word.bits for number in bit.places}
    boxes: list[Box] = []
    position = high
    while position >= low:
        bit = holders.get(position)
        run = next((run for run in bit.runs if run.first <= position < run.first + run.width), None) if bit else None
        last = max(low, run.first) if run else position
        boxes.append(_box(bit, position - last + 1))
        position = last - 1
    return BitRow(f"Layout of {word.name}, bits {high} to {low}", tuple(range(high, low - 1, -1)), tuple(boxes))


def _box(bit: Bit | None, width: int) -> Box:
    if bit is None or bit.reserved:
        return Box(width, "", "" if bit is None else f"#{bit.place.path}", "free")
    return Box(width, bit.name, f"#{bit.place.path}", "field" if width >= UPRIGHT else "bit")


def _characters(word: Flags, width: int) -> str:
    """Boxes of four characters a bit, and from each named bit a line down to its name."""
    labelled = [bit for bit in word.bits if not bit.reserved]
    named_numbers = {number for bit in labelled for number in bit.places}
    numbers = range(width - 1, -1, -1)
    rule = "+---" * width + "+"
    boxes = "".join("| x " if number in named_numbers else "|   " for number in numbers) + "|"
    lines = ["".join(f"{number:>3} " for number in numbers).rstrip(), rule, boxes, rule]
    lines += [_leader(labelled, index, width) for index in range(len(labelled))]
    return "\n".join(lines)


def _leader(labelled: list[Bit], index: int, width: int) -> str:
    """The line to the name of one bit, past the lines of those above it."""

    def column(bit: Bit) -> int:
        return 4 * (width - 1 - bit.first) + 2

    line = [" "] * (column(labelled[index]) + 1)
    for later in labelled[index + 1 :]:
        line[column(later)] = "|"
    return "".join(line[:-1]) + f"+- {labelled[index].number_text} {labelled[index].name}"
