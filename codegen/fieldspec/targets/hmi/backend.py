"""The files for operator panels, and what they can express."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.names import stem
from fieldspec.foundation.spreadsheet import BYTE_ORDER_MARK, Workbook, csv_text
from fieldspec.targets.controllers.capabilities import CONSTRUCTS, EXACT, Capability, refused
from fieldspec.targets.hmi import code_lists
from fieldspec.targets.hmi.workbooks import CULTURES, ENGLISH, TextList, controller_workbook, panel_workbook, text_lists


def files(versions: Sequence[DeviceLayout]) -> dict[str, str | Workbook]:
    """For each version of a device a table of its codes, and workbooks in English and with the manual's labels.

    Versions with the same texts have the same workbooks, as objects too.
    """
    outputs: dict[str, str | Workbook] = {}
    known: dict[tuple[str | None, tuple[TextList, ...]], dict[str, Workbook]] = {}
    for layout in versions:
        device = layout.device
        rows = list(code_lists.rows(layout))
        if not rows:
            continue
        name = stem(device.id, device.version)
        outputs[f"{name}_codes.csv"] = BYTE_ORDER_MARK + csv_text([code_lists.COLUMNS, *rows])
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


def shared() -> dict[str, str | Workbook]:
    """No files: every file of this output belongs to one device."""
    return {}


_EXACT = ("code_texts", "remedies", "labels")


def capabilities() -> Mapping[str, Capability]:
    """How far each construct is expressed: codes alone, since a list of texts has nothing else."""
    return {
        name: Capability(EXACT) if name in _EXACT else refused("the output contains only texts of codes")
        for name in CONSTRUCTS
    }
