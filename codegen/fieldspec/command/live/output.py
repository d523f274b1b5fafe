"""The output and the questions of the verbs of `fieldspec live`."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

from fieldspec.codec.explain.values import DecodedValue
from fieldspec.command.console.streams import print_document, print_json, print_note
from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.console.usage import UsageError
from fieldspec.command.rendering.blocks import Table
from fieldspec.foundation.classes import TYPE_CHECKING

if TYPE_CHECKING:
    from fieldspec.tools.live.access import Access, Reading


@contextmanager
def progress(total: int, description: str) -> Iterator[Callable[[int], None]]:
    """A progress bar on a terminal; nothing elsewhere."""
    if not sys.stderr.isatty():
        yield lambda words: None
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(description, total=total)
        yield lambda words: bar.advance(task, words)


def meaning(value: Reading) -> str:
    """The meaning of a value in a few words."""
    return meaning_of(value.decoded, value.refusal)


def meaning_of(decoded: DecodedValue | None, refusal: str) -> str:
    """The meaning of a value in a few words, or why the device has refused it."""
    if decoded is None:
        return f"refused: {refusal}"
    names = [meaning.name or f"bit {meaning.bits}" for meaning in decoded.meanings]
    raw = decoded.text or (decoded.number if isinstance(decoded.number, str) else "")
    return ", ".join(text for text in (raw, " ".join(names), decoded.verdict) if text and text != "right")


def number(value: Reading) -> str:
    """The raw value as a number; empty for a text and for a refused value."""
    return number_of(value.decoded)


def number_of(decoded: DecodedValue | None) -> str:
    """The raw value as a number, or as hexadecimal bytes; empty for a text and where there is none."""
    number = decoded.number if decoded is not None else None
    if isinstance(number, bytes):
        return number.hex(" ").upper()
    return "" if number is None or isinstance(number, str) else str(number)


def print_values(access: Access, values: Sequence[Reading], form: str) -> int:
    """Prints values as a table or as JSON: exit code 1 where the device refused one."""
    if form == "json":
        rows = [
            {
                "name": value.path,
                access.heading(value): access.number(value),
                "words": list(value.words),
                "value": None if value.decoded is None else _json(value.decoded.number),
                "meaning": meaning(value),
                "refused": value.refusal or None,
            }
            for value in values
        ]
        print_json(rows, indent=1)
    else:
        table = tuple((v.path, access.number_text(v), number(v), meaning(v)) for v in values)
        heading = " or ".join(dict.fromkeys(map(access.heading, values)))
        print_blocks([Table(("name", heading, "value", "meaning"), table)])
    sys.stdout.flush()
    return int(any(value.refusal for value in values))


def _json(number: object) -> object:
    return number.hex() if isinstance(number, bytes) else number


def can_ask(arguments: argparse.Namespace) -> bool:
    """Whether somebody agrees, or can be asked."""
    return bool(arguments.yes) or sys.stdin.isatty()


def confirmed(arguments: argparse.Namespace) -> bool:
    """Whether a person agrees to write. Raises UsageError without a terminal."""
    if arguments.yes:
        return True
    if not can_ask(arguments):
        raise UsageError("nothing is written: confirm the list above with --yes")
    print_document("Write? [y/N] ", sys.stderr)
    if sys.stdin.readline().strip().lower() in ("y", "yes"):
        return True
    print_note("nothing was written")
    return False
