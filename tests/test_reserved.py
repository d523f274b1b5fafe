"""A name that a target reserves is escaped there, and the escaped name is never the name of something else."""

from __future__ import annotations

import re

import pytest

from fieldspec.foundation.reserved import TARGETS
from fieldspec.language.reading.scalars import schema


@pytest.mark.parametrize(
    ("target", "name", "escaped"),
    [
        ("python", "class", "class_"),
        ("python", "register", "register"),
        ("c", "register", "register_"),
        ("c", "Register", "Register"),
        ("c", "size_t", "size_t_"),
        ("iec", "Timer", "Timer"),
        ("iec", "Time", "TimeValue"),
        ("siemens", "Timer", '"Timer"'),
    ],
)
def test_reserved_words_are_escaped(target: str, name: str, escaped: str) -> None:
    assert TARGETS[target].legal_name(name) == escaped


@pytest.mark.parametrize("target", ["python", "c"])
def test_escaped_words_are_no_names_of_specs(target: str) -> None:
    legal = re.compile(schema()["$defs"]["name"]["pattern"])
    for word in TARGETS[target].words:
        assert not legal.search(TARGETS[target].legal_name(word))


@pytest.mark.parametrize("target", [name for name, target in TARGETS.items() if target.folds])
def test_words_of_a_target_that_folds_case_are_in_lower_case(target: str) -> None:
    words = TARGETS[target].words
    assert {word.lower() for word in words} == words
