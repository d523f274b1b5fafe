"""Pairs the items of two versions of a device, and compares their values and field offsets."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterable, Iterator, Sequence
from functools import cached_property
from typing import Any, Generic, TypeVar, cast

from fieldspec.changes.attributes import DEVICE_ATTRIBUTES, MODEL_CLASSES
from fieldspec.changes.evidence import EVIDENCE, Around
from fieldspec.classes import dataclass
from fieldspec.model.device import Device
from fieldspec.model.fact import Place
from fieldspec.model.link import CHECKSUM_SIZES, Part
from fieldspec.model.record import Field
from fieldspec.model.value import Value


@dataclass(frozen=True, slots=True)
class FieldOffsets:
    """The offsets of some fields in bytes, in their order, and their size; `open` where the last ones go on."""

    offsets: tuple[int, ...]
    size: int
    open: bool


class Sizes:
    """The sizes of one device's fields, without asking whether the device makes sense."""

    def __init__(self, device: Device) -> None:
        self._records = device.records
        self._known: dict[str, int] = {}

    def offsets(self, fields: Sequence[Field | Part]) -> FieldOffsets:
        """Where some fields lie behind each other."""
        offsets = []
        at = 0
        goes_on = False
        for field in fields:
            offsets.append(at)
            if isinstance(field, Field) and field.repeat is not None:
                goes_on = True
            else:
                at += self.of(field)
        return FieldOffsets(tuple(offsets), at, goes_on)

    def of(self, field: Field | Part) -> int:
        """The bytes of a field with all its elements, or of a part of a frame; 0 for the body."""
        if isinstance(field, Part):
            if field.algorithm:
                return CHECKSUM_SIZES.get(field.algorithm, 0)
            return field.value.size if field.value is not None else 0
        # What depends on another field lies last, and moves nothing.
        size = field.value.size if field.value is not None else self.record(field.record)
        return size * (field.count or 1)

    def record(self, name: str) -> int:
        """The bytes of a record; 0 for one that is not there, or as far as it holds itself."""
        if name not in self._known:
            self._known[name] = 0
            record = self._records.get(name)
            self._known[name] = self.offsets(record.fields).size if record is not None else 0
        return self._known[name]


# Every list is paired by name in one pass, so the time grows with the size of the device and not faster. Of the pairs,
# only those whose own attributes differ are kept.

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Pair(Generic[T]):
    """The same thing in both devices, and what holds it there."""

    old: T
    new: T
    holder: tuple[Any, Any]


@dataclass(frozen=True, slots=True)
class Values:
    """A value in both devices, with the things that have it. Both have a meaning, or both are reserved."""

    of: Pair[Any]
    old: Value
    new: Value

    @property
    def reserved(self) -> bool:
        """Whether it has no meaning."""
        return bool(getattr(self.of.new, "reserved", False))


@dataclass(frozen=True, slots=True)
class Fields:
    """The fields of a record or of a message, or the parts of a frame, on both sides.

    `direction` is empty for a record. `moved` are those with a meaning that lie elsewhere, with their offsets; `sizes`
    are the bytes on both sides, and whether they go on to the end of the data.
    """

    holder: tuple[Any, Any]
    direction: str
    moved: tuple[tuple[Any, Any, int, int], ...]
    sizes: tuple[tuple[int, bool], tuple[int, bool]]

    @property
    def offsets_equal(self) -> bool:
        """Whether all that have a meaning have kept their places within the same size."""
        return not self.moved and self.sizes[0] == self.sizes[1]


@dataclass(frozen=True, slots=True)
class Lone:
    """What one device has and the other has not. `fields` is given for fields and parts."""

    item: Any
    holder: tuple[Any, Any]
    fields: Fields | None


@dataclass(frozen=True, slots=True)
class Renamed:
    """The same thing by another name, and what shows that it is the same."""

    pair: Pair[Any]
    evidence: str


@dataclass(slots=True)
class _Side:
    """One of the two devices, and what is worked out of it when it is needed."""

    device: Device
    sizes: Sizes
    _placed: dict[str, tuple[str, ...]] | None = None

    def placed(self) -> dict[str, tuple[str, ...]]:
        """The places of the fields that each signal fills."""
        if self._placed is None:
            found: dict[str, list[str]] = {}
            for message in self.device.messages.values():
                for direction, record in (("request", message.request), ("response", message.response)):
                    for number, one in enumerate(record.fields):
                        if one.signal:
                            found.setdefault(one.signal, []).append(f"{message.name}/{direction}/{number}")
            self._placed = {name: tuple(places) for name, places in found.items()}
        return self._placed


