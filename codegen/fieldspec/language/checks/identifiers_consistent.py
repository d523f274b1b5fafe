"""No two printed identifiers differ only by one missing letter or by two swapped letters.

Why: two such identifiers are the same one, misspelt in one place, and a search of the manual misses that
place. Identifiers are words of at least six letters that are in capitals or contain capitals. The number of
repetitions of a doubled letter is not compared.

Example: the signal SOFTLIMIT in one table, and SOFLIMIT in another.

Fix: Use one spelling, and write an erratum with the other. If they are two names, set `allow:
{identifiers_consistent: <reason>}`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from fieldspec.language.checks.facts import facts
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Place

_WORD = re.compile(r"[A-Za-z_]{6,}")
_INNER_CAPITAL = re.compile(r"[a-z][A-Z]")

_Used = dict[str, list[tuple[Place, str]]]


def identifiers_consistent(device: Device) -> Findings:
    used: _Used = {}
    for place, key, text in _printed(device):
        for word in _WORD.findall(text):
            if word.isupper() or _INNER_CAPITAL.search(word):
                used.setdefault(word, []).append((place, key))
    alike: dict[str, str] = {}
    for word in used:
        for variant in dict.fromkeys((word, *_shorter(word), *_swapped(word))):
            other = alike.setdefault(variant.casefold(), word)
            if other != word and _misspelt(word, other):
                yield _finding(used, word, other)
                break


def _printed(device: Device) -> Iterator[tuple[Place, str, str]]:
    """The texts that may hold identifiers, with the places where they are printed."""
    for fact in facts(device):
        if fact.printed_name:
            yield fact.place, "printed_name", fact.printed_name
        for claim in fact.restated:
            yield claim.place, "printed_name", str(claim.values.get("printed_name", ""))
    for lookup in device.lookups:
        for row in lookup.rows:
            for cell in row.cells:
                if isinstance(cell, str):
                    yield row.place, "cells", cell


def _shorter(word: str) -> Iterator[str]:
    """A word without one of its letters, unless that is doubled."""
    for index, letter in enumerate(word):
        if letter.casefold() not in word[max(index - 1, 0) : index].casefold() + word[index + 1 : index + 2].casefold():
            yield word[:index] + word[index + 1 :]


def _swapped(word: str) -> Iterator[str]:
    """A word with two neighbouring letters in the other order."""
    for index in range(len(word) - 1):
        if word[index] != word[index + 1]:
            yield word[:index] + word[index + 1] + word[index] + word[index + 2 :]


def _misspelt(word: str, other: str) -> bool:
    """Whether one of two words is the other with a letter missing or with two in the other order."""
    variants = {variant.casefold() for variant in (*_shorter(word), *_swapped(word))}
    return other.casefold() in variants or word.casefold() in {variant.casefold() for variant in _shorter(other)}


def _finding(used: _Used, word: str, other: str) -> Diagnostic:
    """A finding at the rarer of two words; or at the shorter, or at the later one."""
    rare, usual = sorted((word, other), key=lambda spelling: (len(used[spelling]), len(spelling)))
    (place, key), (usual_place, its_key) = used[rare][0], used[usual][0]
    return finding(
        place,
        key,
        f"`{rare}` differs from `{usual}` by one letter",
        "use one spelling, or allow it with a reason",
        label(usual_place, its_key, f"`{usual}`"),
    )
