"""The files for operator panels: the codes of a device with their texts, and what the files can express."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import Name, stem
from fieldspec.foundation.spreadsheet import BYTE_ORDER_MARK, Cell, Workbook, Worksheet, csv_text
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Enum, Member
from fieldspec.targets.controllers.capabilities import CONSTRUCTS, EXACT, Capability, refused
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


def files(versions: Sequence[DeviceLayout]) -> dict[str, str | Workbook]:
    """For each version of a device a table of its codes, and workbooks in English and with the manual's labels.

    Versions with the same texts have the same workbooks, as objects too.
    """
    outputs: dict[str, str | Workbook] = {}
    known: dict[tuple[str | None, tuple[TextList, ...]], dict[str, Workbook]] = {}
    for layout in versions:
        device = layout.device
        codes = list(rows(layout))
        if not codes:
            continue
        name = stem(device.id, device.version)
        outputs[f"{name}_codes.csv"] = BYTE_ORDER_MARK + csv_text([COLUMNS, *codes])
        texts_of_device = CULTURES.get(device.manual.language), tuple(text_lists(device))
        if texts_of_device not in known:
            known[texts_of_device] = dict(_workbooks(*texts_of_device))
        outputs |= {f"{name}_{ending}.xlsx": book for ending, book in known[texts_of_device].items()}
    return outputs


def _workbooks(culture: str | None, text_lists: Sequence[TextList]) -> Iterator[tuple[str, Workbook]]:
    """Workbooks by the ends of their names, in English, and in English and another language."""
    for languages in ((ENGLISH,), *(((ENGLISH, culture),) if culture else ())):
        words = "_".join(language.replace("-", "_").lower() for language in languages)
        yield f"tia_panel_{words}", panel_workbook(text_lists, languages)
        yield f"tia_alarms_{words}", controller_workbook(text_lists, languages)


_EXACT = ("code_texts", "remedies", "labels")


def capabilities() -> Mapping[str, Capability]:
    """How far each construct is expressed: codes alone, since a list of texts has nothing else."""
    return {
        name: Capability(EXACT) if name in _EXACT else refused("the output contains only texts of codes")
        for name in CONSTRUCTS
    }


NO_VALUE = "<No value>"
"""What stands for a text that is not there, in the sheet of lists."""

CULTURES = {"zh-Hans": "zh-CN", "zh-Hant": "zh-TW"}
"""The culture of texts in a manual's language."""

ENGLISH = "en-US"

# What is done with a text that the program would take for a place of a value.
_FIELD = "<field"


@dataclass(frozen=True, slots=True)
class TextList:
    """A list by its name, with an English comment, and for each value the English text and the manual's, or nothing."""

    name: str
    comment: str
    entries: tuple[tuple[int, str, str], ...]


def text_lists(device: Device) -> Iterator[TextList]:
    """For each list of codes one with what they mean, and one of causes and one of remedies, if there are any."""
    before = Name.of(device.id)
    for enum, codes in lists(device):
        title = f"{device.name}: {enum.title or Name.of(enum.name).title()}"
        base = before + Name.of(enum.name)
        yield TextList(base.snake(), title, tuple((code.member.value, code.text, code.member.label) for code in codes))
        for word in ("cause", "remedy"):
            entries = tuple((code.member.value, _part(code, word), "") for code in codes if _part(code, word))
            if entries:
                yield TextList((base + Name.of(word)).snake(), f"{title}, {word}", entries)


def panel_workbook(text_lists: Sequence[TextList], languages: Sequence[str]) -> Workbook:
    """The text lists of a panel, in the languages that a project has."""
    texts = [f"Text [{language}]" for language in languages]
    head = ("Name", "Parent", "DefaultEntry", "Value", *texts, "FieldInfos")
    entries = [
        (f"Text_list_entry_{number}", text_list.name, "", str(value), *_texts(languages, english, label), "")
        for text_list in text_lists
        for number, (value, english, label) in enumerate(text_list.entries, 1)
    ]
    return Workbook((_lists(text_lists, languages), Worksheet("TextListEntry", (head, *entries))))


def controller_workbook(text_lists: Sequence[TextList], languages: Sequence[str]) -> Workbook:
    """The text lists of a controller's alarms."""
    head = ("Parent", "From", "To", *(f"Text [{language}]" for language in languages))
    entries = [
        (text_list.name, str(value), str(value), *_texts(languages, english, label))
        for text_list in text_lists
        for value, english, label in text_list.entries
    ]
    sheets = (_lists(text_lists, languages), Worksheet("TextListEntry", (head, *entries)))
    return Workbook(sheets, {"FileVersion": "1", "FileContent": "Alarm text lists"})


def _lists(text_lists: Sequence[TextList], languages: Sequence[str]) -> Worksheet:
    head = ("Name", "ListRange", *(f"Comment [{language}]" for language in languages))
    rows = [
        (
            text_list.name,
            "Decimal",
            *(_single_line(text_list.comment) if language == ENGLISH else NO_VALUE for language in languages),
        )
        for text_list in text_lists
    ]
    return Worksheet("TextList", (head, *rows))


def _texts(languages: Sequence[str], english: str, label: str) -> tuple[Cell, ...]:
    """The text in each language; the English one where the manual has none."""
    return tuple(_single_line(english if language == ENGLISH or not label else label) for language in languages)


def _part(code: Code, word: str) -> str:
    return code.cause if word == "cause" else code.remedy


def _single_line(text: str) -> str:
    return text.replace(_FIELD, f"< {_FIELD[1:]}")
