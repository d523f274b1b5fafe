"""Pairs the objects of two versions of a device, and keeps the pairs that differ, with the offsets of their fields."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import pairwise
from typing import Any, Generic, TypeVar, cast

from fieldspec.foundation.classes import dataclass
from fieldspec.language.changes.attributes import CONTENTS, OWN_VALUES
from fieldspec.language.changes.evidence import EVIDENCE, Surroundings
from fieldspec.language.model.attributes import MODEL_CLASSES
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Place
from fieldspec.language.model.link import Part
from fieldspec.language.model.record import Field
from fieldspec.language.model.sizes import RecordSizes, part_size
from fieldspec.language.model.value import Value

# Every list is paired by name in one pass, so the time grows with the size of the device and not faster.

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Pair(Generic[T]):
    """The same object in both devices, and the objects that contain it there."""

    old: T
    new: T
    containers: tuple[Any, Any]


@dataclass(frozen=True, slots=True)
class ValuePair:
    """The value of an object in both devices. The object is reserved in both, or in neither of them."""

    of: Pair[Any]
    old: Value
    new: Value

    @property
    def reserved(self) -> bool:
        """Whether the value has no meaning."""
        return bool(getattr(self.of.new, "reserved", False))


@dataclass(frozen=True, slots=True)
class FieldLists:
    """The fields of a record or of a message, or the parts of a frame, in both devices.

    `direction` is empty for a record. `moved` are the pairs of fields with a meaning whose offsets differ, with both
    offsets. `sizes` are the sizes in bytes, each with whether the fields go on to the end of the data.
    """

    containers: tuple[Any, Any]
    direction: str
    moved: tuple[tuple[Any, Any, str, str], ...]
    sizes: tuple[tuple[int, bool], tuple[int, bool]]

    @property
    def offsets_equal(self) -> bool:
        """Whether all fields with a meaning are at the same offsets, and the size is the same."""
        return not self.moved and self.sizes[0] == self.sizes[1]


@dataclass(frozen=True, slots=True)
class Unpaired:
    """An object that only one device has. `fields` are the lists that a field or a part of a frame belongs to."""

    item: Any
    containers: tuple[Any, Any]
    fields: FieldLists | None


@dataclass(frozen=True, slots=True)
class Rename:
    """The same object by another name, and what shows that it is the same."""

    pair: Pair[Any]
    evidence: str


class Comparison:
    """The pairs of corresponding objects in two versions of a device, and the objects that only one version has.

    `renames` are the new paths of objects that the spec itself renames, by their old paths. `reserved_changes` are the
    pairs of which one object has a meaning and the other is reserved; nothing else in them can be compared.
    """

    def __init__(self, old: Device, new: Device, renames: Mapping[str, str] | None = None) -> None:
        self.old, self.new = old, new
        self._renames = renames or {}
        self.added: list[Unpaired] = []
        self.removed: list[Unpaired] = []
        self.renamed: list[Rename] = []
        self.reserved_changes: list[Pair[Any]] = []
        self.field_lists: list[FieldLists] = []
        self._pairs: dict[type, list[Pair[Any]]] = {model_class: [] for model_class in CONTENTS}
        self._names: dict[str, str] = {}
        self._sides = _Side(old), _Side(new)
        self._add(Device, Pair(old, new, (None, None)))

    def of(self, model_class: type[T]) -> list[Pair[T]]:
        """The pairs of a class of the model whose own attributes differ."""
        return cast("list[Pair[T]]", self._pairs[model_class])

    def any_of(self, *model_classes: type) -> Iterator[Pair[Any]]:
        """The pairs of several classes of the model whose own attributes differ."""
        for model_class in model_classes:
            yield from self._pairs[model_class]

    def renamed_to(self, path: str, name: str) -> str:
        """The new name of what has an old name below a path of the old device, such as a section or a record."""
        return self._names.get(f"{path}/{name}", name)

    def renamed_path(self, path: str) -> str:
        """The path in the new device of what has a path in the old one."""
        old, new = "", []
        for step in path.split("/"):
            new.append(self.renamed_to(old, step) if old else step)
            old = f"{old}/{step}" if old else step
        return "/".join(new)

    @property
    def values(self) -> list[ValuePair]:
        """The values that differ, without values of reserved objects."""
        return [pair for pair in self.all_values if not pair.reserved]

    @cached_property
    def all_values(self) -> list[ValuePair]:
        """The values that differ. A value that a field takes from its signal differs only in the signal."""
        differences = []
        for model_class, pairs in self._pairs.items():
            for pair in pairs:
                old, new = getattr(pair.old, "value", None), getattr(pair.new, "value", None)
                if (
                    isinstance(old, Value)
                    and isinstance(new, Value)
                    and old != new
                    and not self._belongs_to_signal(model_class, pair)
                ):
                    differences.append(ValuePair(pair, old, new))
        return differences

    def _belongs_to_signal(self, model_class: type, pair: Pair[Any]) -> bool:
        """Whether the difference of a field's value is that of its signal."""
        if model_class is not Field or not pair.old.signal or not pair.new.signal:
            return False
        old, new = self.old.signals.get(pair.old.signal), self.new.signals.get(pair.new.signal)
        return old is not None and new is not None and (old.value, new.value) == (pair.old.value, pair.new.value)

    def _add(self, model_class: type, pair: Pair[Any]) -> None:
        """Keeps a pair if it differs, and pairs its contents."""
        if pair.old is pair.new and not CONTENTS[model_class]:
            return
        if getattr(pair.old, "reserved", False) != getattr(pair.new, "reserved", False):
            self.reserved_changes.append(pair)
        elif OWN_VALUES[model_class](pair.old) != OWN_VALUES[model_class](pair.new):
            self._pairs[model_class].append(pair)
        for inner_class, objects, direction in CONTENTS[model_class]:
            self._match(
                inner_class, tuple(objects(pair.old)), tuple(objects(pair.new)), (pair.old, pair.new), direction
            )

    def _match(
        self, model_class: type, old: Sequence[Any], new: Sequence[Any], containers: tuple[Any, Any], direction: str
    ) -> None:
        """Pairs two lists: by key, then by evidence."""
        has_offsets = model_class in (Field, Part)
        if not old and not new and not has_offsets:
            return
        old_by_key, new_by_key = _by_key(model_class, old), _by_key(model_class, new)
        pairs = [Pair(item, new_by_key[key], containers) for key, item in old_by_key.items() if key in new_by_key]
        removed = [item for key, item in old_by_key.items() if key not in new_by_key]
        added = [item for key, item in new_by_key.items() if key not in old_by_key]
        offsets = [
            _Offsets(side.sizes, items) if has_offsets else side.no_offsets
            for side, items in zip(self._sides, (old, new), strict=True)
        ]
        stated = list(self._stated(removed, added, containers)) if self._renames else []
        if stated:
            for pair in stated:
                pairs.append(pair)
                self._rename(model_class, pair, "the new name that its version states")
            stated_items = {id(item) for pair in stated for item in (pair.old, pair.new)}
            removed = [item for item in removed if id(item) not in stated_items]
            added = [item for item in added if id(item) not in stated_items]
        if removed and added:
            surroundings = [
                Surroundings(item_offsets.by_identity, side.places_of_signals())
                for item_offsets, side in zip(offsets, self._sides, strict=True)
            ]
            for pair, evidence in _proven(model_class, removed, added, surroundings[0], surroundings[1], containers):
                pairs.append(pair)
                self._rename(model_class, pair, evidence)
            paired = {id(item) for pair in pairs for item in (pair.old, pair.new)}
            removed = [item for item in removed if id(item) not in paired]
            added = [item for item in added if id(item) not in paired]
        fields = None
        if has_offsets:
            fields = _field_lists(pairs, offsets[0], offsets[1], containers, direction)
            self.field_lists.append(fields)
        self.removed += (Unpaired(item, containers, fields) for item in removed)
        self.added += (Unpaired(item, containers, fields) for item in added)
        for pair in pairs:
            self._add(model_class, pair)

    def _stated(self, removed: list[Any], added: list[Any], containers: tuple[Any, Any]) -> Iterator[Pair[Any]]:
        """The pairs of an object and the one whose name the spec gives it."""
        by_path = {place(item, self.new).path: item for item in added}
        for item in removed:
            new = by_path.get(self._renames.get(place(item, self.old).path, ""))
            if new is not None:
                yield Pair(item, new, containers)

    def _rename(self, model_class: type, pair: Pair[Any], evidence: str) -> None:
        path = place(pair.old, self.old).path.rpartition("/")[0]
        key = MODEL_CLASSES[model_class].key
        self._names[f"{path}/{key(pair.old)}"] = str(key(pair.new))
        is_reserved = getattr(pair.old, "reserved", False) or getattr(pair.new, "reserved", False)
        if not is_reserved:  # nobody uses the name of a reserved object
            self.renamed.append(Rename(pair, evidence))


