"""`fieldspec completion`: the completion script of a shell."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from contextlib import suppress

from fieldspec.codec.explain.option_names import option_word
from fieldspec.codec.explain.readings import DIRECTIONS
from fieldspec.command.console.streams import print_document
from fieldspec.command.console.usage import UsageError
from fieldspec.command.sources import specs
from fieldspec.language.model.link import Link

VERBS = ("decode", "encode")
"""The verbs whose options have names of the device."""


def run(arguments: argparse.Namespace) -> int:
    """Prints the script; source it, or save it where the shell looks for completions."""
    import shtab

    parser = arguments.parser()
    suggest(parser)
    print_document(shtab.complete(parser, shell=arguments.shell) + "\n")
    return 0


def suggest(parser: argparse.ArgumentParser) -> None:
    """Adds the names that devices have for messages and directions to what a shell offers."""
    links = list(_links())
    options = sorted({f"--{option_word(link.message_name)}" for link in links} - {"--message"})
    directions = sorted(
        {link.direction_name(direction) for link in links for direction in DIRECTIONS} - set(DIRECTIONS)
    )
    for verb in _verbs(parser):
        for option in options:
            verb.add_argument(option, metavar="NAME", help="the message, by the device's name for it")
        for action in verb._actions:
            if "--direction" in action.option_strings:
                action.choices = [*DIRECTIONS, *directions]


def _links() -> Iterator[Link]:
    """The links of all devices; none where there are no specs."""
    with suppress(UsageError):
        for spec in specs.project(None).devices.values():
            yield from spec.at(spec.versions()[-1])[0].links.values()


def _verbs(parser: argparse.ArgumentParser) -> Iterator[argparse.ArgumentParser]:
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            yield from (verb for name, verb in action.choices.items() if name in VERBS)
