"""A device as a program: all its objects in an order in which each stands behind those that it uses."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.classes import dataclass
from fieldspec.layout.device import DeviceLayout
from fieldspec.names import Name
from fieldspec.plc.declarations import Declarations, declarations
from fieldspec.plc.dialects import Dialect
from fieldspec.plc.layout.placing import Placed, placed
from fieldspec.plc.routines.device import routines
from fieldspec.plc.routines.routine import Routine
from fieldspec.plc.routines.written import declaration, implementation, plain
from fieldspec.plc.structs import Struct
from fieldspec.plc.structured.examples import examples
from fieldspec.plc.structured.item import Item
from fieldspec.plc.structured.lists import TextForm, constants_item, form_item, text_form, texts_item
from fieldspec.plc.structured.padding import PACKED, padded
from fieldspec.plc.structured.sizes import sizes_item
from fieldspec.plc.structured.types import enum_item, struct_item


@dataclass(frozen=True, slots=True)
class Program:
    """What is declared, its structs with padding, in memory, and the routines. `texts` is None where there are none."""

    declared: Declarations
    structs: tuple[Struct, ...]
    placed: tuple[Placed, ...]
    texts: TextForm | None
    routines: tuple[Routine, ...]
    sizes: Item

    @property
    def texts_list(self) -> str:
        """The name of the list with the texts of codes."""
        return self.declared.dialect.constants.format(_device(self.declared.layout), "CodeTexts")

    def items(self) -> list[Item]:
        """All objects."""
        spelling = self.declared.dialect.spelling
        made = [enum_item(one) for one in self.declared.enums]
        made += [struct_item(one.struct, one.size) for one in self.placed]
        if self.texts is not None:
            made.append(form_item(self.texts))
        made += [constants_item(one) for one in self.declared.constants]
        if self.texts is not None:
            made.append(texts_item(self.texts_list, self.declared.texts, self.texts))
        made.append(self.sizes)
        for one in self.routines:
            lines = tuple(declaration(one, spelling)), tuple(implementation(one, spelling))
            made.append(Item(one.name, "function", one.group, *lines))
        return made

    def about(self) -> list[str]:
        """What stands at the head of a file."""
        layout = self.declared.layout
        device = layout.device
        manual = f"{device.manual.title} {device.manual.edition}".strip()
        return [
            plain(f"{device.name} ({device.vendor}), version {device.version}"),
            plain(f"Manual: {manual}. A note such as [8.2 L1622] is a section and a line of it."),
            f"Identity of the layout: {layout.identity}",
            "Written by fieldspec. Do not edit: change the spec and build again.",
        ]

    def guide(self) -> list[str]:
        """How the functions are used, for the head of a file that has everything."""
        spelling = self.declared.dialect.spelling
        return [
            "Each function returns a status. Unless that is Ok, its outputs and what it was to fill must not be used.",
            "Structs hold numbers as the processor has them. Members of records lie where their fields lie on the",
            "wire, but the order of bytes may be another one: use the functions, and do not copy memory.",
            *examples(self.declared.world, self.routines, spelling),
        ]


def program(layout: DeviceLayout, dialect: Dialect) -> Program:
    """The program of a device that has no findings."""
    declared = declarations(layout, dialect)
    structs = padded(declared)
    by_name = {struct.name: struct for struct in structs}
    where = tuple(placed(struct, PACKED, by_name) for struct in structs)
    device = _device(declared.layout)
    texts = text_form(declared.texts, dialect.texts.format(device, "Code"))
    sizes = {one.struct.name: one.size for one in where if one.struct.members}
    item = sizes_item(f"F_{device}_SizesAreRight", sizes)
    return Program(declared, structs, where, texts, tuple(routines(declared.world)), item)


def newest(versions: Sequence[DeviceLayout]) -> DeviceLayout:
    """The version that a program is made of: the newest of those that are asked for."""
    return versions[-1]


def stem(layout: DeviceLayout) -> str:
    """The name of a version's files: `gadget_v2_0`"""
    words = Name.of(layout.device.version).snake()
    version = f"v{words}" if words[:1].isdigit() else words
    return f"{Name.of(layout.device.id).snake()}_{version}"


def _device(layout: DeviceLayout) -> str:
    return Name.of(layout.device.id).pascal()
