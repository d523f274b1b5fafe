"""Random spaces, registers, tables of records, and numbered parameters."""

from __future__ import annotations

from random_devices.draft import ODD_INTEGERS, Draft, Spec
from random_devices.drawn_records import exponent_keys, may_be_scaled
from random_devices.drawn_values import has_words, size_of, value

ACCESSES = ("rw", "ro", "rw", "wo")


def spaces(draft: Draft) -> list[Spec]:
    """No space, or some with the same addresses, of words, bytes and bits; the first one is of words."""
    if not draft.chance(50):
        return []
    drawn = [draft.fact() for _ in range(draft.number(1, 4))]
    for at, space in enumerate(drawn):
        if at and draft.chance(60):
            space["unit"] = draft.pick(("bit", "byte", "bit"))
        if draft.chance(40):
            space["first_number"] = draft.pick((0, 1, 30001, 40001))
        if draft.chance(20):
            space["bounds"] = "0..0xEFFF"
    return drawn


def register_groups(draft: Draft) -> list[Spec]:
    """Groups of registers in ascending order, with gaps that are declared."""
    words = [space["name"] for space in draft.spec.get("spaces", []) if space.get("unit", "word") == "word"]
    free = dict.fromkeys(words or [""], draft.number(0, 0x2000))
    bits = [space["name"] for space in draft.spec.get("spaces", []) if space.get("unit") == "bit"]
    memories = [space["name"] for space in draft.spec.get("spaces", []) if space.get("unit") == "byte"]
    return [
        *(_group(draft, free) for _ in range(draft.number(0, 3))),
        *(_byte_group(draft, space) for space in memories if draft.chance(80)),
        *(_bit_group(draft, space) for space in bits if draft.chance(80)),
    ]


def _byte_group(draft: Draft, space: str) -> Spec:
    """A group of registers in a space of bytes, some of them at odd addresses."""
    at = draft.number(0, 0x2000)
    group: Spec = {"group": draft.name(), "source": draft.source(), "space": space, "rows": []}
    for _ in range(draft.number(1, 6)):
        row, size = _register(draft, at, 1)
        group["rows"].append(row)
        at += size
    return group


def _bit_group(draft: Draft, space: str) -> Spec:
    """A group of single bits and of arrays of bits, in a space of bits."""
    group: Spec = {"group": draft.name(), "source": draft.source(), "space": space, "rows": []}
    at = draft.number(0, 0x2000)
    gaps = []
    for _ in range(draft.number(1, 5)):
        row = {"at": at, **draft.fact(type="bit"), "access": draft.pick(ACCESSES)}
        if draft.chance(20):
            row["default"] = draft.number(0, 1)
        if draft.chance(10) and row["access"] != "ro":
            row["trigger"] = True
        at += 1
        if draft.chance(40):
            row["count"] = draft.number(2, 20)
            row["stride"] = draft.pick((1, 1, 3))
            at += (row["count"] - 1) * row["stride"]
        group["rows"].append(row)
        if draft.chance(15):
            gaps.append({"at": f"{at}..{at + 2}", "reason": "The manual leaves them out."})
            at += 3
    if gaps and at > 0:
        group["gaps"] = gaps
    return group


