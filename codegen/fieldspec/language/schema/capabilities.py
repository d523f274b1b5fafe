"""Which outputs a key of the language changes: `capabilities.json` has a line for each key that has been derived.

Tests verify each line: they change the key in made-up devices and compare everything that is built from them.
"""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

EXPORT = "export"
"""The lists of `fieldspec export`, beside the names of the outputs."""

AUDIT = "audit"
"""The report of `fieldspec audit`."""

SIMULATOR = "simulate"
"""What `fieldspec simulate` does."""

CHECK = "check"
"""The findings, of keys that change nothing else."""


@cache
def effects() -> dict[str, dict[str, tuple[str, ...]]]:
    """The outputs that a key changes, by the part of the schema that has the key, and by key.

    The keys of every fact are under `fact`, in whatever part they stand.
    """
    text = Path(__file__).with_name("capabilities.json").read_text("utf-8")
    data: dict[str, dict[str, str]] = json.loads(text)
    return {part: {key: tuple(names.split()) for key, names in keys.items()} for part, keys in data.items()}
