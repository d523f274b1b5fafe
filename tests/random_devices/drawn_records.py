"""Random records and bodies of messages: fields, lists, nested records, repeats, choices, sizes of other fields."""

from __future__ import annotations

from random_devices.draft import BOUNDS, Draft, RecordDraft, Spec
from random_devices.drawn_choices import choice_counter, closed_enums, deciding_fields, leave_empty
from random_devices.drawn_presences import (
    continued_list,
    count_type,
    list_counter,
    more_ways,
    optional_field,
    presence_decider,
    text_counter,
)
from random_devices.drawn_values import packed_list, short_field, size_of, value, varying_text, varying_value


def records(draft: Draft) -> list[Spec]:
    """Records that nest in one another; some consist of whole registers, for tables."""
    fixed = [_record(draft, words=draft.chance(35)) for _ in range(draft.number(0, 4))]
    elements = [_element_record(draft) for _ in range(draft.number(1, 2) if draft.chance(30) else 0)]
    return [
        *fixed,
        *elements,
        *(_differing_record(draft) for _ in range(draft.number(0, 3) if draft.chance(50) else 0)),
    ]


def _differing_record(draft: Draft) -> Spec:
    """A record that counts its texts or its lists, and may have others that differ in size, so that it differs, too."""
    record = draft.fact(fields=[])
    fields = [draft.bounded(fixed_field(draft)[0], 8) for _ in range(draft.number(0, 2))]
    if draft.chance(40):
        for _ in range(draft.number(1, 2)):
            fields = _text_between(draft, fields)
    else:
        for _ in range(draft.number(1, 2)):
            if draft.chance(20):
                fields = _text_between(draft, fields)
            if closed_enums(draft) and draft.chance(50):
                fields = _choice_between(draft, fields)
                continue
            if draft.chance(25):
                fields = _optional_between(draft, fields)
                continue
            if draft.chance(15):
                fields = _continued_between(draft, fields)
                continue
            if draft.differing and draft.chance(30):
                inner = _differing(draft)
                fields = _inserted(draft, fields, _byte_counter(draft, inner)) if draft.chance(30) else fields
                fields = [*fields, inner, *_behind(draft)]
                continue
            if draft.chance(30):
                fields = [*fields, packed_list(draft, {"count": draft.number(1, 9)}), *_behind(draft)]
                continue
            inner = draft.differing and draft.chance(25)
            repeated = _differing(draft, "0..2") if inner else _repeated(draft, fields, low_limits=True)
            measure = _counter(draft, repeated, ("u8", "u16"))
            fields = [*_inserted(draft, fields, measure), repeated, *_behind(draft)]
    record["fields"] = fields
    draw_separator(draft, record, fields)
    draft.differing.append(record["name"])
    return record


def _text_between(draft: Draft, fields: list[Spec]) -> list[Spec]:
    """Fields with a counted text behind them, and some behind that."""
    text = draft.fact(**varying_text(draft))
    return [*_inserted(draft, fields, text_counter(draft, text)), text, *_behind(draft)]


def _element_record(draft: Draft) -> Spec:
    """A record that says whether another one follows it in a list; it may differ in size."""
    if draft.chance(40):
        record = _differing_record(draft)
    else:
        record = draft.fact(fields=[fixed_field(draft)[0] for _ in range(draft.number(0, 3))])
    decider, ways = presence_decider(draft)
    record["fields"].insert(0, decider)
    draft.elements.append((record["name"], [{"in": decider["name"], **way} for way in more_ways(draft, ways)]))
    return record


def _continued_between(draft: Draft, fields: list[Spec]) -> list[Spec]:
    """Fields with lists behind them whose elements say which of them is the last, and some behind these."""
    decider, ways = presence_decider(draft)
    before = _inserted(draft, fields, decider)
    presences = [draft.pick(ways) if draft.chance(50) else None for _ in range(draft.number(1, 2))]
    return [*before, *(own for way in presences for own in [continued_list(draft, way), *_behind(draft)])]


def _behind(draft: Draft) -> list[Spec]:
    """Fields of fixed size after what has none, now and then."""
    return [fixed_field(draft)[0] for _ in range(draft.number(1, 2))] if draft.chance(40) else []


def _differing(draft: Draft, limits: str = "") -> Spec:
    """A field with a record that differs in size: once, two times, or repeated."""
    count = {"count": 2} if draft.chance(25) else {}
    return draft.fact(record=draft.pick(draft.differing), **({"repeat": limits} if limits else count))


