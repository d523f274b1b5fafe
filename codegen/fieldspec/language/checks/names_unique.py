"""Names in one name space remain distinct in the spelling of every output, including the escaped names of reserved
words.

Why: each output spells a name in its own case, and some targets do not distinguish upper and lower case. If
two names become equal, one of the declarations is lost or the output does not compile.

Example: `line_1_2` and `line1_2` both become `Line1_2`; a record and an enum with the name zone become one
type.

Fix: Rename one of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache

from fieldspec.foundation.names import Name
from fieldspec.foundation.reserved import TARGETS
from fieldspec.language.checks.facts import cases, layers
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Place

_Named = tuple[str, Place]

_RESERVED = frozenset(word for target in TARGETS.values() for word in target.words)


def names_unique(device: Device) -> Findings:
    for space_name, names in _spaces(device):
        yield from _apart(space_name, names)
    yield from _elements(device)
    yield from _paths(device)


def _spaces(device: Device) -> Iterator[tuple[str, Iterable[_Named]]]:
    """All spaces of names, each with the names in it and their places."""
    yield "registers", ((register.name, register.place) for register in device.registers())
    yield "groups", ((group.name, group.place) for group in device.groups)
    yield "types", _types(device)
    for section, contents in (
        ("links", device.links),
        ("messages", device.messages),
        ("tables", device.tables),
        ("parameter sets", device.parameters),
        ("signals", device.signals),
        ("conversions", device.conversions),
    ):
        yield section, ((content.name, content.place) for content in contents.values())
    for enum in device.enums.values():
        # Members of one name are enum_names_unique's.
        members = {member.name: member.place for member in reversed(enum.members)}
        yield enum.name, reversed(members.items())
    for word in device.flags.values():
        yield word.name, ((bit.name, bit.place) for bit in word.bits if not bit.when)
        yield f"the states of {word.name}", ((state.name, state.place) for state in word.states)
    for record in device.records.values():
        yield record.name, ((field.name, field.place) for field in record.fields)
    for message in device.messages.values():
        for layer in (message.request, message.response):
            yield layer.name, ((field.name, field.place) for field in layer.fields)
    for layer in layers(device):
        for field in layer.fields:
            yield f"the cases of {field.name}", ((case.name, case.place) for case in cases(field))
    for link in device.links.values():
        for direction in ("request", "response"):
            parts = link.parts(direction)
            yield f"{link.name} {direction}", ((part.name, part.place) for part in parts)
    for parameter_set in device.parameters.values():
        yield parameter_set.name, ((parameter.name, parameter.place) for parameter in parameter_set.parameters)
        for parameter in parameter_set.parameters:
            named_elements = [inner for inner in parameter.subindices if inner.name]
            yield f"the elements of {parameter.name}", ((inner.name, inner.place) for inner in named_elements)


def _types(device: Device) -> Iterator[_Named]:
    """What becomes a type of its own in a target."""
    for contents in (device.records, device.enums, device.flags):
        for content in contents.values():
            yield content.name, content.place
    for message in device.messages.values():
        yield f"{message.name}_request", message.place
        yield f"{message.name}_response", message.place


def _apart(space_name: str, names: Iterable[_Named]) -> Findings:
    first: dict[str, _Named] = {}
    for name, place in names:
        for case in _cases(name):
            other, other_place = first.setdefault(case, (name, place))
            if other_place is not place or other != name:
                if other == name:
                    text = f"two of {space_name} have the name `{name}`"
                else:
                    text = f"`{name}` and `{other}` of {space_name} become the same name in an output"
                there_too = label(other_place, "name", f"`{other}`")
                yield finding(place, "name", text, "rename one of them", there_too)
                break


@lru_cache(maxsize=50_000)
def _cases(name: str) -> frozenset[str]:
    """What becomes of a name in targets; those that do not tell upper from lower case get it in lower case."""
    words = Name.of(name)
    snake, pascal = words.snake(), words.pascal()
    folded = pascal.lower()
    if folded not in _RESERVED and snake not in _RESERVED:
        return frozenset((snake, pascal, folded))
    legal_names = (
        target.legal_name(pascal).lower() if target.folds else target.legal_name(snake) for target in TARGETS.values()
    )
    return frozenset((snake, pascal, folded, *legal_names))


def _paths(device: Device) -> Findings:
    """A path leaves out the group of a register, so that the two must not have one name."""
    groups = {group.name: group for group in device.groups}
    for register in device.registers():
        group = groups.get(register.name)
        if group is not None:
            text = f"`registers/{register.name}` is the path of a register and of a group"
            related_label = label(group.place, "group", "the group")
            yield finding(register.place, "name", text, "rename one of them", related_label)


def _elements(device: Device) -> Findings:
    """Elements of arrays are called after the array and their number, and are registers too."""
    arrays = {register.name: register for register in device.registers() if register.count > 1}
    for register in device.registers():
        stem, _, number = register.name.rpartition("_")
        array = arrays.get(stem)
        if array is None or not number.isdecimal() or len(number) > 9:
            continue
        if array.index_from <= int(number) < array.index_from + array.count:
            text = f"`{register.name}` is also an element of the array `{stem}`"
            related_label = label(array.place, "name", f"it has {array.count} elements")
            yield finding(register.place, "name", text, "rename one of them", related_label)
