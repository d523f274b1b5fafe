"""What captures show of a device as sections of an audit: what was seen, what failed, what contradicts the spec."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.explain.occupants import Occupant, forbidden_text
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.quantity import real_text
from fieldspec.tools.audit.section import Cell, Figure, Section, SectionTable
from fieldspec.tools.captures.decoding import DeviceDecoder
from fieldspec.tools.captures.observations import AccessUse, Observations, RegisterUse

UNCHANGED, MANY, OFTEN = 0.99, 100, 10**9
"""A read is too frequent if this share of at least this number of answers is unchanged, less than a second apart."""

_REMARKS = {
    "out_of_range": "outside of the range that the manual prints",
    "unknown_value": "a codec refuses the value",
    "wrong_const": "the constant is another one",
    "unlisted_member": "the enum does not list the number",
    "unlisted_bits": "bits are set that are not listed",
    "unlisted": "no register is listed at the address",
}


class CaptureAudit:
    """The sections of the report on what captures show of a device."""

    def __init__(self, device: DeviceDecoder, observations: Observations) -> None:
        self.layout: DeviceLayout = device.layout
        self.seen = observations
        self.occupants: dict[tuple[str, str], Occupant] = {
            (space, occupant.path): occupant for space, own in device.maps.items() for occupant in own.occupants
        }

    def sections(self) -> tuple[Section, ...]:
        """All sections in the order in which people read them."""
        return (self.map(), self.exchanges(), self.contradictions(), self.polling(), self.wear())

    def map(self) -> Section:
        """Registers in the traffic, how often, and within which bounds."""
        uses = sorted(self.seen.registers.values(), key=_by_address)
        known = {(use.space, use.register) for use in uses} & self.occupants.keys()
        rows = tuple(
            (use.space, use.address, use.register, use.operation, use.count, *_bounds(use), use.unit, _texts(use))
            for use in uses
        )
        unseen = tuple(
            (space, occupant.address, path)
            for (space, path), occupant in self.occupants.items()
            if not occupant.reserved and (space, path) not in known
        )
        frames = sum(self.seen.frames.values())
        figures = (
            Figure("registers were seen", len(known), len(self.occupants)),
            Figure("frames are valid", self.seen.frames["ok"], frames),
            Figure("captures and logs read", len(self.seen.sources)),
        )
        columns = ("space", "address", "register", "operation", "count", "least", "greatest", "unit", "texts")
        units = tuple((str(unit), count) for unit, count in sorted(self.seen.units.items()))
        return Section(
            "seen",
            "Registers in the traffic",
            figures=figures,
            tables=(
                SectionTable("registers", "Registers and fields", columns, rows),
                SectionTable("units", "Unit addresses", ("unit_address", "frames"), units),
                SectionTable("unseen", "Registers that were not seen", columns[:3], unseen, detail=True),
            ),
        )

    def exchanges(self) -> Section:
        """Exception responses and missing ones by register, and the time until the answers."""
        failed, timed = [], []
        for key, use in sorted(self.seen.accesses.items(), key=lambda item: str(item[0])):
            missing = use.requests - use.answers
            for exception, count in sorted(use.exceptions.items()):
                failed.append((*key, self._names(key), exception, count, use.requests))
            if missing > 0:
                failed.append((*key, self._names(key), "no answer", missing, use.requests))
            if use.delays:
                timed.append((*key, use.answers, use.delay_sum // use.delays // 1000, use.delay_high // 1000))
        columns = ("message", "space", "address", "words")
        kinds = tuple("bad" for _ in failed)
        return Section(
            "exchanges",
            "Exceptions, missing answers and response times",
            paragraphs=("A request without an answer may have got one that is not in the capture.",),
            tables=(
                SectionTable(
                    "failures",
                    "Requests that failed",
                    (*columns, "registers", "failure", "count", "requests"),
                    tuple(failed),
                    kinds,
                ),
                SectionTable(
                    "response_times",
                    "Response times in microseconds",
                    (*columns, "answers", "mean", "greatest"),
                    tuple(timed),
                    detail=True,
                ),
            ),
        )

    def contradictions(self) -> Section:
        """Values and frames that the spec does not allow, and accesses that it forbids."""
        rows: list[tuple[Cell, ...]] = []
        for use in sorted(self.seen.registers.values(), key=_by_address):
            rows += [
                (use.space, use.address, use.register, use.operation, _REMARKS[verdict], count, *_bounds(use))
                for verdict, count in sorted(use.verdicts.items())
                if verdict in _REMARKS
            ]
            occupant = self.occupants.get((use.space, use.register))
            objection = forbidden_text(use.operation, occupant.access) if occupant is not None else None
            if objection:
                place = (use.space, use.address, use.register, use.operation)
                rows.append((*place, f"the register {objection}", use.count, *_bounds(use)))
        columns = ("space", "address", "register", "operation", "contradiction", "count", "least", "greatest")
        faults = tuple((verdict, count) for verdict, count in sorted(self.seen.frames.items()) if verdict != "ok")
        return Section(
            "contradictions",
            "What contradicts the spec",
            figures=(Figure("kinds of values or accesses contradict the spec", len(rows), good=not rows),),
            tables=(
                SectionTable("contradictions", "Values and accesses", columns, tuple(rows), tuple("bad" for _ in rows)),
                SectionTable("frames", "Frames that are not valid", ("verdict", "frames"), faults),
            ),
        )

    def polling(self) -> Section:
        """Reads that are repeated: over gaps of the map, or more often than their values change."""
        rows: list[tuple[Cell, ...]] = []
        kinds = []
        for key, use in sorted(self.seen.accesses.items(), key=lambda item: -item[1].requests):
            message = self.layout.messages.get(key[0])
            access = message.message.single_access if message is not None else None
            if access is None or access.operation != "read" or use.requests < 2:
                continue
            interval = _interval(use)
            gaps = self._gaps(key)
            share = use.unchanged / use.compared if use.compared else 0.0
            is_frequent = use.compared >= MANY and share >= UNCHANGED and interval is not None and interval < OFTEN
            remarks = []
            if gaps:
                remarks.append(f"reads over gaps: {', '.join(gaps)}")
            if is_frequent:
                remarks.append("the answer hardly ever changes; read it less often")
            unchanged = f"{100 * share:.1f} %" if use.compared else ""
            times = None if interval is None else interval // 1_000_000
            rows.append((*key, use.requests, times, unchanged, "; ".join(remarks)))
            kinds.append("warning" if remarks else "")
        columns = ("message", "space", "address", "words", "requests", "interval_ms", "unchanged", "remark")
        return Section(
            "polling",
            "Polling",
            tables=(SectionTable("polling", "Repeated reads", columns, tuple(rows), tuple(kinds)),),
        )

    def wear(self) -> Section:
        """The section about writes to memory that wears out."""
        rows: list[tuple[Cell, ...]] = []
        days = self._days()
        for use in sorted(self.seen.registers.values(), key=_by_address):
            occupant = self.occupants.get((use.space, use.register))
            if use.operation != "write" or occupant is None:
                continue
            memory = next((own.memory for own in occupant.handlings if own.memory), "")
            endures = next((own.endurance for own in occupant.handlings if own.endurance), "")
            if endures == "unlimited" or (not endures and memory != "nonvolatile"):
                continue
            rate = f"{use.count / days:.0f}" if days else ""
            endurance = endures or "not printed"
            left = f"{int(endures) * days / use.count:.0f}" if days and endures.isdecimal() else ""
            rows.append((use.space, use.address, use.register, use.count, rate, endurance, left))
        columns = ("space", "address", "register", "writes", "writes_per_day", "endurance", "days_until_worn")
        return Section(
            "wear",
            "Writes to memory that wears out",
            paragraphs=("The rate is that of the time between the first and the last request of the captures.",),
            tables=(SectionTable("wear", "Writes", columns, tuple(rows), tuple("warning" for _ in rows)),),
        )

    def _days(self) -> float:
        firsts = [use.first for use in self.seen.accesses.values() if use.first is not None]
        lasts = [use.last for use in self.seen.accesses.values() if use.last is not None]
        return (max(lasts) - min(firsts)) / (86_400 * 10**9) if firsts and lasts else 0.0

    def _inside(self, key: tuple[str, str, int | None, int | None]) -> Iterator[Occupant]:
        _, space, address, count = key
        if address is not None and count is not None:
            for (own, _), occupant in self.occupants.items():
                if own == space and occupant.address < address + count and address < occupant.address + occupant.words:
                    yield occupant

    def _names(self, key: tuple[str, str, int | None, int | None]) -> str:
        """The registers that a request asks for: the first ones by name."""
        names = [occupant.path for occupant in self._inside(key)]
        return ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")

    def _gaps(self, key: tuple[str, str, int | None, int | None]) -> list[str]:
        """The words in a read that no register has, as spans of addresses."""
        _, _, address, count = key
        if address is None or count is None:
            return []
        covered = {
            word
            for occupant in self._inside(key)
            for word in range(occupant.address, occupant.address + occupant.words)
        }
        free = [word for word in range(address, address + count) if word not in covered]
        spans: list[list[int]] = []
        for word in free:
            if spans and spans[-1][1] == word - 1:
                spans[-1][1] = word
            else:
                spans.append([word, word])
        return [f"0x{low:04X}" if low == high else f"0x{low:04X}..0x{high:04X}" for low, high in spans]


def _by_address(use: RegisterUse) -> tuple[str, int, str, str]:
    return use.space, -1 if use.address is None else use.address, use.register, use.operation


def _bounds(use: RegisterUse) -> tuple[Cell, Cell]:
    """The least and the greatest quantity; raw values where there are no quantities."""
    pair = (use.low, use.high) if use.low is not None else (use.raw_low, use.raw_high)
    return (_number_cell(pair[0]), _number_cell(pair[1]))


def _number_cell(number: float | None) -> Cell:
    if number is None or isinstance(number, int):
        return number
    return int(number) if number.is_integer() and abs(number) < 2**53 else real_text(number)


def _texts(use: RegisterUse) -> str:
    texts = sorted(use.texts)
    return ", ".join(texts[:12]) + (", .." if len(texts) > 12 else "")


def _interval(use: AccessUse) -> int | None:
    """The mean nanoseconds from one request to the next; None without times."""
    if use.first is None or use.last is None or use.requests < 2:
        return None
    return (use.last - use.first) // (use.requests - 1)
