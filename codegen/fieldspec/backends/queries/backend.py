"""The files of the output with queries."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.backends.queries.polars_text import polars_text
from fieldspec.backends.queries.sql_text import sql_text
from fieldspec.diagnostics import Diagnostic
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.digits import digits_refusals
from fieldspec.names import stem


def shared() -> dict[str, str]:
    """No files: each is complete in itself."""
    return {}


def refusals(versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """Values that are sent as digits, and scales that are read from the device, which the queries do not apply."""
    return [*digits_refusals(versions, "a query"), *_scales(versions)]


def _scales(versions: Sequence[DeviceLayout]) -> Iterator[Diagnostic]:
    seen = set()
    for layout in versions:
        for register in layout.registers:
            scale_by, place = register.register.value.scale_by, register.register.place
            if scale_by and place["scale_by"] not in seen:
                seen.add(place["scale_by"])
                text = f"a query does not read the scale of {register.name} from {scale_by}"
                help = "exclude the output, or state the scale under `scale` where the device always has the same"
                yield Diagnostic("query_scales_fixed", text, place["scale_by"], (), help)


def files(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """The macros and the expressions of a device, two files for each version."""
    texts: dict[str, str] = {}
    for layout in versions:
        own = stem(layout.device.id, layout.device.version)
        texts[f"{own}.sql"] = sql_text(layout)
        texts[f"{own}.py"] = polars_text(layout)
    return texts