def _group(draft: Draft, free: dict[str, int]) -> Spec:
    space = draft.pick(list(free))
    at = free[space] + (draft.number(0, 99) if draft.chance(40) else 0)
    group: Spec = {"group": draft.name(), "source": draft.source(), "rows": []}
    if space and draft.chance(90):
        group["space"] = space
    elif space:
        at, space = free[next(iter(free))], next(iter(free))
    gaps = []
    if draft.chance(25):
        group["defaults"] = draft.pick(
            ({"access": draft.pick(ACCESSES)}, {"checked": {"words": 1}, "atomic": False, "trigger": False})
        )
    for _ in range(draft.number(1, 6)):
        if draft.chance(15) and group["rows"]:
            gaps.append(f"{at}..{at + 3}")
            at += 4
        row, words = _register(draft, at)
        group["rows"].append(row)
        at += words
    scaled = [row for row in group["rows"] if may_be_scaled(row)]
    if scaled and draft.chance(40):
        exponent = {"at": at, **draft.fact(**exponent_keys(draft, "i16")), "checked": {"words": 1}}
        exponent["access"] = draft.pick(("ro", "rw"))
        for row in scaled:
            row["scale_by"] = exponent["name"]
        group["rows"].append(exponent)
        draft.exponents.setdefault(space, exponent["name"])
        at += 1
    if gaps:
        group["gaps"] = [{"at": gap, "reason": "The manual leaves them out."} for gap in gaps]
    elif draft.chance(30) and "scale_by" not in {key for row in group["rows"] for key in row}:
        _repeat_block(draft, group, at)
        at += at - group["rows"][0]["at"]
    row = group["rows"][0]
    if len(group["rows"]) == 1 and "copies" not in group and row["access"] != "ro" and has_words(row):
        order = row.pop("write_word_order", _other_order(draft, row))
        group["defaults"] = {**group.get("defaults", {}), "write_word_order": order}
    free[space] = at
    return group


def _other_order(draft: Draft, row: Spec) -> str:
    """The order of words that a value has not got when it is read."""
    order = row.get("word_order") or draft.word_order or row.get("byte_order", draft.byte_order)
    return "little" if order == "big" else "big"


def _repeat_block(draft: Draft, group: Spec, at: int) -> None:
    """Adds a block to a group that repeats all of its registers after it."""
    stated: Spec = {"group": draft.name(), "prefix": f"stored_{draft.names}", "base": at, "source": draft.source()}
    if draft.chance(50) and not any(
        {"write_range", "write_word_order", "const", "trigger"} & set(row) for row in group["rows"]
    ):
        stated["access"] = "ro"
    if draft.chance(50):
        offset = at - group["rows"][0]["at"]
        stated["rows"] = [
            {"of": row["name"], "at": row["at"] + offset, "source": draft.source()} for row in group["rows"]
        ]
    group["copies"] = [stated]


