"""The same device in other words: what a form of a spec means, as a spec that states it without that form.

A version is a spec without bounds; copies and derived members are listed; bits of registers are words; an overlay has
the differences of two versions; a protocol has what `uses` takes from it; bits may be counted from the other end; and
frames that are the same both ways may be stated once.
"""

from __future__ import annotations

import copy
import random
from collections.abc import Iterator
from typing import Any

from random_devices.draft import BOUNDS, SIZES, Spec
from random_devices.drawn_words import count_from_other_end

Files = dict[str, Spec]
"""The files of a project by path."""

LINE = "firmware"
DEVICE, PROTOCOL, INNER = "chance/device.yaml", "protocols/shared.yaml", "protocols/inner.yaml"
_OF_PROTOCOL = ("links", "messages", "records", "enums")
_TEXTS = ("doc", "label", "notes")
_OF_DEVICES = (*_TEXTS, "broadcast", "unit_addresses", "silence", "open", "unit", "range")
"""The keys that a device may state of what it takes from a protocol."""
_OF_DERIVED = ("name", "label", "doc", "source")
_OF_COPIES = ("name", "at", "checked", "access", "trigger", "restart", "source", "clears_on_read", "label", "notes")


def flat(spec: Spec, version: str = "") -> Spec:
    """A spec without bounds, whose facts are those of one version, and with everything listed that follows from others.

    It declares the same versions, which are all alike.
    """
    own = _bare(copy.deepcopy(spec), version)
    for enum in own.get("enums", ()):
        derived = enum.pop("derived", None)
        if derived is not None:
            enum["members"] = [*enum.get("members", ()), *_derived(own, derived)]
    groups = []
    for group in own.get("registers", ()):
        for row in group["rows"]:
            if "bits" in row:
                kind = row.get("type") or group["defaults"]["type"]
                word = {"name": row["name"], "type": kind, "source": row["source"], "bits": row.pop("bits")}
                own["flags"] = [*own.get("flags", ()), word]
                row["flags"] = row["name"]
        copies = group.pop("copies", ())
        first = next(stated["rows"][0]["at"] for stated in spec["registers"] if stated["group"] == group["group"])
        groups += [group, *(_copy(group, first, each) for each in copies)]
    return {**own, "registers": groups} if groups else own


def _bare(node: Any, version: str) -> Any:
    """A part of a spec without the facts of other versions, and without bounds."""
    if isinstance(node, dict):
        return {key: _bare(inner, version) for key, inner in node.items() if key not in BOUNDS}
    if isinstance(node, list):
        return [_bare(item, version) for item in node if applies(item, version)]
    return node


def applies(fact: Any, version: str) -> bool:
    """Whether a fact is one of a version; versions rise in the order of their numbers."""
    if not isinstance(fact, dict) or not version:
        return True
    within = fact.get("since", version) <= version <= fact.get("until", version)
    return bool(within and version in fact.get("only", [version]))


def _derived(spec: Spec, derived: Spec) -> Iterator[Spec]:
    if "flags" in derived:
        word = next(word for word in spec["flags"] if word["name"] == derived["flags"])
        for bit in word["bits"]:
            if "bit" in bit and "name" in bit and not bit.get("reserved"):
                place = bit["bit"] if word.get("bit_0") != "most" else 8 * SIZES[word["type"]] - 1 - bit["bit"]
                yield {key: bit[key] for key in _OF_DERIVED if key in bit} | {"value": 1 << place}
        return
    other = next(enum for enum in spec["enums"] if enum["name"] == derived["enum"])
    for member in other["members"]:
        if "number" in member:
            yield {key: member[key] for key in _OF_DERIVED if key in member} | {"value": member["number"]}


