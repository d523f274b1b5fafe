"""The constructor of a record: every field as a raw value or, by keyword, as a quantity in its unit."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from fieldspec.foundation.classes import dataclass
from fieldspec.targets.python.quantities import ScaledView
from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import chained, filled, item_lines, literal

EXACT = 2
"""Fields with a quantity up to which each combination has an overload of its own: four signatures for two fields."""


@dataclass(frozen=True, slots=True)
class ConstructorView:
    """The lines of `__init__` before it stores the raw values.

    `overloads` are the signatures for type checkers, empty where no field has a quantity. `by_quantity` are the lines
    that leave a call with a quantity, or with a missing argument, to `Record._set_fields`.
    """

    overloads: list[list[str]]
    head: list[str]
    by_quantity: list[str]


def constructor_view(stored: list[Slots], scaled: list[ScaledView]) -> ConstructorView:
    """The constructor of the attributes of a record."""
    quantities = {view.field: view for view in scaled}
    first = next((place for place, field in enumerate(stored) if field.name in quantities), len(stored))
    if first == len(stored):
        return ConstructorView([], _signature(map(_raw, stored)), [])
    optional = [_raw(field, " | None = None") for field in stored[first:]]
    keywords = [_optional(view) for view in scaled]
    return ConstructorView(
        overloads=[_signature(arguments, ": ...") for arguments in _overloads(stored, first, quantities)],
        head=_signature([*map(_raw, stored[:first]), *optional, *keywords]),
        by_quantity=_by_quantity(stored, first, quantities),
    )


def _optional(view: ScaledView) -> str:
    """The argument of a quantity that may be left out, which None does not say where it is an absent value."""
    if view.takes_none:
        return f"{view.name}: {view.accepted} | _LeftOut = _LEFT_OUT"
    return f"{view.name}: {view.accepted} | None = None"


def _left_out(view: ScaledView) -> str:
    return "_LEFT_OUT" if view.takes_none else "None"


def _raw(field: Slots, default: str = "") -> str:
    """`kind: Kinds`; an argument that may be left out has no bytes then."""
    default = ' = b""' if field.field.field.may_be_empty else default
    return f"{field.name}: {field.accepted}{default}"


def _signature(arguments: Iterator[str] | list[str], end: str = ":") -> list[str]:
    """The lines of a signature; arguments that are needed after one that may be left out are keywords."""
    names, mark, keywords = _divided([*arguments])
    first = next((place for place, name in enumerate(names) if " = " in name), len(names))
    if any(" = " not in name for name in names[first:]):
        names, mark, keywords = names[: first + 1], ["*"], [*names[first + 1 :], *keywords]
    return item_lines("def __init__(", ["self", *names, *mark, *keywords], f") -> None{end}", 4)


def _divided(arguments: list[str]) -> tuple[list[str], list[str], list[str]]:
    """The arguments before a `*`, the `*` if there is one, and the arguments after it."""
    place = arguments.index("*") if "*" in arguments else len(arguments)
    return arguments[:place], arguments[place : place + 1], arguments[place + 1 :]


def _overloads(stored: list[Slots], first: int, quantities: dict[str, ScaledView]) -> Iterator[list[str]]:
    """The arguments of each signature: all raw values first.

    From the first quantity on, all arguments are keywords. Above `EXACT` fields with a quantity, one signature allows
    any mixture; only the call itself then tests that each field has exactly one of its two arguments.
    """
    if len(quantities) > EXACT:
        yield list(map(_raw, stored))
        mixed = [*map(_raw, stored[:first]), "*"]
        for field in stored[first:]:
            view = quantities.get(field.name)
            if view is None:
                mixed.append(_raw(field))
            else:
                mixed += [
                    f"{field.name}: {field.accepted} | None = None",
                    _optional(view),
                ]
        yield mixed
        return
    for choices in product((False, True), repeat=len(quantities)):
        by_quantity = dict(zip(quantities, choices, strict=True))
        arguments: list[str] = []
        for field in stored:
            if by_quantity.get(field.name):
                arguments += [] if "*" in arguments else ["*"]
                arguments.append(f"{quantities[field.name].name}: {quantities[field.name].accepted}")
            else:
                arguments.append(_raw(field))
        yield arguments


def _by_quantity(stored: list[Slots], first: int, quantities: dict[str, ScaledView]) -> list[str]:
    """One test before the raw values are stored; `Record._set_fields` handles every other call."""
    tests = [f"{field.name} is None" for field in stored[first:]]
    tests += [f"{view.name} is not {_left_out(view)}" for view in quantities.values()]
    *lines, last = chained("if ", tests, "or", "", 9)
    arguments = [field.name for field in stored]
    arguments += [
        f"{name}=({literal(view.name)}, {view.name}{', _LEFT_OUT' * view.takes_none})"
        for name, view in quantities.items()
    ]
    call = [f"    {line}" for line in filled("self._set_fields(", arguments, ")", 12)]
    return [*lines, f"{last}:", *call, "    return"]
