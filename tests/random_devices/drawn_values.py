"""Random values: types with ranges, scales, enums, sentinels, constants, and orders of their own."""

from __future__ import annotations

from decimal import Decimal

from random_devices.draft import (
    INTEGERS,
    MAGNITUDES,
    ODD_INTEGERS,
    ODD_WORDS,
    SIZES,
    Draft,
    Spec,
    bounds,
    number,
    range_text,
)

SCALES = ("0.01", "0.1", "0.5", "10", "0.001", "100/2^14", "1/1000", "1/8")
FLOATS = {
    "f16": (200, 300, (-1, 2048, 0), (0x7E00, 0x7D01, 0xFFFF)),
    "f32": (1000, 5000, (9999, -1, 70000, 0), (0x7FC00000, 0x7FA00001, 0xFFFFFFFF)),
    "f64": (1000, 5000, (9999, -1, 70000, 0), (0x7FF8 << 48, 2**64 - 1)),
}
"""For each type: the greatest bound and span of ranges, numbers that are states, and bits of NaN, quiet ones first."""
COUNT_DIGITS: tuple[tuple[Spec, int], ...] = (
    ({"type": "u8", "digits": "upper_hex", "length": 2}, 0xFF),
    ({"type": "u16", "digits": "lower_hex", "length": 4, "byte_order": "little"}, 0xFFFF),
    ({"type": "u32", "digits": "decimal", "length": 5, "places": 2}, 9999),
    ({"type": "u16", "digits": "decimal", "length": 3}, 999),
    ({"type": "u32", "digits": "lower_hex", "length": 5}, 0xFFFFF),
    ({"type": "u16", "digits": "decimal", "length": 3, "padding": "space"}, 999),
    ({"type": "u16", "digits": "bcd", "length": 2}, 9999),
    ({"type": "u16", "digits": "packed_decimal", "length": 2}, 999),
)
"""How subcodes and sizes of lists are sent as digits, and the greatest number of each."""
UNITS = ("mm", "rpm", "%", "ms", "V", "pulse", "°C")


def value(draft: Draft, place: str, types: tuple[str, ...] = ()) -> Spec:
    """The keys of a random value at a place."""
    if place in ("field", "register", "signal", "case") and not types and draft.digits(14 if place == "case" else 7):
        return _digits(draft, place)
    kind = draft.pick(types or _types(draft, place))
    keys: Spec = {"type": kind}
    if kind == "text":
        keys["length"] = draft.number(1, 12)
        keys["length"] += keys["length"] % 2 * _fills_words(draft, place)
        if place in ("field", "register", "signal", "table") and draft.chance(40):
            _text_form(draft, keys)
        elif draft.chance(20) and keys["length"] > 1:
            keys["characters"] = draft.number(1, keys["length"] - 1)
    elif kind == "bytes":
        keys["length"] = draft.number(1, 9)
        keys["length"] += keys["length"] % 2 * _fills_words(draft, place)
    elif kind in FLOATS:
        _float(draft, keys, place)
    elif not kind.startswith("bool"):
        _integer(draft, keys, place)
    # A text, bytes and a single byte have no order.
    if SIZES.get(kind, 0) > 1 and draft.chance(15) and place not in ("signal", "subindex"):
        keys["byte_order"] = draft.pick(("little", "big"))
    return keys


def _fills_words(draft: Draft, place: str) -> bool:
    """Whether characters and bytes are of an even number."""
    return place == "table" or (place == "register" and draft.chance(70))


def has_words(keys: Spec) -> bool:
    """Whether a value is a number of several words of 16 bits."""
    is_number = keys["type"] not in ("text", "bytes") and keys.get("digits", "bcd") in ("bcd", "packed_decimal")
    return is_number and size_of(keys) > 2 and size_of(keys) % 2 == 0


def size_of(keys: Spec) -> int:
    """The bytes of a value."""
    return int(keys.get("length") or SIZES[keys["type"]])


