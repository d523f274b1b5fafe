"""All that is declared for a device in a dialect, by its names there, and what is found while they are given."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.omissions import Omission, warning
from fieldspec.codec.layout.record import FieldLayout, RecordLayout, RegisterLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import Name
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.enums import Flags
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value
from fieldspec.targets.controllers.constants import LISTS, Constant, ConstantList, Draft
from fieldspec.targets.controllers.dialects import Dialect, Scope
from fieldspec.targets.controllers.enums import EnumDeclaration, EnumMember, TextTable, available, coded
from fieldspec.targets.controllers.layout import fitting
from fieldspec.targets.controllers.layout.fitting import CONVERT
from fieldspec.targets.controllers.layout.images import Images, Naming, titled
from fieldspec.targets.controllers.layout.memory import MEMORIES, Placed, placed
from fieldspec.targets.controllers.narrowing import narrowed
from fieldspec.targets.controllers.omissions import for_dialect
from fieldspec.targets.controllers.routines.blocks.ports import ports
from fieldspec.targets.controllers.routines.records import choice_type, field_type, is_user_field
from fieldspec.targets.controllers.routines.register_range import answer_name, answer_type, register_type
from fieldspec.targets.controllers.routines.registers import registers_of
from fieldspec.targets.controllers.routines.remarks import cited, member_remark, printed
from fieldspec.targets.controllers.routines.telegrams import telegrams
from fieldspec.targets.controllers.routines.world import Names, World
from fieldspec.targets.controllers.statements.expressions import EnumType, StructType, Type
from fieldspec.targets.controllers.statements.routine import BASE, STATUSES, Status
from fieldspec.targets.controllers.structs import Struct, StructMember, fixed
from fieldspec.targets.controllers.unsupported import (
    wide_enums,
    with_supported_links,
    with_supported_spaces,
    without_digits,
)

_STATUS = "codec_status"


@dataclass(frozen=True, slots=True)
class Declarations:
    """The declarations of a device, in a valid order.

    `structs` hold values, for programs; `images` are what lies on the wire, the process data of telegrams and whatever
    else is in the dialect's memory as it is there. Each follows those that lie in it. `world` has the same names
    for the routines. `status` is also the first one of `enums`. `findings` are the errors that forbid an output, and
    the warnings of what it leaves out, the `omissions`.
    """

    dialect: Dialect
    layout: DeviceLayout
    world: World
    enums: tuple[EnumDeclaration, ...]
    structs: tuple[Struct, ...]
    images: tuple[Struct, ...]
    constants: tuple[ConstantList, ...]
    texts: tuple[TextTable, ...]
    findings: tuple[Diagnostic, ...]
    omissions: tuple[Omission, ...]

    @property
    def status(self) -> EnumDeclaration:
        """The enum that routines return."""
        return self.enums[0]

    def placed(self, struct: Struct) -> Placed:
        """The offsets of the members of a struct or an image in the memory of the dialect."""
        structs = {struct.name: struct for struct in (*self.structs, *self.images)}
        return placed(struct, MEMORIES[self.dialect.target], structs)

    def image(self, key: str) -> Struct | None:
        """The image of the data of a message or of a record."""
        return next((struct for struct in self.images if struct.key == key and struct.kind != "bits"), None)


def declarations(layout: DeviceLayout, dialect: Dialect) -> Declarations:
    """The declarations of a device that has passed the checks."""
    with_spaces, space_findings = with_supported_spaces(layout, dialect)
    remaining = for_dialect(with_spaces, dialect)
    supported, frame_findings = with_supported_links(without_digits(remaining.layout), dialect)
    narrowed_layout = narrowed(supported, dialect)
    findings = [*remaining.findings, *space_findings, *frame_findings, *wide_enums(remaining.layout, dialect)]
    declaring = _Declaring(narrowed_layout, dialect, findings)
    enums = tuple(declaring.enums())
    structs = tuple(declaring.structs())
    images = tuple(declaring.images())
    constants = tuple(declaring.constants())
    texts = tuple(declaring.texts())
    structs += tuple(declaring.ports())
    return Declarations(
        dialect,
        narrowed_layout,
        declaring.world,
        enums,
        structs,
        images,
        constants,
        texts,
        tuple(declaring.found),
        (*remaining.omissions, *declaring.omissions),
    )


class _Declaring:
    """Gives the names of a device's declarations, and collects the findings."""

    def __init__(self, layout: DeviceLayout, dialect: Dialect, findings: list[Diagnostic]) -> None:
        self.layout, self.dialect, self.found = layout, dialect, findings
        self.omissions: list[Omission] = []
        self.device = Name.of(layout.device.id)
        self.scope = Scope(dialect, "name", findings)
        self.alone = Scope(dialect, "constant", findings)
        self._structs: dict[str, str] = {}
        self._members: dict[str, dict[str, str]] = {}
        self._enums: dict[str, EnumType] = {}
        self._enum_members: dict[str, dict[str, str]] = {}
        self.status_members = {name: self.member_of_enum(name) for name, _ in STATUSES}
        status = EnumType(self._enum_name(_STATUS, None), BASE)
        names = Names(
            self.device.pascal(),
            self._structs,
            self._members,
            self._enums,
            self._enum_members,
            Status(status, self.status_members),
            dialect.has_status,
            dialect.prefixed,
        )
        self.world = World(layout, names)

    def _form(self, form: str, name: str) -> str:
        return form.format(self.device.pascal(), Name.of(name).pascal())

    def _enum_name(self, name: str, fact: Fact | None) -> str:
        """The name of an enum; where it is not a type, what the names of its constants begin with."""
        if self.dialect.enums:
            return self.scope.take(self._form(self.dialect.enum, name), fact)
        return (self.device + Name.of(name)).upper()

    def member_of_enum(self, name: str) -> str:
        """The name of a member of an enum as the dialect accepts it."""
        return self.dialect.legal_name(Name.of(name).pascal())

    def enums(self) -> Iterator[EnumDeclaration]:
        """The status, and the enums that are types."""
        members = tuple(
            EnumMember(self.status_members[name], number, text) for number, (name, text) in enumerate(STATUSES)
        )
        yield EnumDeclaration(self.world.status.type.name, BASE, "The status that functions return.", members)
        for enum in self.layout.device.enums.values():
            present = available(enum)
            base = self.world.raw_type(enum.name)
            if len(present) < self.dialect.enum_members or base.size > self.dialect.widest:
                continue
            scope = Scope(self.dialect, f"member of {enum.name}", self.found)
            member_names = {member.name: scope.take(Name.of(member.name).pascal(), member) for member in present}
            name = self._enum_name(enum.name, enum)
            self._enums[enum.name] = EnumType(name, base)
            self._enum_members[enum.name] = member_names
            declared_members = (
                EnumMember(member_names[member.name], member.value, member_remark(member), member) for member in present
            )
            yield EnumDeclaration(name, base, cited(enum.title or printed(enum), enum), tuple(declared_members), enum)

    def structs(self) -> Iterator[Struct]:
        """The structs of records, of groups of registers, and of the data of telegrams."""
        for record in self.layout.records.values():
            if fixed(record):
                yield self._of_record(record, "record", record.record, titled(record.record))
        for message in telegrams(self.layout):
            for data in message.bodies:
                if data.size and fixed(data):
                    title = message.message.title or Name.of(message.name).title()
                    yield self._of_record(data, "telegram", message.message, title)
        for group in self.layout.device.groups:
            registers = registers_of(self.layout, group)
            if registers:
                scope = Scope(self.dialect, f"member of {group.name}", self.found)
                members = []
                for register in registers:
                    kind = register_type(self.world, register)
                    name = scope.take(self.member(register.name, kind), register.register)
                    remark = self.remark(register.register, register.register.value)
                    members.append(StructMember(name, kind, remark, register.register, register.register.value))
                    self._members.setdefault(group.name, {})[register.name] = name
                    answer = answer_type(self.world, register)
                    if answer is not None:
                        members.append(self._answer(scope, group.name, register, answer))
                title = group.title or Name.of(group.name).title()
                yield self._struct(group.name, "registers", group, title, members)

    def ports(self) -> Iterator[Struct]:
        """The structs that the blocks of a device share, by names that no fact has."""
        for port in ports(self.world):
            name = self._structs[port.key] = self.scope.free(self._form(self.dialect.struct, port.name))
            member_names = {text: self.dialect.legal_name(self.member(text, kind)) for text, kind, _ in port.members}
            self._members[port.key] = member_names
            members = [StructMember(member_names[text], kind, remark, None) for text, kind, remark in port.members]
            yield Struct(name, port.key, "port", port.title, tuple(members))

    def _answer(self, scope: Scope, group: str, register: RegisterLayout, kind: Type) -> StructMember:
        """The member that receives what the device answers, beside the one that holds what is written."""
        name = scope.take(self.member(answer_name(register), kind), register.register)
        remark = f"What reading {register.register.printed_name or register.name} gives, which may be any number."
        self._members[group][answer_name(register)] = name
        return StructMember(name, kind, remark, register.register, register.register.answer)

    def _of_record(self, record: RecordLayout, kind: str, fact: Fact, title: str) -> Struct:
        scope = Scope(self.dialect, f"member of {record.name}", self.found)
        members = []
        self._members[record.name] = {}
        for field in record.fields:
            if is_user_field(field):
                type_of = self._type(field)
                name = scope.take(self.member(field.name, type_of), field.field)
                members.append(
                    StructMember(name, type_of, self.remark(field.field, field.value), field.field, field.value)
                )
                self._members[record.name][field.name] = name
        return self._struct(record.name, kind, fact, title, members)

    def _struct(self, key: str, kind: str, fact: Fact, title: str, members: list[StructMember]) -> Struct:
        name = self.scope.take(self._form(self.dialect.struct, key), fact)
        self._structs[key] = name
        return Struct(name, key, kind, cited(title, fact), tuple(members), None, fact)

    def images(self) -> Iterator[Struct]:
        """The images of telegrams that are exact, and of those records that can be read as they lie."""
        memory, packed = MEMORIES[self.dialect.target], self.dialect.bits == "packed"
        spec_images = Images(self.layout, Naming(), packed)
        dialect_images = Images(self.layout, _DialectNaming(self), packed)
        for message in telegrams(self.layout):
            for data in message.bodies:
                if data.size and fixed(data):
                    title = message.message.title or Name.of(message.name).title()
                    proposal = spec_images.of(data, "telegram", message.message, title)
                    misfits = fitting.misfit_findings(placed(proposal, memory, spec_images.structs))
                    if not misfits:
                        dialect_images.of(data, "telegram", message.message, cited(title, message.message))
                        continue
                    left_out = f"image of {data.name}"
                    self.found += (warning(finding, f"the {left_out} is left out: {CONVERT}") for finding in misfits)
                    self.omissions.append(Omission(left_out, f"{misfits[0].message}; {CONVERT}"))
        for record in self.layout.records.values():
            if fixed(record):
                image = spec_images.of(record, "record", record.record, record.record.label)
                if fitting.readable(placed(image, memory, spec_images.structs)):
                    dialect_images.of(record, "record", record.record, cited(titled(record.record), record.record))
        yield from dialect_images.structs.values()

    def _type(self, field: FieldLayout) -> Type:
        if field.record is not None and field.record.name not in self._structs:
            return StructType(self._form(self.dialect.struct, field.record.name))
        return choice_type(field) if field.cases else field_type(self.world, field)

    def member(self, name: str, kind: Type) -> str:
        """The name of a member of a struct."""
        return self.world.variable(name, kind) if self.dialect.prefixed else Name.of(name).camel()

    def remark(self, fact: Fact, value: Value | None) -> str:
        """The comment on a member: its value, its meaning and its place in the manual."""
        comment = self.world.comment(fact, value)
        joint = " " if comment.startswith("[") else ": "
        return joint.join(part for part in (printed(fact), comment) if part)

    def constants(self) -> Iterator[ConstantList]:
        """The lists of constants that are not empty."""
        types = frozenset(self._enums) if self.dialect.enums else frozenset[str]()
        for key, (word, title, make) in LISTS.items():
            drafts = [*(self._statuses() if key == "codes" else ()), *make(self.layout, types)]
            drafts = [
                draft for draft in drafts if draft.type.family == "real" or draft.type.size <= self.dialect.widest
            ]
            if drafts:
                name = self._form(self.dialect.constants, key)
                yield ConstantList(name, key, title, tuple(self._named(drafts, name, word)))

    def _statuses(self) -> Iterator[Draft]:
        """The constants for the statuses of functions, where the dialect has no enums."""
        if not self.dialect.enums:
            for number, (name, text) in enumerate(STATUSES):
                yield Draft(f"{_STATUS}_{name}", BASE, number, text, None, derived=True)

    def _named(self, drafts: list[Draft], list_name: str, word: str) -> Iterator[Constant]:
        qualified = self.dialect.qualified
        scope = Scope(self.dialect, f"constant of {list_name}", self.found) if qualified else self.alone
        before = Name(()) if qualified else self.device + Name.of(word)
        texts = []
        for draft in drafts:
            name = (before + Name.of(draft.name)).upper()
            texts.append(name if self.dialect.legal_name(name) == name else f"{name}_VALUE")
        constant_names: dict[int, str] = {}
        for derived in (False, True):
            for number, draft in enumerate(drafts):
                if draft.derived is derived:
                    constant_names[number] = (
                        scope.free(texts[number]) if derived else scope.take(texts[number], draft.fact)
                    )
        for number, draft in enumerate(drafts):
            yield Constant(constant_names[number], draft.type, draft.value, draft.remark, draft.fact, draft.hexadecimal)

    def texts(self) -> Iterator[TextTable]:
        """The tables of the texts of codes."""
        scope = Scope(self.dialect, "table of texts", self.found)
        for enum, texts in coded(self.layout.device):
            name = scope.take(Name.of(f"{enum.name}_texts").upper(), enum)
            yield TextTable(name, cited(enum.title or printed(enum), enum), enum, texts)


class _DialectNaming(Naming):
    """The names of images in a dialect."""

    def __init__(self, declaring: _Declaring) -> None:
        self._of = declaring

    def struct(self, key: str, fact: Fact) -> str:
        form = self._of.dialect.bit_struct if isinstance(fact, Flags) else self._of.dialect.image
        return self._of.scope.take(form.format(self._of.device.pascal(), Name.of(key).pascal()), fact)

    def members(self, key: str, members: Sequence[tuple[str, Fact | None, Type]]) -> list[str]:
        scope = Scope(self._of.dialect, f"member of {key}", self._of.found)
        texts = [self._of.member(name, kind) for name, _, kind in members]
        fact_names = [
            scope.take(text, fact) if fact is not None else ""
            for text, (_, fact, _) in zip(texts, members, strict=True)
        ]
        return [name or scope.free(text) for name, text in zip(fact_names, texts, strict=True)]

    def remark(self, fact: Fact, value: Value | None) -> str:
        return self._of.remark(fact, value)
