"""The separator of a record, stated once, as constants between its fields.

It is put in when a record of one version is built, so that a field which a version lacks has no separator there.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from fieldspec.foundation.classes import replace
from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.reading.building.context import Entry
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, identity


def with_separators(entry: Entry, key: str) -> Entry:
    """The entry with constants for its separator between the fields under a key."""
    stated, fields = entry.node.values.get("separator"), entry.node.values.get(key)
    if not isinstance(stated, Scalar) or not isinstance(fields, Sequence) or not fields.items:
        return entry
    items = [fields.items[0]]
    for before, after in pairwise(fields.items):
        items += [*_constants(stated, identity(before) or ""), after]
    node = entry.node.with_value(key, replace(fields, items=tuple(items)))
    return Entry(node, entry.path, entry.findings, entry.section, entry.sources)


def _constants(stated: Scalar, name: str) -> Iterator[Mapping]:
    """A field for each byte of a separator after a field, at the place of the separator."""
    content = bytes.fromhex(stated.text)
    for number, byte in enumerate(content, 1):
        head = "separator" if len(content) == 1 else f"separator_{number}"
        texts = {"name": f"{head}_after_{name}", "type": "u8"}
        values: dict[str, Node] = {key: _scalar(stated, text) for key, text in texts.items()}
        values |= {"const": _scalar(stated, byte), "separator": stated}
        yield Mapping(stated.file, stated.start, stated.end, values, dict.fromkeys(values, stated))


def _scalar(stated: Scalar, value: ScalarValue) -> Scalar:
    return Scalar(stated.file, stated.start, stated.end, str(value), False, value)
