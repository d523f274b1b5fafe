"""Escapes in C: the functions of a link that turn bytes into those that are sent, and back, in place."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.language.model.escape import CAN_REMOTE, Escape
from fieldspec.targets.c.declarations import Source
from fieldspec.targets.c.expressions import Call, Expression
from fieldspec.targets.c.fields import return_error
from fieldspec.targets.c.literals import unsigned
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.runtime_files import copy_runtime
from fieldspec.targets.c.statements import Body, call

_FORMS = "escape_forms.h"


def declare_escapes(naming: Naming, layout: DeviceLayout) -> list[list[Source]]:
    """The functions of the escapes of all links."""
    links = [link for link in layout.links.values() if link.link.escape is not None]
    functions = [[_functions(naming, link, link.link.escape)] for link in links if link.link.escape is not None]
    is_moving = any(link.link.escape is not None and link.link.escape.method != "add" for link in links)
    return [*([[copy_runtime(naming, _FORMS, "moving")]] if is_moving else []), *functions]


def _functions(naming: Naming, link: LinkLayout, escape: Escape) -> Source:
    def digits(number: int) -> str:
        return f"0x{number:02X}u"

    if escape.method == "can":
        has_remote = escape.remote is not None
        fields = [[size, int(order == "little"), first, width] for size, order, first, width in escape.fields]
        for row, field in enumerate(fields if has_remote else ()):
            field.append(CAN_REMOTE >> 24 if row == escape.remote else 0)
        own_bits = (1 << escape.bits) - 1 | (CAN_REMOTE if has_remote else 0)
        can_words = {
            "ESCAPE": f"escape_{link.name}",
            "UNESCAPE": f"unescape_{link.name}",
            "ROWS": f"{len(escape.fields)}u",
            "COLUMNS": str(len(fields[0])),
            "FIELDS": "\n".join(f"        {{{', '.join(f'{number}u' for number in field)}}}," for field in fields),
            "FLAGS": f"0x{escape.flags:08X}u",
            "MASKED": f"0x{0xFFFFFFFF & ~own_bits:08X}u",
            "SIZE": f"{escape.fields_size}u",
            "REMOTE": f"0x{CAN_REMOTE:08X}u" if has_remote else "",
            "CONTENT": "(remote != 0u ? 0u : dlc)" if has_remote else "dlc",
        }
        return copy_runtime(naming, _FORMS, escape.method, can_words)
    special = dict.fromkeys([byte for byte, _, _ in escape.pairs] + [first for _, first, _ in escape.pairs])
    words = {
        "ESCAPE": f"escape_{link.name}",
        "UNESCAPE": f"unescape_{link.name}",
        "ROW": f"row_{link.name}" if escape.pairs else f"pattern_{link.name}",
        "ROWS": f"{len(escape.pairs) or len(escape.pattern)}u",
        "PAIRS": "\n".join(f"        {{{', '.join(map(digits, row))}}}," for row in escape.pairs),
        "SENT": "\n".join(f"        {{{', '.join(map(digits, row))}}}," for _, *row in escape.pairs),
        "ORIGINALS": ", ".join(digits(byte) for byte, _, _ in escape.pairs),
        "SPECIAL": " || ".join(f"data[offset] == {digits(byte)}" for byte in special),
        "PATTERN": ", ".join(map(digits, escape.pattern)),
        "INSERTED": digits(escape.inserted),
    }
    return copy_runtime(naming, _FORMS, escape.method, words)


def keeps_size(frame: FrameLayout) -> bool:
    """Whether escaping keeps the number of bytes."""
    return frame.escape is None or frame.escape.method == "add"


def escape_bytes(
    naming: Naming, link: LinkLayout, frame: FrameLayout, data: Expression, length: Expression, *room: Expression
) -> Body:
    """`status = escape_slip(out, &total, 0u, 0u, capacity - 1u);`; without the room, the call of `unescape_slip`."""
    function = naming.own(f"{'escape' if room else 'unescape'}_{link.name}")
    bounds = unsigned(frame.escape_start), unsigned(-(frame.escape_stop or 0))
    if keeps_size(frame):
        return (call(function, data, length, *bounds),)
    return return_error(naming, Call(function, (data, length.address(), *bounds, *room)))
