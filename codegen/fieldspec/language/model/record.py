"""Records with their fields, and messages."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import takewhile

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.enums import Flags
from fieldspec.language.model.escape import CAN_REMOTE
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.value import Handling, Value


@dataclass(frozen=True, slots=True)
class Measure:
    """A field contains the size of another one, its `bytes` or its number of `items`, and a constant number more.

    It is the whole field, or some adjacent `bits` of it: the first and the last, bit 0 being the least significant.
    """

    of: str
    field: str
    plus: int = 0
    bits: tuple[int, int] | None = None

    def number(self, items: int, size: int) -> int:
        """The content of the field for a number of elements of `size` bytes."""
        return (items * size if self.of == "bytes" else items) + self.plus

    def unit(self, size: int) -> int:
        """The bytes for each unit of the number, where an element has `size` bytes."""
        return 1 if self.of == "bytes" else size

    @property
    def text(self) -> str:
        """`the number of bytes of options less 5, in bits 0..3`: what the field contains."""
        plus = f" {'plus' if self.plus > 0 else 'less'} {abs(self.plus)}" if self.plus else ""
        bits = f", in bits {self.bits[0]}..{self.bits[1]}" if self.bits is not None else ""
        return f"the number of {self.of} of {self.field}{plus}{bits}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Case(Fact):
    """The content of a field for some members of the enum of another field."""

    when: tuple[str, ...]
    value: Value


@dataclass(frozen=True, slots=True)
class Choice:
    """The type of a field depends on the value of an earlier field of its record, or on some adjacent `bits` of it.

    These are the first and the last of the bits. The value has an enum, or these bits of its flags have one.
    """

    by: str
    cases: tuple[Case, ...]
    bits: tuple[int, int] | None = None

    @property
    def mask(self) -> int | None:
        """The bits in the number of the earlier field; None where all of it decides."""
        return None if self.bits is None else (2 << self.bits[1]) - (1 << self.bits[0])

    @property
    def subject(self) -> str:
        """`bits 0..3 of dif`: what decides."""
        return self.by if self.bits is None else f"bits {self.bits[0]}..{self.bits[1]} of {self.by}"

    @property
    def has_widths(self) -> bool:
        """Whether one of the types is a text, or bytes, that another field counts, or has no bytes."""
        return any(case.value.width or not case.value.size for case in self.cases)

    def enum_of(self, selector: Field | None, words: Mapping[str, Flags]) -> str:
        """The name of the enum whose members decide; empty where the field that decides has none."""
        value = selector.value if selector is not None else None
        if value is None or self.bits is None:
            return value.enum if value is not None else ""
        word = words.get(value.flags)
        bits = [bit for bit in word.bits if (bit.first, bit.last) == self.bits and not bit.pieces] if word else []
        return bits[0].enum if bits else ""


@dataclass(frozen=True, slots=True)
class Presence:
    """A field is sent if any of some `bits` of the field `by` before it is 1 (all are 0 where `value` is 0), or if that
    field has a member in `when`. There are no `bits` where members decide. For the next element of a list, `by` is a
    field of each element, or empty where elements have no fields.
    """

    by: str
    bits: tuple[tuple[int, int], ...] = ()
    value: int = 1
    when: tuple[str, ...] = ()

    @property
    def subject(self) -> str:
        """`bit 3 of flags`, or `kind`: what says whether the field is sent."""
        name = self.by or "it"
        if not self.bits:
            return name
        places = ", ".join(str(low) if low == high else f"{low}..{high}" for low, high in self.bits)
        noun = "bit" if places.isdecimal() else "one of bits" if self.value else "each of bits"
        return f"{noun} {places} of {name}"

    @property
    def state(self) -> str:
        """`1`, or `place or speed`: what it says if the field is sent."""
        return str(self.value) if self.bits else " or ".join(self.when)

    @property
    def condition(self) -> str:
        """`bit 3 of flags is 1`, or `kind is place or speed`: when the field is sent."""
        return f"{self.subject} is {self.state}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Field(Fact):
    """A value or a record at one place, once, `count` times, or repeated to the end of the data.

    Exactly one of `value`, `record` (a name, else empty) and `choice` is given. `signal` names the signal that it
    places, else empty. `at`, `words`, `span` in bytes and `word_span` are what the manual prints. A constant
    that `is_implied` is not in the spec: a byte of the record's `separator`, or a DLC. A field with a `presence`
    repeats from 0 on; a list with a `continuation` ends after the first element that does not meet it. It `measures`
    another field as a whole, or by a `bit_measure` in some of its bits, which programs set and codecs compare.
    """

    value: Value | None
    record: str
    choice: Choice | None
    signal: str
    count: int | None
    repeat: Ranges | None
    presence: Presence | None
    continuation: Presence | None
    measures: Measure | None
    bit_measure: Measure | None
    reserved: bool
    at: int | None
    words: int | None
    span: tuple[int, int] | None
    word_span: tuple[int, int] | None
    access: str
    restart: bool | None
    atomic: bool
    handling: Handling
    same_as: str
    is_implied: bool = False

    @property
    def is_list(self) -> bool:
        """Whether it is a list of elements."""
        return self.count is not None or self.repeat is not None

    @property
    def stated_measure(self) -> Measure | None:
        """The measure that its whole content states, or some of its bits; None for a field that measures nothing."""
        return self.measures or self.bit_measure

    @property
    def may_be_empty(self) -> bool:
        """Whether one of its cases has no data, so that users may leave the field out."""
        return not self.is_list and self.choice is not None and any(not case.value.size for case in self.choice.cases)

    @property
    def is_optional(self) -> bool:
        """Whether it has one element or none, as another field says."""
        return self.presence is not None and self.repeat is not None and self.repeat.high == 1

    @property
    def tells_end(self) -> bool:
        """Whether it has no more than one element, or its elements say which of them is the last."""
        return self.is_optional or self.continuation is not None


@dataclass(frozen=True, slots=True, kw_only=True)
class Record(Fact):
    """Fields in the order of the wire. `size` in bytes and `words` are what the manual prints.

    `same_as` names the record with the same layout, else it is empty. The bytes of a `separator` are constants between
    its fields.
    """

    size: int | None
    words: int | None
    fields: tuple[Field, ...]
    same_as: str = ""

    @property
    def separator(self) -> bytes:
        """The bytes between each two fields that the spec states, none where nothing separates them."""
        constants = takewhile(lambda field: field.is_implied, self.fields[1:])
        return bytes(field.value.const or 0 for field in constants if field.value is not None)

    @property
    def stated_fields(self) -> tuple[Field, ...]:
        """The fields that the spec states one by one: all but the separators."""
        return tuple(field for field in self.fields if not field.is_implied)

    def named(self, name: str) -> Field | None:
        """The field with a name, None if there is none."""
        return next((field for field in self.fields if field.name == name), None)


@dataclass(frozen=True, slots=True)
class RegisterAccess:
    """A message reads or writes registers. The fields with the address, the number and the words or bits.

    `count` is empty where it is always one. `space` is empty where the spec names none, which means the first one of
    the device. `set` and `clear` are the numbers of a single bit that is 1 and 0; `set` is None where the bits are
    packed into bytes, the first one into the least significant bit, and in spaces of words. Only a step of a message
    with several has masks, and no `values` then: it writes (register AND `and_mask`) OR (`or_mask` AND NOT `and_mask`).
    """

    operation: str
    start: str
    count: str
    values: str
    space: str = ""
    set: int | None = None
    clear: int = 0
    and_mask: str = ""
    or_mask: str = ""

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the fields that the access refers to."""
        return tuple(filter(None, (self.start, self.count, self.values, self.and_mask, self.or_mask)))


