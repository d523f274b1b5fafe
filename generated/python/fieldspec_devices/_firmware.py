"""The module of a version, selected by the firmware that the device reports."""

from __future__ import annotations

from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from types import ModuleType
    from typing import TypeAlias

    Line: TypeAlias = tuple[tuple[str, str], ...]

EARLIER = "before-"
LONGEST = 9  # Digits of a number of a version; Python refuses to read very long ones.


class UnknownFirmwareError(LookupError):
    """Firmware that a spec does not list: `firmware` is the requested one, `known` are the versions of the spec."""

    def __init__(self, firmware: str, known: tuple[str, ...]) -> None:
        self.firmware, self.known = firmware, known
        super().__init__(f"the firmware {firmware!r} is unknown; known are {', '.join(known)}")

    def __reduce__(self) -> tuple[type[UnknownFirmwareError], tuple[str, tuple[str, ...]]]:
        return type(self), (self.firmware, self.known)


def version_in(lines: tuple[Line, ...], value: str | int, form: str, places: int, names: dict[str | int, str]) -> str:
    """The version that a value of the device tells: `2.21` of 221 in the form `decimal` with two places.

    `names` has the versions that single values tell. For the form `bytes`, `places` is the size of the number in bytes.
    Raises UnknownFirmwareError.
    """
    key = value.strip(" \t\r\n\0") if isinstance(value, str) else value
    if key in names:
        return names[key]
    if isinstance(key, str):
        return key
    if form == "bytes" and 0 <= key < 1 << 8 * places:
        return ".".join(map(str, key.to_bytes(places, "big")))
    if form in ("decimal", "hexadecimal") and key >= 0:
        digits = f"{key:d}" if form == "decimal" else f"{key:X}"
        digits = digits.rjust(places + 1, "0")
        return f"{digits[:-places]}.{digits[-places:]}" if places else digits
    raise UnknownFirmwareError(str(value), tuple(version for line in lines for version, _ in line))


def module_of(package: str, lines: tuple[Line, ...], firmware: str, nearest: bool) -> ModuleType:
    """The module of a firmware; `lines` have the versions, the oldest first, each with the name of its module.

    Raises UnknownFirmwareError.
    """
    name = module_name(lines, firmware, nearest)
    from importlib import import_module  # few programs need it, and its import takes time

    return import_module(f"{package}.{name}")


def module_name(lines: tuple[Line, ...], firmware: str, nearest: bool) -> str:
    """The name of the module of a firmware. Raises UnknownFirmwareError."""
    text = firmware.strip(" \t\r\n\0")
    name = _named(lines, text) or _numbered(lines, text, nearest)
    if name is None:
        raise UnknownFirmwareError(firmware, tuple(version for line in lines for version, _ in line))
    return name


def _named(lines: tuple[Line, ...], text: str) -> str | None:
    return next((module for line in lines for version, module in line if version == text), None)


def _numbered(lines: tuple[Line, ...], text: str, nearest: bool) -> str | None:
    """The module of the same number, or of all before the first number, or with `nearest` of the number below."""
    numbers = _numbers(text)
    if numbers is None:
        return None
    for line in lines if len(lines) == 1 else [line for line in lines if _first(line) == numbers[0]]:
        numbered = [(number, module) for version, module in line if (number := _numbers(version)) is not None]
        for number, module in numbered:
            if number == numbers:
                return module
        earlier = [module for version, module in line if _before(version, numbers)]
        if earlier and all(numbers < number for number, _ in numbered):
            return earlier[0]
        below = [(number, module) for number, module in numbered if number < numbers]
        if nearest and below:
            return max(below)[1]
    return None


def _numbers(text: str) -> tuple[int, ...] | None:
    """`v02.21` as (2, 21), without trailing zeros; None for a text that is not a version number."""
    parts = text[text[:1] in ("v", "V") :].split(".")
    if not all(part.isascii() and part.isdigit() and len(part) <= LONGEST for part in parts):
        return None
    numbers = [int(part) for part in parts]
    while len(numbers) > 1 and not numbers[-1]:
        numbers.pop()
    return tuple(numbers)


def _first(line: Line) -> int | None:
    """The first number of the versions of a line."""
    numbers = (_numbers(version.removeprefix(EARLIER)) for version, _ in line)
    return next((parts[0] for parts in numbers if parts is not None), None)


def _before(version: str, numbers: tuple[int, ...]) -> bool:
    """Whether a version stands for all firmware below a number, and the requested number is below it."""
    bound = _numbers(version.removeprefix(EARLIER)) if version.startswith(EARLIER) else None
    return bound is not None and numbers < bound
