"""A device as TIA Portal gets it: declarations, data blocks with their names, and all that is wrong with them."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import Name, stem
from fieldspec.language.diagnostics import Diagnostic, has_errors
from fieldspec.targets.controllers.cache import cached
from fieldspec.targets.controllers.chosen import chosen_routines, trimmed
from fieldspec.targets.controllers.declarations import Declarations, declarations
from fieldspec.targets.controllers.dialects import SIEMENS, Scope
from fieldspec.targets.controllers.enums import TextTable
from fieldspec.targets.controllers.routines.all_routines import routines
from fieldspec.targets.controllers.routines.blocks.all_blocks import Blocks
from fieldspec.targets.controllers.routines.telegrams import telegrams
from fieldspec.targets.controllers.routines.world import narrowest
from fieldspec.targets.controllers.statements.expressions import Elementary
from fieldspec.targets.controllers.statements.routine import Routine
from fieldspec.targets.controllers.structs import Struct


@dataclass(frozen=True, slots=True)
class TelegramBlock:
    """The data blocks of a telegram: one of images, and one of values with the bytes they are all_blocks of.

    `directions` are the names of their members, and the keys of the structs: of what is sent to the device, then of
    what it sends.
    """

    image: str
    values: str
    title: str
    directions: tuple[tuple[str, Struct, Struct], ...]


@dataclass(frozen=True, slots=True)
class TextBlock:
    """The data block of a table of texts."""

    name: str
    table: TextTable


@dataclass(frozen=True, slots=True)
class Project:
    """What TIA Portal gets for one version of a device. `findings` are the errors that forbid it, and warnings.

    `missing` are the tasks without a block, with the reasons.
    """

    layout: DeviceLayout
    declared: Declarations
    telegrams: tuple[TelegramBlock, ...]
    texts: tuple[TextBlock, ...]
    routines: tuple[Routine, ...]
    text_type: str
    findings: tuple[Diagnostic, ...]
    missing: tuple[tuple[str, str], ...]

    @property
    def stem(self) -> str:
        """The name that the files of the device begin with."""
        return stem(self.layout.device.id, self.layout.device.version)

    @property
    def blocks(self) -> bool:
        """Whether there is any data block."""
        return bool(self.telegrams or self.texts)

    @property
    def code_type(self) -> Elementary:
        """The type of codes in tables of texts."""
        codes = [text.code for table in self.declared.texts for text in table.texts]
        return narrowest(min(codes), max(codes))

    @property
    def text_length(self) -> int:
        """The characters of the longest text, as far as a STRING can hold it."""
        return min(LONGEST_STRING, max(table.longest for table in self.declared.texts))


LONGEST_STRING = 254
"""The most characters of a STRING."""


@cached
def declared_for_portal(layout: DeviceLayout) -> Declarations:
    """The declarations of a device in SCL."""
    return declarations(layout, SIEMENS)


@cached
def project(layout: DeviceLayout) -> Project:
    """The project of a device that has passed the checks; without functions if TIA Portal cannot have it."""
    declared = declared_for_portal(layout)
    findings = [*declared.findings]
    all_blocks = Blocks((), ()) if has_errors(findings) else routines(declared.world)
    chosen = chosen_routines(declared.world, all_blocks.routines)
    declared = trimmed(declared, chosen, SIEMENS.spelling)
    scope = Scope(SIEMENS, "block", findings)
    device = Name.of(layout.device.id).pascal()
    telegram_blocks = tuple(_telegrams(declared, scope, device))
    texts = tuple(
        TextBlock(scope.take(f"{device}{Name.of(table.enum.name).pascal()}Texts", table.enum), table)
        for table in declared.texts
    )
    text_type = SIEMENS.texts.format(device, "Code")
    return Project(layout, declared, telegram_blocks, texts, chosen, text_type, tuple(findings), all_blocks.missing)


def _telegrams(declared: Declarations, scope: Scope, device: str) -> Iterator[TelegramBlock]:
    structs = {struct.key: struct for struct in declared.structs if struct.kind == "telegram"}
    for message in telegrams(declared.layout):
        directions = []
        for member, data in (("toDevice", message.request), ("fromDevice", message.response)):
            image = declared.image(data.name)
            if image is not None and data.name in structs:
                directions.append((member, image, structs[data.name]))
        if directions:
            name = f"{device}{Name.of(message.name).pascal()}"
            image_block, values_block = scope.take(name, message.message), scope.take(f"{name}Values", message.message)
            title = message.message.title or Name.of(message.name).title()
            yield TelegramBlock(image_block, values_block, title, tuple(directions))
