"""The printed number of words of a register or field is the width of its type. A field without a fixed size has none.

Why: the type determines how many words are read. If the manual prints a different number, a request reads too few
words, or words of the next register.

Example: a type `u32` with `words: 1`.

Fix: Correct the type, the length or the words, and write an erratum if the manual prints the words that way.
"""

from __future__ import annotations

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.facts import layers
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.sizes import RecordSizes


def words_match_type(device: Device) -> Findings:
    for register in device.registers():
        if register.unit_size == 2:
            yield from _compare_words(register, register.words, 2 * register.width, register.value.type.name)
    sizes = RecordSizes(device)
    for layer in layers(device):
        for field in layer.fields:
            bounds = sizes.field(field)
            if bounds is None or field.words is None:
                continue
            if bounds[0] != bounds[1]:
                text = f"{field.name} is printed with {plural(field.words, 'word')}, but its size is not fixed"
                yield finding(field.place, "words", text, "remove the words")
            else:
                type_name = field.value.type.name if field.value is not None else field.record
                yield from _compare_words(field, field.words, bounds[0], type_name)


def _compare_words(fact: Fact, words: int | None, size: int, type_name: str) -> Findings:
    if words is not None and 2 * words != size:
        yield finding(
            fact.place,
            "words",
            f"{fact.name} is printed with {plural(words, 'word')}; as {type_name} it has {plural(size, 'byte')}",
            "correct the type, the length or the words",
            label(fact.place, "length" if "length" in fact.place else "type", "its type"),
        )
