"""The codes of a device with their texts, and all of them as a table."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.spreadsheet import Cell
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Enum, Member
from fieldspec.targets.controllers.enums import KINDS, meaning


@dataclass(frozen=True, slots=True)
class Code:
    """A code of a list. `text` says what it means; `cause` and `remedy` are empty where the manual has none."""

    kind: str
    list: str
    member: Member
    text: str
    cause: str
    remedy: str


def lists(device: Device) -> Iterator[tuple[Enum, tuple[Code, ...]]]:
    """The lists of codes of a device, each with its codes."""
    for enum in device.enums.values():
        if enum.kind in KINDS:
            yield enum, tuple(_code(enum, member) for member in enum.members)


def _code(enum: Enum, member: Member) -> Code:
    return Code(enum.kind, enum.name, member, meaning(enum, member), _cause(member), _remedy(member))


def _cause(member: Member) -> str:
    return _numbered([cause.cause for cause in member.causes])


def _remedy(member: Member) -> str:
    """The remedies in one text, numbered like the causes; a remedy for all causes comes last."""
    remedies = [" ".join(cause.remedies) for cause in member.causes]
    general = " ".join(member.remedies)
    if not any(remedies):
        return general
    return "; ".join(part for part in (_numbered(remedies), general) if part)


def _numbered(texts: Sequence[str]) -> str:
    """Texts in one, each with its number if there are several; empty ones are left out but counted."""
    if len(texts) == 1:
        return texts[0]
    return "; ".join(f"{number}. {text.removesuffix('.')}" for number, text in enumerate(texts, 1) if text)


COLUMNS = (
    "kind",
    "list",
    "code",
    "hex",
    "number",
    "name",
    "printed_name",
    "text",
    "cause",
    "remedy",
    "label",
    "source",
    "identity",
)


def rows(layout: DeviceLayout) -> Iterator[tuple[Cell, ...]]:
    """The rows of the list, one for each code, without the heading."""
    for _, codes in lists(layout.device):
        for code in codes:
            member = code.member
            yield (
                code.kind,
                code.list,
                member.value,
                f"0x{member.value:X}",
                member.number,
                member.name,
                member.printed_name or None,
                code.text,
                code.cause or None,
                code.remedy or None,
                member.label or None,
                "; ".join(source.text() for source in member.sources) or None,
                layout.identity,
            )
