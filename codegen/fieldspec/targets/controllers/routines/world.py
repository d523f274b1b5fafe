"""What routines need to know of the declarations around them: names, types, sizes of arrays."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from fieldspec.codec.layout.bits import packed_size
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.foundation.classes import dataclass, field
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.foundation.names import Name
from fieldspec.language.model.address_space import BIT as BIT_UNIT
from fieldspec.language.model.checksums import checksum_named
from fieldspec.language.model.encoding import Digits, Encoding, Octets, Precision, Real, Text, Truth, Whole
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.record import Message, RegisterAccess
from fieldspec.language.model.registers import RegisterGroup
from fieldspec.language.model.value import Value
from fieldspec.targets.controllers.cache import cached
from fieldspec.targets.controllers.routines.remarks import of_value, source
from fieldspec.targets.controllers.statements.expressions import (
    BITS,
    BOOL,
    BYTE,
    ELEMENTARY,
    REAL,
    USINT,
    WORD,
    ArrayType,
    Call,
    Elementary,
    EnumType,
    Expression,
    StructType,
    Type,
    sequence,
)
from fieldspec.targets.controllers.statements.numbers import whole_type
from fieldspec.targets.controllers.statements.routine import Status

_NARROWEST_FIRST = ("USINT", "SINT", "UINT", "INT", "UDINT", "DINT", "ULINT", "LINT")
PREFIXES = {
    "BOOL": "x",
    "BYTE": "by",
    "WORD": "w",
    "DWORD": "dw",
    "LWORD": "lw",
    "USINT": "usi",
    "UINT": "ui",
    "UDINT": "udi",
    "ULINT": "uli",
    "SINT": "si",
    "INT": "i",
    "DINT": "di",
    "LINT": "li",
    "REAL": "r",
    "LREAL": "lr",
}
"""The prefix of a variable of an elementary type."""


@dataclass(frozen=True, slots=True)
class Names:
    """How the declarations call what belongs to the device.

    `structs` are known by the names of records, of groups of registers and of the data of telegrams, `members` by those
    and the names of fields and registers. An enum that is missing in `enums` is not a type; its values are numbers.
    `has_status` says that blocks have a WORD that says how they are, in place of the number of an error. `prefixed`
    says that names of functions and blocks begin with letters for what they are.
    """

    device: str
    structs: Mapping[str, str]
    members: Mapping[str, Mapping[str, str]]
    enums: Mapping[str, EnumType]
    enum_members: Mapping[str, Mapping[str, str]]
    status: Status
    has_status: bool = False
    prefixed: bool = True


@dataclass(frozen=True, slots=True)
class World:
    """A device, and how the declarations call its parts.

    `port_members` are the members of ports with their names and types, once one of them is used.
    """

    layout: DeviceLayout
    names: Names
    port_members: dict[str, dict[str, tuple[str, Type]]] = field(default_factory=dict)
    _raw: dict[str, Elementary] = field(default_factory=dict)

    def routine(self, *parts: str) -> str:
        """The name of a routine: `F_Gadget_ReadPoint`, or `Gadget_ReadPoint`"""
        return self._name("F_", parts)

    def block(self, *parts: str) -> str:
        """The name of a function block: `FB_Gadget_ReadRegisters`, or `Gadget_ReadRegisters`"""
        return self._name("FB_", parts)

    def _name(self, prefix: str, parts: Sequence[str]) -> str:
        words = Name(())
        for part in parts:
            words += Name.of(part)
        return f"{prefix if self.names.prefixed else ''}{self.names.device}_{words.pascal()}"

    def variable(self, name: str, kind: Type) -> str:
        """The name of a variable for a part or a field: `uiSpeed`, `stPoint`, `aCorners`"""
        if isinstance(kind, Elementary):
            prefix = PREFIXES[kind.name]
        else:
            prefix = "a" if isinstance(kind, ArrayType) else "e" if isinstance(kind, EnumType) else "st"
        return prefix + Name.of(name).pascal()

    def comment(self, fact: Fact, value: Value | None) -> str:
        """The comment on a fact and its value: unit, range, meaning, place in the manual."""
        return " ".join(part for part in (of_value(value), source(fact)) if part)

    def checksum(self, algorithm: str, length: Expression, frame: Expression, first: Expression) -> Call:
        """The check of the bytes of a frame from an index on up to a length."""
        kind = BITS[checksum_named(algorithm).size]
        begin = (("iFirst", first),) if self.begins_later(algorithm) else ()
        return Call(self.routine(algorithm), (*begin, ("iLength", length), ("aFrame", frame)), (), kind)

    def begins_later(self, algorithm: str) -> bool:
        """Whether a check with an algorithm covers bytes that do not begin with the first one."""
        shapes = (shape for link in self.layout.links.values() for shape in (link.request, link.response))
        checks = (shape.checksum for shape in shapes)
        return any(check is not None and check.algorithm == algorithm and check.start != 0 for check in checks)

    def struct(self, name: str) -> StructType:
        """The struct of a record, a group of registers, or the data of a telegram."""
        return StructType(self.names.structs[name])

    def member(self, struct: str, name: str) -> str:
        """A member of a struct."""
        return self.names.members[struct][name]

    @property
    def status(self) -> Status:
        """What routines return."""
        return self.names.status

    def type_of(self, value: Value) -> Type:
        """The type of the variable that holds a value: an enum where it is closed, bits where bits have meanings."""
        encoding = value.encoding
        match encoding:
            case Text() | Octets():
                return sequence(value.size, BYTE)
            case Truth():
                return BOOL
            case Real():
                return REAL
            case Whole() | Digits():
                return self._type_of_count(value)
            case _:
                assert_never(encoding)

    def _type_of_count(self, value: Value) -> Elementary | EnumType:
        if value.flags:
            return BITS[value.size]
        if value.enum and not value.sentinels and not self.layout.device.enums[value.enum].open:
            enum_type = self.names.enums.get(value.enum)
            if enum_type is not None:
                return enum_type
        return whole_type(value.encoding)

    def raw_type(self, enum: str) -> Elementary:
        """The narrowest type that holds every number that a value with an enum may have on the wire."""
        if not self._raw:
            self._raw.update((name, narrowest(*bounds)) for name, bounds in raw_bounds(self.layout).items())
        return self._raw[enum]

    def enum_from_raw(self, enum: str, raw: Expression, target: Expression) -> Call:
        """Whether a number is listed; the target receives the member."""
        return Call(
            self.routine(enum, "from_raw"), ((raw_name(self.raw_type(enum)), raw),), (("eValue", target),), BOOL
        )

    def enum_to_raw(self, enum: str, source: Expression, target: Expression) -> Call:
        """Whether a variable holds a member; the target receives its number."""
        return Call(
            self.routine(enum, "to_raw"), (("eValue", source),), ((raw_name(self.raw_type(enum)), target),), BOOL
        )

    def real_from_bits(self, precision: Precision, bits: Expression, target: Expression) -> Call:
        """A status; the target receives the number."""
        words, bits_name = real_words(precision)
        return Call(self.routine("real_from", *words), ((bits_name, bits),), (("rValue", target),), self.status.type)

    def bits_from_real(self, precision: Precision, source: Expression, target: Expression) -> Call:
        """A status; the target receives the bits."""
        words, bits_name = real_words(precision)
        return Call(self.routine(*words, "from_real"), (("rValue", source),), ((bits_name, target),), self.status.type)

    def number_from_magnitude(self, whole: Whole, bits: Expression) -> Call:
        """The number that a sign and a magnitude are."""
        return Call(
            self.routine("number_from", magnitude_name(whole)), ((bits_name(whole), bits),), (), whole_type(whole)
        )

    def magnitude_from_number(self, whole: Whole, number: Expression) -> Call:
        """The bits of a number with a sign and a magnitude."""
        return Call(
            self.routine(magnitude_name(whole), "from_number"),
            ((f"{PREFIXES[whole_type(whole).name]}Value", number),),
            (),
            BITS[whole.bits // 8],
        )

    @property
    def frame(self) -> ArrayType:
        """The bytes of the longest frame of any link whose frames are more than a body."""
        return sequence(max(_frame_sizes(self.layout), default=1), BYTE)

    @property
    def bits(self) -> ArrayType:
        """The bytes of the longest list of bits that a message carries; where none does, of the longest group."""
        device = self.layout.device
        lists = [count for count, _ in _lists(self.layout, device.bit_access)]
        groups = [group for group in device.groups if device.space(group.space).unit == BIT_UNIT] if not lists else []
        return sequence(max([*lists, *(packed_size(_span(group)) for group in groups)], default=1), USINT)

    @property
    def words(self) -> ArrayType:
        """The words of the longest list of registers that a message carries; where none does, of the longest group."""
        lists = [count * size // 2 for count, size in _lists(self.layout, self.layout.device.word_access)]
        tables = [table.words for table in self.layout.tables.values()]
        return sequence(max([*lists, *tables, *([] if lists else [_longest_group(self.layout)])], default=1), WORD)


def real_words(precision: Precision) -> tuple[tuple[str, ...], str]:
    """The words for the bits of a floating-point number in the names of functions, and the parameter for them.

    Raises AssertionError for 64 bits, for which there are no functions.
    """
    match precision:
        case Precision.HALF:
            return ("half", "bits"), "wBits"
        case Precision.SINGLE:
            return ("bits",), "dwBits"
        case Precision.DOUBLE:
            raise AssertionError("functions do not convert numbers of 64 bits")
        case _:
            assert_never(precision)


def magnitude_name(whole: Whole) -> str:
    """The word for a sign and a magnitude in the names of functions."""
    return f"sm{whole.bits}"


def bits_name(whole: Whole) -> str:
    """The parameter for the bits of a number."""
    return f"{PREFIXES[BITS[whole.bits // 8].name]}Bits"


def raw_name(kind: Elementary) -> str:
    """The parameter for a number on the wire."""
    return f"{PREFIXES[kind.name]}Raw"


@cached
def _longest_group(layout: DeviceLayout) -> int:
    """The words of the longest group of registers."""
    return max((_span(group) for group in layout.device.word_groups()), default=1)


def _span(group: RegisterGroup) -> int:
    ends = [register.end for register in group.registers]
    return max(ends, default=1) - min((register.address for register in group.registers), default=0)


def _frame_sizes(layout: DeviceLayout) -> Iterator[int]:
    for link in layout.links.values():
        width = 2 if link.link.transmission == "hex_ascii" else 1
        for direction in ("request", "response"):
            shape = link.frame(direction)
            marks = len(shape.start) + len(shape.end)
            part_size = shape.header_size + shape.trailer_size
            if part_size + marks or width > 1:
                bodies = [message.data(direction).most or 0 for message in link.carried(direction).values()]
                yield (part_size + max(bodies, default=0)) * width + marks


def _lists(layout: DeviceLayout, access_of: Callable[[Message], RegisterAccess | None]) -> Iterator[tuple[int, int]]:
    """The most elements of each list of registers or bits that a message carries, and the bytes of one."""
    for message in layout.messages.values():
        access = access_of(message.message)
        for data in message.bodies:
            field = data.named(access.values) if access is not None else None
            if field is not None and field.field.repeat is not None:
                yield field.field.repeat.high, field.size


def values_of(layout: DeviceLayout) -> Iterator[Value]:
    """All values of a device: of records, messages, headers of frames, registers and parameters."""
    for record in every_record(layout):
        yield from (field.value for field in record.fields if field.value is not None)
    for link in layout.links.values():
        for shape in (link.request, link.response):
            yield from (part.value for part in shape.parts if part.value is not None)
    yield from (register.register.value for register in layout.registers)
    for parameter_set in layout.device.parameters.values():
        for parameter in parameter_set.parameters:
            yield parameter.value
            yield from (inner.value for inner in parameter.subindices)


def encodings_of(layout: DeviceLayout) -> frozenset[Encoding]:
    """The encodings of all values of a device, and of the types that fields may have which another one decides."""
    cases = [case.value for record in every_record(layout) for field in record.fields for case in field.cases]
    return frozenset(value.encoding for value in (*values_of(layout), *cases))


def every_record(layout: DeviceLayout) -> Iterator[RecordLayout]:
    """All records, and the data of all messages."""
    yield from layout.records.values()
    for message in layout.messages.values():
        yield from message.bodies


def raw_bounds(layout: DeviceLayout) -> dict[str, tuple[int, int]]:
    """The least and the greatest number that values with each enum may have on the wire."""
    bounds: dict[str, tuple[int, int]] = {}

    def widen(enum: str, low: int, high: int) -> None:
        before = bounds.get(enum, (0, 0))
        bounds[enum] = min(before[0], low), max(before[1], high)

    for value in values_of(layout):
        if value.enum:
            widen(value.enum, value.type.low, value.type.high)
    for word in layout.device.flags.values():
        for bit in word.bits:
            if bit.enum:
                widen(bit.enum, 0, (1 << bit.width) - 1)
    for enum in layout.device.enums.values():
        for member in enum.members:
            widen(enum.name, member.value, member.value)
        bounds.setdefault(enum.name, (0, 0))
    return bounds


def has_common_type(low: int, high: int) -> bool:
    """Whether a type of whole numbers holds two of them: none holds a negative one and one from 2^63 on."""
    return low >= 0 or high <= ELEMENTARY["LINT"].high


def narrowest(low: int, high: int) -> Elementary:
    """The narrowest type of whole numbers that holds two of them; LINT where none does, which is refused."""
    kinds = (ELEMENTARY[name] for name in _NARROWEST_FIRST)
    return next((kind for kind in kinds if kind.low <= low and high <= kind.high), ELEMENTARY["LINT"])