def _register(draft: Draft, at: int, unit_size: int = 2) -> tuple[Spec, int]:
    keys = value(draft, "register", ODD_INTEGERS if unit_size == 1 and draft.chance(25) else ())
    words = -(-size_of(keys) // unit_size)
    access = draft.pick(ACCESSES)
    row = {"at": at, **draft.fact(), **keys, "access": access} | (
        {"checked": {"words": words}} if unit_size == 2 else {}
    )
    if "write_range" in keys:
        row["access"] = access = "rw"
    if draft.chance(12) and access != "ro":
        row["trigger"] = True
    if draft.chance(8) and words > 1:
        row["atomic"] = True
    if draft.chance(30) and access != "ro" and has_words(keys):
        row["write_word_order"] = _other_order(draft, row)
    if draft.chance(6) and set(row) <= {"at", "name", "source", "type", "access", "checked", "length"}:
        row["reserved"] = True
    if draft.chance(4):
        row["restart"] = True
    if draft.chance(4) and access != "wo":
        row["clears_on_read"] = True
    if draft.chance(10) and words == 1:
        row["checked"] = {**row.get("checked", {}), "decimal": at}
    if draft.chance(12):
        row["count"] = draft.number(2, 4)
        if draft.chance(40):
            row["index_from"] = draft.number(0, 3)
        if draft.chance(30):
            row["stride"] = words + draft.number(0, 2)
        return row, (row["count"] - 1) * row.get("stride", words) + words
    return draft.bounded(row, 5), words


def tables(draft: Draft) -> list[Spec]:
    """Tables of the records that consist of whole registers, after all registers; later ones may have earlier ones."""
    drawn = []
    at = 0x4000
    spaces_of_words = [s["name"] for s in draft.spec.get("spaces", []) if s.get("unit", "word") == "word"]
    for record in [record for record in draft.records if record.words and record.size][-2:]:
        if not draft.chance(60):
            continue
        count = draft.number(1, 4)
        table = draft.fact(base=at, stride=record.size // 2 + draft.number(0, 3), count=count, record=record.name)
        if draft.chance(60):
            table["access"] = draft.pick(("rw", "ro", "rw", "ro", "wo"))
        if draft.chance(40):
            table["index_from"] = draft.number(0, 2)
        if spaces_of_words:
            table["space"] = draft.pick(spaces_of_words)
        exponent = draft.exponents.get(table.get("space", ""))
        if exponent and draft.chance(60):
            fields = next(own["fields"] for own in draft.spec["records"] if own["name"] == record.name)
            for field in fields:
                if may_be_scaled(field) and "scale_by" not in field and all(exponent != own["name"] for own in fields):
                    field["scale_by"] = exponent
        if draft.chance(40):
            table["count_by"] = _add_count(draft, at - 4, count, table.get("space", ""))
        if draft.chance(20):
            table["base_by"] = _add_base(draft, at - 6, table)
        drawn.append(table)
        at += table["stride"] * count + 8
    return drawn


def _add_count(draft: Draft, at: int, count: int, space: str) -> str:
    """Adds a register with the number of elements of a table, in a group of its own."""
    row = {"at": at, **draft.fact(type="u16", checked={"words": 1}, range=f"0..{count}", default=count), "access": "rw"}
    group: Spec = {"group": draft.name(), "source": draft.source(), "rows": [row]}
    draft.spec.setdefault("registers", []).append(group | ({"space": space} if space else {}))
    return str(row["name"])


def _add_base(draft: Draft, at: int, table: Spec) -> str:
    """Adds a register with the address of the first element of a table, in a group of its own."""
    words = table["stride"] * table["count"]
    row = {
        "at": at,
        **draft.fact(type="u16", checked={"words": 1}, range=f"{table['base']}..{0xEFFF - words}"),
        "access": "ro",
    }
    group: Spec = {"group": draft.name(), "source": draft.source(), "rows": [row]}
    draft.spec.setdefault("registers", []).append(group | ({"space": table["space"]} if "space" in table else {}))
    return str(row["name"])


def parameters(draft: Draft) -> list[Spec]:
    """Sets of numbered parameters, alone or several that share their numbers on the wire."""
    drawn = []
    shared = draft.chance(30)
    for place in range(draft.number(0, 2)):
        rows: list[Spec] = []
        at = draft.number(0, 20)
        for _ in range(draft.number(1, 5)):
            rows.append(_parameter(draft, at))
            at += rows[-1].get("count", 1) + (draft.number(0, 5) if draft.chance(4) else 0)
        parameter_set = draft.fact(rows=rows)
        if draft.chance(15):
            parameter_set["defaults"] = {"access": draft.pick(ACCESSES)}
        if shared:
            parameter_set |= {"space": "pnu", "base": 0x1000 * place, "numbers": "0..0xFFF"}
        drawn.append(parameter_set)
    return drawn


def _parameter(draft: Draft, at: int) -> Spec:
    keys = value(draft, "parameter")
    row = {"number": at, **draft.fact(), **keys, "access": draft.pick(("rw", "ro", "rw", "rw", "ro", "wo"))}
    if "write_range" in keys:
        row["access"] = "rw"
    if draft.chance(15) and row["access"] == "rw":
        row["trigger"] = True
    if draft.chance(5):
        row["restart"] = True
    if draft.chance(8) and not {"default", "unit_default", "const"} & set(row):
        row = {"number": at, **draft.fact(), "type": row["type"], "reserved": True}
        if draft.chance(50):
            row["count"] = draft.number(2, 4)
    elif draft.chance(25):
        row["elements"] = draft.number(2, 6)
        if draft.chance(70):
            inner = draft.fact(index=0, type=draft.pick((row["type"], "u8", "i32", "u24")))
            if draft.chance(60):
                inner["access"] = draft.pick(("rw", "ro", "wo"))
            rest = draft.fact(index=f"1..{row['elements'] - 1}", type=row["type"], reserved=True)
            row["subindices"] = [inner, rest] if row["elements"] > 2 else [inner, {**rest, "index": 1}]
    return row