class _Side:
    """One of the two devices, its sizes, and where it uses its signals."""

    def __init__(self, device: Device) -> None:
        self.device, self.sizes = device, RecordSizes(device)
        self.no_offsets = _Offsets(self.sizes, ())
        self._places: dict[str, tuple[str, ...]] | None = None

    def places_of_signals(self) -> Mapping[str, tuple[str, ...]]:
        """By signal, the places of the fields that carry it."""
        if self._places is None:
            places: dict[str, list[str]] = {}
            for message in self.device.messages.values():
                for direction, record in (("request", message.request), ("response", message.response)):
                    for number, field in enumerate(record.fields):
                        if field.signal:
                            places.setdefault(field.signal, []).append(f"{message.name}/{direction}/{number}")
            self._places = {name: tuple(of_signal) for name, of_signal in places.items()}
        return self._places


class _Offsets:
    """The offsets of fields, or of parts of a frame, by their identity in memory, and their size.

    An offset is a run and a number of bytes: a frame has one run before its body, and one from there on; fields have
    one up to each choice and each list that extends to the end or that another field measures, and one after the last.
    """

    def __init__(self, sizes: RecordSizes, items: Sequence[Any]) -> None:
        ends = [position for number, item in enumerate(items) if (position := _end_of_run(number, item)) is not None]
        lists = [items[end - 1].name for end in ends if end and isinstance(items[end - 1], Field)]
        self.lists = ["", *lists]
        self.by_identity: dict[int, tuple[int, int]] = {}
        size, is_open = 0, False
        for run, run_items in enumerate(items[start:end] for start, end in pairwise([0, *ends, len(items)])):
            offsets = field_offsets(sizes, run_items)
            self.by_identity |= {
                id(item): (run, position) for item, position in zip(run_items, offsets.offsets, strict=True)
            }
            size, is_open = size + offsets.size, is_open or offsets.is_open
        self.size = size, is_open

    def text(self, item: Any) -> str:
        """The offset of a field or a part: `4`, or `0 after samples`."""
        run, offset = self.by_identity[id(item)]
        return f"{offset} after {self.lists[run]}" if 0 < run < len(self.lists) else str(offset)


