"""The sections of the report about addresses: the map of each space, and the read plan."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.read_plan import ReadBlock, ReadLimit, ReadPlan, ReadUnit, read_plan
from fieldspec.foundation.classes import dataclass
from fieldspec.tools.audit.address_map import DECLARED, OVERLAP, STATES, UNDECLARED, USED, Block, Run, Space, spaces_of
from fieldspec.tools.audit.section import Cell, Figure, Section, SectionTable, Subject

_NAMES = 4
"""The most names of a block that are printed in full; of more names, the first two and the last."""

_INTRODUCTION = (
    "All addresses, numbers and codes of the spec, in the blocks of the manual. A declared gap is "
    "one that the spec says the manual leaves out; any other gap may be a missing row."
)
_PLAN_INTRODUCTION = (
    "Each row is one request. It begins and ends with a value that has a meaning, contains no "
    "address that the manual does not describe, and divides no value. Equal requests at equal "
    "distances are one row."
)


def addresses(subject: Subject) -> Section:
    """The section with the address map."""
    spaces = spaces_of(subject.layout)
    figures = []
    for space in spaces:
        figures.append(Figure(f"{space.what} in use ({space.title})", space.count(USED)))
        overlaps = [run for block in space.blocks for run in block.runs if run.state == OVERLAP and run.is_own]
        if overlaps:
            unexplained = sum(1 for run in overlaps if not run.reason)
            figures.append(
                Figure(f"{space.what} occupied twice ({space.title})", space.count(OVERLAP), good=not unexplained)
            )
        if space.what in ("words", "bits"):
            gaps = space.count(UNDECLARED)
            space_text = f" ({space.title})" if subject.device.several_spaces else ""
            figures.append(Figure(f"{space.what} in gaps that are not declared{space_text}", gaps, good=gaps == 0))
    tables = (_blocks(spaces), _gaps(spaces), _overlaps(spaces), _aliases(spaces), _runs(spaces))
    return Section("addresses", "Address map", (_INTRODUCTION,), tuple(figures), tables, spaces=spaces)


def _blocks(spaces: Sequence[Space]) -> SectionTable:
    rows: list[tuple[Cell, ...]] = []
    for space in spaces:
        for block in space.blocks:
            shape = f"{block.repeats} elements, {block.stride} apart" if block.repeats > 1 else ""
            counts = [block.count(state) or None for state in STATES]
            ends = space.number_text(block.first), space.number_text(block.last)
            rows.append((space.title, block.title, *ends, shape, *counts, block.place["name"]))
    columns = ("space", "block", "first", "last", "shape", *STATES, "spec")
    return SectionTable("blocks", "Blocks", columns, tuple(rows))


def _gaps(spaces: Sequence[Space]) -> SectionTable:
    rows: list[tuple[Cell, ...]] = []
    kinds = []
    for space, block, run in _all_runs(spaces):
        if run.state in (DECLARED, UNDECLARED) and run.is_own:
            reason = run.reason or "no reason stated"
            rows.append((space.title, block.title, *_ends(space, run), run.size, STATES[run.state], reason))
            kinds.append("warning" if run.state == UNDECLARED else "")
    columns = ("space", "block", "first", "last", "size", "state", "reason")
    return SectionTable("gaps", "Gaps", columns, tuple(rows), tuple(kinds), detail=len(rows) > 40)


def _overlaps(spaces: Sequence[Space]) -> SectionTable:
    rows: list[tuple[Cell, ...]] = []
    kinds = []
    for space, block, run in _all_runs(spaces):
        if run.state == OVERLAP and run.is_own:
            names = " and ".join(occupant.name for occupant in run.occupants)
            rows.append((block.title, *_ends(space, run), names, run.reason or "no reason stated"))
            kinds.append("" if run.reason else "warning")
    return SectionTable(
        "overlaps",
        "Addresses that are occupied twice",
        ("block", "first", "last", "held_by", "reason"),
        tuple(rows),
        tuple(kinds),
    )


def _aliases(spaces: Sequence[Space]) -> SectionTable:
    rows: list[tuple[Cell, ...]] = [
        (
            space.number_text(alias.address),
            alias.occupant.name,
            "a copy of" if alias.copied else "the same as",
            space.number_text(alias.of_address),
            alias.of.name,
            alias.occupant.place["copy_of" if alias.copied else "same_as"],
            alias.occupant.sources[0] if alias.occupant.sources else None,
        )
        for space in spaces
        for alias in space.aliases
    ]
    columns = ("address", "name", "is", "of_address", "of", "spec", "source")
    return SectionTable("aliases", "Values at two addresses", columns, tuple(rows), detail=len(rows) > 40)


def _runs(spaces: Sequence[Space]) -> SectionTable:
    rows: list[tuple[Cell, ...]] = []
    for space, block, run in _all_runs(spaces):
        names = " and ".join(occupant.name for occupant in run.occupants)
        descriptions = " and ".join(dict.fromkeys(occupant.about for occupant in run.occupants if occupant.about))
        occupant = run.occupants[0] if run.occupants else None
        source = occupant.sources[0] if occupant is not None and occupant.sources else None
        place = occupant.place["name"] if occupant is not None else None
        rows.append(
            (space.title, block.title, *_ends(space, run), STATES[run.state], names, descriptions, place, source)
        )
    columns = ("space", "block", "first", "last", "state", "name", "type", "spec", "source")
    title = "All addresses; for tables, the addresses of the first element"
    return SectionTable("address_map", title, columns, tuple(rows), detail=True)


def _all_runs(spaces: Sequence[Space]) -> Iterator[tuple[Space, Block, Run]]:
    for space in spaces:
        for block in space.blocks:
            for run in block.runs:
                yield space, block, run


def _ends(space: Space, run: Run) -> tuple[str, str]:
    return space.number_text(run.first), space.number_text(run.last)


@dataclass(frozen=True, slots=True)
class ReadRow:
    """Equal requests at equal distances: the first one, how many there are, and how many addresses they are apart."""

    first: ReadBlock
    times: int
    apart: int


def read_rows(blocks: Sequence[ReadBlock]) -> list[ReadRow]:
    """Blocks as rows; blocks that differ only in an index share a row."""
    rows: list[ReadRow] = []
    for block in blocks:
        last = rows[-1] if rows else None
        if last is not None and "[" in block.names[0] and _shape(block) == _shape(last.first):
            apart = block.start - last.first.start - (last.times - 1) * last.apart
            if last.times == 1 or apart == last.apart:
                rows[-1] = ReadRow(last.first, last.times + 1, apart)
                continue
        rows.append(ReadRow(block, 1, 0))
    return rows


def _shape(block: ReadBlock) -> tuple[str, int, int, int, str]:
    """What equal requests of a record table have in common."""
    return block.space, block.words, block.reserved, len(block.names), block.names[0].partition("[")[0]


def reads(subject: Subject) -> Section:
    """The section with the read plan."""
    plan = read_plan(subject.layout)
    paragraphs = [_PLAN_INTRODUCTION, *(_limit_text(limit) for limit in plan.limits)] if plan.limits else []
    paragraphs += _parameter_reads(subject.layout)
    if not paragraphs:
        paragraphs = ["No message of the device reads registers or parameters."]
    figures = []
    for space in plan.spaces:
        limit, blocks = plan.limit(space), [block for block in plan.blocks if block.space == space]
        if limit is not None:
            values = sum(len(block.names) for block in blocks)
            space_text = f" of {space}" if space else ""
            text = f"requests of up to {limit.words} {limit.unit}s read all {values} values{space_text}"
            figures.append(Figure(text, len(blocks)))
    tables = (_limits(plan), _plan_table(plan), _left_out(plan)) if plan.limits else ()
    return Section("read_plan", "Read plan", tuple(paragraphs), tuple(figures), tables)


def _limit_text(limit: ReadLimit) -> str:
    """A sentence about the most words of a request, with its source."""
    if limit.words is None:
        return f"Nothing says how many {limit.unit}s one request of {limit.message} may read, so that there is no list."
    place = ""
    if limit.span is not None:
        place = f"{limit.span.file.path}:{limit.span.position()[0]}"
    if not limit.from_manual:
        notes = f" {' '.join(limit.notes)}" if limit.notes else ""
        return (
            f"One request of {limit.message} reads up to {limit.words} {limit.unit}s. The manual prints no limit; "
            f"this one is that of the protocol ({place}).{notes}"
        )
    cited = "; ".join(source.text() for source in limit.sources)
    return f"One request of {limit.message} reads up to {limit.words} {limit.unit}s ({cited or place})."


def _limits(plan: ReadPlan) -> SectionTable:
    rows = tuple(
        (
            limit.message,
            limit.words,
            "the manual" if limit.from_manual else "the protocol",
            limit.span,
            limit.sources[0] if limit.sources else None,
        )
        for limit in plan.limits
    )
    return SectionTable("read_limits", "Limits", ("message", "words", "said_by", "spec", "source"), rows)


def _plan_table(plan: ReadPlan) -> SectionTable:
    has_spaces = len(plan.spaces) > 1
    rows: list[tuple[Cell, ...]] = [
        (
            *([row.first.space] if has_spaces else []),
            f"0x{row.first.start:04X}",
            row.first.start,
            row.first.words,
            row.times,
            row.apart or None,
            len(row.first.names),
            row.first.reserved or None,
            _names(row.first.names),
        )
        for row in read_rows(plan.blocks)
    ]
    columns = (
        *(["space"] if has_spaces else []),
        "start",
        "decimal",
        "words",
        "times",
        "apart",
        "values",
        "reserved_words",
        "registers",
    )
    return SectionTable("read_blocks", "One request each", columns, tuple(rows))


def _names(names: Sequence[str]) -> str:
    return ", ".join(names) if len(names) <= _NAMES else f"{names[0]}, {names[1]}, … {names[-1]}"


def _left_out(plan: ReadPlan) -> SectionTable:
    units: dict[tuple[str, str], list[ReadUnit]] = {}
    for unit in plan.left_out:
        name, _, name_rest = unit.name.partition("[")
        units.setdefault((name + name_rest.partition("]")[2], unit.refused), []).append(unit)
    rows = tuple(
        (f"0x{units_of_name[0].first:04X}", units_of_name[0].words, len(units_of_name), name, refused)
        for (name, refused), units_of_name in units.items()
    )
    return SectionTable("not_read", "Not read by any block", ("start", "words", "times", "name", "reason"), rows)


def _parameter_reads(layout: DeviceLayout) -> Iterator[str]:
    """Sentences about how messages read parameters: one, several elements of one, or all of a set."""
    for message in layout.device.messages.values():
        for field in message.response.fields:
            part = field.value.parameter if field.value is not None else None
            parts = [case.value.parameter for case in field.choice.cases] if field.choice is not None else [part]
            parameter_part = next((parameter_part for parameter_part in parts if parameter_part is not None), None)
            if parameter_part is None or parameter_part.part not in ("value", "values"):
                continue
            if parameter_part.part == "values":
                count = field.count or (field.repeat.high if field.repeat is not None else 1)
                yield f"One request of {message.name} reads all {count} parameters of {parameter_part.set}."
            else:
                count = field.repeat.high if field.repeat is not None else field.count or 1
                list_text = f", up to {count} elements of it" if count > 1 else ""
                yield f"One request of {message.name} reads one parameter of {parameter_part.set}{list_text}."
