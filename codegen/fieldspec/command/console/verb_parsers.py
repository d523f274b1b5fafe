"""Parsers of the command line that report wrong use in one line, and import what a verb needs when it is called."""

from __future__ import annotations

import argparse
import os
import re
from collections.abc import Sequence
from importlib import import_module

from fieldspec.command.console.usage import UsageError, unknown

TYPE_CHECKING = False  # as of `typing`, which takes longer to import than the help to print
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any


def _help(prog: str) -> argparse.HelpFormatter:
    """The formatter of help texts. argparse by itself would import all of shutil to ask for the width."""
    try:
        width = int(os.environ.get("COLUMNS") or os.get_terminal_size().columns)
    except (ValueError, OSError):
        width = 80
    return argparse.HelpFormatter(prog, width=max(width - 2, 40))


DEVICE_HELP = "the device, and its version (default: the newest)"
"""The help of an argument that names a device and perhaps a version."""

_PLACES = {"DIR": "folder", "FOLDER": "folder", "FILE": "file", "PATH": "file or a folder"}
"""What arguments name, by what stands for them in the help."""


class LineParser(argparse.ArgumentParser):
    """Reports wrong use in one line that says where to read more."""

    def __init__(self, **options: Any) -> None:
        super().__init__(formatter_class=_help, **options)

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        """Reports an empty path, or a value that is not among the choices, with the nearest. Raises UsageError."""
        if value == "" and action.metavar in _PLACES:
            name, place = action.option_strings[0] if action.option_strings else action.dest, _PLACES[action.metavar]
            raise UsageError(f"{name} is empty; name a {place}; see: {self.prog} --help")
        if action.choices is not None and value not in action.choices:
            name = "/".join(action.option_strings) or str(action.metavar or action.dest)
            subject = "command" if name == "VERB" else f"value of {name}"
            text = unknown(subject, str(value), map(str, action.choices))
            raise UsageError(f"{text}; see: {self.prog} --help")

    def error(self, message: str) -> None:  # type: ignore[override]
        """Reports wrong use. Raises UsageError."""
        raise UsageError(f"{message}; see: {self.prog} --help")


class _Word(argparse.Action):
    """An option named after a word of the device. The verb, which knows the device, judges it."""

    def __call__(self, parser: object, namespace: Any, values: Any, option: str | None = None) -> None:
        namespace.words = [*namespace.words, (option, values)]


class Suggested(tuple[str, ...]):
    """The completions of an option that also accepts other texts."""

    __slots__ = ()

    def __contains__(self, text: object) -> bool:
        return True


class ImportedNames:
    """Names that are imported when they are listed. The verb itself refuses others."""

    def __init__(self, module: str, attribute: str) -> None:
        self._module, self._attribute = module, attribute

    def __contains__(self, text: object) -> bool:
        return True

    def __iter__(self) -> Iterator[str]:
        return iter(getattr(import_module(self._module), self._attribute))


class VerbParser(LineParser):
    """The arguments of one verb, in any order. They are added only when the verb is called.

    Where the verb has a default for `words`, unknown options are collected there.
    """

    late_help: tuple[str, str] | None = None
    """The module and function that write the end of the help, given the arguments; imported for help alone."""

    late_arguments: tuple[str, str] | None = None
    """The module and function that add the arguments; imported when the verb is called."""

    examples: Sequence[str] = ()
    """Commands at the end of the help."""

    _mixing = False
    _tail: Sequence[str] | None = None
    """What stands from `--` on. argparse would look for options in it where positional arguments come in between."""

    def __init__(self, **options: Any) -> None:
        self._waiting: list[tuple[tuple[str, ...], dict[str, Any]]] | None = []
        super().__init__(**options)

    def add_argument(self, *names: str, **options: Any) -> None:  # type: ignore[override]
        """Adds an argument, or notes it until the verb is called."""
        if self._waiting is None:
            super().add_argument(*names, **options)
        else:
            self._waiting.append((names, options))

    def settle(self) -> None:
        """Adds the arguments that were noted."""
        waiting, self._waiting = self._waiting or [], None
        if self.late_arguments:
            module, function = self.late_arguments
            getattr(import_module(module), function)(self)
        for names, options in waiting:
            self.add_argument(*names, **options)

    def format_help(self) -> str:
        """The help, with the examples as they are."""
        examples = "".join(f"  {line}\n" for line in self.examples)
        return f"{super().format_help()}\nexamples:\n{examples}" if examples else super().format_help()

    def _learn(self, arguments: Sequence[str]) -> None:
        for argument in arguments:
            if argument == "--":
                return
            option = argument.partition("=")[0]
            known = any(text.startswith(option) for text in self._option_string_actions)
            if re.fullmatch("--[A-Za-z][A-Za-z0-9_-]*", option) and not known:
                self.add_argument(option, action=_Word, nargs="?", dest="words", help=argparse.SUPPRESS)

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """The arguments and the unknown words; options and positional arguments may be mixed."""
        if self._mixing:
            if self._tail is None:  # the options alone come first
                end = [*args, "--"].index("--")
                args, self._tail = args[:end], args[end:]
            else:
                args = [*args, *self._tail]
            return super().parse_known_args(args, namespace)
        self.settle()
        self._mixing = True
        if self.get_default("words") is not None:
            self._learn(args)
        if self.late_help and {"-h", "--help"} & {*args}:
            module, function = self.late_help
            self.epilog = getattr(import_module(module), function)(args) or self.epilog
        known, unrecognized = self.parse_known_intermixed_args(args, namespace)
        if unrecognized:
            self.error(f"unrecognized arguments: {' '.join(unrecognized)}")
        return known, unrecognized
