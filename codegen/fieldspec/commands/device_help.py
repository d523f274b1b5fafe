"""The names that a device has for its messages and directions, for help texts and completion."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from contextlib import suppress
from itertools import pairwise

from fieldspec.commands import compiled, specs
from fieldspec.commands.frame_options import direction_names
from fieldspec.commands.usage import UsageError
from fieldspec.explain.readings import DIRECTIONS, option_word
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.link import Link
from fieldspec.reading.findings import MAIN

VERBS = ("decode", "encode")


def device_help(arguments: Sequence[str]) -> str:
    """What the help adds for the device among some arguments: its messages and directions. Empty without one."""
    with suppress(UsageError):
        given = next((after for before, after in pairwise(arguments) if before == "--specs"), None)
        path = specs.folder(given)
        for argument in arguments:
            name, _ = specs.split(argument)
            if not name.startswith("-") and name and (path / name / MAIN).is_file():
                return " ".join(_sentences(compiled.layout(given, argument)))
    return ""


def _sentences(layout: DeviceLayout) -> Iterator[str]:
    for link in layout.links.values():
        messages = (laid.message for laid in link.messages.values())
        names = ", ".join(one.name if one.number is None else str(one.number) for one in messages)
        ways = " or ".join(direction_names(layout, link.name))
        yield f"On {link.name}, --{option_word(link.link.message_name)} is one of {names}; --direction is {ways}."


def suggest(parser: argparse.ArgumentParser) -> None:
    """Adds the words of all devices to what a shell offers for the verbs that take them."""
    links = list(_link_help())
    options = sorted({f"--{option_word(link.message_name)}" for link in links} - {"--message"})
    directions = sorted({link.direction_name(way) for link in links for way in DIRECTIONS} - set(DIRECTIONS))
    for verb in _verbs(parser):
        for option in options:
            verb.add_argument(option, metavar="NAME", help="the message, as the device calls it")
        for action in verb._actions:
            if "--direction" in action.option_strings:
                action.choices = [*DIRECTIONS, *directions]


def _link_help() -> Iterator[Link]:
    """The links of all devices; none where there are no specs."""
    with suppress(UsageError):
        for spec in specs.project(None).devices.values():
            yield from spec.at(spec.versions()[-1])[0].links.values()


def _verbs(parser: argparse.ArgumentParser) -> Iterator[argparse.ArgumentParser]:
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            yield from (verb for name, verb in action.choices.items() if name in VERBS)
