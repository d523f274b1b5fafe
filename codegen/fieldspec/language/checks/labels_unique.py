"""No two rows of a list have the same printed name or the same label.

Why: if a manual prints one text for two fields, bits or registers, a row was copied and not changed. Reserved
rows may have the same text. The rule enum_names_unique covers the members of enums.

Example: a record whose second and third field are both labelled "hours".

Fix: Find out what the second row is, correct its label, and write an erratum with the printed label. If both
are correct, set `allow: {labels_unique: <reason>}`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from fieldspec.language.checks.facts import lists
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.registers import Register

_WORDS = {"printed_name": "printed name", "label": "label"}


def labels_unique(device: Device) -> Findings:
    originals = {register.name: register for register in device.registers()}
    for rows in lists(device):
        own_rows = [row for row in rows if not getattr(row, "reserved", False) and not _as_original(row, originals)]
        for key in _WORDS:
            yield from _of_key(own_rows, key)


def _as_original(row: Fact, originals: Mapping[str, Register]) -> bool:
    """Whether a row is the copy of a register with the same label, which is checked there."""
    original = originals.get(row.copy_of) if isinstance(row, Register) else None
    return original is not None and original.label == row.label and not row.printed_name


def _of_key(rows: Iterable[Fact], key: str) -> Findings:
    first: dict[str, Fact] = {}
    for row in rows:
        text = getattr(row, key)
        other = first.setdefault(text, row) if text else row
        if other is not row:
            yield finding(
                row.place,
                key,
                f"{other.name} and {row.name} have the same {_WORDS[key]}, `{text}`",
                "find out what each of them is, or allow it with a reason",
                label(other.place, key, other.name),
            )
