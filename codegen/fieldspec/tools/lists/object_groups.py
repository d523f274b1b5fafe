"""The registers among the objects of JSON and YAML: lists of objects, and objects by their addresses or names."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from fieldspec.foundation.spreadsheet import clean
from fieldspec.tools.lists.addresses import address_text
from fieldspec.tools.lists.cells import space, whole
from fieldspec.tools.lists.naming import snake
from fieldspec.tools.lists.orders import stated_order
from fieldspec.tools.lists.sheet import MOST_COLUMNS, MOST_ROWS, ListError, Sheet, SheetRow
from fieldspec.tools.lists.words import folded, meaning, whole_words, words

GROUP = "group"
"""The heading of the names of groups, which say nothing of what is in them."""

_NO_ADDRESSES = ("index", "offset", "dec", "decimal", "start", "registers")
"""Keys that only are addresses where no others are."""


_FEWEST_ROLES = 4
"""The roles of objects whose numbers may number anything."""


class _Group(NamedTuple):
    """A group of objects under a key, each with the facts outside it that hold for it; `value` is the group itself."""

    name: str
    objects: list[dict[str, Any]]
    value: Any


def objects_sheet(data: object, format_name: str, only_with_addresses: bool = False) -> Sheet:
    """The sheet of all objects with addresses in some data, else perhaps of those that are most alike.

    Raises ListError.
    """
    groups = list(_groups("", data, {})) if isinstance(data, list | dict) else []
    used = max(
        (
            [group for group in groups if any(map(has_address, group.objects))]
            for has_address in (_has_address, _has_compound_address)
        ),
        key=_role_count,
    )
    if not used:
        indexed = [group for group in groups if any(_has_address(item, ()) for item in group.objects)]
        used = indexed if _role_count(indexed) >= _FEWEST_ROLES or not only_with_addresses else []
        used = used or ([] if only_with_addresses else _alike(groups))
    objects = [_with_named_bits(part) for item in _joined(used) for part in _registers_of(item)]
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
    inner = {place for group in used for place in _places(group.value)}
    further = tuple(dict.fromkeys(_beside(groups, used, data, inner)))
    orders = tuple(_settings(data, inner, _is_of_order))
    return Sheet(tuple(row for row in rows if any(row.cells)), len(objects) + 1, beside=further, orders=orders)


def _beside(groups: list[_Group], used: list[_Group], data: object, inner: set[int]) -> Iterator[str]:
    """The contents of a file beside its list: other groups of objects, and settings about addresses."""
    definitions = {place for group in groups if _pairs(group.value) for place in _places(group.value)}
    lists = {id(group.value) for group in used}
    yield from (
        f"{group.name or 'a list'} without addresses: {len(group.objects)}"
        for group in groups
        if id(group.value) not in inner | definitions and lists.isdisjoint(_places(group.value))
    )
    yield from _settings(data, inner, lambda key: meaning("settings", key) != "")


def _places(value: object) -> Iterator[int]:
    """The identities of a value and of all lists and objects in it."""
    yield id(value)
    for inner in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        if isinstance(inner, list | dict):
            yield from _places(inner)


def _is_of_order(key: str) -> bool:
    """Whether a key is of the order of bytes or of words: `endianness`, `wordSwap`."""
    return folded(key).endswith(("endian", "endianness", "wordorder", "byteorder", "wordswap", "swapwords"))


def _settings(value: object, inner: set[int], is_meant: Callable[[str], bool]) -> Iterator[str]:
    """The settings of a whole file by their keys, which are not in an object of its list."""
    if id(value) in inner or not isinstance(value, list | dict):
        return
    for key, setting in value.items() if isinstance(value, dict) else enumerate(value):
        if not isinstance(setting, list | dict) and is_meant(str(key)):
            yield f"{key}: {setting}"
        yield from _settings(setting, inner, is_meant)


def _role_count(groups: list[_Group]) -> int:
    """How many roles the keys of some groups name."""
    keys = {folded(str(key)) for group in groups for item in group.objects for key in item}
    return len({whole_words()[key] for key in keys & whole_words().keys()})


def _alike(groups: list[_Group]) -> list[_Group]:
    """The groups that have half of the keys of the longest one."""
    longest = max((group.objects for group in groups), key=len, default=[])
    keys = {key for item in longest for key in item}
    return [group for group in groups if 2 * len(keys & {key for item in group.objects for key in item}) >= len(keys)]


def _joined(groups: list[_Group]) -> list[dict[str, Any]]:
    """The objects of some groups; if there are several groups, with the names of their groups.

    A name that several groups have follows that of its group: `battery voltage`.
    """
    if len({group.name for group in groups}) == 1:
        return [item for group in groups for item in group.objects]
    spaces = {group.name: space(group.name) for group in groups}
    if any(spaces.values()):  # beside `hold`, `read` is the other table of registers
        spaces |= {name: "input_registers" for name in spaces if folded(name) == "read"}
    if all(spaces.values()):
        return [{"space": spaces[group.name], **item} for group in groups for item in group.objects]
    pairs = {(group.name, str(item.get("name", ""))) for group in groups for item in group.objects}
    times = Counter(name for _, name in pairs)
    return [
        {GROUP: group.name, **item}
        | ({"name": f"{group.name} {name}"} if times[name := str(item.get("name", ""))] > 1 and name else {})
        for group in groups
        for item in group.objects
    ]


def _has_address(item: dict[str, Any], unless: tuple[str, ...] = _NO_ADDRESSES) -> bool:
    addresses = {word for word in words("headings")["address"] if word not in unless}
    return any(folded(str(key)) in addresses and _is_address(value) for key, value in item.items())


def _is_address(value: object) -> bool:
    """Whether a value may be an address, or several, as in `[20, 21]`."""
    inner = value if isinstance(value, list) else [value]
    return bool(inner) and not any(isinstance(part, list | dict) for part in inner)


def _has_compound_address(item: dict[str, Any]) -> bool:
    """Whether the last word of a key of an object is one for addresses, as in `busAddress`."""
    last_words = ((snake(str(key)).rpartition("_"), value) for key, value in item.items())
    return any(
        first
        and first not in words("stations")["address"]
        and _has_address({last: value})
        and address_text(str(value)) is not None
        for (first, _, last), value in last_words
    )


def _has_inner_address(value: Any) -> bool:
    """Whether an object, or one in it, has an address."""
    inner = value.values() if isinstance(value, dict) else ()
    return isinstance(value, dict) and (_has_address(value) or any(map(_has_inner_address, inner)))


def _registers_of(item: dict[str, Any]) -> list[dict[str, Any]]:
    """An object, and one for each further register that a key names: thermostats have several.

    The target of a measured value has its facts; each of the others is a number of its own. They are writable.
    """
    further = {key: meaning("further_registers", key) for key in item if meaning("further_registers", key)}
    parts = {key: inner if isinstance(inner := item[key], dict) else {"address": inner} for key in further}
    parts = {key: part for key, part in parts.items() if whole(str(part.get("address"))) is not None}
    main_register = {key: value for key, value in item.items() if key not in parts}
    shared = {
        key: value for key, value in main_register.items() if meaning("headings", key) not in ("address", "space")
    }
    result = [main_register]
    for key, part in parts.items():
        facts = shared if further[key] == "target" else {}
        states = part.get("values")
        if isinstance(states, dict) and all(whole(str(n)) is not None for n in states.values()):
            part = {**part, "values": {str(number): name for name, number in states.items()}}
        name = f"{item.get('name', '')} {key.replace('_', ' ').removesuffix(' register')}".strip()
        result.append({**facts, "name": name, "access": "rw", **part})
    return result


def _with_named_bits(item: dict[str, Any]) -> dict[str, Any]:
    """An object whose lists of bits are texts of their names: `0..7 data; 16 error`. Other facts of bits stay apart."""
    result: dict[str, Any] = {}
    for key, value in item.items():
        if isinstance(value, list) and meaning("headings", key) in ("bits", "values") and _are_texts(value):
            result[key] = "; ".join(f"{number} {text}" for number, text in enumerate(value) if text)
            continue
        parts = [_bit_parts(bit) for bit in value] if isinstance(value, list) else []
        names = [
            f"{part['low']}{'..' + part['high'] if 'high' in part else ''} {part['name']}" for part in parts if part
        ]
        if not parts or len(names) < len(parts):
            result[key] = value
            continue
        result[key] = "; ".join(names)
        facts = {inner: [bit.get(inner) for bit in value] for bit in value for inner in bit}
        result |= {f"{key} {inner}": texts for inner, texts in facts.items() if not meaning("bit_parts", inner)}
    return result


def _are_texts(values: list[Any]) -> bool:
    """Whether values are names by their numbers, from 0: texts without numbers, or None for a number without one."""
    return any(values) and all(
        value is None or (isinstance(value, str) and not value[:1].isdigit()) for value in values
    )


def _bit_parts(bit: object) -> dict[str, str]:
    """The number of a bit, or of the first and the last one, and its name; empty for anything else."""
    if not isinstance(bit, dict):
        return {}
    place = next((inner for inner in bit.values() if isinstance(inner, dict)), {})
    facts = {meaning("bit_parts", str(key)): value for key, value in {**bit, **place}.items()}
    low, width = whole(str(facts.get("low"))), whole(str(facts.get("width", 1)))
    name = facts.get("name")
    if low is None or width is None or width < 1 or not isinstance(name, str) or not name:
        return {}
    return {"low": str(low), "name": name.replace(";", ",")} | ({"high": str(low + width - 1)} if width > 1 else {})


def _groups(name: str, value: Any, outer_facts: dict[str, Any]) -> Iterator[_Group]:
    """The groups of objects in some data, each with the key that it stands under.

    `outer_facts` are the functions, spaces and orders at the level of the groups, or farther out.
    """
    if objects := _group(value):
        yield _Group(name, [{**outer_facts, **item} for item in objects], value)
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
            is_within = space(name) and folded(str(key)) in words("headings")["words"]  # `coils: {registers: [...]}`
            yield from _groups(name if is_within else str(key), inner, outer_facts)


def _says_order(key: str, text: str) -> bool:
    """Whether a setting of a whole file says that values are not sent in the usual order of bytes."""
    is_order = folded(key) in words("headings")["byte_order"]
    return is_order and stated_order(text) not in ("", "ABCD")


def _group(value: Any) -> list[dict[str, Any]]:
    """The objects of a list, or of an object with their addresses or names as keys; empty if it has others."""
    inner = list(value.values()) if isinstance(value, dict) else value
    if not isinstance(inner, list) or not inner or not all(isinstance(item, dict) for item in inner):
        return []
    inner = [_flat(item) for item in inner]
    if not isinstance(value, dict):
        return inner
    is_name = len(value) == 1 and str(next(iter(value)))[:1].isalpha()
    numbered = sum(address_text(str(text)) is not None for text in value) * 2 > len(value)
    key = "address" if not is_name and numbered and not any(map(_has_inner_address, inner)) else "name"
    return [{key: str(text), **item} for text, item in zip(value, inner, strict=True)]


def _flat(item: dict[str, Any]) -> dict[str, Any]:
    """An object with the facts of the objects in it, which group them: `properties: {valueType: Bool}`."""
    result: dict[str, Any] = {}
    if all(isinstance(value, dict) for value in item.values()):
        return item
    for key, value in item.items():
        facts = _flat(value) if isinstance(value, dict) else {}
        are_facts = any(folded(str(fact)) in whole_words() for fact in facts) and meaning("headings", key) != "values"
        is_apart = facts.keys().isdisjoint(item) and facts.keys().isdisjoint(result)
        result |= facts if are_facts and is_apart else {key: value}
    return result


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
