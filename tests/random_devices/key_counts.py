"""How many random devices without findings have each key of the language, each of its forms, and pairs of its keys."""

from __future__ import annotations

from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import cache
from itertools import combinations, repeat
from typing import Any

from hypothesis import Phase, given
from hypothesis import seed as seeded

from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.project import read
from fieldspec.language.schema import resolved
from fieldspec.tools.proofs.running import outcome
from random_devices.devices import devices, text_of
from random_devices.draft import Spec
from random_devices.schema_keys import ANYWHERE, FORMS, WORDS, Key, key_path, known_keys, nodes_in, reason
from steady_draws import steady

BATCH = 20
SELDOM = 10
"""A key that fewer of 2,000 devices have is listed as a seldom one."""
_MOST_PAIRS = 60


@dataclass
class KeyCounts:
    """The number of devices with each key, each form of a key, and each pair of keys of one mapping.

    A form is a word, a truth value, or the type of another value, as in `part.role: code`.
    """

    devices: int = 0
    clean: int = 0
    keys: Counter[Key] = field(default_factory=Counter)
    forms: Counter[str] = field(default_factory=Counter)
    pairs: Counter[tuple[str, str, str]] = field(default_factory=Counter)

    def add_device(self, spec: Spec) -> None:
        """Counts a device without findings."""
        keys: set[Key] = set()
        forms: set[str] = set()
        pairs: set[tuple[str, str, str]] = set()
        for owner, node, shape in nodes_in(spec):
            own = [key for key in node if key in shape.get("properties", {})]
            keys |= {(owner, key) for key in own}
            forms |= {f"{owner}.{key}: {_form(shape['properties'][key], node[key])}" for key in own}
            telling = sorted(key for key in own if key not in ANYWHERE or key in ("since", "until"))
            pairs |= {(owner, first, second) for first, second in combinations(telling, 2)}
        self.clean += 1
        self.keys.update(keys)
        self.forms.update(forms)
        self.pairs.update(pairs)

    def lacks(self, spec: Spec) -> bool:
        """Whether a device has a key or a word without a reason that no counted one has."""
        counts = KeyCounts()
        counts.add_device(spec)
        return bool(counts.wanted() - self.wanted())

    def wanted(self) -> set[Key | str]:
        """The keys and the words that there are and that no reason excuses."""
        return {key for key in self.keys if not reason(key)} | {*self.forms} & _words()

    def add(self, other: KeyCounts) -> None:
        """Adds the counts of others."""
        self.devices += other.devices
        self.clean += other.clean
        self.keys += other.keys
        self.forms += other.forms
        self.pairs += other.pairs

    def seldom(self, least: int) -> dict[Key, int]:
        """The keys that fewer devices have, and that no reason excuses."""
        return {key: self.keys[key] for key in sorted(known_keys()) if self.keys[key] < least and not reason(key)}

    def absent_forms(self, least: int = 1) -> list[str]:
        """The words of keys that so many devices have, but never with this word."""
        return sorted(form for form in _words() if not self.forms[form] and self.keys[key_path(form)] >= least)

    def report(self) -> str:
        """What is drawn seldom or never, in words."""
        seldom = sorted(self.seldom(SELDOM * self.clean // 2000 + 1).items(), key=lambda item: item[1])
        pairs = sorted(self.pairs.items(), key=lambda item: item[1])[:_MOST_PAIRS]
        return "\n".join(
            [
                f"{self.devices} devices, {self.clean} of them without findings",
                f"seldom: {', '.join(f'{owner}.{key} {count}' for (owner, key), count in seldom)}",
                f"words that no device has: {', '.join(self.absent_forms())}",
                f"the pairs that fewest have: {', '.join(f'{o} {a}+{b} {count}' for (o, a, b), count in pairs)}",
            ]
        )


def _form(shape: Any, value: Any) -> str:
    if isinstance(value, str) and value in _choices(shape):
        return value
    return str(value).lower() if isinstance(value, bool) else type(value).__name__


def _choices(shape: Any) -> list[Any]:
    return list(resolved(shape).get("enum", ()))


@cache
def _words() -> frozenset[str]:
    """All words of all keys that need no reason."""
    shapes = {key: shape for key, shape in known_keys().items() if not reason(key) and key not in WORDS}
    choices = ((key, word) for key, shape in shapes.items() for word in _choices(shape) if isinstance(word, str))
    return frozenset(f"{owner}.{key}: {word}" for (owner, key), word in choices) - FORMS.keys()


def drawn(seed: int, count: int = BATCH) -> list[Spec]:
    """The devices of a seed."""
    specs: list[Spec] = []
    limits = steady(count, Phase.generate)
    seeded(seed)(limits(given(devices())(lambda spec: specs.append(spec))))()
    return specs


def is_clean(spec: Spec) -> bool:
    """Whether a device has no findings, so that codecs are asked about it."""
    project = read({"chance/device.yaml": text_of(spec).encode()})
    return not has_errors(project.findings) and not has_errors(outcome(project.devices["chance"]).findings)


def counts_of(seed: int, count: int = BATCH) -> KeyCounts:
    """The counts of the devices of a seed."""
    result = KeyCounts()
    for spec in drawn(seed, count):
        result.devices += 1
        if is_clean(spec):
            result.add_device(spec)
    return result


def rich_seeds(counts: dict[int, KeyCounts]) -> list[int]:
    """Seeds whose devices have together each key and each word without a reason that the devices of all seeds have."""
    had: dict[int, set[Key | str]] = {}
    for seed, own in counts.items():
        had[seed] = own.wanted()
    missing, seeds = set[Key | str]().union(*had.values()), list[int]()
    while missing:
        rarest = min(missing, key=lambda word: (sum(word in words for words in had.values()), str(word)))
        seeds.append(max((seed for seed in had if rarest in had[seed]), key=lambda seed: len(had[seed] & missing)))
        missing -= had[seeds[-1]]
    return seeds


def statistics(count: int, seed: int, processes: int) -> str:
    """What so many devices have, as a text."""
    total = KeyCounts()
    seeds = range(seed, seed + -(-count // BATCH))
    with ProcessPoolExecutor(processes) as pool:
        counts = dict(zip(seeds, pool.map(counts_of, seeds, repeat(BATCH)), strict=True))
    for batch in counts.values():
        total.add(batch)
    return f"{total.report()}\nseeds that have all of it together: {rich_seeds(counts)}"
