"""The registers among the objects of JSON and YAML: lists of objects, and objects by their addresses or names."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from fieldspec.foundation.spreadsheet import clean
from fieldspec.tools.lists.addresses import address_text
from fieldspec.tools.lists.cells import whole
from fieldspec.tools.lists.orders import stated_order
from fieldspec.tools.lists.sheet import MOST_COLUMNS, MOST_ROWS, ListError, Sheet, SheetRow
from fieldspec.tools.lists.words import folded, meaning, words

GROUP = "group"
"""The heading of the names of groups, which say nothing of what is in them."""

_NO_ADDRESSES = ("index", "offset", "dec", "decimal", "start", "registers")
"""Keys that only are addresses where no others are."""


def objects_sheet(data: object, format_name: str, only_with_addresses: bool = False) -> Sheet:
    """The sheet of all objects with addresses in some data, else perhaps of those that are most alike.

    Raises ListError.
    """
    groups = list(_groups("", data, {})) if isinstance(data, list | dict) else []
    with_addresses = [(name, objects) for name, objects in groups if any(map(_has_address, objects))]
    objects = _joined(with_addresses if with_addresses or only_with_addresses else _alike(groups))
    if not objects:
        raise ListError(f"is {format_name} but not a list of objects; give each register one, or a row of a table")
    if len(objects) > MOST_ROWS:
        raise ListError(f"has more than {MOST_ROWS} rows; a list of registers has fewer")
    heads = list(dict.fromkeys(key for item in objects for key in item))
    if len(heads) > MOST_COLUMNS:
        raise ListError(f"has more than {MOST_COLUMNS} columns")
    rows = [SheetRow(1, tuple(map(clean, heads)))]
    definitions = dict(_named_values(data))
    values = [head for head in heads if meaning("headings", head) == "values"]
    for n, item in enumerate(objects, 2):
        resolved = {head: definitions.get(str(item.get(head)), item.get(head)) for head in values}
        rows.append(SheetRow(n, tuple(_cell(resolved.get(head, item.get(head))) for head in heads)))
    return Sheet(tuple(row for row in rows if any(row.cells)), len(objects) + 1)


def _alike(groups: list[tuple[str, list[dict[str, Any]]]]) -> list[tuple[str, list[dict[str, Any]]]]:
    """The groups that have half of the keys of the longest one."""
    longest = max((objects for _, objects in groups), key=len, default=[])
    keys = {key for item in longest for key in item}
    return [pair for pair in groups if 2 * len(keys & {key for item in pair[1] for key in item}) >= len(keys)]


def _joined(groups: list[tuple[str, list[dict[str, Any]]]]) -> list[dict[str, Any]]:
    """The objects of some groups; if there are several groups, with the names of their groups."""
    if len({name for name, _ in groups}) == 1:
        return [item for _, objects in groups for item in objects]
    head = "space" if all(meaning("spaces", name) for name, _ in groups) else GROUP
    return [{head: name, **item} for name, objects in groups for item in objects]


def _has_address(item: dict[str, Any]) -> bool:
    addresses = {word for word in words("headings")["address"] if word not in _NO_ADDRESSES}
    return any(folded(str(key)) in addresses and not isinstance(value, list | dict) for key, value in item.items())


def _groups(name: str, value: Any, outer_facts: dict[str, Any]) -> Iterator[tuple[str, list[dict[str, Any]]]]:
    """The groups of objects in some data, each with the key that it stands under.

    `outer_facts` are the functions, spaces and orders at the level of the groups, or farther out.
    """
    if objects := _group(value):
        yield name, [{**outer_facts, **item} for item in objects]
    if isinstance(value, dict):
        roles = ("function", "space", "word_order")
        stated = {word for role in roles for word in words("headings")[role]} - {"object", "kind"}
        scalars = {key: inner for key, inner in value.items() if not isinstance(inner, list | dict)}
        orders = [f"{key}: {inner}" for key, inner in scalars.items() if _says_order(str(key), str(inner))]
        outer_facts = outer_facts | (
            {"note": orders[0]} if orders else {}
        )  # of bytes, or of words: the file does not say it
        outer_facts = {**outer_facts, **{key: inner for key, inner in scalars.items() if folded(str(key)) in stated}}
    pairs = (
        value.items()
        if isinstance(value, dict)
        else ((name, item) for item in value)
        if isinstance(value, list)
        else ()
    )
    for key, inner in pairs:
        if isinstance(inner, list | dict):
            yield from _groups(str(key), inner, outer_facts)


def _says_order(key: str, text: str) -> bool:
    """Whether a setting of a whole file says that values are not sent in the usual order of bytes."""
    is_order = folded(key) in words("headings")["byte_order"]
    return is_order and stated_order(text) not in ("", "ABCD")


def _group(value: Any) -> list[dict[str, Any]]:
    """The objects of a list, or of an object with their addresses or names as keys; empty if it has others."""
    inner = list(value.values()) if isinstance(value, dict) else value
    if not isinstance(inner, list) or not inner or not all(isinstance(item, dict) for item in inner):
        return []
    if not isinstance(value, dict):
        return inner
    key = "address" if all(address_text(str(text)) for text in value) else "name"
    return [{key: str(text), **item} for text, item in value.items()]


def _named_values(data: object) -> Iterator[tuple[str, dict[str, str]]]:
    """The values that objects define under a name, which other objects refer to."""
    inner = list(data.values()) if isinstance(data, dict) else data if isinstance(data, list) else []
    if isinstance(data, dict) and isinstance(name := data.get("name"), str):
        yield from ((name, pairs) for value in inner if (pairs := _pairs(value)))
    for value in inner:
        yield from _named_values(value)


def _pairs(value: object) -> dict[str, str]:
    """A list of objects that each have a number and a text alone, as texts by numbers; empty for anything else."""
    pairs: dict[str, str] = {}
    for item in value if isinstance(value, list) else ():
        facts = list(item.values()) if isinstance(item, dict) else []
        numbers = [number for fact in facts if (number := whole(str(fact))) is not None]
        texts = [fact for fact in facts if isinstance(fact, str) and whole(fact) is None]
        if len(facts) != 2 or len(numbers) != 1 or len(texts) != 1:
            return {}
        pairs[str(numbers[0])] = texts[0]
    return pairs


def _cell(value: object) -> str:
    if value is None:
        return ""
    value = _pairs(value) or value
    return clean(value if isinstance(value, str) else json.dumps(value, ensure_ascii=False))
