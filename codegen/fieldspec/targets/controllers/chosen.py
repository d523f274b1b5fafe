"""The blocks that a project chooses, with all that they need and nothing else."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import replace
from fieldspec.language.model.choice import BlockChoice
from fieldspec.language.model.operand import Operands
from fieldspec.targets.controllers.constants import Constant
from fieldspec.targets.controllers.declarations import Declarations
from fieldspec.targets.controllers.dialects import Spelling
from fieldspec.targets.controllers.routines.printer import routine_text, type_text
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.routines.wrapping import link_words
from fieldspec.targets.controllers.statements.routine import Routine, called
from fieldspec.targets.controllers.structs import Struct

_UNITS = ("words", "bytes")
"""The form of the process data of a telegram."""
_OF_TASKS = ("task ", "telegram ", "ready program")
"""The groups of blocks for tasks, of which only those are made that a project chooses."""


def chosen_routines(world: World, routines: Sequence[Routine]) -> tuple[Routine, ...]:
    """The routines that a project chooses, and those that they call, in the order in which they are."""
    choice = world.layout.blocks
    if choice is None:
        return tuple(routines)
    subjects: set[str] = set()
    for name in _groups(world.layout, choice):
        subjects |= {f"registers {name}", f"table {name}"}
    by_name = {routine.name: routine for routine in routines}
    waiting = [
        routine.name
        for routine in routines
        if routine.returns is None and (routine.group in subjects or routine.group.startswith(_OF_TASKS))
    ]
    waiting += [name for name in _of_messages(world, choice) if name in by_name]
    reached: set[str] = set()
    while waiting:
        name = waiting.pop()
        if name in by_name and name not in reached:
            reached.add(name)
            waiting += called(by_name[name])
    return tuple(routine for routine in routines if routine.name in reached)


def _groups(layout: DeviceLayout, choice: BlockChoice) -> Iterator[str]:
    """The groups and tables that are chosen by their own names, or by that of a register."""
    for group in layout.device.groups:
        if group.name in choice.registers or any(own.name in choice.registers for own in group.registers):
            yield group.name
    yield from (name for name in layout.device.tables if name in choice.registers)


def _of_messages(world: World, choice: BlockChoice) -> Iterator[str]:
    """The names of the routines of chosen messages, and of the clients that tasks and registers need."""
    for link in world.layout.links.values():
        if choice.links and link.name not in choice.links:
            continue
        words = link_words(world, link)
        for message in choice.messages:
            yield from (world.routine(deed, *words, message) for deed in ("build", "parse"))
            yield world.block(*words, message)
        if choice.tasks or choice.registers:
            yield world.block(*words, "client")
    for message in choice.messages:
        if message in world.layout.messages:
            for data in world.layout.messages[message].bodies:
                yield from (world.routine(deed, data.name, unit) for deed in ("pack", "unpack") for unit in _UNITS)


def trimmed(declared: Declarations, routines: Sequence[Routine], spelling: Spelling) -> Declarations:
    """The declarations that chosen routines need; all of them where a project chooses none."""
    choice = declared.layout.blocks
    if choice is None:
        return declared
    words = {word for routine in routines for line in routine_text(routine, spelling) for word in _words(line)}
    structs = _needed_structs(declared.structs, words, spelling)
    paths = set(_paths(declared.layout, choice))
    for struct in structs:
        words |= {word for member in struct.members for word in _words(type_text(member.type, spelling))}
    enums = tuple(enum for enum in declared.enums if enum is declared.status or enum.name in words)
    facts = {enum.enum.place.path for enum in enums if enum.enum is not None}
    constants = (
        replace(
            own, constants=tuple(constant for constant in own.constants if _is_needed(constant, words, paths | facts))
        )
        for own in declared.constants
    )
    kinds = {struct.key for struct in structs}
    return replace(
        declared,
        enums=enums,
        structs=structs,
        images=tuple(image for image in declared.images if image.key in kinds or image.kind == "bits"),
        constants=tuple(own for own in constants if own.constants),
        texts=tuple(table for table in declared.texts if table.enum.place.path in facts),
    )


def _needed_structs(structs: Sequence[Struct], words: set[str], spelling: Spelling) -> tuple[Struct, ...]:
    """The structs that are among some words, and those that are members of these."""
    reached: set[str] = set()
    names = set(words)
    for struct in reversed(structs):  # each follows those that are in it
        if struct.name in names:
            reached.add(struct.name)
            names |= {word for member in struct.members for word in _words(type_text(member.type, spelling))}
    return tuple(struct for struct in structs if struct.name in reached)


def _is_needed(constant: Constant, words: set[str], paths: set[str]) -> bool:
    """Whether a routine names a constant, or it belongs to no fact, or to one of these or a part of one."""
    if constant.fact is None or constant.name in words:
        return True
    path = constant.fact.place.path
    return any(path == own or path.startswith(f"{own}/") for own in paths)


def _paths(layout: DeviceLayout, choice: BlockChoice) -> Iterator[str]:
    """The paths of the facts that are chosen, and of what chosen tasks act on."""
    device = layout.device
    yield from (device.messages[name].place.path for name in choice.messages if name in device.messages)
    groups = {*_groups(layout, choice)}
    for group in device.groups:
        if group.name in groups:
            yield from (register.place.path for register in group.registers)
    yield from (table.place.path for name, table in device.tables.items() if name in groups)
    operands = Operands(device)
    for task in device.tasks:
        if task.name in choice.tasks:
            for name in task.messages or ("",):
                for step in task.steps:
                    yield from (operand.path for operand in operands.target(step.target, name))


def _words(text: str) -> list[str]:
    return re.findall(r"\w+", text)
