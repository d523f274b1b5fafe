"""What wrong use of the command line says, and the numbers that its options take."""

from __future__ import annotations

import argparse
import io
import re
import shlex
from collections.abc import Callable
from contextlib import redirect_stdout

import pytest

from fieldspec.cli import _parser, main
from fieldspec.command.console.device_options import natural, positive, seconds, whole
from fieldspec.command.console.usage import unknown


@pytest.mark.parametrize(
    ("name", "known", "hint"),
    [
        ("sped", ["speed", "force"], "there is no register sped; did you mean speed?"),
        ("x", ["b10", "b9", "a"], "there is no register x; choose from a, b9, b10"),
        ("x", ["b", "a", "c"], "there is no register x; choose from a, b, c"),
        ("x", ["d", "a", "b", "c"], "there is no register x; the nearest of 4 are d, c, b"),
        ("x", [], "there is no register x; there are none"),
        ("12", ["121", "112"], "there is no register 12; choose from 112, 121"),
        ("", ["a"], "there is no register without a name; choose from a"),
    ],
)
def test_an_unknown_name_is_answered_by_the_nearest_one_or_by_all_where_they_are_few(
    name: str, known: list[str], hint: str
) -> None:
    assert str(unknown("register", name, known, limit=3)) == hint


@pytest.mark.parametrize(
    ("number", "text", "value"),
    [
        (seconds, "0", 0),
        (seconds, "0.25", 0.25),
        (positive, "0.001", 0.001),
        (whole, "0", 0),
        (natural, "1", 1),
    ],
)
def test_an_option_takes_the_least_number_that_has_a_meaning(
    number: Callable[[str], float], text: str, value: float
) -> None:
    assert number(text) == value


@pytest.mark.parametrize(
    ("number", "text", "reason"),
    [
        (seconds, "-0.001", "-0.001 is less than 0"),
        (seconds, "nan", "nan is not a number"),
        (positive, "0", "0 is not more than 0"),
        (positive, "inf", "inf is not a number"),
        (whole, "-1", "-1 is not a whole number from 0 on"),
        (natural, "0", "0 is not a whole number from 1 on"),
        (natural, "\u0661", "\u0661 is not a whole number from 1 on"),
    ],
)
def test_an_option_refuses_numbers_without_a_meaning(number: Callable[[str], float], text: str, reason: str) -> None:
    with pytest.raises(argparse.ArgumentTypeError, match=f"^{reason}$"):
        number(text)


def help_of(*arguments: str) -> str:
    """The help of a command."""
    output = io.StringIO()
    with redirect_stdout(output), pytest.raises(SystemExit):
        main([*arguments, "--help"])
    return output.getvalue()


def test_the_help_of_live_has_its_options_in_groups() -> None:
    titles = re.findall(r"^(\S.*):$", help_of("live"), re.MULTILINE)
    groups = ["connection", "times", "watch", "write, points upload, restore", "lists", "output"]
    assert titles == ["positional arguments", "options", *groups, "examples"]


def test_the_help_of_live_ends_with_three_examples_that_exist() -> None:
    examples = help_of("live").partition("\nexamples:\n")[2].splitlines()
    commands = [_parser().parse_args(shlex.split(line)[1:]).verb_of_device for line in examples]
    assert commands == ["find", "read", "write"]
