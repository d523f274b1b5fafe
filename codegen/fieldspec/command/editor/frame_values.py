"""The owners of the values of an example, a step or a behaviour, and the meanings of a value."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.command.editor.typed_word import TypedWord
from fieldspec.language.reading.meanings import VALUED, VALUES, Meanings, value_of
from fieldspec.language.reading.nodes import Mapping, Scalar, Sequence, identity


def fields(word: TypedWord) -> Iterator[Mapping]:
    """The fields of what the word is in: of the message and the link of an example or a step, or of a record there."""
    nodes, keys = word.place.nodes, word.place.keys
    number = next((number for number, key in enumerate(keys) if key in VALUES), None)
    if number is None:
        return
    inner = [key for key in keys[number + 1 :] if isinstance(key, str)]
    if not word.is_key:
        inner = inner[:-1]
    for device_meanings in _meanings(word):
        items = [*device_meanings.fields(nodes[number], nodes[number - 1])]
        for key in inner:
            items = [part for item in items if identity(item) == key for part in device_meanings.parts(item)]
        yield from items


def meanings(word: TypedWord, key: str) -> Iterator[tuple[Mapping, str]]:
    """The members, states, bits and special values of what a value is given for."""
    nodes, keys = word.place.nodes, word.place.keys
    holder = nodes[-3] if isinstance(nodes[-2], Sequence) else nodes[-2]
    for device_meanings in _meanings(word):
        facts: list[Mapping] = []
        if "values" in keys:
            facts = [field for field in fields(word) if identity(field) == key]
        elif "if" in keys:
            facts = device_meanings.facts(key)
        elif keys[0] in ("tasks", "behaviour"):
            targets = (value_of(holder, action) for action, valued in VALUED.items() if valued == key)
            facts = [
                fact for target in targets if isinstance(target, Scalar) for fact in device_meanings.facts(target.text)
            ]
        for fact in facts:
            yield from device_meanings.values(fact)


def states(word: TypedWord, key: str) -> Iterator[str]:
    """The states of the machine that a value is for."""
    if key == "state":
        machine = value_of(word.place.nodes[-2], "enter")
        name = machine.text if isinstance(machine, Scalar) else ""
    else:
        name = key.removeprefix("state/") if key.startswith("state/") else ""
    for device_meanings in _meanings(word) if name else ():
        yield from (state.text for state in device_meanings.states(name))


def _meanings(word: TypedWord) -> Iterator[Meanings]:
    """What names mean at the newest version of each device."""
    for spec in word.place.specs:
        yield Meanings(spec.tree_at(spec.versions()[-1]))