def _types(draft: Draft, place: str) -> tuple[str, ...]:
    if place == "part":
        return ODD_INTEGERS if draft.chance(12) else INTEGERS
    wide = place in ("register", "table")
    if draft.chance(8):
        least = 1 if place in ("case", "field", "signal") else 2
        fitting = [kind for kind in MAGNITUDES if SIZES[kind] >= least and not (wide and SIZES[kind] % 2)]
        return (*fitting, *["f16"] * 3)
    if wide and draft.chance(8):
        return ODD_WORDS
    if place == "register" and draft.chance(8):
        return ("u8", "i8", "bool8")
    if place in ("parameter", "subindex", "case"):
        if draft.chance(15):
            return ODD_INTEGERS
        return tuple(k for k in (*INTEGERS, "f32", "bool8", "bool16") if place == "case" or SIZES[k] > 1)
    if place in ("field", "signal") and draft.chance(12):
        return (*ODD_INTEGERS, "f64")
    usual = tuple(kind for kind in INTEGERS if not wide or SIZES[kind] > 1)
    return usual if draft.chance(70) else ("f32", "bool16", "text", "bytes", *(() if wide else ("bool8",)))


def _integer(draft: Draft, keys: Spec, place: str) -> None:
    low, high = bounds(keys["type"])
    forms = ("bare", "range", "scaled", "enum", "flags", "sentinel", "const")
    form = draft.pick(forms[:5] if place == "part" else forms)
    if form == "enum":
        _enum(draft, keys, low, high)
    elif form == "flags":
        barred = draft.ranged if place == "part" else set()
        fitting = [name for name, kind in draft.flags.items() if kind == keys["type"] and name not in barred]
        if fitting:
            keys["flags"] = draft.pick(fitting)
    elif form == "const" and (place in ("field", "register", "parameter") or draft.chance(5)):
        keys["const"] = draft.edge(low, high)
    elif form == "range":
        _range(draft, keys, low, high, place)
    elif form in ("scaled", "sentinel"):
        _scale(draft, keys, place)
        if draft.chance(60):
            _range(draft, keys, low, high, place, form == "sentinel")
        if form == "sentinel" and place != "part":
            _sentinels(draft, keys, low, high)


def _enum(draft: Draft, keys: Spec, low: int, high: int) -> None:
    fitting = [e for e in draft.enums if all(low <= n <= high for n in e.members.values())]
    if not fitting:
        return
    enum = draft.pick(fitting)
    keys["enum"] = enum.name
    outside = [n for n in (high, low, high - 1) if n not in enum.members.values()]
    if draft.chance(15) and outside and not enum.open:
        last = draft.pick(outside)
        first = next(n for n in range(last, low - 2, -1) if n - 1 in enum.members.values() or n == low or last - n == 9)
        keys["sentinels"] = [{"value": last, "name": "nothing"}]
        if first < last and draft.chance(50):
            keys["sentinels"] = [{"range": f"{first}..{last}", "name": "nothing"}]


def _range(draft: Draft, keys: Spec, low: int, high: int, place: str, sentinel: bool = False) -> None:
    intervals = draft.intervals(low, high)
    if low < 0 and (intervals[0][0] == low) != (intervals[-1][1] == high):
        if draft.chance(30) and place in ("field", "register"):
            keys["allow"] = {"range_ends_match": "The manual prints it so."}
        else:
            intervals = draft.intervals(low + 1, high - 1)
    exact = "/" not in str(keys.get("scale", "1"))
    if draft.chance(20) and exact and "unit" in keys:
        scale, offset = Decimal(str(keys.get("scale", 1))), Decimal(str(keys.get("offset", 0)))
        ends = [sorted((a * scale + offset, b * scale + offset)) for a, b in intervals]
        keys["unit_range"] = ", ".join(f"{a:f}..{b:f}" for a, b in ends)
    else:
        keys["range"] = range_text(intervals)
    first, last = draft.pick(intervals)
    inside = draft.edge(first, last)
    if draft.chance(15) and place not in ("case", "part"):
        if "unit_range" in keys and draft.chance(50):
            keys["unit_default"] = number(inside * scale + offset)
        else:
            keys["default"] = inside
    if draft.chance(15) and place in ("register", "parameter", "table") and "default" not in keys and not sentinel:
        keys["write_range"] = range_text([(inside, draft.edge(inside, last))])
        keys.pop("unit_default", None)


