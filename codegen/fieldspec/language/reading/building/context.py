"""Shared by all builders: values of keys, citations, findings, and the reuse of objects between versions."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from decimal import Decimal
from functools import cache
from typing import Any, TypeAlias, TypeVar, cast

from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.source import Span
from fieldspec.language.diagnostics import Diagnostic, Label
from fieldspec.language.model.fact import Citation, Claim, Fact, Place, Report, ScalarValue, Standard
from fieldspec.language.model.ranges import Ranges, intervals, whole_intervals
from fieldspec.language.model.value import HANDLING_KEYS, UNSPECIFIED, Handling
from fieldspec.language.reading.building.citations import citations, common_section
from fieldspec.language.reading.nodes import CHECKED, Mapping, Node, Scalar, Sequence, exact, with_checked_keys

M = TypeVar("M")

_CLAIM_META = ("source", "doc")
_REPORT_META = ("by", "how")


def _real(bound: Decimal) -> float:
    """A bound as a whole number, or with a fraction as the nearest float."""
    return int(bound) if bound == int(bound) else float(bound)


class Entry:
    """A mapping of the tree with its path and what it inherits: the section and the sources around it.

    `stated` is the mapping as the tree has it, `node` the same with its checked keys among the others. `defaults` are
    keys of an enclosing group, for keys that are missing here.
    """

    __slots__ = ("defaults", "findings", "node", "own", "path", "section", "sources", "stated")

    def __init__(
        self,
        node: Mapping,
        path: str,
        findings: list[Diagnostic],
        section: str = "",
        sources: tuple[Citation, ...] = (),
        defaults: Mapping | None = None,
    ) -> None:
        self.stated = node
        if CHECKED in node.values:
            node = with_checked_keys(node)
        if defaults is not None and CHECKED in defaults.values:
            defaults = with_checked_keys(defaults)
        self.node, self.path, self.findings, self.defaults = node, path, findings, defaults
        self.own = own = node.values
        self.section, self.sources = section, sources
        if defaults is not None or "section" in own:
            self.section = self.text("section") or section
        if defaults is not None or "source" in own:
            cited = self.text("source")
            self.sources = citations(cited, self.section) if cited else sources
            if cited and not self.section:
                self.section = common_section(self.sources)

    def get(self, key: str) -> Node | None:
        """The node under a key, or the default for it."""
        node = self.own.get(key)
        if node is None and self.defaults is not None:
            node = self.defaults.values.get(key)
        return node

    def value(self, key: str) -> ScalarValue:
        """The typed value of a scalar, or None."""
        node = self.own.get(key)
        if node is None:
            if self.defaults is None:
                return None  # most keys of most entries: not to be asked for at length
            node = self.defaults.values.get(key)
        return node.value if isinstance(node, Scalar) else None

    def text(self, key: str) -> str:
        """A text, or an empty one."""
        node = self.own.get(key)
        if node is None:
            if self.defaults is None:
                return ""
            node = self.defaults.values.get(key)
        value = node.value if isinstance(node, Scalar) else None
        return value if isinstance(value, str) else ""

    def integer(self, key: str) -> int | None:
        """A whole number, or None."""
        value = self.value(key)
        return value if isinstance(value, int) and not isinstance(value, bool) else None

    def decimal(self, key: str) -> Decimal | None:
        """An exact number, or None."""
        value = self.value(key)
        return Decimal(value) if isinstance(value, int) else value if isinstance(value, Decimal) else None

    def flag(self, key: str) -> bool:
        """A truth value; false where the key is missing."""
        return self.value(key) is True

    def maybe(self, key: str) -> bool | None:
        """A truth value, or None where the key is missing."""
        value = self.value(key)
        return value if isinstance(value, bool) else None

    def texts(self, key: str) -> tuple[str, ...]:
        """A list of texts, or one text."""
        node = self.get(key)
        if isinstance(node, Sequence):
            return tuple(item.text for item in node.items if isinstance(item, Scalar))
        return (node.text,) if isinstance(node, Scalar) else ()

    def integers(self, key: str) -> tuple[int, ...]:
        """A list of whole numbers."""
        node = self.get(key)
        items = node.items if isinstance(node, Sequence) else ()
        return tuple(item.value for item in items if isinstance(item, Scalar) and isinstance(item.value, int))

    def scalars(self, key: str) -> tuple[int | str, ...]:
        """A list of whole numbers and texts."""
        node = self.get(key)
        items = node.items if isinstance(node, Sequence) else ()
        return tuple(item.value for item in items if isinstance(item, Scalar) and isinstance(item.value, int | str))

    def reasons(self, key: str) -> dict[str, str]:
        """A mapping of texts: the defaults, overridden by the entry's own keys."""
        reasons: dict[str, str] = {}
        for holder in (self.defaults, self.node):
            node = holder.values.get(key) if holder is not None else None
            if isinstance(node, Mapping):
                reasons |= {k: v.text for k, v in node.values.items() if isinstance(v, Scalar)}
        return reasons

    def entry(self, key: str) -> Entry | None:
        """The mapping under a key."""
        node = self.get(key)
        if not isinstance(node, Mapping):
            return None
        return Entry(node, f"{self.path}/{key}", self.findings, self.section, self.sources)

    def entries(self, key: str, name: str = "name", defaults: Mapping | None = None) -> Iterator[Entry]:
        """The mappings of the list under a key, each with its own path."""
        yield from self._list_items(self.get(key), f"{self.path}/{key}", name, defaults)

    def named(self, key: str, path: str, defaults: Mapping | None = None, name: str = "name") -> Iterator[Entry]:
        """The same, where paths leave out the key."""
        yield from self._list_items(self.node.values.get(key), path, name, defaults)

    def _list_items(self, node: Node | None, path: str, name: str, defaults: Mapping | None) -> Iterator[Entry]:
        for number, item in enumerate(node.items if isinstance(node, Sequence) else ()):
            if isinstance(item, Mapping):
                identifier = item.values.get(name)
                step = identifier.text if isinstance(identifier, Scalar) else str(number)
                yield Entry(item, f"{path}/{step}", self.findings, self.section, self.sources, defaults)

    def place(self) -> Place:
        """The place of this entry in the spec."""
        return Place(self.path, self.stated, self.own)

    def span(self, key: str) -> Span:
        """The span of a key's value, or of the name."""
        return self.place()[key]

    def refuse(self, code: str, key: str, message: str, help: str, *labels: Label) -> None:
        """Adds a finding at a key's value."""
        self.findings.append(Diagnostic(code, message, self.span(key), labels, help))

    def citations(self, key: str) -> tuple[Citation, ...]:
        """The places that a key cites."""
        return citations(self.text(key), self.section)

    def ranges(self, key: str) -> tuple[tuple[Decimal, Decimal], ...] | None:
        """The intervals under a key, as exact numbers."""
        node = self.get(key)
        return intervals(node.text) if isinstance(node, Scalar) else None

    def bit_range(self, key: str) -> tuple[int, int] | None:
        """The first and the last of adjacent bits, which may be one."""
        text = self.text(key)
        if not text:
            return None
        first, _, last = text.partition("..")
        low, high = int(first), int(last or first)
        if high < low:
            self.refuse("wrong_form", key, f"`{key}` ends before it starts", f"write {high}..{low}")
        return min(low, high), max(low, high)

    def whole_ranges(self, key: str) -> Ranges | None:
        """The intervals under a key, whose bounds must be whole numbers."""
        node = self.get(key)
        if not isinstance(node, Scalar):
            return None
        numbers = whole_intervals(node.text)
        if numbers is not None and all(low <= high for low, high in numbers):
            return Ranges(tuple(sorted(numbers)))
        whole = tuple((int(low), int(high)) for low, high in intervals(node.text))
        if numbers is None:
            # A bound such as 3000.0 is a quantity, even where it is a whole number.
            self.refuse(
                "wrong_form", key, "a bound is not a whole number", "raw values are whole numbers; use `unit_range`"
            )
        elif any(low > high for low, high in whole):
            self.refuse("wrong_form", key, "an interval ends before it starts", "write the lower bound first")
        return Ranges(tuple(sorted(whole)))

    def real_ranges(self, key: str) -> Ranges | None:
        """The intervals under a key of a floating-point value, whose bounds may have a fraction."""
        node = self.get(key)
        if not isinstance(node, Scalar):
            return None
        bounds = tuple(sorted((_real(low), _real(high)) for low, high in intervals(node.text)))
        if any(low > high for low, high in bounds):
            self.refuse("wrong_form", key, "an interval ends before it starts", "write the lower bound first")
        return Ranges(cast("tuple[tuple[int, int], ...]", bounds))

    def fact(self) -> dict[str, Any]:
        """The arguments that every fact of the model takes."""
        arguments = _ABSENT.copy()
        arguments["place"] = self.place()
        arguments["sources"] = self.sources
        # Most facts have few of these keys, so that their own keys are gone through instead.
        for holder in (self.node,) if self.defaults is None else (self.defaults, self.node):
            values = holder.values
            for key in values:
                if key in _FACT:
                    argument, read, _ = _FACT[key]
                    arguments[argument] = read(self, key)
        return arguments

    def built(self, model: type[M], **stated: Any) -> M:
        """An object of the model: what is not stated here is under the keys with the names of its attributes."""
        arguments = self.fact() if issubclass(model, Fact) else {}
        absent, readers, places = _keys_of(model.__mro__)
        arguments |= absent
        for name in places:
            arguments[name] = self.place() if name == "place" else self.sources
        for holder in (self.node,) if self.defaults is None else (self.defaults, self.node):
            for key in holder.values.keys() & readers.keys():
                arguments[key] = readers[key](self, key)
        return model(**arguments | stated)

    def handling(self) -> Handling:
        """The handling of the value."""
        if self.defaults is None and self.own.keys().isdisjoint(HANDLING_KEYS):
            return UNSPECIFIED
        endurance = self.value("endurance")
        return self.built(Handling, endurance="" if endurance is None else str(endurance))

    def claims(self, key: str) -> tuple[Claim, ...]:
        """The statements of other places of the manual about a fact."""
        return tuple(
            Claim(
                entry.place(),
                entry.sources,
                {key: _claimed(value) for key, value in entry.node.values.items() if key not in _CLAIM_META},
            )
            for entry in self.entries(key)
        )

    def standards(self, key: str) -> dict[str, Standard]:
        """The standards that give keys of a fact; first from the defaults, overridden by the entry's own keys."""
        standards: dict[str, Standard] = {}
        for holder in (self.defaults, self.node):
            node = holder.values.get(key) if holder is not None else None
            for name, inner in node.values.items() if isinstance(node, Mapping) else ():
                if isinstance(inner, Mapping):
                    entry = Entry(inner, f"{self.path}/{key}/{name}", self.findings)
                    standards[name] = entry.built(Standard)
        return standards

    def reports(self, key: str) -> tuple[Report, ...]:
        """The reports of others about a fact."""
        return tuple(
            entry.built(
                Report,
                values={key: _claimed(value) for key, value in entry.node.values.items() if key not in _REPORT_META},
            )
            for entry in self.entries(key, "")
        )


