"""The files of the output with queries."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.queries.polars_text import polars_text
from fieldspec.backends.queries.sql_text import sql_text
from fieldspec.diagnostics import Diagnostic
from fieldspec.layout.bases import base_refusals
from fieldspec.layout.characters import character_refusals
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.inner_list_refusals import inner_list_refusals
from fieldspec.names import stem


def shared() -> dict[str, str]:
    """No files: each is complete in itself."""
    return {}


def refusals(versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """Digits, texts in a form of their own, bases that registers hold, and lists with fields behind them."""
    reader = "a query"
    inner_lists = inner_list_refusals(versions, reader)
    return [*character_refusals(versions, reader, reads_frames=False), *base_refusals(versions, reader), *inner_lists]


def files(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """The macros and the expressions of a device, two files for each version."""
    texts: dict[str, str] = {}
    for layout in versions:
        own = stem(layout.device.id, layout.device.version)
        texts[f"{own}.sql"] = sql_text(layout)
        texts[f"{own}.py"] = polars_text(layout)
    return texts
