"""The explanation of a frame, from the layout alone; bytes that make no sense are explained as such."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.classes import dataclass, field, replace
from fieldspec.explain.body import Body
from fieldspec.explain.registers import accessed, register_rows
from fieldspec.explain.row import (
    ExplanationRow,
    Spot,
    end_rows,
    errata_of_message,
    errata_of_words,
    fact_row,
    start_rows,
    unwrapped,
    wrong_row,
)
from fieldspec.explain.values import DecodedValue, Meaning, decode_value, whole
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.frame import CHECKSUMS, LinkLayout, MessageLayout, PartLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.layout.values import Raw
from fieldspec.model.device import Device
from fieldspec.model.texts import Erratum, Example

# >>> found = explained(layout, "line", "request", frame)
# >>> [(row.offset, row.path, row.number, row.verdict) for row in found.rows]
# [(0, 'address', 1, ''), (1, 'command', 6, ''), (2, 'size', 300, ''), (4, 'sum', 55, 'right')]

__all__ = ["Explanation", "ExplanationRow", "Meaning", "closest", "explained", "lengths", "recognised"]

Reading = tuple[str, str, str, bool]

# What a decoder passes on, although the manual gives narrower bounds.
_PASSED_ON = ("", "out_of_range")
_OF_VALUES = frozenset({"unknown_value", "wrong_const", "wrong_measure"})
# That a frame carries no code, so that its message was guessed: no fault, but too little to go by in a broken frame.
_GUESSED = "guessed"
# What may be wrong with a frame, in steps.
_FITTING = (frozenset({_GUESSED}), _OF_VALUES | {_GUESSED})
_CLOSE = (_OF_VALUES | {"wrong_check", _GUESSED}, _OF_VALUES | {"wrong_check", "wrong_length", "incomplete"})


@dataclass(frozen=True, slots=True)
class Explanation:
    """What a frame says.

    `rows` hold every byte of the frame once, in order. `registers` are what the frame reads or writes, by
    address; their bytes, where the frame has them, are those of the rows again.
    `message` is empty where nothing says which one it is; `error` says that the frame refuses a request.
    `values` are the raw values by name: those of the parts before the body but for the length, and those of the
    body's fields. `errata` are those of the message and of the link as a whole.
    """

    link: str
    direction: str
    message: str
    error: bool
    frame: bytes
    rows: tuple[ExplanationRow, ...]
    registers: tuple[ExplanationRow, ...]
    values: dict[str, Raw] = field(repr=False)
    errata: tuple[str, ...] = ()

    @property
    def reasons(self) -> tuple[str, ...]:
        """Why a codec refuses the frame, in the words of its errors; empty where it takes it."""
        return tuple(row.reason for row in self.rows if row.reason not in _PASSED_ON)


def explained(
    layout: DeviceLayout, link: str, direction: str, frame: bytes, message: str = "", request: bytes = b""
) -> Explanation:
    """The explanation of a whole frame, whose direction is `request` or `response`.

    `message` names the message where the frame carries no code. `request` is the frame that a response answers:
    it says which message and which registers a response belongs to, where the response does not say it itself.
    Raises KeyError for a link that the device does not have; never for bytes.
    """
    asked = explained(layout, link, "request", request, message) if request and direction == "response" else None
    return _Frame(layout, link, direction, frame, message, asked).explanation()


_MOST_LAYOUTS = 64
_EXPLANATIONS: dict[int, tuple[DeviceLayout, dict[str, Explanation]]] = {}
"""By identity of a layout, the explanations of its examples, which several outputs ask for."""


def explained_example(layout: DeviceLayout, example: Example) -> Explanation:
    """The explanation of an example's frame, computed once for each layout."""
    if id(layout) not in _EXPLANATIONS and len(_EXPLANATIONS) == _MOST_LAYOUTS:
        del _EXPLANATIONS[next(iter(_EXPLANATIONS))]
    explanations = _EXPLANATIONS.setdefault(id(layout), (layout, {}))[1]
    found = explanations.get(example.id)
    if found is None:
        asked = layout.device.examples.get(example.reply_to)
        if asked is not None and _alone(asked) == (example.link, "request", example.message, ""):
            request = explained_example(layout, asked)
            found = _Frame(layout, *_shape(example), request if example.direction == "response" else None).explanation()
        else:
            found = explained(layout, *_shape(example), asked.frame if asked is not None else b"")
        explanations[example.id] = found
    return found


