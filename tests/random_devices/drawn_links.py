"""Random links: the parts of their frames in any order, with lengths and checksums of any span of them."""

from __future__ import annotations

import re

from fieldspec.language.schema import schema
from random_devices.draft import ODD_COUNTS, ODD_INTEGERS, SIZES, Draft, Spec, bounds, range_text
from random_devices.drawn_bits import share_bytes
from random_devices.drawn_escapes import add_escape, add_preamble
from random_devices.drawn_values import value

USUAL_CHECKSUMS = ("sum8", "crc16_modbus", "lrc")
ALGORITHMS = tuple(schema()["$defs"]["algorithm"]["enum"])


def link(draft: Draft, coded: bool) -> Spec:
    """A link whose frames carry a code, or whose messages are known otherwise."""
    transmission = draft.pick(("binary", "hex_ascii")) if draft.sends_characters else "binary"
    line = draft.fact(transmission=transmission, byte_order=draft.byte_order)
    if draft.word_order:
        line["word_order"] = draft.word_order
    if draft.chance(15):
        by_direction = {"request": _delimiters(draft), "response": _delimiters(draft)}
        for mark in ("start", "end"):
            if stated := {direction: own[mark] for direction, own in by_direction.items() if mark in own}:
                line[mark] = stated
    else:
        line |= _delimiters(draft)
    line["request"] = parts(draft, line, coded, {})
    code = next((part for part in line["request"] if part.get("role") == "code"), None)
    same = draft.chance(50)
    line["response"] = line["request"] if same else parts(draft, line, coded and draft.chance(85), code or {})
    if transmission == "binary" and draft.chance(18):
        add_escape(draft, line)
    if transmission == "binary" and draft.chance(15):
        add_preamble(draft, line)
    roles = {part.get("role") for part in (*line["request"], *line["response"])}
    if "unit_address" in roles and draft.chance(60):
        _unit_addresses(draft, line)
    is_coded = any(part.get("role") == "code" for part in line["response"])
    mark = _mark(draft, line["response"], is_coded) if coded and draft.chance(40) else {}
    record = next((record for record in draft.records if not record.apart), None)
    if mark and record is not None:
        line["exception_response"] = {**mark, "record": record.name}
    if draft.chance(5):
        line["silence"] = {"milliseconds": 5}
    if draft.chance(5):
        line["serial"] = {"baud": [9600], "parity": ["even"]}
    if draft.chance(5):
        line["network"] = {draft.pick(("tcp", "udp")): draft.number(1, 0xFFFF)}
    return line


def _mark(draft: Draft, response: list[Spec], is_coded: bool) -> Spec:
    """What marks an exception response: a bit of the code, a code that no message has, or a part before the body.

    Nothing does where responses carry no code and no other number.
    """
    before = response[: next(at for at, part in enumerate(response) if part.get("role") == "body")]
    bound = {"const", "reserved", "range", "unit_range"}
    numbers = [part for part in before if "role" not in part and not bound & set(part)]
    if numbers and draft.chance(70):
        part = draft.pick(numbers)
        low, high = _limits(part)
        normal = draft.intervals(low + 1, high, 2)
        return {"part": part["name"], "normal": range_text(normal)}
    if not is_coded:
        return {}
    decimal = any(part.get("role") == "code" and part.get("digits") == "decimal" for part in response)
    return {"code": draft.free_mark()} if draft.chance(30) or decimal else {"flag": draft.code_flag}


def _limits(part: Spec) -> tuple[int, int]:
    """The least and the greatest number of a part: those of its type, of its bits, or of its digits."""
    if "bits" in part:
        first, _, last = str(part["bits"]).partition("..")
        return 0, (1 << int(last or first) - int(first) + 1) - 1
    if "digits" not in part:
        return bounds(part["type"])
    return 0, (10 if part["digits"] == "decimal" else 16) ** part["length"] - 1


def _delimiters(draft: Draft) -> Spec:
    """The bytes that open and close frames, both or one of them or none."""
    return {mark: draft.pick(("3A", "02", "0D 0A", "AA 55 AA")) for mark in ("start", "end") if draft.chance(35)}


