"""A device as a program: all its objects in an order in which each follows those that it uses.

Members of structs lie, packed, where their fields lie on the wire: what users do not get is padding by name. Arrays
that routines receive by reference have named types, as an argument must have exactly the bounds of its parameter.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.names import Name
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.targets.controllers.cache import cached
from fieldspec.targets.controllers.chosen import chosen_routines, trimmed
from fieldspec.targets.controllers.declarations import Declarations, declarations
from fieldspec.targets.controllers.dialects import STRUCTURED, Dialect, Spelling
from fieldspec.targets.controllers.layout.memory import MEMORIES, Placed, placed
from fieldspec.targets.controllers.routines.all_routines import routines
from fieldspec.targets.controllers.routines.printer import (
    array_name,
    comment,
    comment_text,
    declaration,
    implementation,
    type_text,
)
from fieldspec.targets.controllers.routines.records import is_user_field
from fieldspec.targets.controllers.routines.remarks import left_out, without_block
from fieldspec.targets.controllers.statements.expressions import BYTE, ArrayType, Type, sequence
from fieldspec.targets.controllers.statements.routine import Routine
from fieldspec.targets.controllers.structs import Struct, StructMember
from fieldspec.targets.controllers.structured.examples import examples
from fieldspec.targets.controllers.structured.objects import (
    Item,
    TextForm,
    constants_item,
    enum_item,
    form_item,
    sizes_item,
    struct_item,
    text_form,
    texts_item,
)
from fieldspec.targets.fact_texts import manual_remark


@dataclass(frozen=True, slots=True)
class Program:
    """The declarations, with padded structs, in memory, and the routines. `texts` is None where there are none.

    `spelling` names the arrays that routines receive by reference. `functions` are the routines as text, `items` all
    objects, with the functions last. `missing` are the tasks without a block, with the reasons.
    """

    declared: Declarations
    structs: tuple[Struct, ...]
    placed: tuple[Placed, ...]
    texts: TextForm | None
    spelling: Spelling
    routines: tuple[Routine, ...]
    functions: tuple[Item, ...]
    sizes: Item
    items: tuple[Item, ...]
    missing: tuple[tuple[str, str], ...]

    @property
    def texts_list(self) -> str:
        """The name of the list with the texts of codes."""
        return _texts_list(self.declared)

    def about(self) -> list[str]:
        """The lines at the head of a file."""
        return about(self.declared)

    def guide(self) -> list[str]:
        """The lines that explain the use of the functions, for the head of a file with all objects."""
        return [
            "Each function returns a status. Use its outputs and in-out variables only if it is Ok.",
            "Array arguments have named types, because their bounds must equal the parameter's.",
            "Structs use the byte order of the CPU. Members of records lie where their fields lie on the",
            "wire, but the order of bytes may be another one: use the functions, and do not copy memory.",
            *examples(self.declared.world, self.routines, self.spelling),
            *without_block(self.missing),
        ]


def origin(layout: DeviceLayout) -> str:
    """The line at the head of an object that is a file of its own; its project has the others."""
    device = layout.device
    text = f"{device.name} {device.version}, layout {layout.identity}. Written by fieldspec: change the spec instead."
    return comment_text(text)


def about(declared: Declarations) -> list[str]:
    """The lines at the head of every file of a device."""
    layout = declared.layout
    device = layout.device
    return [
        comment_text(f"{device.name} ({device.vendor}), version {device.version}"),
        comment_text(manual_remark(device.manual)),
        f"Identity of the layout: {layout.identity}",
        "Written by fieldspec. Do not edit: change the spec and build again.",
        *left_out(declared.omissions),
    ]


def refusals(layout: DeviceLayout, dialect: Dialect) -> list[Diagnostic]:
    """The facts that a Structured Text dialect cannot express: the same in all dialects, but each has its title."""
    return list(declarations(layout, dialect).findings) if declared_in_text(layout).findings else []


@cached
def declared_in_text(layout: DeviceLayout) -> Declarations:
    """The declarations of a device in Structured Text."""
    return declarations(layout, STRUCTURED)


@cached
def program(layout: DeviceLayout) -> Program:
    """The program of a device that has no findings, in Structured Text, whose dialects differ in their files alone."""
    declared = declared_in_text(layout)
    all_blocks = routines(declared.world)
    device_routines = chosen_routines(declared.world, all_blocks.routines)
    declared = trimmed(declared, device_routines, STRUCTURED.spelling)
    structs = padded(declared)
    by_name = {struct.name: struct for struct in structs}
    placed_structs = tuple(placed(struct, PACKED, by_name) for struct in structs)
    device = _device(declared.layout)
    texts = text_form(declared.texts, STRUCTURED.texts.format(device, "Code"))
    sizes = {placed.struct.name: placed.size for placed in placed_structs if placed.struct.members}
    item = sizes_item(f"F_{device}_SizesAreRight", sizes)
    array = STRUCTURED.spelling.array.format(device, "{}")
    spelling = replace(STRUCTURED.spelling, array=array, named=lent_arrays(device_routines))
    functions = tuple(_function(routine, spelling) for routine in device_routines)
    items = (*_items(declared, placed_structs, texts, device_routines, spelling), item, *functions)
    return Program(
        declared, structs, placed_structs, texts, spelling, device_routines, functions, item, items, all_blocks.missing
    )


def _items(
    declared: Declarations,
    placed_structs: Sequence[Placed],
    texts: TextForm | None,
    routines_of_device: Sequence[Routine],
    spelling: Spelling,
) -> Iterator[Item]:
    """All objects except the functions, those first that others use."""
    yield from map(enum_item, declared.enums)
    known: set[str] = set()
    for placed_struct in placed_structs:
        members = [member.type for member in placed_struct.struct.members]
        yield from (array_item(kind, spelling) for kind in named_arrays(members, spelling, known))
        yield struct_item(placed_struct.struct, placed_struct.size, spelling)
    kinds = (item.variable.type for routine in routines_of_device for item in routine.declared)
    yield from (array_item(kind, spelling) for kind in named_arrays(kinds, spelling, known))
    if texts is not None:
        yield form_item(texts)
    yield from map(constants_item, declared.constants)
    if texts is not None:
        yield texts_item(_texts_list(declared), declared.texts, texts)


def _function(routine: Routine, spelling: Spelling) -> Item:
    lines = tuple(declaration(routine, spelling)), tuple(implementation(routine, spelling))
    return Item(routine.name, "function" if routine.returns is not None else "block", routine.group, *lines)


def _texts_list(declared: Declarations) -> str:
    return declared.dialect.constants.format(_device(declared.layout), "CodeTexts")


def newest(versions: Sequence[DeviceLayout]) -> DeviceLayout:
    """The version that the program of a device is written for: the newest of those that are requested."""
    return versions[-1]


def _device(layout: DeviceLayout) -> str:
    return Name.of(layout.device.id).pascal()


PACKED = MEMORIES["tc3:1"]
"""Where nothing is aligned: what pack_mode 1 says."""


def padded(declared: Declarations) -> tuple[Struct, ...]:
    """The structs of a device; structs of records and telegrams have padding."""
    structs: dict[str, Struct] = {}
    for struct in declared.structs:
        record = _record(declared.layout, struct)
        structs[struct.name] = struct if record is None else _filled(struct, record, structs)
    return tuple(structs.values())


def _record(layout: DeviceLayout, struct: Struct) -> RecordLayout | None:
    if struct.kind == "record":
        return layout.records[struct.key]
    data = (record for message in layout.messages.values() for record in message.bodies)
    return next((record for record in data if struct.kind == "telegram" and record.name == struct.key), None)


def _filled(struct: Struct, record: RecordLayout, structs: dict[str, Struct]) -> Struct:
    """The struct with padding where a field is not given, or takes more bytes on the wire than its variable."""
    members = {id(member.fact): member for member in struct.members}
    used_names = {member.name.lower() for member in struct.members}
    filled_members: list[StructMember] = []
    offset = 0
    for field in record.fields:
        size = field.size * (field.count or 1)
        if is_user_field(field):
            member = members[id(field.field)]
            filled_members.append(replace(member, at=field.offset, order=field.order, swapped=field.swapped))
            offset += placed(replace(struct, members=(member,)), PACKED, structs).size
        missing = field.offset + size - offset
        if missing > 0:
            filled_members.append(_padding(missing, field, used_names, offset))
            offset += missing
    return replace(struct, members=tuple(filled_members), size=record.size)


def _padding(size: int, field: FieldLayout, used_names: set[str], offset: int) -> StructMember:
    prefix, number = "by" if size == 1 else "aby", 1
    while f"{prefix}padding{number}" in used_names:
        number += 1
    used_names.add(f"{prefix}padding{number}")
    remark = f"fills up {field.name}" if is_user_field(field) else f"{field.name} on the wire; the functions set it"
    kind = BYTE if size == 1 else sequence(size, BYTE)
    return StructMember(f"{prefix}Padding{number}", kind, remark, None, None, offset)


def lent_arrays(routines: Iterable[Routine]) -> frozenset[ArrayType]:
    """The types of the arrays that routines have as VAR_IN_OUT."""
    declared = (declared for routine in routines for declared in routine.of_role("in_out"))
    return frozenset(item.variable.type for item in declared if isinstance(item.variable.type, ArrayType))


def named_arrays(kinds: Iterable[Type], spelling: Spelling, known: set[str]) -> Iterator[ArrayType]:
    """The arrays that have a name, as far as it is not known yet; each after those that lie in it."""
    for kind in kinds:
        if not isinstance(kind, ArrayType):
            continue
        yield from named_arrays([kind.of], spelling, known)
        if kind in spelling.named:
            name = array_name(kind, spelling)
            if name not in known:
                known.add(name)
                yield kind


def array_item(kind: ArrayType, spelling: Spelling) -> Item:
    """The declaration of an array type with a name."""
    title = "For arguments: the bounds of an array must equal the parameter's."
    bounds = f"ARRAY[{kind.low}..{kind.high}] OF {type_text(kind.of, spelling)}"
    lines = (*comment(title), f"TYPE {array_name(kind, spelling)} : {bounds};", "END_TYPE")
    return Item(array_name(kind, spelling), "type", "arrays", lines)