def _shape(example: Example) -> tuple[str, str, bytes, str]:
    return example.link, example.direction, example.frame, example.message


def _alone(example: Example) -> tuple[str, str, str, str]:
    """What the explanation of an example depends on beside its frame."""
    return example.link, example.direction, example.message, example.reply_to


def recognised(layout: DeviceLayout, frame: bytes) -> list[Reading]:
    """The readings of a frame that fit: (link, direction, message, error), in the order of the spec.

    Marks, length, check and the length of the body are right. Where some of these readings have values that a
    codec refuses, and some have none, only the latter are given. The message is empty for a refusal of a code
    that the device does not know.
    """
    return _readings(layout, frame, _FITTING)


def closest(layout: DeviceLayout, frame: bytes) -> list[Reading]:
    """The readings of a frame that fit best: where none fits, with a wrong check, else with a wrong length too."""
    return _readings(layout, frame, _FITTING + _CLOSE)


def _readings(layout: DeviceLayout, frame: bytes, steps: tuple[frozenset[str], ...]) -> list[Reading]:
    found: dict[Reading, frozenset[str]] = {}
    for link in layout.links.values():
        for direction in ("request", "response"):
            guessed = link.frame(direction).role("code") is None
            names = _of_length(link, direction, frame) if steps is _FITTING else list(link.messages)
            for message in names if guessed else ("",):
                one = explained(layout, link.name, direction, frame, message)
                reasons = frozenset((*one.reasons, _GUESSED) if guessed else one.reasons)
                found.setdefault((link.name, direction, one.message, one.error), reasons)
    for forgiven in steps:
        fitting = [reading for reading, reasons in found.items() if reasons <= forgiven and (reading[2] or reading[3])]
        if fitting:
            return fitting
    return []


def _of_length(link: LinkLayout, direction: str, frame: bytes) -> list[str]:
    """The messages whose body may be as long as that of a frame; of all others the length is wrong."""
    length = len(unwrapped(link.link, frame).data)
    bounds = ((name, lengths(link, direction, name)) for name in link.messages)
    return [name for name, (least, most) in bounds if least <= length and (most is None or length <= most)]


def lengths(link: LinkLayout, direction: str, message: str) -> tuple[int, int | None]:
    """The least and the greatest number of bytes of a message's frames, without marks; None where nothing bounds it."""
    shape, body = link.frame(direction), link.messages[message].data(direction)
    around = shape.head_size + shape.tail_size
    return body.least + around, None if body.most is None else body.most + around


