"""What becomes of the rows of a list: registers, the bits in them, and rows that contradict others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.model.encoding import is_real
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.tools.lists.assumption import Refusal
from fieldspec.tools.lists.item import MESSAGES, REGISTERS
from fieldspec.tools.lists.row_reading import PARAMETER, REGISTER, ListRow
from fieldspec.tools.lists.shapes import BIT, Shape, shape
from fieldspec.tools.lists.sheet import ListError
from fieldspec.tools.lists.type_words import UNSIGNED, Loose

SPACES = {REGISTERS: False, "input_registers": False, "coils": True, "discrete_inputs": True}
"""The address spaces that a list may have, and whether they are of bits."""

_ONLY_READ = ("input_registers", "discrete_inputs")

_HIGHEST_ADDRESS = 0xFFFF
_FEW_CLASHES = 5
"""The rows at addresses of others that a list of one device may have, even if it has fewer others."""

_MOST_WORDS = 1 << 20


@dataclass(frozen=True, slots=True)
class Bit:
    """One bit of a register, or several; `pieces` says where those are that are not neighbours."""

    low: int
    high: int
    name: str
    row: ListRow | None
    pieces: str = ""


@dataclass(frozen=True, slots=True)
class Entry:
    """A register with its bits, a field, or a parameter.

    Without a row of its own, it has the first of its bits as `row`, and no name. Where it stands for several equal
    rows, `rows` has them, and `element_name` is what they print, with `{n}` for the number.
    """

    row: ListRow
    shape: Shape
    space: str
    bits: tuple[Bit, ...] = ()
    is_own: bool = True
    rows: tuple[ListRow, ...] = ()
    element_name: str = ""

    @property
    def kind(self) -> str:
        """Its kind, according to its row."""
        return self.row.kind


def entries(rows: Sequence[ListRow], refused_before: Mapping[int, str]) -> tuple[list[Entry], list[Refusal]]:
    """The registers of a list in its order, and the refused rows. `refused_before` has rows with reasons."""
    refused = [Refusal(number, "", "", reason) for number, reason in refused_before.items()]
    left = [_as_readable(row) for row in rows if row.row not in refused_before and row.place is None]
    stated = _stated([row for row in left if row.is_own or row.kind != REGISTER], refused)
    wholes: list[Entry] = []
    by_place: dict[tuple[str, int], int] = {}
    bits: dict[tuple[str, int], list[ListRow]] = {}
    for row in left:
        space = _space(row)
        if row.is_own or row.kind != REGISTER:
            continue
        if reason := _outside(row, space):
            refused.append(Refusal(row.row, "", "", reason))
        elif row.bits is not None and not SPACES[space]:
            bits.setdefault((space, row.address), []).append(row)
        else:
            by_place.setdefault((space, row.address), len(wholes))
            wholes.append(Entry(row, shape(row, SPACES[space]), space))
    for place, rows_of_bits in bits.items():
        if place in by_place:
            entry = wholes[by_place[place]]
            wholes[by_place[place]] = _with_bits(entry, rows_of_bits, refused)
        else:
            wholes.append(_of_bits(rows_of_bits, place[0], refused))
    wholes.sort(key=lambda entry: entry.row.row)
    disjoint = _disjoint(wholes, refused)
    if stated and disjoint:
        stated = sorted([*stated, *disjoint], key=lambda entry: entry.row.row)
    return stated or disjoint, sorted(refused, key=lambda refusal: refusal.row)


def _space(row: ListRow) -> str:
    return row.space or REGISTERS


def _as_readable(row: ListRow) -> ListRow:
    """A row without the access to write where its space has none."""
    if row.access == "ro" or _space(row) not in _ONLY_READ:
        return row
    if not row.access:
        return row if row.is_own else replace(row, access="ro")
    text = row.texts.get("access") or row.texts.get("writable") or row.access
    return replace(row, access="ro", doubts=(*row.doubts, f"The list says {text}, and {row.space} are only read."))


def _outside(row: ListRow, space: str) -> str:
    """Why a row cannot be a register of a device; empty if it can."""
    if space not in SPACES:
        return f"has the space {space}, which is not one of {', '.join(SPACES)}"
    if row.address < 0:
        return "has an address below 0"
    stride = row.stride or row.words or 1
    if row.address + (row.count - 1) * stride > _HIGHEST_ADDRESS:
        return f"has the address {row.address}, which is beyond {_HIGHEST_ADDRESS}"
    return ""


def _with_bits(entry: Entry, rows: Sequence[ListRow], refused: list[Refusal]) -> Entry:
    """A register with the bits of further rows. A type that has no bits becomes the unsigned one of its size."""
    own_shape = entry.shape
    doubts = list(own_shape.doubts)
    width = own_shape.words * 16
    own_type = UNSIGNED.get(own_shape.words)
    if own_type is None or is_real(PRIMITIVES[own_shape.type].encoding):
        refused += [
            Refusal(row.row, "", "", f"has a bit of row {entry.row.row}, whose type {own_shape.type} has none")
            for row in rows
        ]
        return entry
    if own_type != own_shape.type and not own_shape.inferred:
        doubts.append(f"The list says {entry.row.texts.get('type', own_shape.type)}, and bits of it.")
    rows_by_bit: dict[int, int] = {}
    bits: list[Bit] = []
    for row in rows:
        low, high = _width(row)
        clash = next((rows_by_bit[number] for number in range(low, high + 1) if number in rows_by_bit), None)
        if clash is not None or high >= width:
            reason = (
                f"has a bit that row {clash} has"
                if clash is not None
                else f"has a bit beyond the {width} of row {entry.row.row}"
            )
            refused.append(Refusal(row.row, "", "", reason))
            continue
        rows_by_bit.update(dict.fromkeys(range(low, high + 1), row.row))
        if low == high and row.type is not None and row.type.of_words(1)[0] in "if":
            doubt = f"The list says {row.texts.get('type', row.type.name)}, and a bit of it."
            row = replace(row, doubts=(*row.doubts, doubt))
        bits.append(Bit(low, high, "", row))
    bits.sort(key=lambda bit: bit.low)
    return replace(entry, bits=tuple(bits), shape=replace(own_shape, type=own_type, doubts=tuple(doubts)))


def _width(row: ListRow) -> tuple[int, int]:
    """The bits of a row: several where it says so, or where its type has a size in bits."""
    assert row.bits is not None
    low, high = row.bits
    size = 0
    if row.type is not None and row.type.kind is not Loose.TRUTH:
        size = row.type.bits or (PRIMITIVES[row.type.name].size * 8 if row.type.name in ("u8", "i8") else 0)
    return (low, low + size - 1) if low == high and 1 < size < 16 else (low, high)


def _of_bits(rows: Sequence[ListRow], space: str, refused: list[Refusal]) -> Entry:
    """A register of which the list has only bits."""
    highest = max(_width(row)[1] for row in rows)
    stated = max(row.words or 0 for row in rows)
    words = 1 if highest < 16 and stated < 2 else 2 if highest < 32 and stated < 3 else 4
    first = rows[0]
    accesses = {row.access for row in rows}
    access = first.access if len(accesses) == 1 else "rw"
    whole = ListRow(first.row, first.address, access=access, space=first.space, order=first.order, gap=first.gap)
    reason = "The list has only bits of it."
    own_shape = Shape(UNSIGNED[words], words, inferred=reason)
    return _with_bits(Entry(whole, own_shape, space, is_own=False), rows, refused)


def _disjoint(wholes: Sequence[Entry], refused: list[Refusal]) -> list[Entry]:
    """The registers of which no word is in another row: an earlier one, or one that says more."""
    owners: dict[str, dict[int, int]] = {}
    disjoint_entries: list[Entry] = []
    words = clashes = 0
    for entry in sorted(wholes, key=_is_bare):
        row, own_shape = entry.row, entry.shape
        stride = row.stride or own_shape.words
        words += own_shape.count * own_shape.words
        if words > _MOST_WORDS:
            raise ListError(f"has more words than a device, up to row {row.row}")
        rows_by_address = owners.setdefault(entry.space, {})
        numbers = [row.address + n * stride + word for n in range(own_shape.count) for word in range(own_shape.words)]
        clash = next((number for number in numbers if number in rows_by_address), None)
        clashes += clash is not None
        if clash is not None or numbers[-1] > _HIGHEST_ADDRESS:
            reason = (
                f"holds 0x{clash:04X}, as row {rows_by_address[clash]} does"
                if clash is not None
                else "ends beyond the last address"
            )
            refused.append(Refusal(row.row, "", "", reason))
            continue
        rows_by_address.update(dict.fromkeys(numbers, row.row))
        disjoint_entries.append(entry)
    if clashes > max(len(disjoint_entries), _FEW_CLASHES):
        raise ListError(
            f"has {clashes} rows at addresses of other rows, and {len(disjoint_entries)} at addresses of their own: it "
            "has several devices, or its addresses count within blocks; keep one device, with whole addresses"
        )
    return sorted(disjoint_entries, key=lambda entry: entry.row.row)


def _is_bare(entry: Entry) -> bool:
    """Whether a row has an address and texts alone, as one of an overview has."""
    row = entry.row
    return bool(entry.shape.inferred) and not (
        row.unit or row.access or row.scale or row.meanings.members or entry.bits
    )


def _stated(rows: Sequence[ListRow], refused: list[Refusal]) -> list[Entry]:
    """The entries of rows that say what they are. A type that a list has no room for is refused."""
    result: list[Entry] = []
    numbers: dict[tuple[str, int, tuple[int, int] | None], int] = {}
    for row in rows:
        name = row.type.name if row.type is not None else ""
        kind = PRIMITIVES.get(name)
        place = _space(row), row.address, row.subindices
        if place[0] == MESSAGES:
            reason = f"is a field of the message {row.message}, and a list has no frames for messages"
        elif kind is None or (not kind.size and not row.texts.get("bytes")):
            reason = f"has the type {row.texts.get('type', name)}, of which the list does not say how it is sent"
        elif row.subindices is not None and (*place[:2], None) not in numbers:
            reason = "is an element of a parameter that is not taken"
        elif row.kind == PARAMETER and place in numbers:
            reason = f"has the number of row {numbers[place]}"
        else:
            numbers[place] = row.row
            words = row.words or (1 if name == BIT else kind.size or int(row.texts["bytes"]))
            result.append(Entry(row, Shape(name, words, 1), _space(row)))
            continue
        refused.append(Refusal(row.row, "", "", reason))
    return result