def _copy(group: Spec, first: int, stated: Spec) -> Spec:
    """The group that repeats another one at another address, which is that of the `first` row of all versions."""
    rows, sources = [], {row["of"]: row["source"] for row in stated.get("rows", ())}
    for row in group["rows"]:
        own = {"at": row["at"] - first + stated["base"], "name": f"{stated['prefix']}_{row['name']}"}
        own |= {key: value for key, value in row.items() if key not in _OF_COPIES}
        own |= {key: inner for key in ("access", "trigger") if (inner := stated.get(key, row.get(key))) is not None}
        own |= {"checked": {"words": row["checked"]["words"]}} if "words" in row.get("checked", {}) else {}
        own |= {"source": sources[row["name"]]} if row["name"] in sources else {}
        rows.append({**own, "copy_of": row["name"]})
    result = {"group": stated["group"], "source": stated["source"], "rows": rows}
    return result | {key: group[key] for key in ("space", "defaults") if key in group}


def with_bits_from_most(spec: Spec) -> Spec | None:
    """A spec whose words count their bits from the other end; None for one without words."""
    if not spec.get("flags"):
        return None
    own = copy.deepcopy(spec)
    for word in own["flags"]:
        highest = 8 * SIZES[word["type"]] - 1
        word["bit_0"] = "least" if word.get("bit_0") == "most" else "most"
        for bit in word["bits"]:
            count_from_other_end(bit, highest)
    return own


def with_frames(spec: Spec) -> Spec | None:
    """A spec whose links state equal requests and responses once; None for one without such a link."""
    own = copy.deepcopy(spec)
    for link in own["links"]:
        if link["request"] == link["response"]:
            link["frame"] = link.pop("request")
            del link["response"]
    return own if own != spec else None


def split(spec: Spec, dice: random.Random) -> Files:
    """The files of a device that takes some of its links, messages, records and enums from a protocol.

    Of some of these, the device states keys of its own, also such as the protocol states otherwise. The protocol may
    have a link that the device does not take, its enums may be those of a protocol that it uses itself, and frames may
    be stated once.
    """
    framed = with_frames(spec) if dice.random() < 0.5 else None
    own = _bare(framed or spec, "")  # messages share fields, of which each gets keys of its own
    protocol: Spec = {"protocol": {"id": "shared", "title": "What several devices share"}}
    counts = {section: len(own.get(section, ())) for section in _OF_PROTOCOL}
    if dice.random() < 0.4:
        counts["messages"] = dice.randint(0, counts["messages"])
    for section, count in counts.items():
        taken, left = own.get(section, [])[:count], own.get(section, [])[count:]
        protocol[section] = taken
        entries = [_own_entry(item, dice) for item in taken if section != "records" and dice.random() < 0.5]
        own[section] = [*entries, *left]
    use: Spec = {"protocol": "shared"}
    if dice.random() < 0.5:
        use["links"] = [link["name"] for link in protocol["links"]]
        other = copy.deepcopy(protocol["links"][0])
        protocol["links"].insert(0, {**other, "name": f"{other['name']}_of_others"})
    files = {DEVICE: {**own, "uses": [use]}, PROTOCOL: protocol}
    if protocol["enums"] and dice.random() < 0.5:
        files[INNER] = {"protocol": {"id": "inner", "title": "What protocols share"}, "enums": protocol.pop("enums")}
        protocol["uses"] = [{"protocol": "inner"}]
    return {path: {key: inner for key, inner in content.items() if inner} for path, content in files.items()}


def _own_entry(item: Spec, dice: random.Random) -> Spec:
    """The entry of a device for what it takes from a protocol, with keys that are not in the protocol, or otherwise."""
    entry = _moved(item, dice)
    for direction in ("request", "response"):
        fields = item.get(direction, ())
        if "code" in item and fields and all("name" in field for field in fields) and dice.random() < 0.5:
            entry[direction] = [_moved(dice.choice(fields), dice)]
    return entry


def _moved(item: Spec, dice: random.Random) -> Spec:
    entry = {"name": item["name"], "source": item["source"]}
    for key in _OF_DEVICES:
        if key in item and dice.random() < 0.7:
            entry[key] = item.pop(key)
            if key in _TEXTS and dice.random() < 0.5:
                item[key] = "Other devices have another one."
    return entry


