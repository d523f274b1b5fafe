"""What tells the version of a random device that has several: a register, a parameter, or a field of a response."""

from __future__ import annotations

from random_devices.draft import BOUNDS, Draft, Spec


def tell_versions(draft: Draft) -> None:
    """A register, a parameter or a field of a response may tell the version of the device."""
    if not draft.versions or not draft.chance(60):
        return
    spec = draft.spec
    rows = [(f"registers/{row['name']}", row) for group in spec.get("registers", []) for row in group["rows"]]
    rows += [
        (f"parameters/{own['name']}/{row['name']}", row) for own in spec.get("parameters", []) for row in own["rows"]
    ]
    rows += [
        (f"messages/{message['name']}/response/{field['name']}", field)
        for message in spec["messages"]
        for field in message.get("response", ())
        if "name" in field and not BOUNDS & set(message)
    ]
    barred = BOUNDS | {"count", "repeat", "reserved", "const", "trigger", "elements", "varies"}
    telling = [
        (path, row)
        for path, row in rows
        if row.get("type") in ("u8", "u16", "u32", "text")
        and not barred & set(row)
        and row.get("access") != "wo"
        and "same_as" not in row
    ]
    if not telling:
        return
    path, row = draft.pick(telling)
    detected: Spec = {"fact": path, "source": draft.source()}
    is_text = row["type"] == "text"
    if not is_text and draft.chance(50):
        detected["form"] = draft.pick(("decimal", "hexadecimal", "bytes"))
        if draft.chance(50) and detected["form"] != "bytes":
            detected["places"] = draft.number(1, 2)
    line = spec["versions"][0]
    line["detected_by"] = detected
    if "form" not in detected:
        for number, member in enumerate(line["members"]):
            member["detected_as"] = [f"V{number}" if is_text else 10 + number]