def parts(draft: Draft, line: Spec, coded: bool, code: Spec) -> list[Spec]:
    """The parts of one direction: those before the body in any order, the body, those after it."""
    before: list[Spec] = []
    behind: list[Spec] = []
    kind = code.get("type") or f"u{draft.code_bits}"
    if coded and draft.chance(25):
        return _usual(draft, kind)
    if coded:
        before.append(_part(draft, "code", **_number(draft, kind, (1 << draft.code_bits) - 1)))
    if draft.chance(45):
        widths = ("u32", "u40", "u48", "u56", "u64") if draft.chance(20) else ("u8", "u8", "u16")
        before.append(_part(draft, "unit_address", **_number(draft, _count(draft, *widths), 99)))
    before += [_argument(draft) for _ in range(draft.number(0, 2))]
    for _ in range(draft.number(0, 2)):
        (before if draft.chance(50) else behind).append(_constant(draft))
    counts = draft.chance(45)
    if counts:
        for _ in range(draft.pick((1, 1, 1, 2))):
            before.append(_part(draft, "length", **_number(draft, _count(draft, "u16", "u8", "u32"), 999)))
    if draft.chance(70):
        for _ in range(draft.pick((1, 1, 1, 1, 1, 1, 2, 3, 4))):
            (before if draft.chance(15) else behind).append(_checksum(draft))
    before = _shuffled(draft, before)
    if draft.chance(25):
        before = share_bytes(draft, before)
    line_of_parts = [*before, _part(draft, "body"), *_shuffled(draft, behind)]
    names = [part["name"] for part in line_of_parts]
    middle = next(at for at, part in enumerate(line_of_parts) if part["role"] == "body")
    for at, part in enumerate(line_of_parts):
        if part["role"] == "length" and draft.chance(60):
            part["measures"] = _counts(draft, names, middle)
        if part["role"] == "checksum" and (draft.chance(40) or at < middle):
            part["covers"] = _covers(draft, names, at)
    return [{key: v for key, v in part.items() if (key, v) != ("role", "plain")} for part in line_of_parts]


def _count(draft: Draft, *usual: str) -> str:
    """One of some unsigned types, or now and then one of a width that machines do not have."""
    if draft.chance(1):
        return draft.pick(ODD_COUNTS)
    return "u24" if draft.chance(12) else draft.pick(usual)


def _number(draft: Draft, kind: str, least: int) -> Spec:
    """The type of a part, or the digits that it is sent as, which mostly have all numbers up to one."""
    if not draft.digits(20):
        return {"type": kind}
    form = draft.pick(("upper_hex", "lower_hex", "decimal") if least < 10**19 else ("upper_hex", "lower_hex"))
    base = 10 if form == "decimal" else 16
    length = draft.number(1, 3)
    while base**length <= least and not draft.chance(3):
        length += 1
    bits = next(bits for bits in (8, 16, 32, 64) if base**length <= 1 << bits)
    return {"type": f"u{bits}", "digits": form, "length": length}


def _usual(draft: Draft, kind: str) -> list[Spec]:
    """What most protocols have, for which outputs have code of their own: an address, a code, the body, a CRC."""
    head = [_part(draft, "unit_address", type="u8"), _part(draft, "code", type=kind)]
    if draft.chance(60):
        low, high = bounds("u8")
        head.insert(draft.number(0, 2), {**_part(draft, "plain", type="u8"), "const": draft.edge(low, high)})
    return [*head, _part(draft, "body"), _part(draft, "checksum", algorithm="crc16_modbus")]


def _part(draft: Draft, role: str, **keys: object) -> Spec:
    fact = draft.fact()
    return {**fact, "name": f"{role[:4]}_part_{draft.names}", "role": role, **keys}


