"""The order of the bytes of two words in a list: `CDAB`, or `CDAB, written ABCD` if a write has a different order."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.model.encoding import is_octets, is_truth
from fieldspec.language.model.primitives import Primitive
from fieldspec.language.model.value import Value
from fieldspec.tools.lists.words import meaning

_OF_WRITES = ", written "
_JOINED = {(False, False): "ABCD", (False, True): "CDAB", (True, False): "BADC", (True, True): "DCBA"}
"""The orders of bytes by whether words have the low byte first, and whether the low word is first."""


def stated_order(text: str) -> str:
    """The order that a text says; empty if it says none."""
    read, separator, write = text.partition(_OF_WRITES)
    orders = [meaning("orders", part) for part in ((read, write) if separator else (read,))]
    return _OF_WRITES.join(orders) if all(orders) else ""


def joined_order(of_bytes: str, of_words: str) -> str:
    """The order that one of bytes and one of words give together; an empty one says nothing."""
    if not of_words or of_bytes not in ("ABCD", "DCBA"):
        return of_bytes or of_words
    return _OF_WRITES.join(_JOINED[of_bytes == "DCBA", _is_low_first(own)] for own in of_words.split(_OF_WRITES))


def order_text(value: Value | None, order: str, swapped: bool) -> str:
    """The order of a value; empty for the usual one, and where there is only one byte."""
    if value is None or value.size < 2 or not (value.type.is_number or value.text_form):
        return ""
    is_little = order == "little"
    is_low_first = is_little != (swapped and value.has_words)
    read, write = _JOINED[is_little, is_low_first], _JOINED[is_little, not is_low_first]
    if value.write_word_order:
        return f"{read}{_OF_WRITES}{write}"
    return "" if read == "ABCD" else read


def order_keys(order: str, kind: Primitive, size: int) -> Iterator[str]:
    """The keys of the order of words and of bytes that differ from the orders of the device: big, as in frames."""
    read, _, write = order.partition(_OF_WRITES)
    if kind.is_number and size > 2 and size % 2 == 0:
        if read in ("CDAB", "DCBA", "BADC"):
            yield f"word_order: {_word_order(read)}"
        if write and _word_order(write) != _word_order(read):
            yield f"write_word_order: {_word_order(write)}"
    if read in ("BADC", "DCBA") and not (is_truth(kind.encoding) or is_octets(kind.encoding)):
        yield "byte_order: little"


def _word_order(order: str) -> str:
    return "little" if _is_low_first(order) else "big"


def _is_low_first(order: str) -> bool:
    return order in ("CDAB", "DCBA")