class Comparison:
    """Two versions of a device, paired."""

    def __init__(self, old: Device, new: Device) -> None:
        self.old, self.new = old, new
        self.added: list[Lone] = []
        self.removed: list[Lone] = []
        self.renamed: list[Renamed] = []
        self.turned: list[Pair[Any]] = []
        """What has a meaning on one side and is reserved on the other. Nothing else of it can be compared."""
        self.fields: list[Fields] = []
        self._pairs: dict[type, list[Pair[Any]]] = {noun: [] for noun in MODEL_CLASSES}
        self._names: dict[str, str] = {}
        self._sides = _Side(old, Sizes(old)), _Side(new, Sizes(new))
        self._enter(Device, Pair(old, new, (None, None)))

    def of(self, noun: type[T]) -> list[Pair[T]]:
        """The pairs of a class of the model whose own attributes differ."""
        return cast("list[Pair[T]]", self._pairs[noun])

    def any_of(self, *nouns: type) -> Iterator[Pair[Any]]:
        """The same of several classes."""
        for noun in nouns:
            yield from self._pairs[noun]

    def renamed_to(self, path: str, name: str) -> str:
        """The new name of what an old one names in a section, or in a record, with a path of the old device."""
        return self._names.get(f"{path}/{name}", name)

    def renamed_path(self, path: str) -> str:
        """The new path of what an old path leads to."""
        old, new = "", []
        for step in path.split("/"):
            new.append(self.renamed_to(old, step) if old else step)
            old = f"{old}/{step}" if old else step
        return "/".join(new)

    @property
    def values(self) -> list[Values]:
        """The values with a meaning that differ."""
        return [held for held in self.all_values if not held.reserved]

    @cached_property
    def all_values(self) -> list[Values]:
        """The values that differ. A field that has its value from a signal does not repeat what the signal says."""
        found = []
        for noun, pairs in self._pairs.items():
            for pair in pairs:
                old, new = getattr(pair.old, "value", None), getattr(pair.new, "value", None)
                if (
                    isinstance(old, Value)
                    and isinstance(new, Value)
                    and old != new
                    and not self._is_told_by_signal(noun, pair)
                ):
                    found.append(Values(pair, old, new))
        return found

    def _is_told_by_signal(self, noun: type, pair: Pair[Any]) -> bool:
        """Whether a signal tells what has changed in the value of a field."""
        if noun is not Field or not pair.old.signal or not pair.new.signal:
            return False
        old, new = self.old.signals.get(pair.old.signal), self.new.signals.get(pair.new.signal)
        return old is not None and new is not None and (old.value, new.value) == (pair.old.value, pair.new.value)

    def _enter(self, noun: type, pair: Pair[Any]) -> None:
        """Keeps a pair that differs, and pairs what it holds."""
        if pair.old is pair.new and not MODEL_CLASSES[noun].holds:
            return
        if getattr(pair.old, "reserved", False) != getattr(pair.new, "reserved", False):
            self.turned.append(pair)
        elif DEVICE_ATTRIBUTES[noun](pair.old) != DEVICE_ATTRIBUTES[noun](pair.new):
            self._pairs[noun].append(pair)
        for kind, items, direction in MODEL_CLASSES[noun].holds:
            self._match(kind, tuple(items(pair.old)), tuple(items(pair.new)), (pair.old, pair.new), direction)

    def _match(
        self, noun: type, old: Sequence[Any], new: Sequence[Any], holder: tuple[Any, Any], direction: str
    ) -> None:
        """Pairs two lists: by key, then by evidence."""
        left, right = _by_key(noun, old), _by_key(noun, new)
        pairs = [Pair(one, right[key], holder) for key, one in left.items() if key in right]
        gone = [one for key, one in left.items() if key not in right]
        come = [one for key, one in right.items() if key not in left]
        laid = noun in (Field, Part)
        sides = zip(self._sides, (old, new), strict=True)
        offsets = [_offsets(side.sizes, items) if laid else {} for side, items in sides]
        if gone and come:
            around = [Around(at, side.placed()) for at, side in zip(offsets, self._sides, strict=True)]
            for pair, said in _proven(noun, gone, come, around[0], around[1], holder):
                pairs.append(pair)
                self._rename(noun, pair, said)
            paired = {id(one) for pair in pairs for one in (pair.old, pair.new)}
            gone = [one for one in gone if id(one) not in paired]
            come = [one for one in come if id(one) not in paired]
        fields = self._offset_evidence(pairs, offsets[0], offsets[1], holder, direction) if laid else None
        self.removed += (Lone(one, holder, fields) for one in gone)
        self.added += (Lone(one, holder, fields) for one in come)
        for pair in pairs:
            self._enter(noun, pair)

    def _rename(self, noun: type, pair: Pair[Any], said: str) -> None:
        path = place(pair.old, self.old).path.rpartition("/")[0]
        self._names[f"{path}/{MODEL_CLASSES[noun].key(pair.old)}"] = str(MODEL_CLASSES[noun].key(pair.new))
        meaningless = getattr(pair.old, "reserved", False) or getattr(pair.new, "reserved", False)
        if not meaningless:  # nobody knows it by its name
            self.renamed.append(Renamed(pair, said))

    def _offset_evidence(
        self,
        pairs: list[Pair[Any]],
        old: dict[int, tuple[int, int]],
        new: dict[int, tuple[int, int]],
        holder: tuple[Any, Any],
        direction: str,
    ) -> Fields:
        """What the offsets of fields say."""
        moved = [
            (pair.old, pair.new, old[id(pair.old)][1], new[id(pair.new)][1])
            for pair in pairs
            if old[id(pair.old)] != new[id(pair.new)] and not getattr(pair.new, "reserved", False)
        ]
        (size, goes_on), (new_size, new_goes_on) = old[0], new[0]
        sizes = (size, bool(goes_on)), (new_size, bool(new_goes_on))
        fields = Fields(holder, direction, tuple(moved), sizes)
        self.fields.append(fields)
        return fields


