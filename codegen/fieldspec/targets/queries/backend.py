"""The files of the output with queries."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.bases import base_refusals
from fieldspec.codec.layout.characters import character_refusals
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.inner_list_refusals import inner_list_refusals
from fieldspec.codec.layout.omissions import Expressed, expressed
from fieldspec.foundation.names import stem
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.targets.queries.polars_text import polars_text
from fieldspec.targets.queries.sql_text import sql_text


def shared() -> dict[str, str]:
    """No files: each is complete in itself."""
    return {}


def refusals(versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """The refusals of digits, forms of texts, moving tables and lists with fields after them."""
    return [finding for layout in versions for finding in remaining(layout).findings]


def remaining(layout: DeviceLayout) -> Expressed:
    """The facts of a version that queries express, with those that they leave out."""
    reader = "a query"
    return expressed(
        layout,
        [
            *character_refusals(layout, reader, reads_frames=False),
            *base_refusals(layout, reader),
            *inner_list_refusals(layout, reader),
        ],
        reads_exceptions=False,
    )


def files(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """The macros and the expressions of a device, two files for each version."""
    texts: dict[str, str] = {}
    for layout in versions:
        own = stem(layout.device.id, layout.device.version)
        expressed_layout = remaining(layout)
        texts[f"{own}.sql"] = sql_text(expressed_layout.layout, expressed_layout.omissions)
        texts[f"{own}.py"] = polars_text(expressed_layout.layout, expressed_layout.omissions)
    return texts