_READERS: dict[str, tuple[Callable[[Entry, str], object], object]] = {
    "str": (Entry.text, ""),
    "tuple[str, ...]": (Entry.texts, ()),
    "bool": (Entry.flag, False),
    "bool | None": (Entry.maybe, None),
    "int": (lambda entry, key: entry.integer(key) or 0, 0),
    "int | None": (Entry.integer, None),
    "tuple[int, ...]": (Entry.integers, ()),
    "Decimal | None": (Entry.decimal, None),
}
"""How attributes of these types are read, and what they are where the key is not given."""


@cache
def _keys_of(
    classes: tuple[type, ...],
) -> tuple[dict[str, object], dict[str, Callable[[Entry, str], object]], tuple[str, ...]]:
    """What attributes are without keys, how their keys are read, and which say where an entry is.

    `classes` are a class and all that it extends. The attributes of every fact are left out.
    """
    bases = [base for base in classes if base not in Fact.__mro__]
    types = {name: kind for base in bases for name, kind in vars(base).get("__annotations__", {}).items()}
    read = {name: _READERS[kind] for name, kind in types.items() if kind in _READERS}
    places = tuple(name for name in ("place", "sources") if name in types)
    return {name: own[1] for name, own in read.items()}, {name: own[0] for name, own in read.items()}, places