def _record(draft: Draft, words: bool) -> Spec:
    record = draft.fact(fields=[])
    size = 0
    for _ in range(draft.number(1, 5)):
        field, bytes_of_field = fixed_field(draft, "table" if words else "field")
        record["fields"].append(field)
        size += bytes_of_field
    if draft.chance(20):
        size += add_exponent(draft, record["fields"], "i16" if words else "i8")
    size += 0 if words else draw_separator(draft, record, record["fields"])
    if draft.chance(20):
        record["checked"] = {"size": size}
    elif draft.chance(20) and words:
        record["checked"] = {"words": size // 2}
    if any(BOUNDS & set(field) for field in record["fields"]):
        record.pop("checked", None)
    apart = any("write_range" in field for field in record["fields"])
    draft.records.append(RecordDraft(record["name"], size, words, apart))
    return record


def draw_separator(draft: Draft, holder: Spec, *bodies: list[Spec]) -> int:
    """Lets bytes separate the fields of a record or a message; returns how many there are in the first body."""
    if max(map(len, bodies)) < 2 or not draft.chance(15):
        return 0
    holder["separator"] = draft.pick(("2C", "20", "0A", "3B 20", "2C 00 2C", "7C 7C 7C 7C"))
    return (len(bodies[0]) - 1) * len(bytes.fromhex(holder["separator"]))


def fixed_field(draft: Draft, place: str = "field") -> tuple[Spec, int]:
    """A field whose size is fixed, and this size."""
    fact = draft.fact()
    nested = [record for record in draft.records if (record.words or place == "field") and not record.apart]
    if nested and draft.chance(15):
        record = draft.pick(nested)
        count = draft.number(2, 3) if draft.chance(30) else 1
        keys: Spec = {"record": record.name, **({"count": count} if count > 1 else {})}
        if place == "table":
            keys |= {"access": draft.pick(("rw", "ro"))} if draft.chance(15) else {}
            keys |= {"clears_on_read": True} if draft.chance(8) else {}
        return {**fact, **keys}, record.size * count
    keys = value(draft, place)
    if draft.chance(8) and "digits" not in keys:
        keys = {key: keys[key] for key in ("type", "length", "byte_order", "const") if key in keys} | {"reserved": True}
        if keys["type"] == "f32":
            keys["type"] = "u32"
    count = draft.number(2, 4) if draft.chance(15) and not {"default", "const"} & set(keys) else 1
    if count > 1:
        keys["count"] = count
    if place == "table" and draft.chance(20):
        keys["access"] = "rw" if "write_range" in keys else draft.pick(("ro", "rw", "ro", "rw", "wo"))
    return {**fact, **keys}, size_of(keys) * count


_FIXED = {"scale", "offset", "enum", "flags", "const", "parameter", "unit_range", "unit_default", "reserved", "record"}
"""The keys that a value with its scale elsewhere does not have."""


def may_be_scaled(row: Spec) -> bool:
    """Whether a register or a field may have its scale elsewhere: a whole number that has none of its own."""
    return row.get("type", "").lstrip("iu").isdigit() and _FIXED.isdisjoint(row) and "measures" not in row


def exponent_keys(draft: Draft, kind: str) -> Spec:
    """The keys of a value with the exponent of a scale."""
    keys: Spec = {"type": kind, "range": draft.pick(("-10..10", "-22..22", "-3..-1, 2..5"))}
    if draft.chance(60):
        keys["sentinels"] = [{"value": -0x8000 if kind == "i16" else -0x80, "name": "not_implemented"}]
    return keys


def add_exponent(draft: Draft, fields: list[Spec], kind: str) -> int:
    """Adds a field with the exponent of others, somewhere between them; its size, 0 where no field can have one."""
    scaled = [field for field in fields if may_be_scaled(field)]
    if not scaled:
        return 0
    exponent = draft.fact(**exponent_keys(draft, kind))
    for field in scaled:
        field["scale_by"] = exponent["name"]
    fields.insert(draft.number(0, len(fields)), exponent)
    return 2 if kind == "i16" else 1


def body(draft: Draft, place: str = "field") -> list[Spec]:
    """The fields of a request or a response."""
    form = draft.pick(
        (
            *("fixed", "empty", "repeat", "measured", "choice", "counted", "short", "line", "inner", "lists", "texts"),
            "optional",
            "continued",
        )
    )
    if form in ("empty", "short"):
        return [short_field(draft) for _ in range(draft.number(1, 3) if form == "short" else 0)]
    if form in ("line", "texts"):
        return _line(draft) if form == "line" else _texts_with_sizes(draft)
    fields = [draft.bounded(fixed_field(draft)[0], 8) for _ in range(draft.number(0 if form != "fixed" else 1, 4))]
    if form not in ("fixed", "counted", "repeat") and draft.chance(15):
        fields = _text_between(draft, fields)
    if form in ("fixed", "repeat") and draft.chance(20):
        add_exponent(draft, fields, draft.pick(("i8", "i16")))
    if form == "repeat":
        return [*fields, _repeated(draft, fields)]
    if form in ("measured", "inner"):
        if form == "inner" and draft.differing and draft.chance(30):
            fields = [*fields, _differing(draft)]
        has_count = form == "measured" or draft.chance(70)
        behind = [fixed_field(draft)[0] for _ in range(draft.number(1, 3))] if form == "inner" else []
        if behind and has_count and draft.differing and draft.chance(20):
            return [*fields, _differing(draft), *behind]
        return [*(_measured(draft, fields) if has_count else [*fields, _repeated(draft, fields)]), *behind]
    if form == "lists":
        return _lists(draft, fields)
    if form == "optional":
        return _optional_at_end(draft, _optional_between(draft, fields))
    if form == "continued":
        return _continued_between(draft, fields)
    if form == "choice":
        return _choosing(draft, fields)
    if form == "counted":
        return _counting(draft, fields)
    return fields


def _line(draft: Draft) -> list[Spec]:
    """Values that vary in width with what separates them, between other fields."""
    fields: list[Spec] = []
    for number in range(draft.number(1, 4)):
        if number and draft.chance(80):
            fields.append(draft.fact(type="u8", const=draft.pick((0x2C, 0x3B, 0x20, 0x2F, 0x0A))))
        elif number:
            fields.append(draft.fact(type="u8", const=0x3A))
            fields.append(fixed_field(draft)[0])
        fields.append(draft.fact(**varying_value(draft)))
    if draft.chance(30):
        fields.append(draft.fact(type="u8", const=0x0D))
        fields += [fixed_field(draft)[0] for _ in range(draft.number(0, 2))]
    return fields


def _texts_with_sizes(draft: Draft) -> list[Spec]:
    """Texts, each after the field with its number of bytes; now and then a value with an end of its own is last."""
    counts: list[Spec] = []
    rest: list[Spec] = []
    for _ in range(draft.number(1, 3)):
        text = draft.fact(**varying_text(draft))
        count = text_counter(draft, text)
        (counts if draft.chance(25) else rest).append(count)
        rest += [fixed_field(draft)[0] for _ in range(draft.number(0, 1))] if draft.chance(30) else []
        rest.append(text)
        rest += [fixed_field(draft)[0]] if draft.chance(40) else []
    if draft.chance(20):
        rest.append(draft.fact(**varying_value(draft)))
    return [*counts, *rest]


def _limits(draft: Draft) -> str:
    low = draft.number(0, 3)
    return f"{low}..{low + draft.number(1, 20)}"


def _repeated(draft: Draft, fields: list[Spec], low_limits: bool = False) -> Spec:
    """A field that goes on to the end; in a record that counts it, a short one of elements of one size."""
    if draft.differing and not low_limits and draft.chance(40):
        return _differing(draft, f"{draft.number(0, 1)}..{draft.number(1, 4)}")
    nested = [record for record in draft.records if not record.apart]
    if nested and draft.chance(25):
        return draft.fact(record=draft.pick(nested).name, repeat=_limits(draft))
    limits = {"repeat": f"0..{draft.number(1, 6)}" if low_limits else _limits(draft)}
    if draft.chance(25):
        return packed_list(draft, limits, least=8)
    keys = {k: v for k, v in value(draft, "field").items() if k not in ("const", "default", "unit_default")}
    return draft.fact(**keys, **limits)


def _measured(draft: Draft, fields: list[Spec]) -> list[Spec]:
    """A number of elements or bytes somewhere before the repeat that it counts."""
    repeated = _repeated(draft, fields)
    measure = _counter(draft, repeated, ("u16", "u8", "u32"))
    return [*_inserted(draft, fields, measure), repeated]


def _counter(draft: Draft, repeated: Spec, kinds: tuple[str, ...]) -> Spec:
    """The number of a list before it; of elements that differ in size, now and then that of their bytes."""
    if repeated.get("record") in draft.differing and draft.chance(50):
        return _byte_counter(draft, repeated)
    return list_counter(draft, repeated, _measure(draft, repeated), kinds)


def _byte_counter(draft: Draft, differing: Spec) -> Spec:
    """The number of bytes of a record that differs in size, or of all elements of a list of such records."""
    plus = {"plus": draft.pick((1, 2, 5))} if draft.chance(25) else {}
    return draft.fact(type=draft.pick(("u8", "u16")), measures={"bytes": differing["name"], **plus})


def _measure(draft: Draft, field: Spec) -> Spec:
    """What a field contains that counts another one, now and then with a constant number in addition."""
    least = int(str(field.get("repeat", 0)).partition("..")[0])
    plus = draft.pick((-1, 1, 2, 5) if least else (1, 2, 5)) if draft.chance(25) else 0
    is_apart = field.get("record") in draft.differing or "packed_bits" in field
    what = "items" if is_apart else draft.pick(("items", "bytes"))
    return {what: field["name"], **({"plus": plus} if plus else {})}


def _lists(draft: Draft, fields: list[Spec]) -> list[Spec]:
    """Several lists, each after the field that counts it; the last one may be counted by nothing."""
    for number in range(draft.number(2, 3)):
        repeated = _repeated(draft, fields)
        if number and draft.chance(15):
            return [*fields, repeated, *_behind(draft)]
        measure = list_counter(draft, repeated, _measure(draft, repeated), ("u8", "u16"))
        fields = [*_inserted(draft, fields, measure), repeated]
        if draft.chance(15):
            fields.append(packed_list(draft, {"count": draft.number(1, 9)}))
        if draft.chance(20) and "bits" not in measure["measures"]:
            fields.append(draft.fact(type="u16", measures=_measure(draft, repeated)))
    return [*fields, *(fixed_field(draft)[0] for _ in range(draft.number(0, 2)))]


def _counting(draft: Draft, fields: list[Spec]) -> list[Spec]:
    """The size of a field whose size is fixed, before or after it."""
    countable = [field for field in fields if not ({"reserved", "const", "measures"} | BOUNDS) & set(field)]
    if not countable:
        return fields
    other = draft.pick(countable)
    sent = count_type(draft, ("u16", "u8"))
    return _inserted(draft, fields, draft.fact(**sent, measures=_measure(draft, other)))


def _inserted(draft: Draft, fields: list[Spec], field: Spec) -> list[Spec]:
    at = draft.number(0, len(fields))
    return [*fields[:at], field, *fields[at:]]


def _choice_between(draft: Draft, fields: list[Spec]) -> list[Spec]:
    """Fields with one behind them whose type another one decides, and some behind that, now and then."""
    decided = deciding_fields(draft)
    if decided is None:
        return fields
    selector, choice = decided
    leave_empty(draft, choice)
    before = _inserted(draft, fields, selector)
    before = _inserted(draft, before, choice_counter(draft, choice)) if draft.chance(40) else before
    return [*before, choice, *_behind(draft)]


def _optional_between(draft: Draft, fields: list[Spec]) -> list[Spec]:
    """Fields with the one that decides on optional ones behind them, and some behind these, now and then."""
    decider, ways = presence_decider(draft)
    optional = [field for way in ways for field in [optional_field(draft, way), *_behind(draft)]]
    return [*_inserted(draft, fields, decider), *optional]


def _optional_at_end(draft: Draft, fields: list[Spec]) -> list[Spec]:
    """Fields with an optional list at the end, now and then."""
    if not draft.chance(40):
        return fields
    presence = draft.pick([field["present_if"] for field in fields if "present_if" in field])
    repeated = _repeated(draft, fields, low_limits=True) | {"repeat": f"1..{draft.number(1, 6)}"}
    repeated["present_if"] = presence
    return fields if "packed_bits" in repeated else [*fields, repeated, *_behind(draft)]


def _choosing(draft: Draft, fields: list[Spec]) -> list[Spec]:
    """A last field whose type an enum decides, or one with others behind it."""
    if draft.chance(40):
        repeated = _repeated(draft, fields)
        lists = [_counter(draft, repeated, ("u8",)), repeated] if draft.chance(30) else []
        return _choice_between(draft, [*fields, *lists])
    decided = deciding_fields(draft)
    if decided is None:
        return fields
    selector, last = decided
    cases = last["choice"]["cases"]
    # How often a constant is repeated is not a value of C's self-test.
    is_wide = "bits" in last["choice"] and selector["type"] != "u8"
    if draft.chance(50) and not is_wide and not any("const" in case for case in cases):
        last["repeat"] = _limits(draft)
    if "repeat" not in last:
        leave_empty(draft, last)
    before = _inserted(draft, fields, selector)
    if "repeat" in last and draft.chance(50):
        measure = draft.fact(type="u8", measures={"items": last["name"]})
        before = _inserted(draft, before, measure)
    elif "repeat" not in last and draft.chance(40):
        before = _inserted(draft, before, choice_counter(draft, last))
    return [*before, last]


def telegram(draft: Draft) -> list[Spec]:
    """A body of signals and other fields."""
    names = [name for name in draft.signals if draft.chance(60)]
    placed = [{"signal": name, "source": draft.source()} for name in names]
    own = [draft.bounded(fixed_field(draft)[0], 8) for _ in range(draft.number(0, 2))]
    return [*placed, *own]
