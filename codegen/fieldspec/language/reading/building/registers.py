"""Address spaces, registers in groups, tables of records, and numbered parameters."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from fieldspec.language.model.address_space import WHOLE, WORD, AddressSpace
from fieldspec.language.model.encoding import is_array, is_text
from fieldspec.language.model.fact import Citation
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.registers import (
    Gap,
    Parameter,
    ParameterSet,
    PrintedElement,
    Register,
    RegisterGroup,
    Subindex,
    Table,
)
from fieldspec.language.model.value import Value
from fieldspec.language.reading.building.context import Entry, Reused, rows
from fieldspec.language.reading.building.values import value
from fieldspec.language.reading.nodes import Mapping


def address_space(entry: Entry) -> AddressSpace:
    """The address space that an entry states."""
    return entry.built(
        AddressSpace,
        unit=entry.text("unit") or WORD,
        bounds=entry.whole_ranges("bounds") or WHOLE,
    )


def group(entry: Entry, sizes: dict[str, int], reused: Reused) -> RegisterGroup:
    """A group of registers. `sizes` has the bytes at one address by the name of each space."""
    defaults = _defaults(entry)
    space = entry.text("space")
    size = sizes.get(space, sizes[""])
    registers = rows(entry, "registers", defaults, reused, lambda inner: _register(inner, space, size), space, size)
    _refuse_idle_defaults(entry, [register.value for register in registers])
    return entry.built(
        RegisterGroup,
        name=entry.text("group"),
        space=space,
        ascending=entry.text("order") != "as_listed",
        gaps=tuple(_gap(inner) for inner in entry.entries("gaps")),
        registers=registers,
    )


def _gap(entry: Entry) -> Gap:
    return Gap(entry.place(), entry.whole_ranges("at") or Ranges(()), entry.text("reason"), entry.sources)


def _register(entry: Entry, space: str, unit_size: int) -> Register:
    if not entry.node.values.get("source"):
        entry.sources = ()  # a group's source is the place of its table
    content = value(entry)
    width = -(-content.size // unit_size)
    count = entry.integer("count") or 1
    for key in ("stride", "index_from", "element_name") if entry.get("count") is None else ():
        if key in entry.own:
            entry.refuse("wrong_form", key, f"`{key}` has no effect without `count`", "add `count`, or remove it")
    elements = _elements(entry, count)
    if not entry.sources and elements:
        entry.sources = (elements[0],)
    address = entry.integer("at")
    if address is None:
        entry.refuse("missing_key", "at", "a register needs an address", "add it under `at`")
    return entry.built(
        Register,
        space=space,
        address=address or 0,
        value=content,
        handling=entry.handling(),
        count=count,
        stride=entry.integer("stride") or width,
        element_sources=elements,
        unit_size=unit_size,
    )


def _elements(entry: Entry, count: int) -> tuple[Citation, ...]:
    """One citation for each cited line, the same number as registers."""
    cited = entry.citations("element_sources")
    lines = sum(last - first + 1 for citation in cited for first, last in citation.lines)
    if cited and lines != count:
        text = f"{lines} lines are cited for {count} registers"
        entry.refuse("sources_present", "element_sources", text, "cite one line for each")
        return ()
    return tuple(
        Citation(citation.section, ((line, line),), citation.mark)
        for citation in cited
        for first, last in citation.lines
        for line in range(first, last + 1)
    )


def table(entry: Entry) -> Table:
    """The table of records that an entry states."""
    return entry.built(
        Table,
        stride=entry.integer("stride") or 1,
        count=entry.integer("count") or 1,
        handling=entry.handling(),
        elements=tuple(_printed_element(inner) for inner in entry.entries("elements")),
    )


def _printed_element(entry: Entry) -> PrintedElement:
    first, _, last = entry.text("at").partition("..")
    return entry.built(
        PrintedElement,
        first=int(first, 16) if first else None,
        last=int(last, 16) if last else None,
    )


def _subindex(entry: Entry, type_name: str) -> Subindex:
    return entry.built(
        Subindex,
        indices=entry.whole_ranges("index") or Ranges(()),
        value=value(entry, type_name),
    )


def parameter_set(entry: Entry, reused: Reused) -> ParameterSet:
    """The set of parameters that an entry states."""
    defaults = _defaults(entry)
    type_name = entry.text("type")
    parameters = rows(entry, entry.path, defaults, reused, lambda inner: _parameter(inner, type_name), type_name)
    _refuse_idle_defaults(entry, [parameter.value for parameter in parameters])
    return entry.built(
        ParameterSet,
        space=entry.text("space") or entry.text("name"),
        numbers=entry.whole_ranges("numbers"),
        parameters=parameters,
    )


def _parameter(entry: Entry, type_name: str) -> Parameter:
    own_type = entry.text("type") or type_name
    return entry.built(
        Parameter,
        count=entry.integer("count") or 1,
        value=value(entry, type_name),
        subindices=tuple(_subindex(inner, own_type) for inner in entry.entries("subindices")),
        handling=entry.handling(),
    )


def _defaults(entry: Entry) -> Mapping | None:
    """The defaults for keys that rows do not have."""
    node = entry.node.values.get("defaults")
    return node if isinstance(node, Mapping) else None


def _refuse_idle_defaults(entry: Entry, values: Sequence[Value]) -> None:
    """Refuses the defaults that apply to the type of no row."""
    defaults = entry.entry("defaults")
    for key in defaults.own if defaults is not None and values else ():
        applies = _APPLICABLE.get(key)
        if defaults is not None and applies is not None and not any(applies(value) for value in values):
            text = f"`{key}` has no effect on the types of these rows"
            defaults.refuse("wrong_form", key, text, f"remove `{key}`, or correct the type")


def _is_text(value: Value) -> bool:
    return is_text(value.encoding)


def _has_length(value: Value) -> bool:
    return is_array(value.encoding) or bool(value.digits)


def _has_padding(value: Value) -> bool:
    return _is_text(value) or value.has_blanks


_APPLICABLE: dict[str, Callable[[Value], bool]] = {
    **dict.fromkeys(("encoding", "align", "terminator"), _is_text),
    "padding": _has_padding,
    "length": _has_length,
}
"""The keys of defaults that only values of some types have."""
