"""How programs use what an output generates: code to copy, by the paths of facts."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_exact, is_real, is_truth
from fieldspec.language.model.enums import Enum, Member
from fieldspec.language.model.value import Value


class Usage(NamedTuple):
    """Code that reads or writes a fact. `@0@`, `@1@` in the template are the arguments, `@name@` the variables."""

    fact: str
    template: str
    arguments: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class VersionUsages:
    """The code for one version of a device in one language. `variables` differ from version to version.

    Templates and arguments do not, wherever the names of the versions are the same; versions then share their code.
    """

    language: str
    variables: dict[str, str]
    rows: tuple[Usage, ...]


def sample_count(value: Value, device: Device) -> int | None:
    """A raw value that may be written; None for texts, bytes and floating-point numbers."""
    if not is_exact(value.encoding):
        return None
    if value.const is not None:
        return value.const
    ranges = value.writable_ranges
    enum = device.enums.get(value.enum)
    if enum is not None:
        for member in enum.members:
            if not member.unavailable and (ranges is None or member.value in ranges):
                return member.value
    if isinstance(value.default, int) and (ranges is None or value.default in ranges):
        return value.default
    return 0 if ranges is None or 0 in ranges else ranges.low


def sample_text(
    value: Value, device: Device, member_text: Callable[[Enum, Member], str], number_text: Callable[[int], str]
) -> str:
    """An expression of a language with braces that may be written; empty where there is none, and for constants.

    `member_text` gives the constant of a member of an enum, `number_text` the literal of a whole number.
    """
    if is_real(value.encoding):
        return "0" if value.ranges is None or 0 in value.ranges else str(value.ranges.low)
    if value.const is not None:
        return ""
    if is_truth(value.encoding):
        return "true" if value.ranges is None or 1 in value.ranges else "false"
    count = sample_count(value, device)
    if count is None:
        return ""
    enum = device.enums.get(value.enum)
    for member in enum.members if enum is not None else ():
        if enum is not None and member.value == count and not member.unavailable:
            return member_text(enum, member)
    return number_text(count)