_FACT: dict[str, tuple[str, Callable[[Entry, str], object], object]] = {
    "name": ("name", Entry.text, ""),
    "printed_name": ("printed_name", Entry.text, ""),
    "label": ("label", Entry.text, ""),
    "doc": ("doc", Entry.text, ""),
    "notes": ("notes", Entry.texts, ()),
    "inferred": ("inferred", Entry.reasons, {}),
    "standard": ("standard", Entry.standards, {}),
    "reported": ("reported", Entry.reports, ()),
    "unverified": ("unverified", Entry.flag, False),
    "allow": ("allowed", Entry.reasons, {}),
    "restated": ("restated", Entry.claims, ()),
    "roles": ("roles", Entry.texts, ()),
    "since": ("since", Entry.texts, ()),
    "until": ("until", Entry.texts, ()),
    "only": ("only", Entry.texts, ()),
}
"""The keys of a fact: the argument of the model, how it is read, and what it is where the key is not given."""

_ABSENT: dict[str, Any] = {argument: absent for argument, _, absent in _FACT.values()}


def _claimed(node: Node) -> ScalarValue:
    """The text of a claim under a key; a list of names is one text."""
    if isinstance(node, Sequence):
        return ", ".join(item.text for item in node.items if isinstance(item, Scalar))
    return node.value if isinstance(node, Scalar) else None


