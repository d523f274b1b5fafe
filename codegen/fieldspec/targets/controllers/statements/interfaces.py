"""Names of the inputs and outputs of blocks: PLCopen names, without letters for their types.

Siemens writes the same words with a small first letter.
"""

from __future__ import annotations

from fieldspec.foundation.reserved import TARGETS
from fieldspec.targets.controllers.statements.expressions import TIMER, StructType, Type, Variable
from fieldspec.targets.controllers.statements.routine import Routine, Variables, bare

OWN = frozenset(
    {
        *("Execute", "Abort", "Enable", "JogForward", "JogBackward", "Axis", "Frames", "Frame"),
        *("Done", "Busy", "Active", "Valid", "InVelocity", "CommandAborted", "Error", "ErrorID", "LastError"),
        *("Status", "Diagnostics", "TimeLimit", "StartTime", "EndingTime", "SettlingTime", "Timeout", "Retries"),
        *("Window", "Send", "SendLength", "Received", "ReceivedLength", "Failed"),
    }
)
"""What blocks have of their own accord. A value of a device that has one of these names is, say, `DeviceStatus`."""


def parameter_name(name: str) -> str:
    """The name of an input or an output for a value whose variable elsewhere has letters for its type."""
    text = bare(name)
    if text != name and text.lower() in {own.lower() for own in OWN}:
        text = f"Device{text}"
    return TARGETS["iec"].legal_name(text)


def camel(name: str) -> str:
    """A name as Siemens writes it, without letters for its type: `errorID` for `ErrorID`, `words` for `aWords`"""
    text = bare(name)
    return TARGETS["siemens"].legal_name(text[:1].lower() + text[1:])


def siemens_names(routine: Routine) -> dict[str, str]:
    """The names of the variables of a routine as Siemens writes them: those inside have a word for their kind."""
    names: dict[str, str] = {}
    used = {routine.name.lower()}
    for declared in sorted(routine.declared, key=lambda item: item.role == "local"):
        variable = declared.variable
        text = camel(variable.name) if declared.role != "local" else _inner_name(routine, variable)
        number, tried = 1, text
        while tried.lower() in used:
            number += 1
            tried = f"{text}{number}"
        used.add(tried.lower())
        names[variable.name] = tried
    return names


def _inner_name(routine: Routine, variable: Variable) -> str:
    if routine.returns is not None:
        return f"temp{bare(variable.name)}"
    return f"{'inst' if _is_instance(variable.type) else 'stat'}{bare(variable.name)}"


def _is_instance(kind: Type) -> bool:
    return kind == TIMER or (isinstance(kind, StructType) and kind.is_block)


class BlockVariables(Variables):
    """The variables of a block while it is being made, with inputs and outputs named by the rule of this module."""

    def declare(self, name: str, kind: Type, role: str, remark: str = "", initial: str = "") -> Variable:
        """See `Variables`."""
        return super().declare(name if role == "local" else parameter_name(name), kind, role, remark, initial)