class _Frame:
    """A frame while it is being explained. `data` are its parts as bytes; `cut` is what follows them."""

    def __init__(
        self, layout: DeviceLayout, link: str, direction: str, frame: bytes, message: str, asked: Explanation | None
    ) -> None:
        self.layout, self.link, self.direction, self.frame = layout, layout.links[link].link, direction, frame
        self.shape = layout.links[link].frame(direction)
        self.asked = asked
        self.wrapped = unwrapped(self.link, frame)
        self.spot = Spot(frame, len(self.wrapped.start), 2 if self.link.encoding == "hex_ascii" else 1)
        self.data, self.cut = self._cut(self.wrapped.data)
        self.named = message or (asked.message if asked else "")
        self.sent = layout.links[link].messages
        self.laid: MessageLayout | None = self.sent.get(self.named)
        self.error = False
        self.values: dict[str, Raw] = {}

    def explanation(self) -> Explanation:
        """The whole explanation. The head comes first: its code says what the body holds."""
        rows = [*start_rows(self.wrapped), *self._head()]
        registers: tuple[ExplanationRow, ...] = ()
        if len(self.data) >= self.shape.head_size:
            inside, registers = self._body()
            rows += [*inside, *self._tail()]
        if self.cut:
            text = f"{len(self.cut)} bytes are over"
            rows.append(wrong_row(self.spot, len(self.data), self.cut, "wrong_length", text))
        rows += end_rows(self.wrapped)
        errata = errata_of_words(self.layout.device, (self.link.place.path,))
        if self.laid is not None:
            errata += errata_of_message(self.layout.device, self.laid.message)
        name = self.laid.name if self.laid else ""
        return Explanation(
            self.link.name, self.direction, name, self.error, self.frame, tuple(rows), registers, self.values, errata
        )

    def _cut(self, data: bytes) -> tuple[bytes, bytes]:
        """The parts, and what follows them: the length part and the check may say that the frame ends earlier."""
        length, check = self.shape.role("length"), self.shape.checksum
        if length is None or check is None or not self.wrapped.whole:
            return data, b""
        number = whole(data[length.offset : length.offset + length.size], length.order)
        said = number * length.unit_size + length.base
        early = self.shape.head_size + self.shape.tail_size <= said < len(data)
        if (
            early
            and _sum(check, data) != _checksum(check, data)
            and _sum(check, data[:said]) == _checksum(check, data[:said])
        ):
            return data[:said], data[said:]
        return data, b""

    def _head(self) -> Iterator[ExplanationRow]:
        for part in self.shape.head:
            held = self.data[part.offset : part.offset + part.size]
            if len(held) < part.size:
                if self.wrapped.whole:
                    yield self._short(part, part.offset, held)
                return
            yield self._part(part, part.offset, held, self._part_text(part, held))

    def _part(self, part: PartLayout, at: int, held: bytes, read: DecodedValue) -> ExplanationRow:
        return fact_row(self.layout.device, "part", part.name, part.part, self.spot, at, held, read, self.link)

    def _short(self, part: PartLayout, at: int, held: bytes) -> ExplanationRow:
        missing = part.size - len(held)
        text = f"{missing} {'byte is' if missing == 1 else 'bytes are'} missing for {part.name}"
        return wrong_row(self.spot, at, held, "incomplete", text, part.name, part.part.place.path)

    def _part_text(self, part: PartLayout, raw: bytes) -> DecodedValue:
        """What the bytes of a part say, with what its role adds."""
        if part.role == "checksum":
            return self._checked(part, raw)
        assert part.value is not None
        if part.reserved:
            return decode_value(self.layout.device, part.value, raw, part.order, False, reserved=True)
        read = decode_value(self.layout.device, part.value, raw, part.order, False)
        assert isinstance(read.number, int)
        if part.role == "length":
            return self._counted(part, read)
        if part.offset < 0:
            return read
        self.values[part.name] = read.number
        if part.role == "code":
            return self._code(part, read)
        if part.role == "unit_address":
            return self._station(read)
        return read

    def _counted(self, part: PartLayout, read: DecodedValue) -> DecodedValue:
        """What a length says."""
        if not self.wrapped.whole:
            return read
        should = part.number(len(self.data))
        right = should is not None and read.number == should
        return read.judged(right, should if should is not None else "for another number of bytes", "wrong_length")

    def _checked(self, part: PartLayout, raw: bytes) -> DecodedValue:
        """What a check says."""
        read = DecodedValue(whole(raw, part.order))
        if not self.wrapped.whole:
            return read
        should = _sum(part, self.data)
        return read.judged(raw == should, should.hex(" ").upper(), "wrong_check")

    def _code(self, part: PartLayout, read: DecodedValue) -> DecodedValue:
        """The message that a code names. A response may mark it as a refusal."""
        code, refusal = read.number, self.link.exception_response
        assert isinstance(code, int)
        if refusal is not None and self.direction == "response" and code & refusal.flag:
            self.error = True
            code &= ~refusal.flag
            self.values[part.name] = code
        self.laid = self.layout.links[self.link.name].message_with_code(code)
        if self.laid is None:
            if self.error:
                return replace(read, meanings=(Meaning("", "", f"the code {code:#04x} is refused", ""),))
            codes = (laid.message.code for laid in self.sent.values())
            known = ", ".join(f"{code:02X}" for code in codes if code is not None)
            return read.judged(False, f"one of {known}", "unknown_code")
        message = self.laid.message
        text = f"{message.title or message.label or message.name}, refused" if self.error else message.title
        meaning = Meaning(message.name, message.label, text, "")
        read = replace(read, meanings=(meaning,), notes=message.notes, facts=(message.place.path,))
        expected = self.sent.get(self.named)
        if expected is None or expected is self.laid or self.error:
            return read
        return read.judged(False, f"{expected.message.code:02X}", "unknown_code")

    def _station(self, read: DecodedValue) -> DecodedValue:
        stations = self.link.unit_addresses
        if stations is None or stations.ranges is None:
            return read
        if read.number == stations.broadcast:
            return replace(read, meanings=(Meaning("broadcast", "", "for all stations", ""),), verdict="", reason="")
        if read.number in stations.ranges:
            return read
        return read.judged(False, stations.ranges.text(), "out_of_range")

    def _record(self) -> RecordLayout | None:
        """The record of the body; None where nothing says what it holds."""
        if self.error and self.link.exception_response is not None:
            return self.layout.records[self.link.exception_response.record]
        return self.laid.data(self.direction) if self.laid else None

    def _body(self) -> tuple[list[ExplanationRow], tuple[ExplanationRow, ...]]:
        """The rows of the body, and of the registers that it reads or writes."""
        start, record = self.shape.head_size, self._record()
        end = max(start, len(self.data) - self.shape.tail_size) if self.wrapped.whole else len(self.data)
        if record is None:
            return list(self._unknown(start, end)), ()
        message = self.laid.message if self.laid else None
        asked = self.asked.values if self.asked else {}
        body = Body(self.layout, record, message or record.record, self.data, start, end, self.spot, asked)
        self.values |= body.values
        rows = [row for row in body.rows if self.wrapped.whole or row.kind != "unexplained" or row.length]
        access = self.layout.device.register_access(message) if message is not None and not self.error else None
        if access is None:
            return rows, ()
        values = record.named(access.values)
        at = start + values.offset if values else start
        last = min(end, start + values.end) if values and values.end is not None else end
        held = self.data[at:last] if values else b""
        span = accessed(access, body.values, asked, at, held[: len(held) // 2 * 2])
        return rows, tuple(register_rows(self.layout, span, self.spot, access.operation)) if span else ()

    def _unknown(self, start: int, end: int) -> Iterator[ExplanationRow]:
        """The row of a body of which nothing is known."""
        if self.shape.role("code") is None:
            text = "the frame carries no code, and nothing else says which message it is"
            yield wrong_row(self.spot, start, self.data[start:end], "unknown_code", text)
        elif end > start:
            row = wrong_row(self.spot, start, self.data[start:end], "", "")
            yield replace(row, verdict="", doc="The data of an unknown message.")

    def _tail(self) -> Iterator[ExplanationRow]:
        if not self.wrapped.whole:
            return
        start = max(self.shape.head_size, len(self.data) - self.shape.tail_size)
        for part in self.shape.tail:
            at = start + self.shape.tail_size + part.offset
            held = self.data[at : at + part.size]
            if len(held) < part.size:
                yield self._short(part, at, held)
                return
            yield self._part(part, at, held, self._part_text(part, held))


def _sum(check: PartLayout, data: bytes) -> bytes:
    """What the check of some parts should be."""
    number = CHECKSUMS[check.algorithm](data[check.start : check.stop])
    return number.to_bytes(check.size, "big" if check.order == "big" else "little")


def _checksum(check: PartLayout, data: bytes) -> bytes:
    """What the check of some parts is."""
    return data[check.at(len(data)) :][: check.size]


@dataclass(frozen=True, slots=True)
class Printed:
    """An example as the manual prints it.

    `frame` are its bytes as hexadecimal digits, empty where it is computed or has parts that are printed as dots;
    where only the row of characters is misprinted, they are the bytes of that row. `characters` is the row of
    characters, empty where the manual has none. The verdict is `ok`, `misprint`, or `open` where the manual does
    not decide which bytes are right. `errata` are all those of the example.
    """

    frame: str
    characters: str
    verdict: str
    errata: tuple[Erratum, ...]


def printed(device: Device, example: Example) -> Printed:
    """The print of an example: that of its errata, or else the example itself."""
    errata = tuple(erratum for erratum in device.errata if erratum.fact == example.place.path)
    frames = [erratum for erratum in errata if "frame" in erratum.printed]
    rows = [erratum for erratum in errata if "characters" in erratum.printed]
    characters = _characters(rows[0].printed["characters"]) if rows else example.characters
    if example.origin == "computed" or example.elided:
        frame = ""
    elif frames:
        frame = "".join(str(frames[0].printed["frame"]).split()).upper()
    else:
        frame = (characters.encode("latin-1", "replace") if rows else example.frame).hex().upper()
    verdict = "misprint" if frames or rows else "ok"
    if any(erratum.confidence == "open" for erratum in (*frames, *rows)):
        verdict = "open"
    return Printed(frame, characters, verdict, errata)


def _characters(held: object) -> str:
    """A row of characters as an erratum writes it, with its control characters."""
    return str(held).replace("\\r", "\r").replace("\\n", "\n")
