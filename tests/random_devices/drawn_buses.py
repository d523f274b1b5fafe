"""Random CAN buses: identifiers whose bits are parts, and messages that fit into a frame."""

from __future__ import annotations

from random_devices import drawn_messages, drawn_registers
from random_devices.draft import BOUNDS, Draft, Spec
from random_devices.drawn_records import fixed_field
from random_devices.drawn_values import size_of

DATA = 8
"""The most bytes of the data of a frame."""

_OF_DATA = {"accesses", "segments", "checked"}
"""The keys of messages that need data in their requests."""


def add_bus(draft: Draft) -> None:
    """Adds one or two CAN buses with messages to a device, whose numbered parameters some of them carry."""
    drawn = [_link(draft, coded := draft.chance(75))]
    if draft.chance(25):
        drawn.append(_link(draft, coded))
    link = drawn[0][0]
    room = {key: min(own[key] for _, own in drawn) for key in ("request", "response")}
    draft.spec["links"] = [own for own, _ in drawn]
    names = [own["name"] for own, _ in drawn]
    codes: set[int] = set()
    draft.spec["messages"] = []
    for number in range(1, draft.number(2, 5)):
        key = {"code": drawn_messages.free_code(draft, codes)} if coded else {"number": number, "links": names}
        message = draft.fact(**key, request=_body(draft, room["request"]), response=_body(draft, room["response"]))
        draft.spec["messages"].append(message)
    if coded and draft.chance(30):
        _add_parameters(draft, codes, min(room.values()))
    if any(part.get("role") == "code" for part in link["response"]):
        small = [record for record in draft.records if not record.apart and record.size <= room["response"]]
        if small and draft.chance(60):
            mark = {"code": draft.free_mark()} if draft.chance(40) else {"flag": draft.code_flag}
            link["exception_response"] = {**mark, "record": draft.pick(small).name}
    else:
        drawn_messages.mark_exceptions(draft)
    drawn_messages.draw_response_codes(draft)
    drawn_messages.leave_unrequested(draft)
    if all(_has_room_for_remote_requests(own) for own, _ in drawn):
        _ask_remotely(draft, codes)


