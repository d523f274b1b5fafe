"""A device at one version: everything that its spec says."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.address_space import BIT, WORD, WORDS, AddressSpace
from fieldspec.language.model.enums import Enum, Flags
from fieldspec.language.model.fact import LINES, PAGES, Citation, Place
from fieldspec.language.model.link import Link
from fieldspec.language.model.machines import StateMachine
from fieldspec.language.model.quantity import decimal_of, point_text, quantity_of
from fieldspec.language.model.record import Message, Record, RegisterAccess
from fieldspec.language.model.registers import ParameterSet, Register, RegisterGroup, Table
from fieldspec.language.model.task import Task
from fieldspec.language.model.texts import Acceptance, Erratum, Example, Limit, Lookup, Note, StatedChange
from fieldspec.language.model.units import DeclaredUnit, Unit, standard_unit
from fieldspec.language.model.value import Conversion, Signal, Value

if TYPE_CHECKING:
    from fractions import Fraction


@dataclass(frozen=True, slots=True)
class Manual:
    """The authority for a device's facts: a text of `lines`, a document of `pages`, or a page on the web at `url`."""

    title: str = ""
    edition: str = ""
    language: str = ""
    file: str = ""
    sha256: str = ""
    lines: int = 0
    pages: int = 0
    url: str = ""
    read: str = ""

    @property
    def mark(self) -> str:
        """The mark of the numbers in citations; empty for sections alone."""
        return LINES if self.lines else PAGES if self.pages else ""

    @property
    def unit(self) -> str:
        """What citations count: `lines` or `pages`; empty for sections alone."""
        return {LINES: "lines", PAGES: "pages", "": ""}[self.mark]

    @property
    def extent(self) -> str:
        """`manual.txt, 3193 lines`, `manual.pdf, 120 pages`, or the address and the day on which it was read."""
        return (
            f"{self.file}, {self.lines or self.pages} {self.unit}" if self.unit else f"{self.url}, read on {self.read}"
        )


@dataclass(frozen=True, slots=True)
class Detection:
    """The value that identifies the version of a device.

    `fact` is the path of a register, of a parameter or of a field. `form` is how a number in it is read: `decimal`
    or `hexadecimal` digits, of which `places` follow the point, or `bytes`; it is empty where the manual does not
    print it.
    """

    place: Place
    fact: str
    form: str
    places: int
    doc: str
    inferred: str
    sources: tuple[Citation, ...]


@dataclass(frozen=True, slots=True)
class Version:
    """One version of a line. `detected_as` is what the detecting value of the line is in this version."""

    id: str
    title: str
    doc: str
    inferred: str
    sources: tuple[Citation, ...]
    detected_as: tuple[int | str, ...] = ()


@dataclass(frozen=True, slots=True)
class VersionLine:
    """Versions that follow one another, the oldest first. Outputs are written for the versions of the built line.

    `like` is the line whose bounds apply to this one too, or empty; `inferred` is the reason. `detected_by` is the
    value that identifies the version of a device, or None.
    """

    name: str
    title: str
    builds: bool
    like: str
    inferred: str
    versions: tuple[Version, ...]
    detected_by: Detection | None = None


