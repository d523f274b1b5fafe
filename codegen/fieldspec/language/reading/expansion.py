"""Expands what a spec states once and places several times: block copies, signals, derived enums, bits of registers."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import replace
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.model.value import HANDLING_KEYS
from fieldspec.language.reading.findings import near, quoted
from fieldspec.language.reading.nodes import CHECKED, Mapping, Node, Scalar, Sequence, identity, mappings
from fieldspec.language.schema import schema

_FACT = frozenset(schema()["$defs"]["fact"]["properties"])
_VALUE = frozenset(schema()["$defs"]["value"]["properties"])
_WORDS = frozenset(schema()["$defs"]["flags"]["properties"]["type"]["enum"])
# The keys that a field takes from its signal, and a register from its original.
_OF_SIGNAL = _VALUE | {"name", "printed_name", "label", "doc"}
_NOT_COPIED = (_FACT - {"since", "until", "only", "inferred", "unverified", "doc"}) | {
    *HANDLING_KEYS,  # a copy is in a memory of its own
    "at",
    "number",
    "access",
    "trigger",
    "restart",
    "same_as",
    "element_sources",
}
_OF_COPY = frozenset({"prefix", "base", "rows", "access", "trigger", "memory", "inferred"})


def expanded(tree: Mapping) -> tuple[Mapping, list[Diagnostic]]:
    """The tree with copies, signals, derived enums and bits of registers expanded."""
    tree, findings = _with_bit_fields(tree)
    work = _Expansion(tree)
    for section, change in (
        ("enums", work.enum),
        ("messages", work.message),
        ("records", work.record),
    ):
        facts = tree.values.get(section)
        if isinstance(facts, Sequence):
            tree = tree.with_value(section, _change_each(facts, change))
    groups = tree.values.get("registers")
    if isinstance(groups, Sequence):
        items = [item for group in groups.items for item in (group, *work.copies(group))]
        tree = tree.with_value("registers", replace(groups, items=tuple(items)))
    return tree, findings + work.findings


def _with_bit_fields(tree: Mapping) -> tuple[Mapping, list[Diagnostic]]:
    """The tree with a bit field for each register that states its bits in place; it has the name of the register."""
    findings: list[Diagnostic] = []
    bit_fields: list[Mapping] = []

    def with_bit_fields(group: Mapping) -> Mapping:
        rows = group.values.get("rows")
        if not isinstance(rows, Sequence) or not any("bits" in row.values for row in mappings(rows)):
            return group
        return group.with_value("rows", _change_each(rows, lambda row: _named(group, row, bit_fields, findings)))

    groups, shared = tree.values.get("registers"), tree.values.get("flags")
    if isinstance(groups, Sequence):
        tree = tree.with_value("registers", _change_each(groups, with_bit_fields))
    if bit_fields:
        items = (*(shared.items if isinstance(shared, Sequence) else ()), *bit_fields)
        tree = tree.with_value("flags", Sequence(tree.file, tree.start, tree.end, items))
    return tree, findings


def _named(group: Mapping, row: Mapping, bit_fields: list[Mapping], findings: list[Diagnostic]) -> Mapping:
    """A register that names its bits; where it states them in place, they are added to `bit_fields`."""
    if "bits" not in row.values:
        return row
    defaults = group.values.get("defaults")
    stated = row.values.get("type") or (defaults.values.get("type") if isinstance(defaults, Mapping) else None)
    bits, name = row.values["bits"], _scalar(row, "name")
    if "flags" in row.values:
        text, help = "`flags` names the bits already", "remove `flags`, or remove `bits`"
        findings.append(Diagnostic("wrong_form", text, bits.span, help=help))
    elif isinstance(stated, Scalar) and stated.text not in _WORDS:
        text = f"a register of the type {stated.text} has no bits"
        findings.append(Diagnostic("wrong_form", text, bits.span, help="state an unsigned type, or remove `bits`"))
    elif isinstance(stated, Scalar):
        bit_field = Mapping(row.file, row.start, row.end, {}).with_value("name", name).with_value("type", stated)
        for key in ("source", "since", "until", "only", "bits"):
            bit_field = bit_field.with_value(key, row.values[key]) if key in row.values else bit_field
        if "section" in group.values:
            bit_field = bit_field.with_value("section", group.values["section"])
        bit_fields.append(bit_field)
        row = row.with_value("flags", _scalar_like(name, name.text))
    return row.without("bits")


class _Expansion:
    """Expands one tree. References to nothing become findings."""

    def __init__(self, tree: Mapping) -> None:
        self.findings: list[Diagnostic] = []
        self.signals = _mappings_by_name(tree.values.get("signals"))
        self.flags = _mappings_by_name(tree.values.get("flags"))
        self.enums = _mappings_by_name(tree.values.get("enums"))

    def message(self, message: Mapping) -> Mapping:
        """The message, with the keys of signals in the fields that place them."""
        self._refuse_separator(message, "request", "response")
        for direction in ("request", "response"):
            message = self._placed(message, direction)
        return message

    def record(self, record: Mapping) -> Mapping:
        """The record, with the keys of signals in the fields that place them."""
        self._refuse_separator(record, "fields")
        return self._placed(record, "fields")

    def _refuse_separator(self, holder: Mapping, *keys: str) -> None:
        """Adds a finding for a separator where no version has two fields that it could separate."""
        stated = holder.values.get("separator")
        counts = [len(fields.items) for key in keys if isinstance(fields := holder.values.get(key), Sequence)]
        if isinstance(stated, Scalar) and max(counts, default=0) < 2:
            text = "there are no two fields that a separator could be between"
            self.findings.append(Diagnostic("keys_have_effect", text, stated.span, help="remove it"))

    def _placed(self, holder: Mapping, key: str) -> Mapping:
        fields = holder.values.get(key)
        return holder.with_value(key, _change_each(fields, self._field)) if isinstance(fields, Sequence) else holder

    def _field(self, field: Mapping) -> Mapping:
        name = field.values.get("signal")
        signal = self._known(name, self.signals, "signal")
        if signal is None:
            return field
        for key, value in signal.values.items():
            if key in _OF_SIGNAL and key not in field.values:
                field = field.with_value(key, value)
        return field

    def enum(self, enum: Mapping) -> Mapping:
        """An enum with the members that follow from a bit field or from another enum."""
        derived = enum.values.get("derived")
        if not isinstance(derived, Mapping):
            return enum
        own = enum.values.get("members")
        members: list[Node] = list(own.items) if isinstance(own, Sequence) else []
        if flags := self._known(derived.values.get("flags"), self.flags, "bit field"):
            members += _masks(flags)
        if other := self._known(derived.values.get("enum"), self.enums, "enum"):
            numbers = [*_numbers(other)]
            members += numbers
            if not numbers:
                name = _scalar(derived, "enum")
                text = f"no member of {quoted(name.text)} has a `number`, so that none follows from it"
                help = "name the enum whose members have numbers, or list the members"
                self.findings.append(Diagnostic("wrong_form", text, name.span, help=help))
        return enum.with_value("members", Sequence(derived.file, derived.start, derived.end, tuple(members)))

    def copies(self, group: Node) -> Iterator[Mapping]:
        """The groups that copy the registers of a group."""
        copies = group.values.get("copies") if isinstance(group, Mapping) else None
        for copy in copies.items if isinstance(copies, Sequence) else ():
            if isinstance(group, Mapping) and isinstance(copy, Mapping):
                yield self._copy(group, copy)

    def _copy(self, group: Mapping, copy: Mapping) -> Mapping:
        group_rows = group.values.get("rows")
        originals = (
            [row for row in group_rows.items if isinstance(row, Mapping)] if isinstance(group_rows, Sequence) else []
        )
        prints = self._prints(copy, _mappings_by_name(group_rows))
        prefix, base = _scalar(copy, "prefix").text, _scalar(copy, "base")
        first = _integer(originals[0].values.get("at")) if originals else 0
        rows = []
        for original in originals:
            name = identity(original) or ""
            printed = prints.get(name, {})
            row = Mapping(copy.file, copy.start, copy.end, {})
            if printed:
                printed_node = next(iter(printed.values()))
                row = replace(row, start=printed_node.start, end=printed_node.end)
            for key, value in original.values.items():
                if key not in _NOT_COPIED:
                    row = row.with_value(key, value)
            address = _integer(original.values.get("at")) - first + _integer(base)
            row = row.with_value("name", _scalar_like(base, f"{prefix}_{name}"))
            row = row.with_value("copy_of", _scalar_like(base, name))
            row = row.with_value("at", _scalar_like(base, address))
            for key in ("access", "trigger", "inferred"):
                inherited = copy.values.get(key) or original.values.get(key)
                if inherited is not None:
                    row = row.with_value(key, inherited)
            if "memory" in copy.values:
                row = row.with_value("memory", copy.values["memory"])
            for key, value in {**printed, **_checked_of_copy(original, printed)}.items():
                row = row.with_value(key, value)
            rows.append(row)
        result = copy
        for key in _OF_COPY & result.values.keys():
            result = result.without(key)
        for key in ("defaults", "order", "allow", "space"):
            if key in group.values:
                result = result.with_value(key, group.values[key])
        result = (
            result.with_value("defaults", _elsewhere(result.values["defaults"]))
            if "defaults" in result.values
            else result
        )
        return result.with_value("rows", Sequence(copy.file, copy.start, copy.end, tuple(rows)))

    def _prints(self, copy: Mapping, originals: dict[str, Mapping]) -> dict[str, dict[str, Node]]:
        """The printed details of each register of a copy, by the name of its original."""
        prints: dict[str, dict[str, Node]] = {}
        printed_rows = copy.values.get("rows")
        for row in printed_rows.items if isinstance(printed_rows, Sequence) else ():
            if isinstance(row, Mapping) and self._known(row.values.get("of"), originals, "register in this group"):
                name = _scalar(row, "of").text
                prints[name] = {key: value for key, value in row.values.items() if key != "of"}
        return prints

    def _known(self, name: Node | None, known: dict[str, Mapping], kind: str) -> Mapping | None:
        """The mapping that a reference names; one that names nothing is a finding."""
        if not isinstance(name, Scalar):
            return None
        if name.text not in known:
            text = f"there is no {kind} `{name.text}`"
            self.findings.append(Diagnostic("references_resolve", text, name.span, help=near(name.text, known)))
        return known.get(name.text)


def _checked_of_copy(original: Mapping, printed: dict[str, Node]) -> dict[str, Node]:
    """The numbers to compare for the copy of a register: the words of its original, and those printed for the copy."""
    stated = [node for node in (original.values.get(CHECKED), printed.get(CHECKED)) if isinstance(node, Mapping)]
    if not stated:
        return {}
    checked = stated[0].without("decimal") if stated[0] is original.values.get(CHECKED) else stated[0]
    for key, value in stated[-1].values.items() if len(stated) > 1 else ():
        checked = checked.with_value(key, value)
    return {CHECKED: checked} if checked.values else {}


def _elsewhere(defaults: Node) -> Node:
    """The defaults of a group, for rows that are in another memory."""
    for key in sorted(defaults.values.keys() & HANDLING_KEYS) if isinstance(defaults, Mapping) else ():
        assert isinstance(defaults, Mapping)
        defaults = defaults.without(key)
    return defaults


def _change_each(items: Sequence, change: object) -> Sequence:
    assert callable(change)
    return replace(items, items=tuple(change(item) if isinstance(item, Mapping) else item for item in items.items))


def _mappings_by_name(items: Node | None) -> dict[str, Mapping]:
    """The mappings of a list by name."""
    nodes = items.items if isinstance(items, Sequence) else ()
    return {name: item for item in nodes if isinstance(item, Mapping) and (name := identity(item)) is not None}


def _masks(flags: Mapping) -> Iterator[Mapping]:
    """A member for each bit that has a name: its value is the mask, whichever end the manual counts the bits from."""
    bits, bit_0 = flags.values.get("bits"), flags.values.get("bit_0")
    highest = int(_scalar(flags, "type").text[1:]) - 1 if isinstance(bit_0, Scalar) and bit_0.text == "most" else None
    for bit in bits.items if isinstance(bits, Sequence) else ():
        if not isinstance(bit, Mapping) or "name" not in bit.values or "bit" not in bit.values:
            continue
        if isinstance(reserved := bit.values.get("reserved"), Scalar) and reserved.value is True:
            continue
        number = bit.values["bit"]
        place = _integer(number) if highest is None else highest - _integer(number)
        yield _member(bit, _scalar_like(number, 1 << max(place, 0)))


def _numbers(enum: Mapping) -> Iterator[Mapping]:
    """A member for each member that has a number: its value is that number."""
    members = enum.values.get("members")
    for member in members.items if isinstance(members, Sequence) else ():
        if isinstance(member, Mapping) and "number" in member.values:
            yield _member(member, member.values["number"])


def _member(bit: Mapping, value: Node) -> Mapping:
    member = Mapping(bit.file, bit.start, bit.end, {})
    for key in ("name", "printed_name", "label", "doc", "source", "since", "until", "only"):
        if key in bit.values:
            member = member.with_value(key, bit.values[key])
    return member.with_value("value", value)


def _scalar(mapping: Mapping, key: str) -> Scalar:
    scalar = mapping.values[key]
    assert isinstance(scalar, Scalar)
    return scalar


def _integer(node: Node | None) -> int:
    return node.value if isinstance(node, Scalar) and isinstance(node.value, int) else 0


def _scalar_like(node: Node, value: ScalarValue) -> Scalar:
    """A scalar at the place of another node."""
    return Scalar(node.file, node.start, node.end, str(value), False, value)