# Overlays


def overlaid(spec: Spec, dice: random.Random) -> tuple[Files, Spec] | None:
    """The files of a device whose second version is an overlay of the first, and that version as a flat spec.

    The overlay has what the bounds of the spec say, and some more changes. None where it cannot say it.
    """
    first, second = (member["id"] for member in spec["versions"][0]["members"])
    entries: Spec = {"changes": [], "removes": [], "adds": [], "renames": []}
    copied = {f"registers/{group['group']}" for group in spec.get("registers", ()) if group.get("copies")}
    why = {"reason": "The notes of the release say so.", "source": "1 L1"}
    for place, before, items in _lists(spec):
        has_order = place.partition("/")[0] in ("registers", "enums")
        last, is_known = "", False
        for item in items:
            path = f"{before}/{item['name']}" if "name" in item else ""
            was, is_now = applies(item, first), applies(item, second)
            if was != is_now and place in copied:
                return None  # the flat base lists the copies, which the overlay would have to change, too
            if was and not is_now:
                entries["removes"].append({"fact": path, **why})
            if is_now and not was:
                if not has_order and not is_known:
                    return None  # an overlay puts a fact after one of the base
                added = {key: inner for key, inner in item.items() if key not in BOUNDS}
                behind = {} if has_order else {"after": last.rpartition("/")[2]}
                entries["adds"].append({"in": place, "item": flat_item(added, second), **behind, **why})
            last, is_known = (path, bool(was and path)) if is_now else (last, is_known)
    base, changed = flat(spec, first), flat(spec, second)
    for path, fact in dice.sample(changeable := list(_changeable(changed)), min(3, len(changeable))):
        if dice.random() < 0.6:
            unit = dice.choice(("kg", "A", "Hz"))
            entries["changes"].append({"fact": path, "set": {"unit": {"was": fact["unit"], "is": unit}}, **why})
            fact["unit"] = unit
        elif str(changed).count(f"'{fact['name']}'") == 1:
            entries["renames"].append({"fact": path, "to": f"{fact['name']}_renamed", **why})
            fact["name"] += "_renamed"
    added = [path for entry in entries["adds"] if (path := entry["in"])]
    if any(entry["fact"].startswith(f"{path}/") for entry in entries["changes"] + entries["renames"] for path in added):
        return None  # a path of an overlay is one of the base
    if not any(entries.values()):
        return None
    member = base["versions"][0]["members"].pop()
    head = {**member, "id": second, "line": LINE, "based_on": first}
    overlay = {"overlay": head, **{key: inner for key, inner in entries.items() if inner}}
    return {DEVICE: base, f"chance/versions/{second}.yaml": overlay}, changed


def flat_item(item: Spec, version: str) -> Spec:
    """A fact of a version without bounds in it."""
    bare: Spec = _bare(item, version)
    return bare


def _lists(spec: Spec) -> Iterator[tuple[str, str, list[Spec]]]:
    """The lists of facts that may have bounds: the path of each, that which its items begin with, and these."""
    yield "messages", "messages", spec["messages"]
    for section, key in (("records", "fields"), ("enums", "members"), ("flags", "bits")):
        for fact in spec.get(section, ()):
            yield f"{section}/{fact['name']}", f"{section}/{fact['name']}", fact.get(key, [])
    for message in spec["messages"]:
        if not BOUNDS & set(message):
            for direction in ("request", "response"):
                place = f"messages/{message['name']}/{direction}"
                yield place, place, message.get(direction, [])
    for group in spec.get("registers", ()):
        yield f"registers/{group['group']}", "registers", group["rows"]


def _changeable(spec: Spec) -> Iterator[tuple[str, Spec]]:
    """The facts of a flat spec whose unit or name may be another one."""
    for _, before, items in _lists(spec):
        for item in items:
            if "unit" in item and "name" in item and "unit_range" not in item and before.split("/")[0] != "flags":
                yield f"{before}/{item['name']}", item