@dataclass(frozen=True, slots=True)
class Device:
    """A device at one version. Mappings are by name, in the order of the spec."""

    id: str
    version: str
    place: Place
    name: str
    vendor: str
    title: str
    doc: str
    manual: Manual
    lines: tuple[VersionLine, ...]
    links: Mapping[str, Link]
    messages: Mapping[str, Message]
    records: Mapping[str, Record]
    enums: Mapping[str, Enum]
    flags: Mapping[str, Flags]
    units: Mapping[str, DeclaredUnit]
    spaces: Mapping[str, AddressSpace]
    groups: tuple[RegisterGroup, ...]
    tables: Mapping[str, Table]
    parameters: Mapping[str, ParameterSet]
    signals: Mapping[str, Signal]
    conversions: Mapping[str, Conversion]
    lookups: tuple[Lookup, ...]
    limits: tuple[Limit, ...]
    tasks: tuple[Task, ...]
    notes: tuple[Note, ...]
    examples: Mapping[str, Example]
    errata: tuple[Erratum, ...]
    accepts: tuple[Acceptance, ...]
    stated_changes: tuple[StatedChange, ...]
    machines: tuple[StateMachine, ...]

    @property
    def detection(self) -> Detection | None:
        """The value that identifies the version, among those with outputs, of a device; None where no
        line states it.
        """
        lines = (line.detected_by for line in self.lines if line.builds or line.like)
        return next((detection for detection in lines if detection is not None), None)

    def registers(self) -> Iterator[Register]:
        """All registers in the order of the spec."""
        for group in self.groups:
            yield from group.registers

    def word_groups(self) -> Iterator[RegisterGroup]:
        """The groups in spaces of words."""
        return (group for group in self.groups if self.space(group.space).unit == WORD)

    def register(self, name: str) -> Register | None:
        """The register with a name, None if there is none."""
        return next((register for register in self.registers() if register.name == name), None)

    def unit(self, text: str) -> Unit | None:
        """The unit with a symbol: one that the spec declares, or one that the language has."""
        own = next((declared.unit for declared in self.units.values() if declared.symbol == text), None)
        return own or standard_unit(text)

    def quantity_in(self, number: Decimal, unit: str, target: str) -> Fraction | None:
        """A number in one unit as a number in another one, exactly; None if they do not measure the same."""
        old, new = self.unit(unit), self.unit(target)
        return old.in_unit(number, new) if old is not None and new is not None else None

    def entered_quantity(self, value: Value, entered: object) -> Fraction | None:
        """The exact quantity that is entered for a value, in its unit: `10.5mm`, and `1.05 cm` if the unit is mm.

        That of a value with a scale and without a unit has a decimal point, `2.0`, as a whole number is a count; in a
        spec, it is a decimal. None for other quantities.
        """
        text = point_text(entered) if isinstance(entered, float | Decimal) else entered
        if not isinstance(text, str):
            return None
        if not value.unit:
            number = decimal_of(text) if value.scaled else None
            return _fraction(number) if number is not None else None
        quantity = quantity_of(text)
        return self.quantity_in(*quantity, value.unit) if quantity is not None else None

    def space(self, name: str) -> AddressSpace:
        """The address space with a name; the first one for an empty name, or a name that no space has."""
        return self.spaces.get(name) or next(iter(self.spaces.values()), WORDS)

    def space_name(self, name: str) -> str:
        """The name of the space that `space` returns for a name; empty where the device declares none."""
        return name or next(iter(self.spaces), "")

    def register_access(self, message: Message) -> RegisterAccess | None:
        """How a message accesses registers of words or bytes; None where it accesses none, or a space of bits."""
        access = message.single_access
        return access if access is not None and self.space(access.space).unit != BIT else None

    def word_access(self, message: Message) -> RegisterAccess | None:
        """How a message accesses registers of words; None where it accesses none, or a space of bits or bytes."""
        access = message.single_access
        return access if access is not None and self.space(access.space).unit == WORD else None

    def bit_access(self, message: Message) -> RegisterAccess | None:
        """How a message accesses a space of bits; None where it accesses none."""
        access = message.single_access
        return access if access is not None and self.space(access.space).unit == BIT else None

    @property
    def several_spaces(self) -> bool:
        """Whether an address is ambiguous without the name of its space."""
        return len(self.spaces) > 1

    def sets(self, name: str) -> list[ParameterSet]:
        """The parameter set with a name, or all sets of the address space with that name."""
        single = self.parameters.get(name)
        return (
            [single]
            if single is not None
            else [parameter_set for parameter_set in self.parameters.values() if parameter_set.space == name]
        )

    def parameter_at(self, name: str, wire_number: int) -> tuple[ParameterSet, int] | None:
        """The set, named or in a space, that has a number on the wire, and the number in it; None if none does."""
        for parameter_set in self.sets(name):
            if parameter_set.holds(wire_number - parameter_set.base):
                return parameter_set, wire_number - parameter_set.base
        return None

    @property
    def default_link(self) -> str:
        """The name of the link that the device uses with factory settings: the first one if none is stated."""
        stated = (name for name, link in self.links.items() if link.is_default)
        return next(stated, next(iter(self.links), ""))

    @property
    def byte_order(self) -> str:
        """The byte order of the device's links."""
        return next((link.byte_order for link in self.links.values() if link.byte_order), "big")

    @property
    def word_order(self) -> str:
        """The order of the words in values of several registers; empty where no link states it."""
        return next((link.word_order for link in self.links.values() if link.word_order), "")


def _fraction(number: Decimal) -> Fraction:
    from fractions import Fraction

    return Fraction(number)