def free(node: Node | None) -> dict[str, object]:
    """A mapping of free form as plain data."""
    data = exact(node) if node is not None else {}
    return data if isinstance(data, dict) else {}


Item = TypeVar("Item")

Reused: TypeAlias = dict[object, ByIdentity[object, object]]
"""Built objects by everything that they depend on except their own node, and then by this node."""


def rows(
    entry: Entry,
    path: str,
    defaults: Mapping | None,
    reused: Reused,
    build: Callable[[Entry], Item],
    *dependencies: object,
    key: str = "rows",
) -> tuple[Item, ...]:
    """The objects of the rows of an entry, each under a path with its name; they depend on `dependencies` too."""
    by_defaults = reused.setdefault((path, entry.section, entry.sources, *dependencies), ByIdentity())
    same = cast("ByIdentity[object, object]", by_defaults.get_or_compute(defaults, lambda _: ByIdentity()))
    return reused_items(entry, key, path, "name", defaults, same, build)


def reused_items(
    entry: Entry,
    key: str,
    path: str,
    name: str,
    defaults: Mapping | None,
    same: ByIdentity[object, object],
    build: Callable[[Entry], Item],
) -> tuple[Item, ...]:
    """The objects of the list under a key of an entry; `same` has those that other versions have built."""
    sequence = entry.node.values.get(key)
    items: list[Item] = []
    for number, item in enumerate(sequence.items if isinstance(sequence, Sequence) else ()):
        if not isinstance(item, Mapping):
            continue
        if item in same:
            items.append(cast("Item", same[item]))
            continue
        name_node = item.values.get(name)
        step = name_node.text if isinstance(name_node, Scalar) else str(number)
        quiet = len(entry.findings)
        result = build(Entry(item, f"{path}/{step}", entry.findings, entry.section, entry.sources, defaults))
        items.append(result)
        if isinstance(name_node, Scalar) and len(entry.findings) == quiet:  # a finding is for every version
            same[item] = result
    return tuple(items)
