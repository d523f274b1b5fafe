"""The entries that a device with a protocol has to state: its citations, and its address spaces."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from functools import lru_cache
from pathlib import Path

from fieldspec.command.console.usage import UsageError
from fieldspec.command.files import regular_file
from fieldspec.language.model.address_space import BIT, WORD
from fieldspec.language.reading.findings import LARGEST_FILE, PROTOCOLS
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, identity, mappings
from fieldspec.language.reading.project import read
from fieldspec.language.reading.scalars import typed
from fieldspec.language.reading.yaml_reader import decoded, parsed

# The sections of a protocol whose entries a device must cite, and the keys that an entry needs there.
_CITED: dict[str, tuple[str, ...]] = {
    "links": (),
    "messages": (),
    "enums": (),
    "flags": ("type", "bits"),
    "records": ("fields",),
    "parameters": ("rows",),
}


def entries(path: Path) -> Iterator[str]:
    """A line for each entry of a protocol that a device must cite. Raises UsageError."""
    tree = _tree(path)
    for section in _CITED:
        yield from _section(section, list(mappings(tree.values.get(section))), "")
    yield from _spaces(_accesses(mappings(tree.values.get("messages"))), "")


def uses(path: Path, spaces: Collection[str]) -> dict[str, list[str]]:
    """The sections of a device that uses a protocol for some address spaces: what it takes, and what it states of that.

    The first space is that of the messages that name none. Raises UsageError.
    """
    tree = _tree(path)
    links, messages = (list(mappings(tree.values.get(section))) for section in ("links", "messages"))
    used_messages = [message for message in messages if {space for space, _ in _accesses([message])} & {*spaces}]
    names = {text for item in (*links, *used_messages) for text in _texts(item)}
    records = [item for item in mappings(tree.values.get("records")) if identity(item) in names]
    names |= {text for item in records for text in _texts(item)}
    enums = [item for item in mappings(tree.values.get("enums")) if identity(item) in names]
    message_names = ", ".join(identity(message) or "" for message in used_messages)
    sections = {"uses": [f"  - {{protocol: {path.stem}, messages: [{message_names}]}}"]}
    for section, items in (("links", links), ("messages", used_messages), ("enums", enums), ("records", records)):
        sections[section] = list(_section(section, items, ", unverified: true"))[1:]
    accessed = [(space, unit) for space, unit in _accesses(messages) if space in ("", *spaces)]
    sections["spaces"] = list(_spaces(accessed, ", unverified: true"))[1:]
    return sections


def object_uses(path: Path) -> tuple[dict[str, list[str]], dict[tuple[int, int | None], str]]:
    """The sections of a device that uses a protocol for its objects, and the names of those that every device has.

    Names are by number, and of elements by number and subindex. Raises UsageError.
    """
    tree = _tree(path)
    sections = {"uses": [f"  - {{protocol: {path.stem}}}"]}
    for section in ("links", "messages", "enums", "flags", "records"):
        items = list(mappings(tree.values.get(section)))
        sections[section] = list(_section(section, items, ", unverified: true"))[1:]
    names: dict[tuple[int, int | None], str] = {}
    for row in (row for own in mappings(tree.values.get("parameters")) for row in mappings(own.values.get("rows"))):
        number = int(_key_text(row, "number"), 0)
        names[number, None] = identity(row) or ""
        for part in mappings(row.values.get("subindices")):
            names[number, int(_key_text(part, "index").partition("..")[0], 0)] = identity(part) or ""
    return sections, names


def reads_objects(path: Path) -> bool:
    """Whether a protocol has a message that reads elements of numbered objects. Raises UsageError."""
    parts = (
        field
        for message in mappings(_tree(path).values.get("messages"))
        for field in mappings(message.values.get("request"))
    )
    accesses = (part.values.get("parameter") for part in parts)
    return any(isinstance(access, Mapping) and _key_text(access, "part") == "subindex" for access in accesses)


def reads_words(path: Path) -> bool:
    """Whether a protocol has a message that reads words at addresses. Raises UsageError."""
    return first_words(path) is not None


def first_words(path: Path) -> tuple[str, str] | None:
    """The first address space of words that is read, empty for that of messages that name none, and the access to it.

    None without one. Raises UsageError.
    """
    messages = list(mappings(_tree(path).values.get("messages")))
    read_spaces, writable_spaces = (_word_spaces(messages, operation) for operation in ("read", "write"))
    return (read_spaces[0], "rw" if read_spaces[0] in writable_spaces else "ro") if read_spaces else None


def _word_spaces(messages: Iterable[Mapping], operation: str) -> list[str]:
    """The address spaces whose words messages read or write."""
    return [
        _key_text(access, "space")
        for message in messages
        for access in mappings(message.values.get("accesses"))
        if _key_text(access, "operation") == operation and _unit(message, access) == WORD
    ]


def _tree(path: Path) -> Mapping:
    with regular_file.reading(path):
        content = regular_file.content(path, LARGEST_FILE)
    tree = _protocol(path.name, content)
    if tree is None:
        raise UsageError(f"the protocol {path.stem} has findings; see them with: fieldspec check")
    return tree


@lru_cache(maxsize=16)
def _protocol(name: str, content: bytes) -> Mapping | None:
    """The tree of a protocol, which an import asks several times. None for one that has findings."""
    node, _ = parsed(decoded(name, content)[0])
    tree = typed(node)[0] if node is not None else None
    return tree if isinstance(tree, Mapping) and not read({f"{PROTOCOLS}/{name}": content}).findings else None


def _texts(node: Node) -> Iterator[str]:
    """All texts in a node."""
    if isinstance(node, Scalar):
        yield node.text
    elif isinstance(node, Sequence):
        for item in node.items:
            yield from _texts(item)
    else:
        for value in node.values.values():
            yield from _texts(value)


def _section(section: str, items: list[Mapping], mark: str) -> Iterator[str]:
    required_keys = _CITED[section]
    if items:
        yield f"{section}:"
    for item in items:
        keys_text = "".join(f", {key}: {_needed(item, key)}" for key in required_keys if key in item.values)
        # In the order of the bytes: another one would swap the words of values that have no words in the protocol.
        order = f", word_order: {_key_text(item, 'byte_order') or 'big'}" if section == "links" else ""
        yield f"  - {{name: {identity(item)}, source: 1 L1{order}{keys_text}{mark}}}"


def _accesses(messages: Iterable[Mapping]) -> Iterator[tuple[str, str]]:
    """The address space that each message accesses, empty for the first one, and the unit of what it carries."""
    for message in messages:
        for access in mappings(message.values.get("accesses")):
            yield _key_text(access, "space"), _unit(message, access)


def _needed(item: Mapping, key: str) -> str:
    """The required content of an entry under a key of its protocol: only its first element, or the same."""
    inner = next(mappings(item.values.get(key)), None)
    if inner is None:
        return _key_text(item, key)
    number = f", number: {_key_text(inner, 'number')}" if "number" in inner.values else ""
    return f"[{{name: {identity(inner)}{number}}}]"


def _spaces(accesses: Iterable[tuple[str, str]], mark: str) -> Iterator[str]:
    """A line for each address space that messages access, the first one at the top; none where they name none."""
    units: dict[str, str] = {}
    for name, unit in accesses:
        units = {name: unit, **units} if not name else {**units, name: unit}
    if any(units):
        yield "spaces:"
        for name, unit in units.items():
            unit_key = ", unit: bit" if unit == BIT else ""
            yield f"  - {{name: {name or 'registers'}, first_number: 0{unit_key}, source: 1 L1{mark}}}"


def _unit(message: Mapping, access: Mapping) -> str:
    """The unit of what a message carries: bits are packed into bytes, or one of them is a number with a meaning."""
    fields = message.values.get("response" if _key_text(access, "operation") == "read" else "request")
    names = (field for field in mappings(fields) if _key_text(field, "name") == _key_text(access, "values"))
    values = next(names, None)
    packed = values is not None and "repeat" in values.values and _key_text(values, "type") == "u8"
    return BIT if packed or "set" in access.values else WORD


def _key_text(mapping: Mapping, key: str) -> str:
    scalar = mapping.values.get(key)
    return scalar.text if isinstance(scalar, Scalar) else ""
