"""If an enum or a parameter set states how the manual prints its values, every printed name has that form.

Why: a display code and the number next to it give the same information. If they differ, the code leads the
user to the wrong alarm.

Example: `printed_as: "AL.{value:03X}"` and a member 0xEE0 with the printed name AL.EEO.

Fix: Correct the name or the value, and write an erratum if the manual prints it that way. Upper and lower
case are not distinguished.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TypeAlias

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact

_FORM = re.compile(r"[^{}]*\{(value|number)(?::[0-9]{0,2}[dxXob]?)?\}[^{}]*")

_Rows: TypeAlias = list[tuple[Fact, Mapping[str, int | None]]]


def printed_names_match(device: Device) -> Findings:
    for enum in device.enums.values():
        members: _Rows = [(member, {"value": member.value, "number": member.number}) for member in enum.members]
        yield from _of_list(enum, enum.printed_as, ("value", "number"), members)
    for parameter_set in device.parameters.values():
        rows: _Rows = [(row, {"number": row.number}) for row in parameter_set.parameters]
        yield from _of_list(parameter_set, parameter_set.printed_as, ("number",), rows)


def _of_list(holder: Fact, form: str, keys: tuple[str, ...], rows: _Rows) -> Findings:
    if not form:
        return
    match = _FORM.fullmatch(form)
    if match is None or match[1] not in keys:
        text = f"`{form}` is not a form of a {keys[0]}"
        help = f"write it like `AL.{{{keys[0]}:03X}}`: one pair of braces, and digits in base 2, 8, 10 or 16"
        yield finding(holder.place, "printed_as", text, help)
        return
    for row, numbers in rows:
        if numbers[match[1]] is not None:
            yield from _compare_names(holder, row, form.format(**numbers), match[1])


def _compare_names(holder: Fact, row: Fact, right: str, key: str) -> Findings:
    printed = [(row.place, row.printed_name)]
    printed += [(claim.place, str(claim.values.get("printed_name") or "")) for claim in row.restated]
    for place, name in printed:
        if name and name.casefold() != right.casefold():
            text = f"{row.name} is printed as `{name}`, but its {key} gives `{right}`"
            related_label = label(holder.place, "printed_as", "how it is printed")
            yield finding(place, "printed_name", text, f"correct the name or the {key}", related_label)
