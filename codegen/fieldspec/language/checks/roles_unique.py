"""A role occurs once wherever a step looks for it: among the registers, the parameters, the commands and the
frames, in a record, and in each message.

Why: a step that writes the target position must find exactly one value. With two, the compiler would have to
guess the target of a motion.

Example: `roles: target_position` on two registers.

Fix: Keep the role on the fact that the task uses. A step can name the other fact by its path.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.operand import Operand, operands


def roles_unique(device: Device) -> Findings:
    first: dict[tuple[str, str], Operand] = {}
    reported: set[tuple[str, str, str]] = set()
    for operand in operands(device):
        for role in operand.roles:
            before = first.setdefault((operand.scope, role), operand)
            key = role, before.fact.place.path, operand.fact.place.path
            if before is operand or key in reported:
                continue
            reported.add(key)
            text = f"{before.path} and {operand.path} have the role `{role}`"
            related_label = label(before.fact.place, "roles", "the first one")
            yield finding(operand.fact.place, "roles", text, "remove it from one of them", related_label)
