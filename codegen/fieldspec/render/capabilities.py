"""The page of capabilities as Markdown: what outputs express exactly, adapt or refuse, and which keys change them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib import import_module
from itertools import groupby

from fieldspec.backends import BUILT_IN, OUTPUTS
from fieldspec.plc.capabilities import CONSTRUCTS, EXACT, Capability, of_dialect
from fieldspec.plc.dialects import DIALECTS
from fieldspec.render.left_out import left_out_lines
from fieldspec.schema.capabilities import AUDIT, CHECK, EXPORT, SIMULATOR, effects

COLUMNS = ("st", "twincat", "plcopen", "iec", "scl", "kv", "hmi")
"""The outputs for engineering tools, in the order of the columns."""

_INTRODUCTION = """\
<!-- Written by `fieldspec.render.capabilities.page`; a test keeps it fresh. -->

# What the outputs express

The [first table](#constructs) says which constructs the outputs for
engineering tools express, adapt or refuse. The [second one](#keys) says which outputs each key of the language changes.

## Constructs

**exact**: programs get all of it, and nothing else. **adapted**: they get it in another form; the number leads to how.
**refused**: nothing of it is written. Where a rule says so, the build does too: see [below](#what-is-left-out).
"""

_KEYS = """\
## Keys

The outputs that change when the key changes in a spec, apart from the identity, which every output has. An output
that a row does not name has no place for what the key states: the lists for operator panels have no registers, and a
codec has no use for the line of a manual. A key of which only `docs` is named is documentation. `export` are the
lists of `fieldspec export`, `audit` is the report of `fieldspec audit`, `simulate` is what `fieldspec simulate` does,
and `check` are the findings, which stand only at keys that change nothing else: the findings compare them with other
facts, or refuse them where they stand. `none` means that nothing which is built has the key: it is for readers of the
spec. Tests verify the lines: they change a key in made-up devices and compare everything that is built from them.
"""

_ALL = "all outputs"


def page() -> str:
    """The text of the page of capabilities."""
    reasons: dict[str, int] = {}
    tables = {name: capabilities(name) for name in COLUMNS}
    lines = [_INTRODUCTION, f"| construct | {' | '.join(COLUMNS)} |", f"|---{'|---' * len(COLUMNS)}|"]
    for key, title in CONSTRUCTS.items():
        cells = [_cell(tables[name][key], reasons) for name in COLUMNS]
        lines.append(f"| {title} | {' | '.join(cells)} |")
    lines += ["", *(f"- `{name}`: {OUTPUTS[name].title}" for name in COLUMNS), "", "### Why", ""]
    lines += [f"{number}. {reason[:1].upper()}{reason[1:]}." for reason, number in reasons.items()]
    lines += ["", *left_out_lines(), ""]
    lines += [_KEYS, *(f"- `{name}`: {OUTPUTS[name].title}" for name in OUTPUTS if name in BUILT_IN)]
    for part, keys in effects().items():
        lines += ["", f"### {part or 'the file'}", "", "| keys | change |", "|---|---|", *_rows(keys)]
    return "\n".join(lines) + "\n"


def _rows(keys: Mapping[str, tuple[str, ...]]) -> Iterator[str]:
    """A row for the keys that change the same outputs."""
    by_outputs = sorted(keys.items(), key=lambda item: (-len(item[1]), item[1], item[0]))
    for outputs, entries in groupby(by_outputs, key=lambda item: item[1]):
        yield f"| {', '.join(f'`{key}`' for key, _ in entries)} | {_outputs_text(outputs)} |"


def _outputs_text(outputs: tuple[str, ...]) -> str:
    ordered = [name for name in (*OUTPUTS, EXPORT, AUDIT, SIMULATOR, CHECK) if name in outputs]
    return _ALL if set(outputs) >= BUILT_IN else ", ".join(ordered) or "none"


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
