"""The values of captures as evidence: what a unit has answered, and which writes it has accepted."""

from __future__ import annotations

from collections.abc import Collection

from fieldspec.tools.audit.register_dump import DumpReport, DumpValue
from fieldspec.tools.captures.decoding import Batch, DeviceDecoder
from fieldspec.tools.captures.verdicts import OK, UNLISTED, VERDICTS
from fieldspec.tools.evidence.observables import READ, WRITE, Observable, Observables, bare
from fieldspec.tools.evidence.unit_evidence import SeriesValue, UnitEvidence

_TROUBLES = ("wrong_const", "unknown_value", "out_of_range", "unlisted_member", "unlisted_bits")


class CaptureValues:
    """The values of one file. A write counts once its response says that it was carried out.

    `moment` is the moment of the frame 0 of the file.
    """

    def __init__(
        self, unit: UnitEvidence, observables: Observables, decoder: DeviceDecoder, source: str, moment: int
    ) -> None:
        self.unit, self.observables, self.decoder = unit, observables, decoder
        self.source, self.moment = source, moment
        self.frames = 0
        self.accepted: set[int] = set()
        self.writes: list[tuple[int, Observable, str, SeriesValue, str]] = []

    def add(self, batch: Batch) -> None:
        """Adds a batch of frames."""
        texts = self.decoder.texts.texts
        frames = batch.frames
        numbers = frames.number.tolist()
        ways = [texts[place] if place >= 0 else "" for place in frames.direction.tolist()]
        self.frames += int((frames.verdict == OK).sum())
        rows = zip(
            ways, frames.request.tolist(), frames.exception.tolist(), frames.message.tolist(),
            frames.space.tolist(), frames.address.tolist(), frames.count.tolist(), frames.unit_address.tolist(),
            strict=True,
        )  # fmt: skip
        own = self.decoder.choices.units
        for direction, request, exception, message, space, address, count, unit_address in rows:
            if direction != "response" or request < 0 or (own and unit_address not in own):
                continue
            if exception < 0:
                self.accepted.add(request)
            elif message >= 0 and address >= 0:
                self._refuse(texts[message], texts[space] if space >= 0 else "", address, count, texts[exception])
        self._add_values(batch, texts, numbers, ways)

    def _add_values(self, batch: Batch, texts: list[str], numbers: list[int], ways: list[str]) -> None:
        values, own = batch.values, batch.values.values
        rows = zip(
            values.frame.tolist(), values.operation.tolist(), values.space.tolist(), values.address.tolist(),
            values.register.tolist(), own.raw.tolist(), own.has_raw.tolist(), own.quantity.tolist(),
            own.has_quantity.tolist(), own.text.tolist(), own.verdict.tolist(), strict=True,
        )  # fmt: skip
        for row, operation, space, address, register, raw, has_raw, quantity, has_quantity, text, verdict in rows:
            path = texts[register]
            name = texts[text] if text >= 0 else ""
            value: SeriesValue = raw if has_raw else quantity if has_quantity else name
            place_text = f"{self.source}, frame {numbers[row]}"
            if operation < 0:
                operation_name = WRITE if ways[row] == "request" else READ
                item = self.observables.fields.get((operation_name, bare(path)))
            else:
                operation_name = texts[operation]
                space_name = texts[space] if space >= 0 else ""
                if verdict == UNLISTED:
                    if operation_name == READ:
                        self.unit.add_unlisted(space_name, address, str(value), place_text)
                    continue
                item = self.observables.registers.get((space_name, path))
            if item is None or VERDICTS[verdict] == "partial":
                continue
            if operation >= 0 and operation_name == WRITE:
                self.writes.append((numbers[row], item, path, value, place_text))
            else:
                self.unit.add(item, path, operation_name, value, self.moment + numbers[row], place_text)
            if VERDICTS[verdict] in _TROUBLES and operation_name == READ:
                self.unit.add_trouble(item, path, VERDICTS[verdict], str(value), place_text)

    def _refuse(self, message: str, space: str, address: int, count: int, exception: str) -> None:
        """Notes a refusal that concerns one value; the refusal of a longer request does not identify the value."""
        access = self.observables.layout.messages[message].message.single_access
        if access is None:
            return
        requested_items = [
            item
            for item in self.observables.registers.values()
            if item.space == space and item.address is not None and address <= item.address < address + count
        ]
        if len(requested_items) == 1 and requested_items[0].address == address:
            self.unit.add_refusal(requested_items[0], requested_items[0].path, access.operation, exception)

    def finish(self) -> None:
        """Adds the writes that were accepted."""
        for number, item, path, value, place_text in self.writes:
            if number in self.accepted:
                self.unit.add(item, path, WRITE, value, self.moment + number, place_text)


def add_dump(unit: UnitEvidence, observables: Observables, report: DumpReport, source: str, moment: int) -> None:
    """Adds the values of a dump."""
    by_name = {item.path: item for item in observables.registers.values()}
    for read in report.read:
        item = by_name.get(read.name)
        if item is None or item.fact.place.path != read.fact.place.path:
            item = observables.parameters.get(read.fact.place.path)
        place_text = f"{source}, row {read.rows[0]}"
        if item is not None and read.number is not None:
            _add(unit, item, read, place_text, moment)
    for entry in report.unknown:
        space = entry.space or observables.layout.device.space_name("")
        for offset, value in enumerate(entry.values):
            unit.add_unlisted(space, entry.address + offset, str(value), f"{source}, row {entry.row}")


def add_scan(unit: UnitEvidence, observables: Observables, space: str, refused: Collection[int]) -> None:
    """Adds the registers of a scan of which the unit has refused the first word."""
    for item in observables.registers.values():
        if item.space == space and item.address is not None and item.address in refused and item.access != "wo":
            unit.add_refusal(item, item.path, READ, "an exception")


def _add(unit: UnitEvidence, item: Observable, read: DumpValue, place_text: str, moment: int) -> None:
    number = read.number
    value: SeriesValue = number if isinstance(number, int | float) else read.text or str(number)
    unit.add(item, read.name, READ, value, moment, place_text)
    if read.unread:
        return
    if read.decoded.reason:
        unit.add_trouble(item, read.name, read.decoded.reason, str(value), place_text)
    elif read.spare:
        unit.add_trouble(item, read.name, "unlisted_bits", str(value), place_text)
    elif isinstance(number, int) and item.value.enum:
        enum = unit.layout.device.enums.get(item.value.enum)
        if enum is not None and enum.member(number) is None and item.value.sentinel(number) is None:
            unit.add_trouble(item, read.name, "unlisted_member", str(value), place_text)
