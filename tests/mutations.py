"""Changes of specs that a device on the wire would notice: each with the rule by which the diff must call it.

A mutation takes the tree of a version and gives another tree, or None where the tree has nothing to change.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence

from fieldspec.language.reading.nodes import Mapping, Node, Scalar, children
from fieldspec.language.reading.nodes import Sequence as Items

Way = tuple[str | int, ...]
Mutation = Callable[[Mapping, random.Random], Mapping | None]

SWAPPED = {"big": "little", "little": "big"}
NUMBERS = ("u8", "i8", "u16", "i16", "u32", "i32", "u64", "i64")
ALGORITHMS = ("crc16_modbus", "lrc", "sum8")
UNITS = ("mm", "pulse", "rpm", "%", "ms", "V")
VALUED = ("rows", "fields", "request", "response")


def scalar(value: int | str | bool, near: Node) -> Scalar:
    return Scalar(near.file, near.start, near.end, str(value), False, value)


def at(node: Node, way: Way) -> Node:
    """The node at the end of a path."""
    for step in way:
        node = node.values[str(step)] if isinstance(node, Mapping) else node.items[int(step)]  # type: ignore[union-attr]
    return node


def put(node: Node, way: Way, new: Node | None) -> Mapping:
    """The tree with something else at the end of a way; without it, where that is None."""
    changed = _put(node, way, new)
    assert isinstance(changed, Mapping)
    return changed


def _put(node: Node, way: Way, new: Node | None) -> Node:
    step, rest = way[0], way[1:]
    if isinstance(node, Mapping):
        assert isinstance(step, str)
        if not rest and new is None:
            return node.without(step)
        if not rest:
            assert new is not None
            return node.with_value(step, new)
        return node.with_value(step, _put(node.values[step], rest, new))
    assert isinstance(node, Items)
    items: list[Node] = list(node.items)
    number = int(step)
    if rest:
        items[number] = _put(items[number], rest, new)
    elif new is None:
        del items[number]
    else:
        items[number] = new
    return Items(node.file, node.start, node.end, tuple(items))


def mappings(node: Node, way: Way = ()) -> Iterator[tuple[Way, Mapping]]:
    """All mappings below a node, with their paths."""
    if isinstance(node, Mapping):
        yield way, node
    for step, inner in children(node):
        if not isinstance(inner, Scalar):
            yield from mappings(inner, (*way, step))


def of(
    tree: Mapping, *sections: str, keys: Sequence[str] = (), without: Sequence[str] = ()
) -> list[tuple[Way, Mapping]]:
    """The mappings of some sections, at any depth, that have all of `keys` and none of `without`."""
    return [
        (way, node)
        for way, node in mappings(tree)
        if way
        and way[0] in sections
        and all(key in node.values for key in keys)
        and not any(key in node.values for key in without)
        and "reserved" not in node.values
        and not {"examples", "defaults", "copies", "restated"} & set(way)
    ]


def values(tree: Mapping) -> list[tuple[Way, Mapping]]:
    """Registers, fields, parameters and parts with a type of their own."""
    sections = ("registers", "records", "messages", "parameters", "links")
    candidates = of(tree, *sections, keys=("type", "name"))
    return [(way, node) for way, node in candidates if way[-2] in VALUED and len(way) > 2]


def counts(tree: Mapping) -> list[tuple[Way, Mapping]]:
    """Those that hold whole numbers and refer to nothing else."""
    return [(way, node) for way, node in values(tree) if text(node, "type") in NUMBERS and "role" not in node.values]


def text(node: Mapping, key: str) -> str:
    scalar = node.values.get(key)
    return scalar.text if isinstance(scalar, Scalar) else ""


def number(node: Mapping, key: str) -> int:
    scalar = node.values.get(key)
    assert isinstance(scalar, Scalar)
    assert isinstance(scalar.value, int)
    return scalar.value


def picked(places: list[tuple[Way, Mapping]], chance: random.Random) -> tuple[Way, Mapping] | None:
    return chance.choice(places) if places else None


def setting(
    find: Callable[[Mapping], list[tuple[Way, Mapping]]],
    key: str,
    other: Callable[[Mapping, random.Random], int | str | bool],
) -> Mutation:
    """Sets a key of one of some mappings to another value."""

    def mutation(tree: Mapping, chance: random.Random) -> Mapping | None:
        place = picked(find(tree), chance)
        if place is None:
            return None
        way, node = place
        value = other(node, chance)
        if key in node.values and text(node, key) == str(value):
            return None
        return put(tree, (*way, key), scalar(value, node))

    return mutation


def removing(find: Callable[[Mapping], list[tuple[Way, Mapping]]]) -> Mutation:
    """Takes one of some mappings out of its list."""

    def mutation(tree: Mapping, chance: random.Random) -> Mapping | None:
        places = [(way, node) for way, node in find(tree) if len(at(tree, way[:-1]).items) > 1]  # type: ignore[union-attr]
        place = picked(places, chance)
        return None if place is None else put(tree, place[0], None)

    return mutation


def fields(tree: Mapping) -> list[tuple[Way, Mapping]]:
    """The fields of records and messages."""
    places = of(tree, "records", "messages", keys=("name",), without=("repeat", "choice", "measures", "record"))
    return [(way, node) for way, node in places if way[-2] in VALUED and "type" in node.values and len(way) < 6]


def fields_always_sent(tree: Mapping) -> list[tuple[Way, Mapping]]:
    """The fields that no other field leaves out, and that may have a count."""
    return [(way, node) for way, node in fields(tree) if "present_if" not in node.values]


def inserted(tree: Mapping, chance: random.Random) -> Mapping | None:
    """A field is inserted before another one."""
    one = picked(fields(tree), chance)
    if one is None:
        return None
    way, node = one
    new = Mapping(node.file, node.start, node.end, {})
    new = new.with_value("name", scalar("put_before", node)).with_value("type", scalar("u8", node))
    sequence = at(tree, way[:-1])
    assert isinstance(sequence, Items)
    place = int(way[-1])
    items = (*sequence.items[:place], new, *sequence.items[place:])
    return put(tree, way[:-1], Items(sequence.file, sequence.start, sequence.end, items))


def swapped(tree: Mapping, chance: random.Random) -> Mapping | None:
    """Two adjacent fields change places."""
    known = {way for way, _ in fields(tree)}
    pairs = [way for way in known if (*way[:-1], int(way[-1]) + 1) in known]
    if not pairs:
        return None
    way = chance.choice(sorted(pairs, key=str))
    sequence = at(tree, way[:-1])
    assert isinstance(sequence, Items)
    items = list(sequence.items)
    place = int(way[-1])
    items[place], items[place + 1] = items[place + 1], items[place]
    return put(tree, way[:-1], Items(sequence.file, sequence.start, sequence.end, tuple(items)))


def free(node: Mapping, key: str, tree_values: set[int], chance: random.Random) -> int:
    return chance.choice([value for value in range(1, 60000, 7) if value not in tree_values])


def members(tree: Mapping) -> list[tuple[Way, Mapping]]:
    places = of(tree, "enums", keys=("name", "value"), without=("unavailable",))
    derived = {way[:2] for way, node in of(tree, "enums", keys=("derived",))}
    return [(way, node) for way, node in places if way[-2] == "members" and way[:2] not in derived]


def renumbered(tree: Mapping, chance: random.Random) -> Mapping | None:
    place = picked(members(tree), chance)
    if place is None:
        return None
    way, node = place
    used = {number(node, "value") for _, node in members(tree)}
    return put(tree, (*way, "value"), scalar(max(used) + chance.randint(1, 9), node))


def bits(tree: Mapping) -> list[tuple[Way, Mapping]]:
    return [(way, node) for way, node in of(tree, "flags", keys=("bit", "name")) if way[-2] == "bits"]


def renamed(find: Callable[[Mapping], list[tuple[Way, Mapping]]]) -> Mutation:
    return setting(find, "name", lambda node, _: text(node, "name") + "_renamed")


def rows(tree: Mapping) -> list[tuple[Way, Mapping]]:
    return [(way, node) for way, node in of(tree, "registers", keys=("name", "at")) if way[-2] == "rows"]


def lone_rows(tree: Mapping) -> list[tuple[Way, Mapping]]:
    """Registers whose address no other register has."""
    candidates = rows(tree)
    used = [number(node, "at") for _, node in candidates]
    return [(way, node) for way, node in candidates if used.count(number(node, "at")) == 1]


def numbered(tree: Mapping) -> list[tuple[Way, Mapping]]:
    return [(way, node) for way, node in of(tree, "parameters", keys=("name", "number")) if way[-2] == "rows"]


def parts(role: str, *keys: str) -> Callable[[Mapping], list[tuple[Way, Mapping]]]:
    """The parts of frames with a role that have some keys."""
    return lambda tree: [
        (way, node) for way, node in of(tree, "links", keys=("role", *keys)) if text(node, "role") == role
    ]


def top(section: str, *keys: str) -> Callable[[Mapping], list[tuple[Way, Mapping]]]:
    """The entries of a section."""
    return lambda tree: [(way, node) for way, node in of(tree, section, keys=keys) if len(way) == 2]


def delimited(tree: Mapping) -> list[tuple[Way, Mapping]]:
    """The links with the same delimiters in both directions."""
    marks = (Scalar, type(None))
    return [
        (way, node)
        for way, node in top("links")(tree)
        if all(isinstance(node.values.get(key), marks) for key in ("start", "end"))
    ]


def inner(section: str, step: str, *keys: str) -> Callable[[Mapping], list[tuple[Way, Mapping]]]:
    """The mappings of a section that stand under a key, or in the list under it."""
    return lambda tree: [(way, node) for way, node in of(tree, section, keys=keys) if step in way[-2:]]


def other_word(words: Sequence[str], key: str) -> Callable[[Mapping, random.Random], str]:
    return lambda node, chance: chance.choice([word for word in words if word != text(node, key)])


def more(key: str, most: int = 9) -> Callable[[Mapping, random.Random], int]:
    return lambda node, chance: number(node, key) + chance.randint(1, most)


def measured(tree: Mapping, chance: random.Random) -> Mapping | None:
    """A field that counts items counts bytes, or the other way round."""
    counters = [(way, node) for way, node in mappings(tree) if way and way[-1] == "measures"]
    place = picked([(way, node) for way, node in counters if {"items", "bytes"} & node.values.keys()], chance)
    if place is None:
        return None
    way, node = place
    key, other = ("bytes", "items") if "bytes" in node.values else ("items", "bytes")
    return put(tree, way, node.without(key).with_value(other, node.values[key]))


def turned(key: str) -> Mutation:
    """All links that have an order have the other one: a device has one order on all of them."""

    def mutation(tree: Mapping, _: random.Random) -> Mapping | None:
        candidates = top("links", key)(tree)
        for way, node in candidates:
            tree = put(tree, (*way, key), scalar(SWAPPED[text(node, key)], node))
        return tree if candidates else None

    return mutation


MUTATIONS: tuple[tuple[str, Mutation], ...] = (
    ("register_moved", setting(rows, "at", more("at"))),
    ("type_changed", setting(counts, "type", other_word(NUMBERS, "type"))),
    ("scale_changed", setting(counts, "scale", lambda node, chance: chance.choice((2, 3, 7)))),
    ("scale_changed", setting(counts, "offset", lambda node, chance: chance.randint(1, 99))),
    ("unit_changed", setting(counts, "unit", other_word(UNITS, "unit"))),
    ("const_changed", setting(counts, "const", lambda node, chance: chance.randint(1, 99))),
    ("byte_order_changed", turned("byte_order")),
    ("byte_order_changed", turned("word_order")),
    ("check_changed", setting(parts("checksum", "algorithm"), "algorithm", other_word(ALGORITHMS, "algorithm"))),
    (
        "framing_changed",
        setting(top("links", "transmission"), "transmission", other_word(("binary", "hex_ascii"), "transmission")),
    ),
    ("framing_changed", setting(delimited, "start", lambda node, chance: f"{chance.randint(16, 99)}")),
    ("framing_changed", setting(delimited, "end", lambda node, chance: f"{chance.randint(16, 99)}")),
    (
        "exception_response_changed",
        setting(inner("links", "exception_response", "flag"), "flag", lambda node, chance: chance.choice((1, 2, 4))),
    ),
    (
        "broadcast_changed",
        setting(inner("links", "unit_addresses", "range"), "broadcast", lambda n, chance: chance.randint(100, 200)),
    ),
    ("role_changed", setting(parts("length"), "role", lambda *_: "plain")),
    ("role_changed", measured),
    ("code_changed", setting(top("messages", "code"), "code", more("code", 60))),
    ("code_changed", setting(top("messages", "number"), "number", more("number"))),
    ("fact_removed", removing(top("messages", "name"))),
    ("fact_removed", removing(rows)),
    ("fact_removed", removing(bits)),
    ("fact_removed", removing(fields)),
    ("fact_removed", removing(numbered)),
    ("fact_added", inserted),
    ("field_moved", swapped),
    ("member_renumbered", renumbered),
    ("member_removed", removing(members)),
    ("bit_moved", setting(bits, "bit", lambda node, chance: number(node, "bit") + chance.choice((1, 2, 3)))),
    ("polarity_changed", setting(bits, "active", lambda node, _: "high" if text(node, "active") == "low" else "low")),
    ("reserved_changed", setting(fields, "reserved", lambda *_: True)),
    ("number_changed", setting(numbered, "number", more("number", 900))),
    ("number_changed", setting(top("parameters", "name"), "base", lambda node, chance: chance.randint(9000, 9999))),
    ("table_moved", setting(top("tables", "base"), "base", more("base"))),
    ("stride_changed", setting(top("tables", "stride"), "stride", more("stride"))),
    ("index_changed", setting(top("tables", "base"), "index_from", lambda node, chance: chance.randint(5, 9))),
    ("count_changed", setting(top("tables", "count"), "count", lambda node, _: number(node, "count") - 1)),
    ("count_changed", setting(fields_always_sent, "count", lambda node, chance: chance.randint(20, 90))),
    (
        "sentinel_changed",
        setting(
            lambda tree: [
                place
                for place in mappings(tree)
                if place[0] and "sentinels" in place[0][-2:] and "value" in place[1].values
            ],
            "value",
            more("value"),
        ),
    ),
    ("conversion_changed", setting(top("conversions", "full_scale"), "full_scale", more("full_scale"))),
    (
        "case_changed",
        setting(
            lambda tree: [
                place for place in mappings(tree) if place[0] and "cases" in place[0][-2:] and "sizes" not in place[0]
            ],
            "when",
            lambda *_: "another",
        ),
    ),
    ("renamed", renamed(lone_rows)),
    ("renamed", renamed(members)),
    ("renamed", renamed(bits)),
    ("renamed", renamed(top("messages", "code"))),
)
"""The rule, and what it must notice."""
