"""The files for operator panels."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.hmi import plain_list
from fieldspec.backends.hmi.workbooks import CULTURES, ENGLISH, controller_workbook, panel_workbook
from fieldspec.layout.device import DeviceLayout
from fieldspec.names import stem
from fieldspec.spreadsheet import BYTE_ORDER_MARK, Workbook, csv_text


def files(versions: Sequence[DeviceLayout]) -> dict[str, str | Workbook]:
    """For each version of a device a table of its codes, and workbooks in English and with the manual's labels."""
    made: dict[str, str | Workbook] = {}
    for layout in versions:
        device = layout.device
        rows = list(plain_list.rows(layout))
        if not rows:
            continue
        name = stem(device.id, device.version)
        made[f"{name}_codes.csv"] = BYTE_ORDER_MARK + csv_text([plain_list.COLUMNS, *rows])
        culture = CULTURES.get(device.manual.language)
        for languages in ((ENGLISH,), *(((ENGLISH, culture),) if culture else ())):
            words = "_".join(language.replace("-", "_").lower() for language in languages)
            made[f"{name}_tia_panel_{words}.xlsx"] = panel_workbook(device, languages)
            made[f"{name}_tia_alarms_{words}.xlsx"] = controller_workbook(device, languages)
    return made


def shared() -> dict[str, str | Workbook]:
    """Nothing belongs to no device."""
    return {}
