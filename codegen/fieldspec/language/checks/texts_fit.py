"""A text has room for its characters and its terminator, and only texts have keys for texts. Only a left-aligned text
has a terminator, UTF-16 and a text with `byte_order: little` have an even number of bytes, packed ASCII has three bytes
for four characters and no zeros, and a default is a text that can be sent. Only fields and registers that are not
reserved have a special text form.

Why: a text that is written in a different form than it is read loses or changes characters unnoticed.

Example: `{name: title, type: text, length: 7, encoding: utf_16}`, as the last character has one byte.

Fix: Correct the length, or remove the key.
"""

from __future__ import annotations

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.finding import Findings, finding
from fieldspec.language.checks.settled import of_values
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_text
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.registers import Parameter, Subindex
from fieldspec.language.model.text_form import text_fault
from fieldspec.language.model.value import Value

_KEYS = ("encoding", "padding", "align", "terminator")


def texts_fit(device: Device) -> Findings:
    yield from of_values(device, _of_value)


def _of_value(fact: Fact, value: Value) -> Findings:
    keys = [key for key in _KEYS if key in fact.place and not (key == "padding" and value.digits)]
    if not is_text(value.encoding):
        for key in keys:
            text = f"{fact.name} is {value.type.name}, and `{key}` is that of a text"
            yield finding(fact.place, key, text, "remove it, or use the type `text`")
    elif value.text_form is not None:
        yield from _of_form(fact, value, next(iter(keys), "byte_order"))


def _of_form(fact: Fact, value: Value, key: str) -> Findings:
    """The findings of the form of a text, the first one of each value."""
    form = value.text_form
    assert form is not None
    use = _use(fact)
    if use:
        text = f"{fact.name} {use}, and has a form of its own"
        yield finding(fact.place, key, text, "state it as `bytes`, or as ASCII filled up with zeros")
    elif value.size % form.unit:
        text = f"{fact.name} has {plural(value.size, 'byte')}, and UTF-16 an even number of them"
        yield finding(fact.place, "encoding", text, "correct the length")
    elif form.is_packed and value.size % 3:
        text = f"{fact.name} has {plural(value.size, 'byte')}, and packed ASCII three of them for four characters"
        yield finding(fact.place, "encoding", text, "correct the length")
    elif not form.has(chr(form.padding)):
        text = f"{fact.name} is packed ASCII, which has no zeros that could fill it up"
        yield finding(fact.place, "padding", text, "remove it: spaces fill the text up")
    elif form.terminator is not None and not form.has(chr(form.terminator)):
        text = f"{fact.name} is packed ASCII, which does not have the character that ends it"
        yield finding(fact.place, "terminator", text, "use a character from the space to `_`, or remove it")
    elif form.is_turned and value.size % 2:
        text = (
            f"{fact.name} has {plural(value.size, 'byte')}, but `byte_order: little` exchanges bytes within whole words"
        )
        yield finding(fact.place, "byte_order", text, "correct the length, or remove `byte_order`")
    elif form.is_right and form.terminator is not None:
        text = f"{fact.name} ends before what fills it up, and cannot be on the right"
        yield finding(fact.place, "align", text, "remove `align`, or remove `terminator`")
    elif form.room(value.size) < form.unit:
        text = f"{fact.name} has no room for a character in {plural(value.size, 'byte')}"
        yield finding(fact.place, "terminator", text, "count the terminator and all characters")
    elif isinstance(value.default, str):
        fault = text_fault(value, "big", value.default)
        if fault is not None:
            text = f"the default of {fact.name} {fault[1]}"
            yield finding(fact.place, "default", text, "correct the default, or how the text is sent")


def _use(fact: Fact) -> str:
    """The purpose of a text that outputs do not read in a special form; empty for other texts."""
    if isinstance(fact, (Parameter, Subindex)):
        return "is a parameter"
    return "is reserved" if getattr(fact, "reserved", False) else ""