def _scale(draft: Draft, keys: Spec, place: str) -> None:
    if draft.chance(80):
        scale = draft.pick(SCALES)
        keys["scale"] = scale if "/" in scale else number(Decimal(scale))
    if draft.chance(25):
        keys["offset"] = number(Decimal(draft.number(-400, 400)) / 10)
    keys["unit"] = draft.pick(UNITS)


def _sentinels(draft: Draft, keys: Spec, low: int, high: int) -> None:
    numbers = sorted({draft.edge(low, high) for _ in range(draft.number(1, 2))}, reverse=True)
    states: list[Spec] = [{"value": n, "name": f"absent_{place}"} for place, n in enumerate(numbers)]
    if draft.chance(35) and numbers[0] < high:
        states[0] = {"range": f"{numbers[0]}..{draft.edge(numbers[0] + 1, high)}", "name": "absent_0"}
    keys["sentinels"] = states


def _digits(draft: Draft, place: str) -> Spec:
    """A number that is sent as digits, in a type that holds all of them."""
    form = draft.pick(("decimal", "decimal", "upper_hex", "lower_hex", "bcd", "packed_decimal"))
    has_nibbles = form in ("bcd", "packed_decimal")
    is_signed = draft.chance(40)
    size = draft.number(1, 8)
    places = draft.number(1, 3) if form == "decimal" and place != "case" and draft.chance(40) else 0
    if form.endswith("hex") and is_signed:
        size = draft.pick((2, 4, 8, 16))
    elif form == "decimal":
        size += is_signed + (places + 1 if places else 0)
    size += size % 2 if place == "register" else 0
    count = size - (form == "decimal" and is_signed) - bool(places)
    if has_nibbles:
        count = 2 * size - (form == "packed_decimal")
    has_blanks = form == "decimal" and count > places + 1 and draft.chance(50)
    count += has_blanks and is_signed
    high = (16 if form.endswith("hex") else 10) ** count - 1
    low = 0
    if (has_blanks or form == "bcd") and is_signed:
        low = 1 - 10 ** (count - 1)
    elif is_signed:
        low, high = (-high, high) if not form.endswith("hex") else (-(high + 1) // 2, high // 2)
    bits = next(bits for bits in (8, 16, 32, 64) if high < 1 << (bits - is_signed))
    keys: Spec = {"type": f"{'i' if is_signed else 'u'}{bits}", "digits": form, "length": size}
    if places:
        keys["places"] = places
    if has_blanks:
        keys["padding"] = "space"
    if has_nibbles and size > 1 and place != "signal" and draft.chance(30):
        keys["byte_order"] = draft.pick(("little", "big"))
    if form.endswith("hex") and size % 2 == 0 and place != "signal" and draft.chance(40):
        keys["byte_order"] = "little"
    use = draft.pick(("bare", "range", "scaled", "enum", "sentinel", "const"))
    if use == "enum":
        _enum(draft, keys, low, high)
    elif use == "const" and place in ("field", "register"):
        keys["const"] = draft.edge(low, high)
    elif use not in ("bare", "const"):
        if use != "range":
            _scale(draft, keys, place)
        _range(draft, keys, low, high, place, use == "sentinel")
        if use == "sentinel":
            _sentinels(draft, keys, low, high)
    return keys


def short_field(draft: Draft) -> Spec:
    """A number or a constant of one or two bytes, for which outputs have code of their own."""
    keys: Spec = {"type": draft.pick(("u8", "u16"))}
    if draft.chance(25):
        keys["const"] = draft.number(0, 255)
    return draft.fact(**keys)


def varying_text(draft: Draft) -> Spec:
    """A text of as many bytes as it needs."""
    encoding = {"encoding": draft.pick(("ascii", "latin_1", "utf_8"))} if draft.chance(60) else {}
    return {"type": "text", "length": draft.number(1, 9), "varies": True, **encoding}


def varying_value(draft: Draft) -> Spec:
    """A text, or a number of digits, of as many bytes as it needs."""
    if not draft.digits(75):
        return varying_text(draft)
    form = draft.pick(("decimal", "decimal", "decimal", "upper_hex", "lower_hex"))
    size = draft.number(1, 9)
    places = draft.number(1, 3) if form == "decimal" and size > 2 and draft.chance(50) else 0
    places = min(places, size - 2)
    count = size - (places > 0)
    is_signed = form == "decimal" and draft.chance(50)
    high = (10 if form == "decimal" else 16) ** count - 1
    low = 1 - 10 ** (count - 1) if is_signed else 0
    bits = next(bits for bits in (8, 16, 32, 64) if high < 1 << (bits - is_signed))
    keys: Spec = {"type": f"{'i' if is_signed else 'u'}{bits}", "digits": form, "length": size, "varies": True}
    if places > 0:
        keys["places"] = places
    use = draft.pick(("bare", "range", "scaled", "enum", "sentinel"))
    if use == "enum":
        _enum(draft, keys, low, high)
    elif use != "bare":
        if use != "range":
            _scale(draft, keys, "field")
        _range(draft, keys, low, high, "field", use == "sentinel")
        if use == "sentinel":
            _sentinels(draft, keys, low, high)
    return keys


def _text_form(draft: Draft, keys: Spec) -> None:
    """How a text is sent that is not ASCII filled up with zeros."""
    keys["encoding"] = draft.pick(("ascii", "latin_1", "utf_8", "utf_16", "packed_ascii"))
    if keys["encoding"] == "utf_16":
        keys["length"] += keys["length"] % 2
    is_packed = keys["encoding"] == "packed_ascii"
    if is_packed:
        keys["length"] += -keys["length"] % 3
    if draft.chance(50):
        keys["padding"] = "space" if is_packed else draft.pick(("nul", "space"))
    if draft.chance(30):
        keys["align"] = draft.pick(("left", "right"))
    if draft.chance(30) and keys["length"] > 2 and keys.get("align") != "right":
        keys["terminator"] = draft.pick((0x20, 0x3F, 0x40, 0x5F) if is_packed else (0x00, 0x0D, 0x20, 0x7F))
    if keys["encoding"] == "utf_16" and draft.chance(40):
        keys["byte_order"] = draft.pick(("little", "big"))
    elif keys["encoding"] != "utf_16" and draft.chance(25):
        keys["length"] += keys["length"] % 2 * (3 if is_packed else 1)
        keys["byte_order"] = "little"


def _float(draft: Draft, keys: Spec, place: str) -> None:
    greatest, span, numbers, (quiet, *others) = FLOATS[keys["type"]]
    if draft.chance(50):
        keys["unit"] = draft.pick(UNITS)
    if draft.chance(40):
        low = draft.number(-greatest, greatest)
        keys["range"] = range_text([(low, low + draft.number(1, span))])
        if draft.chance(50):
            keys["range"] = f"{low}.{draft.pick(('5', '25', '125'))}..{low + draft.number(1, span)}.75"
    if draft.chance(30) and place != "part":
        nan = {"bits": draft.pick((*(quiet,) * 9, *others)), "name": "not_measured"}
        states = [{"value": draft.pick(numbers[:2]), "name": "overflow"}]
        states += [{"value": draft.pick(numbers[2:]), "name": "underflow"}] * draft.chance(30)
        keys["sentinels"] = draft.pick(([nan], [nan], states, states, [nan, *states]))


def packed_list(draft: Draft, limits: Spec, least: int = 1) -> Spec:
    """A list of numbers of at least so many bits that follow each other without filling bytes."""
    size = draft.pick([own for own in (8, 16, 24, 32) if own > least])
    bits = draft.number(least, size - 1)
    letter = draft.pick("ui")
    low, high = (0, (1 << bits) - 1) if letter == "u" else (-(1 << bits - 1), (1 << bits - 1) - 1)
    keys: Spec = {"type": f"{letter}{size}", "packed_bits": bits, **limits}
    if draft.chance(50):
        keys["byte_order"] = draft.pick(("big", "little"))
    if draft.chance(30):
        keys["range"] = f"{draft.number(low, high)}..{high}"
    if draft.chance(20):
        keys |= {"scale": draft.pick((0.1, 0.5, 2)), "unit": "V"}
    return draft.fact(**keys)
