"""The areas of memory that hold what a device has: runs of registers, tables, and the data of messages."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.kv.held import Held, of_part, of_record, of_register, of_table
from fieldspec.classes import dataclass
from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.layout.frame import LinkLayout
from fieldspec.layout.message import MessageLayout


@dataclass(frozen=True, slots=True)
class Area:
    """Words that follow each other. Each holds `unit` bytes of the wire; of two, the first one is the upper half.

    `size` is in bytes. `tag` stands before the names of its values in comments. `address` is that of the first
    register, None where it holds no registers.
    """

    name: str
    tag: str
    unit: int
    size: int
    held: tuple[Held, ...]
    address: int | None = None

    @property
    def words(self) -> int:
        """How many words it has."""
        return -(-self.size // self.unit)


def areas(layout: DeviceLayout) -> Iterator[Area]:
    """The areas of a device in the order of its spec: registers by address, tables, messages."""
    yield from _runs(layout)
    for table in layout.tables.values():
        yield _table(table)
    for link in layout.links.values():
        if link.link.encoding == "binary":
            for message in link.messages.values():
                yield from _message(layout, link, message)


def _runs(layout: DeviceLayout) -> Iterator[Area]:
    """Registers whose addresses follow each other, so that one request can read or write them."""
    names = list(layout.device.spaces) if layout.device.several_spaces else [""]
    for name in names:
        yield from _runs_of(layout, name)


def _runs_of(layout: DeviceLayout, space: str) -> Iterator[Area]:
    """The runs of a space; of all registers where it has no name."""
    placed = [
        (laid.address + number * laid.stride, laid, number)
        for laid in layout.registers
        if not space or layout.device.space_name(laid.register.space) == space
        for number in range(laid.count)
    ]
    placed.sort(key=lambda one: one[0])
    run: list[Held] = []
    first = end = 0
    for address, laid, number in placed:
        if run and address > end:
            yield _run(space, first, end, run)
            run = []
        if not run:
            first = end = address
        run.append(of_register(laid, number, 2 * (address - first)))
        end = max(end, address + laid.words)
    if run:
        yield _run(space, first, end, run)


def _run(space: str, first: int, end: int, run: list[Held]) -> Area:
    return Area(f"{space or 'registers'} 0x{first:04X}..0x{end - 1:04X}", "", 2, 2 * (end - first), tuple(run), first)


def _table(laid: TableLayout) -> Area:
    table = laid.table
    stride = 2 * table.stride
    held = tuple(of_table(table.name, laid.record, table.access, table.count, stride, table.index_from))
    return Area(f"table {table.name}", "", 2, stride * (table.count - 1) + 2 * laid.words, held, table.base)


def _message(layout: DeviceLayout, link: LinkLayout, laid: MessageLayout) -> Iterator[Area]:
    """The frames of a message. Of one that reads or writes registers, the areas of registers are all there is."""
    if layout.device.register_access(laid.message) is not None:
        return
    several = sum(laid.name in other.messages for other in layout.links.values()) > 1
    for direction, sign in (("request", ">"), ("response", "<")):
        shape, data = link.frame(direction), laid.data(direction)
        whole = None if data.size is None else shape.head_size + data.size + shape.tail_size
        length = shape.role("length")
        fixed = {"code": laid.message.code, "length": None if length is None or whole is None else length.number(whole)}
        held = [of_part(part, part.offset, fixed.get(part.role)) for part in shape.head]
        held += of_record(data, shape.head_size)
        if whole is not None:
            held += [of_part(part, whole + part.offset, None) for part in shape.tail]
        size = shape.head_size + (data.size if data.size is not None else data.most or data.least) + shape.tail_size
        if held:
            name = f"{laid.name} on {link.name}" if several else laid.name
            # A frame with a check goes through a serial port, byte by byte; anything else is exchanged as words.
            unit = 1 if shape.check else 2
            each = tuple(one for some in held for one in some.regular(unit))
            yield Area(f"{name} {direction}", f"{laid.name}{sign}", unit, size, each)
