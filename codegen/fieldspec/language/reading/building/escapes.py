"""The escape of a link, from the method and the bytes that a spec states."""

from __future__ import annotations

from fieldspec.language.model.escape import SLIP, Escape
from fieldspec.language.reading.building.context import Entry

_KEYS = {
    "slip": frozenset[str](),
    "cobs": frozenset[str](),
    "double": frozenset({"bytes"}),
    "xor": frozenset({"bytes", "byte", "mask"}),
    "insert": frozenset({"pattern", "byte"}),
    "add": frozenset({"byte"}),
}


def escape(entry: Entry) -> Escape:
    """The escape that an entry states."""
    method = entry.text("method") or "cobs"
    for key in entry.own:
        if key not in _KEYS[method] | {"method", "from", "to", "source"}:
            entry.refuse("wrong_form", key, f"`{key}` has no effect on the method {method}", f"remove `{key}`")
    for key in sorted(_KEYS[method]):
        if entry.get(key) is None:
            entry.refuse("wrong_form", "method", f"the method {method} needs `{key}`", f"add `{key}`")
    pairs: tuple[tuple[int, int, int], ...] = SLIP if method == "slip" else ()
    special = bytes.fromhex(entry.text("bytes"))
    byte, mask = entry.integer("byte") or 0, entry.integer("mask") or 0
    if method == "double":
        pairs = tuple((special_byte, special_byte, special_byte) for special_byte in special)
    if method == "xor":
        all_special = dict.fromkeys((*special, byte))
        pairs = tuple((special_byte, byte, special_byte ^ mask) for special_byte in all_special)
        if any(second in all_special for _, _, second in pairs):
            text = "an escaped byte is sent as one that must be escaped itself"
            entry.refuse("wrong_form", "mask", text, "correct the mask, or the bytes that are escaped")
    if method == "add" and byte == 0:
        entry.refuse("wrong_form", "byte", "0 changes no byte", "state what is added, or remove `escape`")
    return Escape(
        method="replace" if pairs else method if method in ("cobs", "add") else "insert",
        pairs=pairs,
        pattern=bytes.fromhex(entry.text("pattern")) or b"\0",
        inserted=byte,
        first=entry.text("from"),
        last=entry.text("to"),
    )
