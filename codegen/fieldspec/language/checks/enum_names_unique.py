"""No two members of an enum have the same name, the same printed identifier or the same label.

Why: if a manual prints one text for two codes, a row was copied and not changed. Reserved members and members
that are not available may have the same label.

Example: two homing modes with the label "positive direction, then back to the Z phase".

Fix: Find out what the second member is, name it accordingly, and write an erratum with the printed text.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Enum, Member

_KEYS = ("name", "printed_name", "label")


def enum_names_unique(device: Device) -> Findings:
    for enum in device.enums.values():
        # What the members of another list are called is looked at there.
        for key in ("name",) if enum.derived else _KEYS:
            yield from _of_key(enum, key)
        yield from _of_aliases(enum)


def _of_aliases(enum: Enum) -> Findings:
    """Aliases that are also the name of a member, or an alias of another one."""
    members_by_name = {member.name: member for member in enum.members}
    for member in enum.members:
        for alias in member.aliases:
            other = members_by_name.setdefault(alias, member)
            if other is not member or alias == member.name:
                text = f"the alias `{alias}` of {member.name} is already a name of {other.name}"
                related_label = label(other.place, "name", f"the value {other.value}")
                help = "remove it from one of them"
                yield finding(member.place, "aliases", text, help, related_label)


def _of_key(enum: Enum, key: str) -> Findings:
    first: dict[str, Member] = {}
    for member in enum.members:
        text = getattr(member, key)
        if not text or (member.unavailable and key != "name"):
            continue
        other = first.setdefault(text, member)
        if other is not member:
            yield finding(
                member.place,
                key,
                f"{other.value} and {member.value} of {enum.name} have the same {_WORDS[key]}, `{text}`",
                "find out what each of them is",
                label(other.place, key, f"the value {other.value}"),
            )


_WORDS = {"name": "name", "printed_name": "printed name", "label": "label"}