def beside(field: Field, device: Device) -> tuple[Field, ...]:
    """The fields of the record, or of the message, that a field is in."""
    section, _, path = field.place.path.rpartition("/")[0].partition("/")
    if section == "records" and path in device.records:
        return device.records[path].fields
    message = device.messages.get(path.rpartition("/")[0])
    if message is None:
        return ()
    return message.request.fields if path.endswith("/request") else message.response.fields


def place(item: Any, device: Device) -> Place:
    """The place of a thing; that of the device where it has none of its own."""
    own = getattr(item, "place", None)
    return own if isinstance(own, Place) else device.place


def _by_key(noun: type, items: Iterable[Any]) -> dict[Hashable, Any]:
    """Things by key; further ones of the same key by key and number."""
    key = MODEL_CLASSES[noun].key
    found: dict[Hashable, Any] = {}
    for item in items:
        own = key(item)
        if own in found:
            own = (own, len(found))
        found[own] = item
    return found


def _offsets(sizes: Sizes, items: Sequence[Any]) -> dict[int, tuple[int, int]]:
    """The run and the offset of each field by its identity in memory; a frame has a run before its body and one
    behind it. The size of all of them, and whether they go on, stand under 0."""
    body = next((at for at, one in enumerate(items) if isinstance(one, Part) and one.role == "body"), len(items))
    found: dict[int, tuple[int, int]] = {}
    size, goes_on = 0, False
    for run, some in enumerate((items[:body], items[body:])):
        laid = sizes.offsets(some)
        found |= {id(one): (run, at) for one, at in zip(some, laid.offsets, strict=True)}
        size, goes_on = size + laid.size, goes_on or laid.open
    found[0] = size, goes_on
    return found


def _proven(
    noun: type, gone: list[Any], come: list[Any], before: Around, after: Around, holder: tuple[Any, Any]
) -> Iterator[tuple[Pair[Any], str]]:
    """The pairs that evidence proves: what they share, nothing else that is gone or has come shares."""
    evidence = EVIDENCE.get(noun)
    if evidence is None:
        return
    old = [(evidence.of(one, before), one) for one in gone]
    new = [(evidence.of(one, after), one) for one in come]
    once = {key for key, count in Counter(key for key, _ in new).items() if count == 1 and key is not None}
    single = {key for key, count in Counter(key for key, _ in old).items() if count == 1}
    arrived = dict(new)
    for key, one in old:
        if key in once and key in single:
            yield Pair(one, arrived[key], holder), evidence.describe(one, before)
