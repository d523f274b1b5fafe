"""All routines of a device, each after those that it calls."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.targets.controllers.routines.absent import absent_routines, range_routines
from fieldspec.targets.controllers.routines.blocks.all_blocks import Blocks, device_blocks
from fieldspec.targets.controllers.routines.checksums import checksum
from fieldspec.targets.controllers.routines.enums import enum_routines
from fieldspec.targets.controllers.routines.exchanges import exchange_blocks
from fieldspec.targets.controllers.routines.frames import frame_routines
from fieldspec.targets.controllers.routines.magnitudes import magnitude_routines
from fieldspec.targets.controllers.routines.messages import message_routines
from fieldspec.targets.controllers.routines.reals import real_routines
from fieldspec.targets.controllers.routines.registers import group_routines, table_routines
from fieldspec.targets.controllers.routines.scaling import scaling_routines
from fieldspec.targets.controllers.routines.status_words import status_word
from fieldspec.targets.controllers.routines.telegrams import telegram_routines
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.routines.wrapping import framed
from fieldspec.targets.controllers.statements.routine import Routine, called


def routines(world: World) -> Blocks:
    """The functions and blocks of a device; of the functions that make numbers of enums, those that others need."""
    functions = list(_all(world))
    blocks = device_blocks(world, functions)
    return Blocks(tuple(_needed(world, [*functions, *blocks.routines])), blocks.missing)


def _needed(world: World, routines: list[Routine]) -> list[Routine]:
    optional = {world.routine(enum, "to_raw") for enum in world.names.enums}
    if not optional:
        return routines
    called_names = set().union(*map(called, routines))
    return [routine for routine in routines if routine.name in called_names or routine.name not in optional]


def _all(world: World) -> Iterator[Routine]:
    layout = world.layout
    for enum in layout.device.enums.values():
        yield from enum_routines(world, enum)
    yield from real_routines(world)
    yield from magnitude_routines(world)
    yield from scaling_routines(world)
    yield from absent_routines(world)
    yield from range_routines(world)
    yield from table_routines(world)
    yield from group_routines(world)
    yield from telegram_routines(world)
    links = [link for link in layout.links.values() if framed(link)]
    checks = (part.algorithm for link in links for shape in (link.request, link.response) for part in shape.parts)
    for algorithm in dict.fromkeys(algorithm for algorithm in checks if algorithm):
        yield checksum(world, algorithm)
    if world.names.has_status:
        yield status_word(world)
    for link in links:
        yield from frame_routines(world, link)
        messages = list(message_routines(world, link))
        yield from messages
        yield from exchange_blocks(world, link, messages)
