"""The matrix of capabilities as Markdown: what each output expresses exactly, loses, or refuses."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module

from fieldspec.backends import OUTPUTS
from fieldspec.plc.capabilities import CONSTRUCTS, EXACT, Capability, of_dialect
from fieldspec.plc.dialects import DIALECTS

COLUMNS = ("st", "twincat", "plcopen", "iec", "scl", "kv", "hmi")
"""The outputs for engineering tools, in the order of the columns."""

_INTRODUCTION = """\
<!-- Written by `fieldspec.render.capabilities.page`; a test keeps it fresh. -->

# What each output for engineering tools can express

**exact**: programs get all of it, and nothing else. **lossy**: something gets lost; the number leads to what.
**refused**: nothing of it is written. Where a device needs what an output refuses by a rule, the build says so and
writes nothing; `fieldspec rule CODE` explains the rule.
"""


def page() -> str:
    """The whole page."""
    reasons: dict[str, int] = {}
    tables = {name: capabilities(name) for name in COLUMNS}
    lines = [_INTRODUCTION, f"| construct | {' | '.join(COLUMNS)} |", f"|---{'|---' * len(COLUMNS)}|"]
    for key, title in CONSTRUCTS.items():
        cells = [_cell(tables[name][key], reasons) for name in COLUMNS]
        lines.append(f"| {title} | {' | '.join(cells)} |")
    lines += ["", *(f"- `{name}`: {OUTPUTS[name].title}" for name in COLUMNS), "", "## Why", ""]
    lines += [f"{number}. {reason[:1].upper()}{reason[1:]}." for reason, number in reasons.items()]
    return "\n".join(lines) + "\n"


def capabilities(name: str) -> Mapping[str, Capability]:
    """The capabilities of an output, from its dialect or its back end."""
    if name in DIALECTS:
        return of_dialect(DIALECTS[name])
    table: Mapping[str, Capability] = import_module(f"fieldspec.backends.{name}.backend").capabilities()
    return table


def _cell(capability: Capability, reasons: dict[str, int]) -> str:
    if capability.level == EXACT:
        return EXACT
    return f"{capability.level} ({reasons.setdefault(capability.reason, len(reasons) + 1)})"
