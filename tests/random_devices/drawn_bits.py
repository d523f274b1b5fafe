"""Random bytes and words before the body whose bits are parts: addresses, codes, lengths, constants, numbers."""

from __future__ import annotations

from random_devices.draft import Draft, Spec

_ROLES = ("unit_address", "code", "length", "plain")
_FOREIGN = {"digits", "enum", "flags", "scale", "offset", "unit", "range", "sentinels", "byte_order", "unit_range"}


def share_bytes(draft: Draft, parts: list[Spec]) -> list[Spec]:
    """The same parts, of which some that are next to each other are bits of one byte or word."""
    first = draft.number(0, len(parts))
    inner = parts[first : first + draft.number(0, 4)]
    while inner and not all(map(_can_be_bits, inner)):
        inner.pop()
    widths = [_width(draft, part) for part in inner]
    while widths and sum(widths) > 64:
        widths.pop()
    inner = inner[: len(widths)]
    size = -(-max(sum(widths), 8) // 8)
    if "length" in {part["role"] for part in inner} and size > 4:
        return parts
    shared = [(part, width) for part, width in zip(inner, widths, strict=True)]
    free = 8 * size - sum(widths)
    while free or len(shared) < 2:
        if not free:
            return parts
        width = draft.number(1, free - (not shared))
        shared.insert(draft.number(0, len(shared)), (_filler(draft, width), width))
        free -= width
    order = draft.pick(("big", "little")) if size > 1 and draft.chance(30) else ""
    own = _placed(draft, shared, f"u{8 * size}", {"byte_order": order} if order else {})
    return [*parts[:first], *own, *parts[first + len(inner) :]]


def _can_be_bits(part: Spec) -> bool:
    """Whether a part is an unsigned number without anything that depends on its type."""
    return part["role"] in _ROLES and part["type"].startswith("u") and not _FOREIGN & set(part)


def _width(draft: Draft, part: Spec) -> int:
    """The bits of a part: a code has those of all codes."""
    match part["role"]:
        case "code":
            return draft.code_bits
        case "length":
            return draft.number(7, 20)
        case "unit_address":
            return draft.number(3, 12)
        case _:
            return max(part.get("const", 0).bit_length(), draft.number(1, 9))


def _filler(draft: Draft, width: int) -> Spec:
    """A part that takes bits which are left: a constant, a number that users supply, or one without a meaning."""
    part: Spec = {**draft.fact(), "name": f"bits_part_{draft.names}", "role": "plain"}
    if draft.chance(60):
        part["const"] = draft.edge(0, (1 << width) - 1)
    if draft.chance(40):
        part["reserved"] = True
    return part


def _placed(draft: Draft, shared: list[tuple[Spec, int]], kind: str, order: Spec) -> list[Spec]:
    """Parts with their bits, which have any order in the byte or word."""
    places = list(range(len(shared)))
    at, bits = 0, {}
    while places:
        index = places.pop(draft.number(0, len(places) - 1))
        bits[index] = f"{at}..{at + shared[index][1] - 1}" if shared[index][1] > 1 else at
        at += shared[index][1]
    return [{**part, **order, "type": kind, "bits": bits[index]} for index, (part, _) in enumerate(shared)]