def _end_of_run(index: int, item: Any) -> int | None:
    """Where the first run ends, if it does so at an item: before the body of a frame, and after a list."""
    if isinstance(item, Part):
        return index if item.role == "body" else None
    return index + 1 if isinstance(item, Field) and (item.repeat is not None or item.choice is not None) else None


def _field_lists(
    pairs: Iterable[Pair[Any]], old: _Offsets, new: _Offsets, containers: tuple[Any, Any], direction: str
) -> FieldLists:
    moved = [
        (pair.old, pair.new, *_apart(old, new, pair))
        for pair in pairs
        if old.by_identity[id(pair.old)] != new.by_identity[id(pair.new)] and not getattr(pair.new, "reserved", False)
    ]
    return FieldLists(containers, direction, tuple(moved), (old.size, new.size))


def _apart(old: _Offsets, new: _Offsets, pair: Pair[Any]) -> tuple[str, str]:
    """The offsets of a field that has moved, as two texts that differ."""
    before, after = old.text(pair.old), new.text(pair.new)
    if before != after:
        return before, after
    runs = old.by_identity[id(pair.old)][0], new.by_identity[id(pair.new)][0]
    before, after = (f"{before} {'after' if run else 'before'} the body" for run in runs)
    return before, after


def fields_beside(field: Field, device: Device) -> tuple[Field, ...]:
    """All fields of the record or of the message that contains a field."""
    section, _, path = field.place.path.rpartition("/")[0].partition("/")
    if section == "records" and path in device.records:
        return device.records[path].fields
    message = device.messages.get(path.rpartition("/")[0])
    if message is None:
        return ()
    return message.request.fields if path.endswith("/request") else message.response.fields


