"""Texts that are not ASCII filled up with zeros after them, which C has in UTF-8: their functions and arguments."""

from __future__ import annotations

from fieldspec.language.model.text_form import PACKED_ASCII, UTF_16
from fieldspec.language.model.value import Value
from fieldspec.targets.c.expressions import Call, Expression
from fieldspec.targets.c.literals import FALSE, TRUE, hexadecimal, unsigned
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.statements import Evaluation, call

_ENCODINGS = {"ascii": 0, "latin_1": 1, "utf_8": 2, UTF_16: 3, PACKED_ASCII: 8}
"""The numbers of encodings in `runtime/encoded_texts.h`; UTF-16 with the low byte first has the next one."""

_NO_END = 0x80


def text_capacity(value: Value) -> int:
    """The most bytes that the characters of a text have in C, without the zero that ends them."""
    encoding = value.text_form.encoding if value.text_form is not None else ""
    return {"latin_1": 2 * value.size, UTF_16: value.size // 2 * 3, PACKED_ASCII: value.size // 3 * 4}.get(
        encoding, value.size
    )


def load_text(naming: Naming, value: Value, order: str, source: Expression, target: Expression) -> Evaluation:
    """`load_encoded_text(name, in + 4, 12u, 3u, 0x20u, false, 0x80u);`: reads a text without a check."""
    return call(naming.own("load_encoded_text"), target, source, *_form(value, order))


def text_bytes_test(naming: Naming, value: Value, order: str, source: Expression) -> Expression:
    """`is_encoded_text(in + 4, 12u, ...)`: whether bytes are characters of the encoding of a text, with their end."""
    return Call(naming.own("is_encoded_text"), (source, *_form(value, order)))


def text_test(naming: Naming, value: Value, order: str, source: Expression) -> Expression:
    """`fits_encoded_text(in->name, 18u, 12u, ...)`: whether a text can be sent."""
    return Call(naming.own("fits_encoded_text"), (source, unsigned(text_capacity(value)), *_form(value, order)))


def store_text(naming: Naming, value: Value, order: str, source: Expression, target: Expression) -> Evaluation:
    """`store_encoded_text(out + 4, in->name, 18u, 12u, ...);`: writes a text that can be sent."""
    capacity = unsigned(text_capacity(value))
    return call(naming.own("store_encoded_text"), target, source, capacity, *_form(value, order))


def _form(value: Value, order: str) -> tuple[Expression, ...]:
    """The form of a text: `12u, 3u, 0x20u, false, 0x80u`

    These are its bytes, its encoding, its padding, whether the padding comes first, and its terminator.
    """
    form = value.text_form
    assert form is not None
    turned = 1 if form.is_packed else 5
    encoding = _ENCODINGS[form.encoding] + (form.encoding == UTF_16 and order != "big") + turned * form.is_turned
    end = _NO_END if form.terminator is None else form.terminator
    characters = hexadecimal(form.padding, 1), TRUE if form.is_right else FALSE, hexadecimal(end, 1)
    return (unsigned(value.size), unsigned(encoding), *characters)
