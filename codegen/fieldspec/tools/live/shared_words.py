"""Values of tables that share a word are written together, in one request with all of the word."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from fieldspec.codec.reference.structs import value_construct
from fieldspec.foundation.classes import TYPE_CHECKING, replace
from fieldspec.language.model.access import writable
from fieldspec.tools.live.writing import Assignment, is_partial, words_of

if TYPE_CHECKING:
    from fieldspec.codec.explain.occupants import Occupant
    from fieldspec.codec.layout.device import DeviceLayout


class SharedWords:
    """The fields of tables by their words. A field that has only a part of its words needs those beside it."""

    def __init__(self, layout: DeviceLayout, items: Sequence[tuple[str, Occupant]]) -> None:
        self.layout = layout
        self._at: dict[tuple[str, str, int], list[Occupant]] = {}
        self._sizes = {space: layout.device.space(space).unit_size for space, _ in items}
        for space, occupant in items:
            if occupant.nested is not None:
                for address in range(occupant.address, occupant.address + occupant.words):
                    self._at.setdefault((space, occupant.outer.name, address), []).append(occupant)

    def beside(self, space: str, occupant: Occupant) -> list[Occupant]:
        """What shares words with a field, itself too, directly or through others, by address."""
        if occupant.nested is None or not is_partial(occupant, self._sizes[space]):
            return [occupant]
        known = {occupant.path: occupant}
        waiting = [occupant]
        while waiting:
            own = waiting.pop()
            for address in range(own.address, own.address + own.words):
                new = [
                    candidate for candidate in self._at[space, own.outer.name, address] if candidate.path not in known
                ]
                known |= {candidate.path: candidate for candidate in new}
                waiting += new
        return sorted(known.values(), key=lambda candidate: (candidate.address, candidate.skip))

    def objection(self, item: tuple[str, Occupant], judge: Callable[[Occupant], str]) -> str:
        """Why a writable field is in no list: a field that shares a word with it cannot be written."""
        for other in self.beside(*item):
            objection = judge(other) if other is not item[1] and not other.reserved else ""
            if objection:
                return f"shares a word with {other.path}, which {objection}"
        return ""

    def together(self, chosen: Sequence[Assignment]) -> tuple[list[Assignment], dict[str, str]]:
        """Assignments of which each has the words of all that shares words with it, and by path why some have not."""
        by_path = {item.path: item for item in chosen if item.mask}
        result, problems = [], {}
        for item in chosen:
            if not item.mask:
                result.append(item)
                continue
            sharing = self.beside(item.space, item.occupant)
            missing = [own for own in sharing if own.path not in by_path and not own.reserved]
            if missing:
                problems[item.path] = _problem(item.path, missing)
                continue
            result.append(self._with_request(item, list(self._parts(item.space, sharing, by_path)), sharing))
        return result, problems

    def _parts(
        self, space: str, sharing: Sequence[Occupant], by_path: dict[str, Assignment]
    ) -> Iterator[tuple[Occupant, tuple[int, ...], tuple[int, ...]]]:
        """Each of what shares words, with its words and the bits in them; what is reserved as encoders write it."""
        for own in sharing:
            known = by_path.get(own.path)
            if known is not None:
                yield own, known.words, known.mask
                continue
            value, size = own.value, self._sizes[space]
            data = _reserved_bytes(own)
            padding = own.words * size - own.skip - value.size
            placed, ones = (bytes(own.skip) + part + bytes(padding) for part in (data, b"\xff" * value.size))
            yield own, words_of(self.layout, placed, size), words_of(self.layout, ones, size)

    def _with_request(
        self,
        item: Assignment,
        parts: Sequence[tuple[Occupant, tuple[int, ...], tuple[int, ...]]],
        sharing: Sequence[Occupant],
    ) -> Assignment:
        first = min(own.address for own in sharing)
        words = [0] * (max(own.address + own.words for own in sharing) - first)
        for own, content, mask in parts:
            offset = own.address - first
            words[offset : offset + own.words] = merged(words[offset : offset + own.words], content, mask)
        before = item.occupant.address - first
        own_words = tuple(words[before : before + item.occupant.words])
        return replace(item, words=own_words, request=tuple(words), before=before)


def merged(words: Sequence[int], content: Sequence[int], mask: Sequence[int]) -> tuple[int, ...]:
    """Words in which the bits of a mask come from the content."""
    return tuple(word & ~bits | own & bits for word, own, bits in zip(words, content, mask, strict=True))


def _problem(path: str, missing: Sequence[Occupant]) -> str:
    names = ", ".join(own.path for own in missing)
    fixed = [own.path for own in missing if not writable(own.access)]
    if fixed:
        return f"{path} shares a word with {', '.join(fixed)}, which is not stated to be writable"
    return f"{path} shares a word with {names}, and is written together with that alone: give a value for each"


def _reserved_bytes(occupant: Occupant) -> bytes:
    """What encoders write for a reserved field: its constant, its default, or 0."""
    value = occupant.value
    number = value.const if value.const is not None else value.default
    if not isinstance(number, int):
        return bytes(value.size)
    data: bytes = value_construct(value, occupant.order, occupant.swapped).build(number)
    return data
