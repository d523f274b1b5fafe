"""Random escapes of frames: each method, for all parts or for those around the body, with delimiters that fit."""

from __future__ import annotations

from random_devices.draft import Draft, Spec

_FLAGS = ("7E", "02", "C0 FE")


def add_escape(draft: Draft, line: Spec) -> None:
    """Adds an escape to a link, and the delimiters that fit it."""
    for key in ("start", "end"):
        line.pop(key, None)
    method = draft.pick(("slip", "cobs", "double", "xor", "insert", "add"))
    escape: Spec = {"method": method}
    if method in ("slip", "cobs"):
        mark = "C0" if method == "slip" else "00"
        line["end"] = mark
        if draft.chance(25):
            line["start"] = mark
    elif method == "double":
        first = draft.pick(("10", "1B", "00"))
        escape["bytes"] = first if draft.chance(60) else f"{first} FF"
        line |= {"start": f"{first} 02", "end": f"{first} 03"}
    elif method == "xor":
        mark = draft.pick(_FLAGS)
        bytes_of_mark = mark if draft.chance(60) else f"{mark} 11"
        escape |= {"bytes": bytes_of_mark, "byte": draft.pick((0x7D, 0x1B)), "mask": draft.pick((0x20, 1, 0xFF))}
        line["end"] = mark
        if draft.chance(60):
            line["start"] = draft.pick((mark, "02"))
    elif method == "add":
        escape["byte"] = draft.pick((0x33, 0xFF, 1))
    else:
        pattern = draft.pick(("FF FF FD", "AA", "00 00"))
        escape |= {"pattern": pattern, "byte": draft.pick((0xFD, 0, 0x55))}
        line["start"] = pattern
    if line["request"] is line["response"] and draft.chance(60):
        _bound(draft, line, escape)
    line["escape"] = escape
    if "from" in escape or "to" in escape:
        _before_escape(draft, line, escape)


def add_preamble(draft: Draft, line: Spec) -> None:
    """Adds a preamble to a link whose frames have a length, and mostly a start delimiter behind it."""
    directions = ("request", "response")
    if not all(any(part.get("role") == "length" for part in line[direction]) for direction in directions):
        return
    if "escape" in line and "from" not in line["escape"]:
        return
    openings = [_opening(line, direction) for direction in directions]
    if None in openings:
        line["start"], openings = "AA 55", [0xAA]
    byte = draft.pick(tuple({0xFF, 0xFE, 0x55, 0} - set(openings)))
    least = draft.number(0, 5)
    most = least + draft.number(0, 9)
    line["preamble"] = {"byte": byte, "count": f"{least}..{most}", "sent": draft.number(least, most)}


def _opening(line: Spec, direction: str) -> int | None:
    """The byte with which the frames of a direction begin, None where they differ."""
    start, first = line.get("start", ""), line[direction][0]
    if isinstance(start, dict):
        start = start.get(direction, "")
    if start:
        return int(start[:2], 16)
    is_constant = first.get("type") == "u8" and "const" in first and not {"reserved", "digits"} & set(first)
    return first["const"] if is_constant else None


def _before_escape(draft: Draft, line: Spec, escape: Spec) -> None:
    """Some lengths and checksums that are not escaped are those of the bytes before they are."""
    names = [part["name"] for part in line["request"]]
    first = names.index(escape["from"]) if "from" in escape else 0
    last = names.index(escape["to"]) if "to" in escape else len(names) - 1
    for at, part in enumerate(line["request"]):
        key = {"length": "measures", "checksum": "covers"}.get(part.get("role", ""))
        if key is not None and not first <= at <= last and draft.chance(60 if key == "covers" else 90):
            part[key] = {**part.get(key, {}), "before_escape": True}


def _bound(draft: Draft, line: Spec, escape: Spec) -> None:
    """Escapes some parts only, the body among them; these names are the same in both directions."""
    names = [part["name"] for part in line["request"]]
    body = next(at for at, part in enumerate(line["request"]) if part.get("role") == "body")
    if draft.chance(70):
        escape["from"] = names[body if draft.chance(40) else draft.number(0, body)]
    if draft.chance(70):
        escape["to"] = names[draft.number(body, len(names) - 1)]
