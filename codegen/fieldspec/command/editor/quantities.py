"""The quantity of a raw number in the unit of its fact."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.explain.values import in_unit
from fieldspec.command.editor.cursor import Cursor
from fieldspec.command.editor.edits import stated_fact
from fieldspec.command.editor.index import meant
from fieldspec.foundation.classes import replace
from fieldspec.language.model.value import Value
from fieldspec.language.reading.meanings import VALUED, VALUES, value_of
from fieldspec.language.reading.nodes import Mapping, Node, Scalar
from fieldspec.language.reading.yaml_reader import key_spans

_OF_FACTS = ("default", "const")
"""The keys of a fact, and of what is printed, restated or changed of it, that have a number of counts."""


def quantity(place: Cursor) -> str:
    """A number with its quantity, formatted like the ranges in `show`; empty for other values."""
    number = _count(place.scalar)
    for fact in _facts(place) if number is not None else ():
        value = getattr(stated_fact(place, fact), "value", None)
        text = in_unit(value, number) if isinstance(value, Value) and number is not None else ""
        if text:
            return f"{number} ({text})"
    return ""


def _count(scalar: Scalar | None) -> int | None:
    try:
        return int(scalar.text, 0) if scalar is not None else None
    except ValueError:
        return None


def _facts(place: Cursor) -> Iterator[Mapping]:
    """The facts that a value is given for."""
    names = [key for key in place.keys if isinstance(key, str)]
    number = max((number for number, node in enumerate(place.nodes) if isinstance(node, Mapping)), default=0)
    holder, key = place.nodes[number], place.keys[number]
    if not {*VALUES, "if"}.isdisjoint(names[:-1]):
        spans = (span for word, span in key_spans(holder) if word == key) if isinstance(holder, Mapping) else ()
        yield from _meant(place, *(Scalar(span.file, span.start, span.end, str(key), False) for span in spans))
    elif names[0] in ("tasks", "behaviour"):
        yield from _meant(place, *(value_of(holder, action) for action, valued in VALUED.items() if valued == key))
    elif not {*_OF_FACTS}.isdisjoint(names[-2:]):
        yield from _meant(place, value_of(place.nodes[2], "fact") if len(place.nodes) > 2 else None)
        yield from (node for node in reversed(place.nodes) if isinstance(node, Mapping))


def _meant(place: Cursor, *names: Node | None) -> Iterator[Mapping]:
    """The facts that names mean; of a path what its last step does."""
    for name in names:
        if isinstance(name, Scalar):
            at_end = replace(place, offset=name.end, nodes=(name,), key_scalar=None)
            yield from (fact.stated for fact in meant(at_end) if isinstance(fact.stated, Mapping))
