"""The manual of the language: its general texts, with tables of keys made from the schema."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from importlib import resources

from fieldspec.language.schema import Schema, built_in_units, described, referred, resolved, schema
from fieldspec.language.schema.crc_catalogue import CRC_CATALOGUE, OTHER_NAMES

ROOT = "file"
"""The name under which the template asks for the sections of a file."""

PAGES = {
    "language": "core.md",
    "language-structure": "structure.md",
    "language-evidence": "evidence.md",
    "language-operation": "operation.md",
    "language-proof": "proof.md",
    "language-limits": "limits.md",
}
"""The pages of the manual, each with its template."""

_MARK = re.compile(r"^<!-- keys: ([a-z_. ]+) -->$", re.MULTILINE)
_CORE = re.compile(r"^<!-- core: ([a-z_.]+) ([a-z_0-9 ]+) -->$", re.MULTILINE)
_INCLUDED = re.compile(r"^<!-- include: ([a-z_]+\.md) -->$", re.MULTILINE)
_HEADING = re.compile(r"^#+ (.+)$", re.MULTILINE)
_ANCHOR = re.compile(r"\]\(#([^)]*)\)")
_SENTENCE = re.compile(r".*?\.(?= [A-Z`]|$)")
_LINK = re.compile(r"\[([^\]]*)\]\(#[^)]*\)")
_UNITS = "<!-- units -->"
_CHECKSUM = "crc16_modbus"
"""A name that only the list of checksums contains."""
_SHARED = {"fact": "the keys of every [fact](#fact)", "value": "the keys of a [value](#value)"}
_KINDS = {
    "string": ("text", "texts"),
    "integer": ("whole number", "whole numbers"),
    "number": ("number", "numbers"),
    "boolean": ("`true` or `false`", "truth values"),
    "null": ("`~`", "empty values"),
    "array": ("list of texts", "lists"),
    "object": ("mapping", "mappings"),
}


@cache
def pages() -> dict[str, str]:
    """The pages of the manual as Markdown, by name. Links lead to the page that has the heading."""
    texts = {name: _filled(template) for name, template in PAGES.items()}
    homes = {anchor(heading): name for name, text in texts.items() for heading in _HEADING.findall(text)}
    return {name: _with_addresses(text, name, homes) for name, text in texts.items()}


def _with_addresses(text: str, page: str, homes: dict[str, str]) -> str:
    """A page whose links to headings of other pages name these."""
    files = {heading: "" if home == page else f"{home}.md" for heading, home in homes.items()}
    return _ANCHOR.sub(lambda link: f"]({files[link[1]]}#{link[1]})", text)


def _filled(template: str) -> str:
    """A page without addresses of other pages. The template names the part of the schema for each table of keys."""
    text = _INCLUDED.sub(lambda mark: _resource_text(mark[1]).rstrip("\n"), _resource_text(template))
    text = text.replace(_UNITS, "\n".join(_units()))
    text = _CORE.sub(lambda mark: "\n".join(_core_keys(mark[1], mark[2].split())), text)
    return _MARK.sub(lambda mark: "\n\n".join("\n".join(_section(name)) for name in mark[1].split()), text)


def _core_keys(name: str, keys: list[str]) -> Iterator[str]:
    """The first sentences of what some keys of a part are, with a link to its section."""
    yield f"| [{name}](#{anchor(name)})  | meaning |"
    yield "|---|---|"
    for key in keys:
        sentence = _SENTENCE.match(described(parts()[name]["properties"][key]))
        yield f"| `{key}` | {_cell(sentence[0]) if sentence else ''} |"


def _units() -> Iterator[str]:
    """The table of the units that every spec may use."""
    yield "| symbol | also entered as | unit | quantity | coherent SI units | UCUM |"
    yield "|---|---|---|---|---|---|"
    for unit in built_in_units():
        also = ", ".join(f"`{symbol}`" for symbol in unit.get("also", ()))
        factor = unit.get("factor", "") + (f" + {unit['offset']}" if "offset" in unit else "")
        ucum = f"`{unit['ucum']}`" if "ucum" in unit else ""
        quantity = unit["quantity"].replace("_", " ")
        yield f"| `{unit['symbol']}` | {also} | {unit['title']} | {quantity} | {factor} | {ucum} |"


def _resource_text(name: str) -> str:
    return resources.files(__name__.rpartition(".")[0]).joinpath(name).read_text("utf-8")


@cache
def parts() -> dict[str, Schema]:
    """Every part of the schema that has a section, by its name: `register`, `link.serial`, `unit`."""
    schemas: dict[str, Schema] = {ROOT: schema()}
    for name, part in schema()["properties"].items():
        schemas |= dict(_inner(name, part))
    for name, part in schema()["$defs"].items():
        schemas |= {name: part, **dict(_mappings(name, part))}
    return schemas


def _mappings(path: str, part: Schema) -> Iterator[tuple[str, Schema]]:
    """The mappings below a part that have no definition of their own, by path."""
    for key, inner in part.get("properties", {}).items():
        yield from _inner(f"{path}.{key}", inner)


def _inner(path: str, part: Schema) -> Iterator[tuple[str, Schema]]:
    part = part.get("items", part)
    if "properties" in part:
        yield path, part
        yield from _mappings(path, part)


def _section(name: str) -> Iterator[str]:
    """The heading, the description and the keys, or the words, of a part of the schema."""
    part = parts()[name]
    yield f"### {name}"
    yield ""
    sentence = _SENTENCE.match(described(part))
    yield sentence[0] if sentence and "." in name else described(part)  # the row of its key has the other sentences
    yield from _words(part)
    own = {key: inner for key, inner in part.get("properties", {}).items() if not _shared_by(inner)}
    required = part.get("required", [])
    if own:
        yield ""
        yield "| key | form | needed | meaning |"
        yield "|---|---|---|---|"
        for key, inner in own.items():
            form = form_of(key if name == ROOT else f"{name}.{key}", inner)
            yield f"| `{key}` | {form} | {'yes' * (key in required)} | {_cell(described(inner))} |"
    yield from _also(name, part, required)


def key_text(part: Schema, key: str) -> str:
    """A key of a part of the schema as its table has it: form, need and description, and the words that it takes."""
    inner = part["properties"][key]
    while "/properties/" in inner.get("$ref", ""):  # the key of all facts, or values, has the row
        inner = referred(inner["$ref"])
    need = ", needed" if key in part.get("required", []) else ""
    words = _words(resolved(inner))
    text = "\n".join([f"`{key}`: {form_of(key, inner)}{need}", "", described(inner), *words])
    return _LINK.sub(r"\1", text)


def _shared_by(part: Schema) -> str:
    """The group of shared keys that a key comes from, or nothing."""
    group = part.get("$ref", "").removeprefix("#/$defs/").partition("/properties/")[0]
    return group if group in _SHARED else ""


def _also(name: str, part: Schema, required: list[str]) -> Iterator[str]:
    """A sentence for each group of shared keys that a part takes."""
    for group, words in _SHARED.items():
        all_keys = list(schema()["$defs"][group]["properties"])
        shared_keys = [key for key, inner in part.get("properties", {}).items() if _shared_by(inner) == group]
        if not shared_keys:
            continue
        left_out = [key for key in all_keys if key not in shared_keys]
        few = len(shared_keys) < len(left_out)
        text = f"`{name}` also has {words}"
        if few:
            text = f"`{name}` also has {_enumeration(shared_keys)}, as every [{group}](#{group}) does"
        elif left_out:
            text += f" except {_enumeration(left_out)}"
        must = [key for key in shared_keys if key in required]
        yield ""
        yield text + (f"; {_enumeration(must)} is required." if must else ".")


def _words(part: Schema) -> Iterator[str]:
    """The words that a scalar may be; nothing where any text may be."""
    if "enum" in part:
        yield ""
        if "enumDescriptions" in part:
            yield "| word | meaning |"
            yield "|---|---|"
            yield from (
                f"| `{word}` | {_cell(text)} |"
                for word, text in zip(part["enum"], part["enumDescriptions"], strict=True)
            )
            return
        if _CHECKSUM in part["enum"]:
            yield from _algorithms(part["enum"])
            return
        yield "Permitted values: " + ", ".join(f"`{word}`" for word in part["enum"]) + "."


def _algorithms(words: list[str]) -> Iterator[str]:
    """The names of checksums in a row for each width, with the names of one algorithm together."""
    widths = {name: int(width) for name, width, *_ in map(str.split, CRC_CATALOGUE.splitlines())}
    first_names = dict(line.split() for line in OTHER_NAMES.splitlines())
    names: dict[int, dict[str, list[str]]] = {}
    for word in words:
        first_name = first_names.get(word, word)
        width = widths.get(first_name) or int(re.sub(r"\D", "", first_name) or 8)  # `lrc` has eight bits
        names.setdefault(width, {}).setdefault(first_name, []).append(f"`{word}`")
    yield "| bits | permitted values; `=` joins the names of one algorithm |"
    yield "|---|---|"
    for width, algorithms in sorted(names.items()):
        yield f"| {width} | {', '.join(' = '.join(synonyms) for synonyms in algorithms.values())} |"


def form_of(path: str, part: Schema) -> str:
    """The form of a key's value in a few words, with a link to its section."""
    if "$ref" in part:
        name = part["$ref"].removeprefix("#/$defs/")
        return _link(name) if "/" not in name else form_of(name.replace("/properties/", "."), resolved(part))
    if "then" in part:
        other = {key: inner for key, inner in part.items() if key != "then"} | {"type": part["type"][1]}
        return f"{form_of(path, part['then'])} or {form_of(path, other)}"
    if "properties" in part:
        return f"[mapping](#{anchor(path)})"
    if "enum" in part:
        return ", ".join(f"`{word}`" for word in part["enum"])
    if "items" in part and part["type"] == "array":
        return f"list of {_plural_form(path, part['items'])}"
    if part.get("type") == "object":
        return f"mapping of {_plural_form(path, part['additionalProperties'])}"
    kinds = [part["type"]] if isinstance(part["type"], str) else part["type"]
    return " or ".join(_KINDS[kind][0] for kind in kinds) + _bounds(part)


def _plural_form(path: str, part: Schema) -> str:
    """The items of a list, or the values of a mapping."""
    if "$ref" in part or "properties" in part or "enum" in part:
        return form_of(path, part).replace("[mapping]", "[mappings]")
    kinds = [part["type"]] if isinstance(part["type"], str) else part["type"]
    return " or ".join(_KINDS[kind][1] for kind in kinds if kind != "integer" or "number" not in kinds)


def _bounds(part: Schema) -> str:
    low, high = part.get("minimum"), part.get("maximum")
    if low is None:
        return ""
    return f", {low} to {high}" if high is not None else f", {low} or more"


def _link(name: str) -> str:
    return f"[{name}](#{anchor(name)})"


def anchor(heading: str) -> str:
    """The anchor that Markdown viewers give a heading: `link.serial` is `linkserial`."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


def _enumeration(words: list[str]) -> str:
    quoted = [f"`{word}`" for word in words]
    return quoted[0] if len(quoted) == 1 else ", ".join(quoted[:-1]) + " and " + quoted[-1]
