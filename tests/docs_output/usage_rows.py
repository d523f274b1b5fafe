"""The code that the site offers for facts, of all devices."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.targets import OUTPUTS
from fieldspec.targets.usages import Usage
from layouts import SPECS, TEST_SPECS, layouts


def usage_text(usage: Usage, variables: dict[str, str]) -> str:
    """The code of a usage, as `facts.js` makes it."""
    text = usage.template
    for name, value in (*((str(n), value) for n, value in enumerate(usage.arguments)), *variables.items()):
        text = text.replace(f"@{name}@", value)
    return text


@cache
def usages(output: str, device: str) -> tuple[DeviceLayout, dict[str, list[str]]]:
    """The newest version of a device, and the code of an output for its facts by path."""
    versions = (layouts(SPECS) | layouts(TEST_SPECS))[device]
    by_version = OUTPUTS[output].usages(versions)
    newest = by_version[versions[-1].device.version]
    codes: dict[str, list[str]] = {}
    for usage in newest.rows:
        codes.setdefault(usage.fact, []).append(usage_text(usage, newest.variables))
    return versions[-1], codes


def code(output: str, device: str) -> Iterator[tuple[str, str]]:
    """The paths and the code of an output for a device; the same text once."""
    seen: set[str] = set()
    for path, texts in usages(output, device)[1].items():
        for text in texts:
            if text not in seen:
                seen.add(text)
                yield path, text
