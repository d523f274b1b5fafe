"""The checks that a device must pass to have a layout."""

from __future__ import annotations

from fieldspec.language.checks.can_frames_complete import can_frames_complete
from fieldspec.language.checks.choices_complete import choices_complete
from fieldspec.language.checks.links_complete import links_complete
from fieldspec.language.checks.messages_complete import messages_complete
from fieldspec.language.checks.presences_complete import presences_complete
from fieldspec.language.checks.records_finite import records_finite
from fieldspec.language.checks.references_resolve import references_resolve
from fieldspec.language.checks.repeat_last import repeat_last
from fieldspec.language.checks.varying_widths_end import varying_widths_end
from fieldspec.language.model.device import Device

_CHECKS = (
    can_frames_complete,
    references_resolve,
    records_finite,
    repeat_last,
    choices_complete,
    links_complete,
    messages_complete,
    presences_complete,
    varying_widths_end,
)
LAYOUT_CONDITIONS = tuple(check.__name__ for check in _CHECKS)
"""The checks without which a device has no layout."""


def has_layout(device: Device) -> bool:
    """Whether a device has a layout: what it names is there, its records end, and its links and messages are whole."""
    return not any(True for check in _CHECKS for _ in check(device))
