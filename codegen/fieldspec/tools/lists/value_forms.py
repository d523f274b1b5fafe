"""How a value is sent beyond its type, as words after the type in a list: `u16 bcd`, `text utf_16 align right`."""

from __future__ import annotations

import re

from fieldspec.language.model.value import Value

_SPACE = ord(" ")
_FORM = re.compile(
    r"(?P<type>[a-z]+[0-9]*)(?: (?P<digits>bcd|packed_decimal|decimal|upper_hex|lower_hex))?"
    r"(?: codec (?P<codec>[a-z][a-z0-9_]*))?"
    r"(?: (?P<encoding>latin_1|utf_8|utf_16|packed_ascii))?"
    r"(?: places (?P<places>[0-9]{1,2}))?(?: padding (?P<padding>space))?(?: align (?P<align>right))?"
    r"(?: terminator (?P<terminator>[0-9]{1,5}))?(?: byte_order (?P<byte_order>little))?"
)


def type_text(value: Value) -> str:
    """The type of a value, and the words about its form."""
    form = value.text_form
    has_spaces = value.has_blanks or (form is not None and form.padding == _SPACE)
    texts = [value.type.name, f"codec {value.codec}" if value.codec else value.digits]
    texts += [form.encoding] if form is not None and form.encoding != "ascii" else []
    texts += [f"places {value.places}"] if value.places else []
    texts += ["padding space"] if has_spaces else []
    texts += ["align right"] if form is not None and form.is_right else []
    texts += [f"terminator {form.terminator}"] if form is not None and form.terminator is not None else []
    texts += ["byte_order little"] if value.is_low_first else []
    return " ".join(filter(None, texts))


def type_parts(text: str) -> tuple[str, dict[str, str]]:
    """The type in such a text, and the keys of a spec that state its form; the whole text if it has no form."""
    match = _FORM.fullmatch(text)
    if match is None:
        return text, {}
    keys = {key: part for key, part in match.groupdict().items() if part and key != "type"}
    return match["type"], keys