def _checksum(draft: Draft) -> Spec:
    """A checksum by its name, or by its parameters, as bytes or as characters; some have a prefix."""
    part = _part(draft, "checksum")
    if draft.chance(15):
        part["prefix"] = draft.pick(("34 12", "00", "A5 5A 01 FF"))
    if draft.chance(10):
        part["suffix"] = draft.pick(("03", "12 34", "00 FF 80"))
    if draft.chance(80):
        part["algorithm"] = draft.pick(USUAL_CHECKSUMS if draft.chance(60) else ALGORITHMS)
    elif draft.chance(60):
        width = draft.pick((8, 16, 32, 12, 5, 64))
        parameters: Spec = {"width": width, "polynomial": draft.number(1, (1 << width) - 1) | 1}
        for key in ("initial", "final_xor"):
            if draft.chance(50):
                parameters[key] = draft.number(0, (1 << width) - 1)
        if draft.chance(40):
            parameters["method"] = "crc"
        for key in ("reflect_in", "reflect_out"):
            if draft.chance(50):
                parameters[key] = True
        if draft.chance(30):
            parameters |= {
                "unit_size": draft.pick((2, 3, 4)),
                "unit_order": "big" if "reflect_in" in parameters else "little",
            }
        part["algorithm"] = parameters
    elif draft.chance(40):
        part["algorithm"] = _fletcher(draft)
    else:
        method, width = draft.pick(("sum", "xor")), draft.pick((8, 16, 32))
        part["algorithm"] = {"method": method, "width": width}
        if draft.chance(50):
            part["algorithm"]["complement"] = draft.pick(("ones", "twos"))
        if draft.chance(30):
            part["algorithm"]["unit_size"] = draft.pick((1, 2, 4))
        _order_units(draft, part["algorithm"], 1 if method == "sum" else width // 8)
    if draft.digits(15):
        part["digits"] = draft.pick(("upper_hex", "lower_hex", "decimal"))
        return part
    if draft.chance(20):
        avoided, replacements = draft.pick(
            (("28 0D 0A", "29 0E 0B"), ("00", "FF"), ("00 01 02 03 04", "05 06 07 05 05"))
        )
        part["avoids"] = {"bytes": avoided, "replacements": replacements}
    if _has_order(part) and draft.chance(40):
        part["byte_order"] = draft.pick(("big", "little"))
    return part


def _fletcher(draft: Draft) -> Spec:
    """The parameters of a Fletcher checksum."""
    width = draft.pick((16, 32, 48, 64))
    half = 1 << width // 2
    parameters: Spec = {"method": "fletcher", "width": width}
    if draft.chance(70):
        parameters["modulus"] = draft.pick((half, half - 1, half - 15, 251))
    if draft.chance(40):
        parameters["initial"] = draft.pick((1, half | 1, 250 * half + 250))
    if draft.chance(40):
        parameters["unit_size"] = draft.pick(range(1, width // 16 + 1))
    _order_units(draft, parameters, 1)
    return parameters


def _order_units(draft: Draft, parameters: Spec, usual: int) -> None:
    """States the order of the numbers that a checksum takes, where they have several bytes."""
    if parameters.get("unit_size", usual) > 1 and draft.chance(40):
        parameters["unit_order"] = draft.pick(("big", "little"))


def _has_order(part: Spec) -> bool:
    """Whether a checksum has several bytes, or combines numbers of several bytes."""
    if isinstance(stated := part["algorithm"], dict):
        unit_size = stated.get("unit_size", stated["width"] // 8 if stated.get("method") == "xor" else 1)
        return bool(stated["width"] > 8 or unit_size > 1)
    width = re.search("[0-9]+", stated)
    return width is not None and int(width[0]) > 8


def _argument(draft: Draft) -> Spec:
    """A part that users supply."""
    if draft.chance(15):
        return _part(draft, "plain", **_number(draft, "u8", draft.pick((9, 255, 65535))))
    keys = value(draft, "part")
    if "enum" in keys and not next(enum.open for enum in draft.enums if enum.name == keys["enum"]):
        keys = {"type": keys["type"]}
    return _part(draft, "plain", **keys)


def _constant(draft: Draft) -> Spec:
    """A part with a constant, or without a meaning."""
    kind = draft.pick(ODD_INTEGERS if draft.chance(15) else ("u8", "u16", "i8", "u32", "i16"))
    keys: Spec = {"type": kind} if draft.chance(80) else _number(draft, kind, 9)
    if draft.chance(70):
        keys["const"] = draft.edge(*_limits(keys))
    if "const" not in keys or draft.chance(30):
        keys["reserved"] = True
    if SIZES[kind] > 1 and "digits" not in keys and draft.chance(20):
        keys["byte_order"] = draft.pick(("big", "little"))
    return _part(draft, "plain", **keys)


def _shuffled(draft: Draft, drawn: list[Spec]) -> list[Spec]:
    left, result = list(drawn), []
    while left:
        result.append(left.pop(draft.number(0, len(left) - 1)))
    return result


def _counts(draft: Draft, names: list[str], middle: int) -> Spec:
    keys: Spec = {}
    if draft.chance(60):
        keys["from"] = names[draft.number(0, middle)]
    if draft.chance(60):
        keys["to"] = names[draft.number(middle, len(names) - 1)]
    if draft.chance(12):
        keys["in"] = draft.pick(("words", "bytes"))
    if draft.chance(40):
        keys["plus"] = draft.number(-3, 20)
    return keys or {"plus": 1}


def _covers(draft: Draft, names: list[str], at: int) -> Spec:
    """A span that does not contain the checksum itself."""
    behind = at < len(names) - 1 and (at == 0 or draft.chance(30))
    low, high = (at + 1, len(names) - 1) if behind else (0, max(at - 1, 0))
    first = draft.number(low, high)
    last = draft.number(first, high)
    keys: Spec = {"from": names[first], "to": names[last]}
    if draft.chance(30) and not behind and first == 0:
        keys.pop("from")
    if draft.chance(30) and last in (at - 1, len(names) - 1):
        keys.pop("to")
    return keys or {"from": names[first]}


def _unit_addresses(draft: Draft, line: Spec) -> None:
    numbers = [part for part in (*line["request"], *line["response"]) if part.get("role") == "unit_address"]
    low, high = 0, min([0xFF, *(_limits(part)[1] for part in numbers)])
    intervals = draft.intervals(low, high, 2)
    line["unit_addresses"] = {"range": range_text(intervals)}
    if draft.chance(40):
        number = draft.number(low, high)
        if all(number < first or number > last for first, last in intervals) or draft.chance(5):
            line["unit_addresses"]["broadcast"] = number
