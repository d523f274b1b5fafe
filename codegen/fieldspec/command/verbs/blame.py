"""`fieldspec blame`: which file and line set each attribute of a fact."""

from __future__ import annotations

import argparse
from collections.abc import Iterator

from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.console.usage import UsageError
from fieldspec.command.rendering.blocks import Table
from fieldspec.command.sources import specs
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, find, keys, node_at

_HEADINGS = ("key", "value", "set in")
_LONGEST = 60


def run(arguments: argparse.Namespace) -> int:
    """Prints one row for each attribute; defaults of its group are marked. Raises UsageError."""
    spec, version = specs.spec_at(arguments.specs, arguments.device)
    tree = spec.tree_at(version)
    fact = find(tree, arguments.path)
    if not isinstance(fact, Mapping):
        hint = "" if fact is None else ", only a list"
        known = f"{arguments.device.partition('@')[0]} has no fact {arguments.path} at {version}{hint}"
        raise UsageError(f"{known}; {_near(spec, version, arguments.path)}`fieldspec facts` lists all paths")
    rows = [*_rows(fact, ""), *_inherited(tree, arguments.path, fact)]
    print_blocks([Table(_HEADINGS, tuple(rows))])
    return 0


def _near(spec: DeviceSpec, version: str, path: str) -> str:
    """The fact that somebody may mean who gives a wrong path, or the last part of a path; empty for none."""
    from difflib import get_close_matches

    from fieldspec.codec.layout.device import device_layout
    from fieldspec.language.checks.layout_conditions import has_layout
    from fieldspec.tools.facts import rows

    device, broken = spec.at(version)
    if has_errors(broken) or not has_layout(device):
        return ""
    paths = [str(row["path"]) for row in rows(device_layout(device))]
    matches = [own for own in paths if own.rpartition("/")[2] == path] or get_close_matches(path, paths, 1, 0.8)
    return f"did you mean {matches[0]}? " if matches else ""


def _rows(node: Mapping, before: str, remark: str = "") -> Iterator[tuple[str, str, str]]:
    for key, value in node.values.items():
        name = f"{before}{key}"
        if isinstance(value, Scalar):
            yield name, _shortened(value.text), _place(value) + remark
        elif isinstance(value, Mapping):
            yield from _rows(value, f"{name}/", remark)
        else:
            texts = [item.text for item in value.items if isinstance(item, Scalar)]
            summary = ", ".join(texts) if len(texts) == len(value.items) else f"{len(value.items)} entries"
            yield name, _shortened(summary), _place(value) + remark


def _inherited(tree: Mapping, path: str, fact: Mapping) -> Iterator[tuple[str, str, str]]:
    """The attributes that a row takes from the defaults of its group."""
    fact_keys = keys(tree, path) or []
    for end in range(len(fact_keys) - 1, 0, -1):
        holder = node_at(tree, fact_keys[:end])
        defaults = holder.values.get("defaults") if isinstance(holder, Mapping) else None
        if isinstance(defaults, Mapping):
            for key, value in defaults.values.items():
                if key not in fact.values and isinstance(value, Scalar):
                    yield key, _shortened(value.text), f"{_place(value)}, a default"
            return


def _shortened(text: str) -> str:
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}..."


def _place(node: Node) -> str:
    line, column = node.span.position()
    return f"{node.span.file.path}:{line}:{column}"
