"""The cells of a value: type, unit, range, default, and what its numbers mean."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.codec.explain.values import in_unit, range_in_unit
from fieldspec.foundation.line_text import plural
from fieldspec.language.model.digits import digits_text
from fieldspec.language.model.encoding import is_array
from fieldspec.language.model.enums import Enum, Member
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.registers import Parameter, Register, Subindex
from fieldspec.language.model.text_form import text_form_title
from fieldspec.language.model.value import Sentinel, Value
from fieldspec.targets.docs.context import Context, names
from fieldspec.targets.docs.document import (
    UNKNOWN,
    Cell,
    Item,
    Line,
    TableColumn,
    cell,
    code,
    joined,
    label,
    styled,
    text_piece,
)
from fieldspec.targets.docs.sources import Inferences

# An enum with more members than this is not written out in the rows that use it.
MOST_MEMBERS = 8

VALUE_COLUMNS = (TableColumn("Type"), TableColumn("Unit", "short"), TableColumn("Range", "range"))
SETTING_COLUMNS = (
    TableColumn("Name", unbroken=True),
    VALUE_COLUMNS[0],
    TableColumn("Access", "short", unbroken=True),
    *VALUE_COLUMNS[1:],
    TableColumn("Default"),
    TableColumn("Restart", "short"),
)
PARTS = {
    "number": "The number of one of: ",
    "subindex": "The first accessed element of one of: ",
    "value": "The value of one of: ",
    "values": "The values of all: ",
}
RESTART = {True: "yes", False: "no"}


def value_cells(value: Value, inferred: Mapping[str, str], marks: Inferences) -> tuple[Cell, Cell, Cell]:
    """The cells of a value, in the order of VALUE_COLUMNS."""
    return (
        _with(type_lines(value), marks.marks(inferred, "type")),
        _with(unit_lines(value), marks.marks(inferred, "unit")),
        _with(range_lines(value), marks.marks(inferred, "range")),
    )


def setting_cells(
    fact: Register | Parameter | Subindex, name: str, marks: Inferences, restart: bool
) -> tuple[Cell, ...]:
    """The cells of a register or parameter, in the order of SETTING_COLUMNS; `restart` says whether any states one."""
    inferred = fact.inferred
    kind, unit, bounds = value_cells(fact.value, inferred, marks)
    is_element = isinstance(fact, Subindex)
    return (
        names(fact, name, mark=marks.all_marks(inferred) if is_element else marks.marks(inferred)),
        kind,
        access_cell(fact.access, inferred, marks) if fact.access or not is_element else Cell(),
        unit,
        bounds,
        default_cell(fact.value, inferred, marks),
        restart_cell(fact.restart, inferred, marks) if restart and not isinstance(fact, Subindex) else Cell(),
    )


def effect_lines(fact: Register | Parameter) -> Iterator[Line]:
    """That a register or parameter is reserved, and that writing it has an effect."""
    if fact.reserved:
        yield (styled("reserved", "badge"),)
    if fact.trigger:
        text = " Writing has an effect; reading does not return the written value."
        yield (styled("trigger", "badge"), text_piece(text))


def _with(lines: list[Line], marks: Line) -> Cell:
    """Lines with marks after the first one."""
    if not marks:
        return cell(*lines)
    first = lines[0] if lines else ()
    return cell((*first, *marks), *lines[1:])


def type_lines(value: Value) -> list[Line]:
    """The type, with its length where the type has none, and the order of its bytes where it has one of its own."""
    qualifier = "at most " if value.width else ""
    size = f" of {qualifier}{plural(value.size, 'byte')}" if is_array(value.encoding) else ""
    lines: list[Line] = [(code(value.type.name), text_piece(size))]
    if value.digits:
        lines.append((text_piece(f"sent as {digits_text(value)}"),))
    if value.packed_bits:
        lines.append((text_piece(value.packed_text),))
    if value.text_form is not None:
        lines.append((text_piece(text_form_title(value)),))
    if value.characters is not None:
        lines.append((text_piece(f"{value.characters} characters at most"),))
    if value.byte_order:
        lines.append((text_piece(f"{value.byte_order} endian"),))
    if value.write_word_order:
        lines.append((text_piece(value.write_order_text),))
    if value.const is not None:
        lines.append((text_piece("always "), code(_constant_text(value, value.const))))
    return lines


def _constant_text(value: Value, number: int) -> str:
    """A constant: with the hexadecimal digits of its bytes if it is a pattern rather than a number."""
    return f"0x{number:0{2 * value.size}X}" if number > 9 else str(number)


def unit_lines(value: Value) -> list[Line]:
    """`0.01 mm`: the worth of one count."""
    if not value.scaled:
        return [(text_piece(value.unit),)] if value.unit else []
    exact = value.scale_number
    scale = value.scale_text if "/" in value.scale_text or isinstance(exact, str) else f"{exact:f}"
    lines: list[Line] = [(text_piece(f"{scale} {value.unit}".strip()),)]
    if value.offset:
        lines.append((text_piece(f"plus {value.offset:f} {value.unit}".strip()),))
    return lines


def range_lines(value: Value) -> list[Line]:
    """The range in the unit, then in counts where these are other numbers; then that of writing, where it differs."""
    lines: list[Line] = []
    for before, ranges in (("", value.ranges), ("written: ", value.write_ranges)):
        if ranges is not None:
            lines.append((text_piece(before + spoken(range_in_unit(value, ranges))),))
            if value.scaled:
                lines.append((styled(f"raw {spoken(ranges.text())}", "quiet"),))
    return lines


def spoken(ranges: str) -> str:
    """`0 to 100`: long intervals may then be broken into lines."""
    return ranges.replace("..", " to ")


def default_cell(value: Value, inferred: Mapping[str, str], marks: Inferences) -> Cell:
    """The default in the unit, then in counts where that is another number."""
    default = value.default
    lines: list[Line] = []
    if isinstance(default, int):
        sentinel = value.sentinel(default)
        if sentinel is not None:
            lines = [(code(str(default)), text_piece(" "), code(sentinel.name))]
        else:
            lines = [(text_piece(in_unit(value, default) or str(default)),)]
        if value.scaled and sentinel is None:
            lines.append((styled(f"raw {default}", "quiet"),))
    elif default is not None:
        lines = [(code(default),)]
    return _with(lines, marks.marks(inferred, "default"))


def access_cell(access: str, inferred: Mapping[str, str], marks: Inferences) -> Cell:
    """The access, or that it is unknown."""
    known: Line = (code(access),) if access else (UNKNOWN,)
    return cell((*known, *marks.marks(inferred, "access")))


def restart_cell(restart: bool | None, inferred: Mapping[str, str], marks: Inferences) -> Cell:
    """Whether a restart is needed, or that it is unknown."""
    known: Line = (text_piece(RESTART[restart]),) if restart is not None else (UNKNOWN,)
    return cell((*known, *marks.marks(inferred, "restart")))


def meaning_cell(context: Context, fact: Fact, value: Value | None, *lines: Line) -> Cell:
    """The cell with the documentation of a fact, the meanings of its numbers, and notes."""
    remarks = list(context.about(fact))
    if value is None:
        return cell(*lines, *remarks)
    return cell(*lines, *remarks, *_named_by(context, value), items=tuple(_meanings(context, value)))


def case_lines(context: Context, fact: Fact, value: Value) -> list[Line]:
    """Everything about a value of one of several types, its type first."""
    about_number = [*type_lines(value), *unit_lines(value), *range_lines(value)]
    return [*about_number, *context.about(fact), *_named_by(context, value), *map(_sentinel, value.sentinels)]


def _named_by(context: Context, value: Value) -> Iterator[Line]:
    """The enum, the word of flags and the parameters that a value refers to."""
    if value.enum:
        yield (styled("Values: ", "quiet"), code(value.enum, f"#enums/{value.enum}"))
    if value.flags:
        yield (styled("Bits: ", "quiet"), code(value.flags, f"#flags/{value.flags}"))
    if value.parameter is not None:
        name = value.parameter.set
        links = [
            code(parameter_set.name, f"#parameters/{parameter_set.name}") for parameter_set in context.device.sets(name)
        ]
        yield (styled(PARTS[value.parameter.part], "quiet"), *joined((link,) for link in links))
        sizes = value.parameter.sizes
        if sizes is not None:
            case_lines = [
                (text_piece(f"{case.bytes} where it is "), *joined((code(name),) for name in case.when))
                for case in sizes.cases
            ]
            yield (styled("Bytes that count, by ", "quiet"), code(sizes.by), text_piece(": "), *joined(case_lines))


def _meanings(context: Context, value: Value) -> Iterator[Item]:
    """Values with names: members of a short enum, and sentinels."""
    enum = context.device.enums[value.enum] if value.enum else None
    if enum is not None and _short(enum):
        yield from (Item(_member(member)) for member in enum.members)
    yield from (Item(_sentinel(sentinel)) for sentinel in value.sentinels)


def _sentinel(sentinel: Sentinel) -> Line:
    doc: Line = (text_piece(f": {sentinel.doc}"),) if sentinel.doc else ()
    return code(sentinel.text), text_piece(" "), code(sentinel.name), *doc


def _short(enum: Enum) -> bool:
    return len(enum.members) <= MOST_MEMBERS and enum.kind == "enum"


def _member(member: Member) -> Line:
    badge: Line = (text_piece(" "), styled("not available", "badge")) if member.unavailable else ()
    label_line: Line = (text_piece(" "), label(member.label)) if member.label else ()
    return (code(str(member.value)), text_piece(" "), code(member.name), *label_line, *badge)