def _has_room_for_remote_requests(link: Spec) -> bool:
    """Whether requests have all their parts in the identifier, with a code that can have four bytes."""
    identifier = [part for part in link["request"] if "bits" in part]
    sizes = [4 if part.get("role") == "code" else int(part["type"][1:]) // 8 for part in identifier]
    is_coded = any(part.get("role") == "code" for part in identifier)
    return is_coded and len(identifier) == len(link["request"]) - 1 and sum(sizes) <= 7


def _ask_remotely(draft: Draft, codes: set[int]) -> None:
    """Makes some requests without data remote ones, and adds one that has the code of a data frame."""
    requests = [own for own in draft.spec["messages"] if own.get("request") and not _OF_DATA & {*own}]
    if requests and draft.chance(80):
        code = draft.pick(requests)["code"] if draft.chance(50) else drawn_messages.free_code(draft, codes)
        keys = {"response_code": drawn_messages.free_code(draft, codes), "response": _body(draft, 4)}
        draft.spec["messages"].append(draft.fact(code=code, remote=draft.number(0, DATA), **keys))
    for message in draft.spec["messages"]:
        if message.get("request") == [] and not _OF_DATA & {*message} and draft.chance(60):
            message["remote"] = draft.number(0, DATA)
            del message["request"]


def _add_parameters(draft: Draft, codes: set[int], room: int) -> None:
    """Adds sets of parameters, and the messages that read and write them where these fit into frames."""
    draft.spec["parameters"] = drawn_registers.parameters(draft)
    if not draft.spec["parameters"]:
        return
    drawn = drawn_messages.parameter_messages(draft, codes, [])
    if all(sum(map(size_of, message[key])) <= room + 2 for message in drawn for key in ("request", "response")):
        draft.spec["messages"] += drawn


def _link(draft: Draft, coded: bool) -> tuple[Spec, dict[str, int]]:
    """A bus, and the bytes that are left for the data of each direction."""
    bits = draft.pick((11, 29))
    link = draft.fact(byte_order=draft.byte_order, can={"identifier": bits})
    if draft.word_order:
        link["word_order"] = draft.word_order
    in_identifier = coded and draft.code_bits <= (24 if bits == 29 else 8) and draft.chance(50)
    identifier = _identifier(draft, bits, draft.code_bits if in_identifier else 0)
    is_bare = in_identifier and draft.chance(60)
    room = {}
    has_code = {"request": coded, "response": coded and (in_identifier or draft.chance(70))}
    for direction in ("request", "response"):
        behind: list[Spec] = []
        if has_code[direction] and not in_identifier:
            behind.append(_part(draft, "code", f"u{draft.code_bits}"))
        if not is_bare and draft.chance(30):
            behind.append(_part(draft, "plain", "u8", **({"const": draft.number(0, 255)} if draft.chance(50) else {})))
        behind.append(draft.fact(role="body"))
        checked = not is_bare and draft.chance(30)
        if checked:
            behind.insert(draft.pick((0, len(behind) - 1, len(behind))), _checksum(draft))
        if not is_bare and draft.chance(15):
            first = next(at for at, part in enumerate(behind) if part.get("role") == "body")
            behind.insert(draft.number(0, first), _part(draft, "length", "u8", measures={"from": behind[0]["name"]}))
        for part in behind:
            if part.get("role") == "checksum":
                others = [other["name"] for other in behind if other is not part]
                part["covers"] = {"from": others[0], **({} if part is not behind[-1] else {"to": others[-1]})}
                if behind.index(part) > 0:
                    part["covers"]["to"] = behind[behind.index(part) - 1]["name"]
        link[direction] = [*({**part} for part in identifier), *behind]
        sizes = (int(part["type"][1:]) // 8 if "type" in part else 1 for part in behind if part.get("role") != "body")
        room[direction] = DATA - 2 - sum(sizes)
    return link, room


def _checksum(draft: Draft) -> Spec:
    """A checksum of one byte, as safe data have it."""
    part: Spec = draft.fact(role="checksum", algorithm=draft.pick(("crc8_sae_j1850", "crc8_autosar", "sum8")))
    return {**part, "prefix": draft.pick(("34 12", "07"))} if draft.chance(60) else part


def _identifier(draft: Draft, bits: int, code_bits: int) -> list[Spec]:
    """Parts that have all bits of an identifier, in any order; the code is one where it has `code_bits`."""
    widths = [("code", code_bits)] if code_bits else []
    left = bits - code_bits
    while left > 0:
        width = min(left, draft.number(1, 16)) if len(widths) < 3 else left
        role = "unit_address" if width <= 8 and all(own != "unit_address" for own, _ in widths) else "plain"
        widths.append((role if draft.chance(60) else "plain", width))
        left -= width
    order = list(range(len(widths)))
    at, places = 0, {}
    while order:
        index = order.pop(draft.number(0, len(order) - 1))
        places[index] = (at, at + widths[index][1] - 1)
        at += widths[index][1]
    parts = []
    for index, (role, width) in enumerate(widths):
        first, last = places[index]
        kind = f"u{8 if width <= 8 else 16 if width <= 16 else 32}"
        part = _part(draft, role, kind, bits=f"{first}..{last}" if first < last else first)
        if role == "plain" and draft.chance(40):
            part |= {"const": draft.number(0, (1 << width) - 1)} if draft.chance(70) else {"reserved": True}
        parts.append(part)
    return parts


def _part(draft: Draft, role: str, kind: str, **keys: object) -> Spec:
    part = draft.fact(type=kind, **keys)
    return part if role == "plain" else {**part, "role": role}


def _body(draft: Draft, room: int) -> list[Spec]:
    """Fields that take some bytes at the most; now and then data and padding that fill them together."""
    if room > 1 and draft.chance(25):
        data, padding = (draft.fact(type="u8", repeat=f"0..{room - 1}") for _ in range(2))
        return [draft.fact(type="u8", measures={"items": data["name"]}), data, padding]
    fields = []
    for _ in range(draft.number(0, 4)):
        field, size = fixed_field(draft)
        if size <= room and not BOUNDS & set(field):
            fields.append(field)
            room -= size
    return fields
