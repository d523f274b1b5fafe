"""Types the scalars of a node tree by the schema, and validates the result against it.

Until here every scalar is text, so `on`, `010` and `12:30` are not surprises: a scalar becomes a number or a
truth value only where the schema wants one and the text is one.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from decimal import Decimal
from functools import lru_cache
from typing import Any

from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass, field
from fieldspec.foundation.source import Span
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.reading.findings import MOST_FINDINGS, former, near, quoted, synonym
from fieldspec.language.reading.help_on_algorithms import algorithm_help
from fieldspec.language.reading.help_on_forms import form_help
from fieldspec.language.reading.help_on_scalars import number_help
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, copied, json_data, node_at
from fieldspec.language.reading.yaml_reader import key_span
from fieldspec.language.schema import Schema, described, project_schema, resolved, schema

# Longer numbers are on no wire; a number that is not written like this is text, and then of the wrong type.
_INTEGER = re.compile(r"[-+]?(0x[0-9A-Fa-f]{1,16}|0|[1-9][0-9]{0,19})")
_NUMBER = re.compile(r"[-+]?(0|[1-9][0-9]{0,19})(\.[0-9]{1,20})?")
_SLIP = 0.85
"""How alike two keys are at least where one may be written for the other by mistake."""


@lru_cache(maxsize=64)
def _validator(path: tuple[str, ...]) -> Any:
    import jsonschema_rs

    whole = schema()
    return jsonschema_rs.Draft202012Validator({**part_at(path), "$defs": whole["$defs"]} if path else whole)


PROJECT_FILE = "the project file"
"""The key below which `part_at` has the schema of project files."""


def part_at(path: Iterable[str]) -> Schema:
    """The part of the schema at some keys, with all references followed."""
    part: Any = schema()
    for key in path:
        if key == PROJECT_FILE:
            part = project_schema()
            continue
        part = resolved(part)[key] if isinstance(part, dict) else part[int(key)]
    return resolved(part)


def typed_at(node: Node, path: tuple[str, ...]) -> tuple[Node, list[Diagnostic]]:
    """A copy of a node, typed by the part of the schema at some keys, and the violations of that part."""
    result = copied(node)
    return result, _objections(result, _typed_value(result, _form(part_at(path))), path)


def typed(node: Node) -> tuple[Node, list[Diagnostic]]:
    """The tree of one file, with its scalars typed in place, and its violations of the schema."""
    return node, _objections(node, _typed_value(node, _form(schema())), ())


def typed_item(item: Node, keys: Iterable[str | int]) -> bool:
    """Types an item of the list at some keys in place; whether it does not violate the schema."""
    list_keys = (*keys, 0)
    node = _alone(item, list_keys)
    data = _typed_value(node, _form(schema()))
    return all(len(error.instance_path) < len(list_keys) for error in _validator(()).iter_errors(data))


def _alone(node: Node, node_keys: Collection[str | int]) -> Node:
    """A tree in which a node is alone: the whole schema is at hand, its parts would have to be compiled."""
    for key in reversed([*node_keys]):
        place = (node.file, node.start, node.end)
        node = Sequence(*place, (node,)) if isinstance(key, int) else Mapping(*place, {key: node})
    return node


def violations_at(tree: Node, node_keys: list[str | int]) -> list[Diagnostic]:
    """The violations of the schema by the node at some keys of a tree."""
    node = _alone(node_at(tree, node_keys), node_keys)
    return _objections(node, json_data(node), (), len(node_keys))


def _objections(node: Node, data: object, path: tuple[str, ...], depth: int = 0) -> list[Diagnostic]:
    """The violations of the schema, or of its part at some keys, by a tree and its plain data, from a depth on."""
    findings: list[Diagnostic] = []
    for error in _validator(path).iter_errors(data):
        if len(error.instance_path) >= depth:
            findings += _findings(error, node, path)
        if len(findings) > MOST_FINDINGS:
            break
    return findings


@dataclass(slots=True, eq=False)
class _Form:
    """The types that a part of the schema requires of texts, items and values.

    `words`: every text remains text. Forms of items and keys are built when they are first needed.
    """

    part: Schema
    words: bool
    integer: bool
    number: bool
    boolean: bool
    null: bool
    items: _Form | None = None
    keys: dict[str, _Form] = field(default_factory=dict)

    def item(self) -> _Form:
        """The form of the items of a list."""
        if self.items is None:
            self.items = _form(self.part.get("items", _ANYTHING))
        return self.items

    def key(self, key: str) -> _Form:
        """The form of the value of a key."""
        form = self.keys.get(key)
        if form is None:
            known = self.part.get("properties", _ANYTHING)
            form = _form(known.get(key) or self.part.get("additionalProperties") or _ANYTHING)
            if key in known:  # the others may be any words of a file
                self.keys[key] = form
        return form


_ANYTHING: Schema = {}
_SCHEMA_FORMS: ByIdentity[Schema, _Form] = ByIdentity()


def _form(part: Schema) -> _Form:
    """The form of a part of the schema, built once."""
    return _SCHEMA_FORMS.get_or_compute(resolved(part), _new_form)


def _new_form(part: Schema) -> _Form:
    types = part.get("type")
    if types is None and "enum" in part:
        types = "string"
    kinds = {types} if isinstance(types, str) else set(types or _KINDS)
    return _Form(
        part,
        kinds.isdisjoint(("integer", "number", "boolean", "null")),
        not kinds.isdisjoint(("integer", "number")),
        "number" in kinds,
        "boolean" in kinds,
        "null" in kinds,
    )


def _typed_value(node: Node, form: _Form) -> object:
    """Types the scalars of a tree; gives it as plain data, with decimals as floats, for validation only."""
    if isinstance(node, Scalar):
        value = node.value = node.text if node.quoted or form.words else _value(node.text, form)
        return float(value) if isinstance(value, Decimal) else value
    if isinstance(node, Sequence):
        inner = form.item()
        return [_typed_value(item, inner) for item in node.items]
    data: dict[str, object] = {}
    keys = form.keys
    for key, child in node.values.items():
        expected = keys.get(key) or form.key(key)
        if isinstance(child, Scalar) and (expected.words or child.quoted):
            data[key] = child.value = child.text  # nine of ten scalars
        else:
            data[key] = _typed_value(child, expected)
    return data


def _value(text: str, form: _Form) -> ScalarValue:
    """The value of a text without quotes: a number, a truth value or null where the form has these, else the text."""
    if form.integer and _INTEGER.fullmatch(text):
        return int(text, 0)
    if form.number and _NUMBER.fullmatch(text):
        return Decimal(text)
    if form.boolean and text in ("true", "false"):
        return text == "true"
    if form.null and text in ("~", "null", ""):
        return None
    return text


def _findings(error: Any, root: Node, path: tuple[str, ...]) -> list[Diagnostic]:
    """A validation error of the library: one finding, or one for each unknown key."""
    node = _node_at(root, error.instance_path)
    part = _schema_part(error.schema_path, path)
    if error.schema_path[-1] == "additionalProperties" and isinstance(node, Mapping):
        unknown = error.kind.as_dict()["unexpected"]
        return [_unknown_key(node, key, part) for key in unknown[: MOST_FINDINGS + 1]]
    return [_finding(error, node, part)]


def _finding(error: Any, node: Node, part: Schema) -> Diagnostic:
    """A validation error of the library in our words, at its place."""
    last = error.instance_path[-1] if error.instance_path else "the file"
    subject = f"`{last}`" if isinstance(last, str) and error.instance_path else "this"
    facts = error.kind.as_dict()
    keyword = error.schema_path[-1]
    text = node.text if isinstance(node, Scalar) else None
    if keyword == "required":
        missing = facts["property"]
        purpose = described(part.get("properties", {}).get(missing, {}))
        help = f"add `{missing}`: {purpose[:1].lower()}{purpose[1:]}" if purpose else f"add `{missing}`"
        return Diagnostic("missing_key", f"the key `{missing}` is missing", _head(node), help=help)
    if keyword == "enum" and text is not None:
        options = [str(option) for option in part.get("enum", [])]
        hint = algorithm_help(text, options) if last == "algorithm" else ""
        hint = hint or near(text, options, described(part))
        return Diagnostic("unknown_word", f"{subject} cannot be {quoted(text)}", node.span, help=hint)
    description = part.get("description", "")
    if keyword == "type":
        types = part.get("type")
        names = [types] if isinstance(types, str) else list(types or [])
        kinds = " or ".join(_KINDS.get(name, name) for name in names)
        message = f"{subject} must be {kinds}, not {_kind_text(node)}"
        form = _FORMS.get(names[0], "") if isinstance(node, Scalar) else ""
        if isinstance(node, Scalar) and not {"integer", "number"}.isdisjoint(names):
            form = number_help(node.text, node.quoted, "integer" in names) or form
        return Diagnostic("wrong_type", message, _head(node), help=f"{form}; {description}" if form else description)
    if keyword in ("pattern", "maxLength"):
        if isinstance(node, Scalar):
            is_number = "number" in part.get("type", ())
            help = number_help(node.text, node.quoted, whole=False) if is_number else ""
            help = help or form_help(node.text, part.get("pattern", ""))
            description = f"{help}; {description}" if help else description
        return Diagnostic("wrong_form", f"{subject} cannot be {quoted(text or '')}", node.span, help=description)
    if keyword in ("minimum", "maximum"):
        limit = part.get(keyword)
        return Diagnostic("wrong_value", f"{subject} is {text}; the {keyword} is {limit}", node.span, help=description)
    if keyword in ("minItems", "minProperties", "maxProperties"):
        return Diagnostic("wrong_size", f"{subject} has too few or too many entries", _head(node), help=description)
    if keyword in ("oneOf", "anyOf"):
        return Diagnostic("wrong_form", f"{subject} has other keys than it can have", _head(node), help=_choices(part))
    if keyword == "uniqueItems" and isinstance(node, Sequence):
        texts = [item.text if isinstance(item, Scalar) else "" for item in node.items]
        number = next(number for number, own in enumerate(texts) if own in texts[:number])
        message = f"{subject} lists {quoted(texts[number])} twice"
        return Diagnostic("wrong_form", message, node.items[number].span, help="remove one of them")
    return Diagnostic("wrong_form", error.message, _head(node), help=description)


def _choices(part: Schema) -> str:
    """The help for a mapping that must have one of some keys."""
    options = part.get("oneOf") or part.get("anyOf") or []
    keys = [key for option in options for key in option.get("required", [])]
    stated = f" State one of {', '.join(f'`{key}`' for key in dict.fromkeys(keys))}." if keys else ""
    return f"{part.get('description', '')}{stated}".strip()


_KINDS = {
    "integer": "a whole number",
    "number": "a number",
    "boolean": "true or false",
    "string": "a text",
    "array": "a list",
    "object": "a mapping",
    "null": "empty",
}

_FORMS = {
    "integer": "write it as `10` or `0x0A`, without quotes",
    "number": "write it as `0.5`, without quotes",
    "boolean": "write `true` or `false`, without quotes",
}


def _kind_text(node: Node) -> str:
    """The kind of a node, for a finding that another kind is expected."""
    if isinstance(node, Scalar):
        return f'"{quoted(node.text)[1:-1]}"' if node.quoted else quoted(node.text) if node.text else "empty"
    return "a list" if isinstance(node, Sequence) else "a mapping"


def _unknown_key(node: Mapping, key: str, part: Schema) -> Diagnostic:
    known = part.get("properties", {})
    hint = (
        former(key, known)
        or _comma(node, key, known)
        or _known_key(key, known)
        or _misplaced(key, known)
        or near(key, list(known))
    )
    return Diagnostic("unknown_key", f"there is no key {quoted(key)} here", key_span(node, key), help=hint)


_BOUNDS = ("min", "minimum", "max", "maximum")
"""Words of other tools for one bound of a range."""


def _known_key(key: str, known: Schema) -> str:
    """The help for a word that other tools use, or for a key of the entries of a list here; empty for others."""
    if "unit_range" in known and key.lower() in _BOUNDS:
        return "write `unit_range: low..high` in the unit, or `range: low..high` in counts"
    if f"{key.lower()}s" in known:
        return f"did you mean `{key.lower()}s`?"
    if own := synonym(key, known):
        return f"the key for it is `{own}`"
    for name, part in known.items():
        keys = resolved(resolved(part).get("items", {})).get("properties", {})
        if "name" in keys and (own := key if key in keys else synonym(key, keys)):
            return f"the entries of `{name}` have the key `{own}`"
    return ""


def _misplaced(key: str, known: Schema) -> str:
    """The help for a key of other mappings, which is not a typing error; empty for others."""
    from difflib import get_close_matches

    if key not in _all_keys() or get_close_matches(key, known, 1, _SLIP):
        return ""
    names = [f"`{name}`" for name in sorted(known)]
    return f"`{key}` is a key of other mappings; here it can be {', '.join(names)}"


@lru_cache(maxsize=1)
def _all_keys() -> frozenset[str]:
    """All keys of the language, of any mapping."""
    keys: set[str] = set()
    parts: list[Any] = [schema()]
    while parts:
        part = parts.pop()
        if isinstance(part, dict):
            properties = part.get("properties", {})
            keys |= properties.keys()
            parts += part.values()
        elif isinstance(part, list):
            parts += part
    return frozenset(keys)


def _comma(node: Mapping, key: str, known: Schema) -> str:
    """The help for a key within braces that is the rest of a text with a comma; empty for other keys."""
    value = node.values[key]
    keys = list(node.values)
    before = keys[keys.index(key) - 1] if key != keys[0] else ""
    text = node.values.get(before)
    in_braces = node.file.text[node.start : node.start + 1] == "{"
    if not in_braces or not isinstance(value, Scalar) or value.text or value.quoted:
        return ""
    if not isinstance(text, Scalar) or text.quoted or not text.text:
        return ""
    if key.isdecimal() and text.text.isdecimal() and "number" in resolved(known.get(before, {})).get("type", ()):
        return f"numbers have a point: write `{before}: {text.text}.{key}`"
    return f'a comma within braces ends the text of `{before}`: quote it, as in `{before}: "{text.text}, {key}"`'


def _schema_part(path: list[str | int], root: tuple[str, ...]) -> Schema:
    """The part of the schema with the last keyword of a schema path, which starts at a root."""
    part: Any = schema() if "$defs" in path[:1] else part_at(root)
    for key in path[:-1]:
        part = resolved(part) if isinstance(part, dict) and key != "$ref" else part
        part = resolved(part) if key == "$ref" else part[key]
    return resolved(part) if isinstance(part, dict) else {}


def _node_at(root: Node, path: list[str | int]) -> Node:
    node = root
    for step in path:
        node = node.items[int(step)] if isinstance(node, Sequence) else node.values[str(step)]  # type: ignore[union-attr]
    return node


def _head(node: Node) -> Span:
    """The first line of a node: underlining a whole block does not help."""
    if isinstance(node, Scalar):
        return node.span
    end = node.file.text.find("\n", node.start)
    return Span(node.file, node.start, max(node.start + 1, min(node.end, end if end > 0 else node.end)))