STEP_FIELDS = ("start", "count", "values", "and_mask", "or_mask")
"""The keys of a step that name fields."""


@dataclass(frozen=True, slots=True)
class SegmentsAbort:
    """The message that ends the transfer of a value whose pieces do not follow: its field `reason` says why.

    `counter` and `size` are members of the enum of that field.
    """

    message: str
    reason: str
    counter: str
    size: str


@dataclass(frozen=True, slots=True)
class Segments:
    """A message begins to read or to write a value that follows in pieces, each in another `message`.

    It reads where `when` has members, of the field that says how many bytes of its response are the value. `size` is
    the field with the number of bytes of the whole value, which has none with the members `unsized`. `data` is the
    field with a piece. `counter`, `unused` and `last` are fields or bits of its message; each may be empty. `abort` is
    None where nothing ends a transfer before its last piece.
    """

    message: str
    when: tuple[str, ...]
    size: str
    unsized: tuple[str, ...]
    data: str
    counter: str
    unused: str
    last: str
    abort: SegmentsAbort | None = None

    @property
    def reads(self) -> bool:
        """Whether a value is read in pieces; else it is written."""
        return bool(self.when)


@dataclass(frozen=True, slots=True, kw_only=True)
class Message(Fact):
    """A code, the data of its request and of its response.

    A response has the code of its request, or `response_code`. A message without a code may have a `number` by which
    people know it. It is sent on `links`, which are all of the device's where they are empty, and never without one of
    those that it `supplements`. It is answered on the links in `answered_on`, which is None for all. The lengths of the
    frame are in bytes, and the words count the data, as printed. Outputs read and write registers by a message with a
    `single_access`; one that does more with registers has `access_steps`, and is never chosen. `remote` is the number
    of bytes that a remote request on a CAN bus asks for, which its only field repeats; None for other requests.
    """

    title: str
    group: str
    code: int | None
    number: int | None
    links: tuple[str, ...]
    answered_on: tuple[str, ...] | None
    supplements: tuple[str, ...]
    request: Record
    response: Record
    request_length: int | None
    response_length: int | None
    request_words: int | None
    response_words: int | None
    broadcast: bool | None
    handling: Handling
    accesses: tuple[RegisterAccess, ...]
    segments: Segments | None = None
    response_code: int | None = None
    is_requested: bool = True
    remote: int | None = None

    @property
    def single_access(self) -> RegisterAccess | None:
        """The access of a message that has no other one, and whose values are registers without masks."""
        access = self.accesses[0] if len(self.accesses) == 1 else None
        return access if access is not None and access.values and not access.and_mask and not access.or_mask else None

    @property
    def access_steps(self) -> tuple[RegisterAccess, ...]:
        """The accesses of a message that does more with registers than one access."""
        return self.accesses if self.single_access is None else ()

    def code_of(self, direction: str) -> int | None:
        """The code in one direction, `request` or `response`, as frames have it; None where the message has none."""
        if direction == "response":
            return self.code if self.response_code is None else self.response_code
        return self.code if self.code is None or self.remote is None else self.code | CAN_REMOTE

    def printed_code(self, direction: str) -> int | None:
        """The code in one direction as people know it; None where the message has none."""
        return self.code if direction == "request" else self.code_of("response")

    @property
    def has_response_code(self) -> bool:
        """Whether the code of its response differs from the code of its request."""
        return self.code_of("request") != self.code_of("response")

    @property
    def codes(self) -> tuple[tuple[str, int], ...]:
        """The codes of the request and of the response with the keys of the spec that state them, each once."""
        stated = (("code", self.code), ("response_code", self.response_code))
        return tuple((key, code) for key, code in stated if code is not None)

    @property
    def directions(self) -> tuple[str, ...]:
        """The directions in which it is sent on any link: `request`, `response`, or both."""
        return ("request",) * self.is_requested + ("response",) * self.is_answered

    @property
    def is_answered(self) -> bool:
        """Whether the device answers it on any link."""
        return self.answered_on != ()

    def is_answered_on(self, link: str) -> bool:
        """Whether the device answers it on a link."""
        return self.answered_on is None or link in self.answered_on
