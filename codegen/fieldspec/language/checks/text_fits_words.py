"""The permitted characters of a text, and its default, fit its bytes. `characters` is less than the number that fits
into the `length`.

Why: a text that is longer than its registers overwrites the next ones or is cut off. No room for a terminator is
required, because manuals rarely mention terminators. If `characters` equals the length, it has no effect.

Example: 31 characters in a text of two bytes, or `length: 4` with `characters: 4`.

Fix: Correct the number of characters or the length, and write an erratum. Remove `characters` if it equals
the length.
"""

from __future__ import annotations

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.facts import values
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.diagnostics import Label
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_text
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.text_form import text_fault
from fieldspec.language.model.value import Value


def text_fits_words(device: Device) -> Findings:
    for fact, value in values(device):
        if value.characters is not None and not is_text(value.encoding):
            text = f"{fact.name} is {value.type.name}, which has no characters"
            yield finding(fact.place, "characters", text, "use the type `text`")
        elif value.characters is not None and value.characters > _most(value):
            text = f"{fact.name} can have {value.characters} characters, but has {plural(value.size, 'byte')}"
            help = "correct the characters or the size"
            yield finding(fact.place, "characters", text, help, _size(fact))
        elif value.characters == _most(value) and "characters" in fact.place and "length" in fact.place:
            text = f"{fact.name} has room for {plural(_most(value), 'character')}, so that `characters` has no effect"
            help = "remove it, or state the characters that the manual permits"
            yield finding(fact.place, "characters", text, help, _size(fact))
        if isinstance(value.default, str) and is_text(value.encoding) and value.text_form is None:
            length = len(value.default.encode())
            fault = text_fault(value, "big", value.default)
            if fault is not None and fault[0] == "unknown_value":
                text = f"the default of {fact.name} {fault[1]}"
                help = "correct the default, or state the `encoding` of the text"
                yield finding(fact.place, "default", text, help)
            elif length > value.size:
                text = f"the default of {fact.name} takes {length} bytes, but it has {value.size}"
                help = "correct the default or the size"
                yield finding(fact.place, "default", text, help, _size(fact))
        if isinstance(value.default, str) and value.characters is not None and len(value.default) > value.characters:
            text = f"the default of {fact.name} has {len(value.default)} characters, and may have {value.characters}"
            help = "correct the default or the characters"
            yield finding(fact.place, "default", text, help)


def _most(value: Value) -> int:
    """The greatest number of characters that a text may have."""
    form = value.text_form
    return value.size if form is None else form.room(value.size) // form.unit


def _size(fact: Fact) -> Label:
    return label(fact.place, "length", "its size")
