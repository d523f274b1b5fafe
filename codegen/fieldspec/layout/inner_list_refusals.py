"""What outputs refuse that read lists only where they come last."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.layout.device import DeviceLayout


def inner_list_refusals(
    versions: Sequence[DeviceLayout], reader: str, for_controllers: bool = False
) -> list[Diagnostic]:
    """A finding for each list with fields behind it; `reader` is what does not read it."""
    lists = {
        field.place.path: field
        for layout in versions
        for message in layout.messages.values()
        for body in message.bodies
        if body.inner_lists is not None
        for field in body.record.fields
        if field.repeat is not None and field is not body.record.fields[-1]
    }
    return [
        Diagnostic(
            "plc_lists_last" if for_controllers else "output_lists_last",
            f"{field.name} has fields behind it, and {reader} reads only lists that come last",
            field.place["repeat"],
            help=LEAVE_OUT,
        )
        for field in lists.values()
    ]