def place(item: Any, device: Device) -> Place:
    """The place of an object, or that of the device for an object without its own."""
    own = getattr(item, "place", None)
    return own if isinstance(own, Place) else device.place


def _by_key(model_class: type, items: Iterable[Any]) -> dict[Hashable, Any]:
    """Objects by key. A key that occurs again is completed by a number."""
    key = MODEL_CLASSES[model_class].key
    items_by_key: dict[Hashable, Any] = {}
    for item in items:
        own = key(item)
        if own in items_by_key:
            own = (own, len(items_by_key))
        items_by_key[own] = item
    return items_by_key


def _proven(
    model_class: type,
    removed: list[Any],
    added: list[Any],
    old_surroundings: Surroundings,
    new_surroundings: Surroundings,
    containers: tuple[Any, Any],
) -> Iterator[tuple[Pair[Any], str]]:
    """The pairs that evidence proves: the two share data that no other removed or added object has."""
    evidence = EVIDENCE.get(model_class)
    if evidence is None:
        return
    old = [(evidence.of(item, old_surroundings), item) for item in removed]
    new = [(evidence.of(item, new_surroundings), item) for item in added]
    once_new = {key for key, count in Counter(key for key, _ in new).items() if count == 1 and key is not None}
    once_old = {key for key, count in Counter(key for key, _ in old).items() if count == 1}
    added_by_key = dict(new)
    for key, item in old:
        if key in once_new and key in once_old:
            yield Pair(item, added_by_key[key], containers), evidence.describe(item, old_surroundings)


@dataclass(frozen=True, slots=True)
class FieldOffsets:
    """The offsets of fields in bytes, in their order, and their size. `is_open` if the last one repeats to the end."""

    offsets: tuple[int, ...]
    size: int
    is_open: bool


def field_offsets(sizes: RecordSizes, fields: Sequence[Field | Part]) -> FieldOffsets:
    """The offsets of the fields of a record or of a message, or of the parts of a frame."""
    offsets = []
    offset = 0
    for field in fields:
        offsets.append(offset)
        offset += part_size(field) if isinstance(field, Part) else _field_size(sizes, field)
    return FieldOffsets(tuple(offsets), offset, any(isinstance(f, Field) and f.repeat is not None for f in fields))


def _field_size(sizes: RecordSizes, field: Field) -> int:
    """The bytes of a field, the fewest where they vary; 0 where nothing decides them.

    It is 0 as well for a choice and for a field that repeats: these are last in their run, and move no field of it.
    """
    if field.choice is not None or field.repeat is not None:
        return 0
    bounds = sizes.field(field)
    return bounds[0] if bounds is not None else 0
