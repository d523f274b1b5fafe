"""What a careful person would write by hand for one device with registers, and nothing else: `floor.py SPEC OUT`.

It reads the YAML of `registers.py` with the line of every value, tests what would break the outputs, and writes a C
header, Markdown and a Python module from strings. It knows no other key, no versions and no errata, and proves nothing.
"""

from __future__ import annotations

import gc
import os
import sys

from yaml import _yaml
from yaml.events import MappingEndEvent, MappingStartEvent, ScalarEvent, SequenceEndEvent, SequenceStartEvent

gc.disable()
ACCESS = {"ro", "rw", "wo"}
SIZES = {"u16": 65_535, "i16": 32_767, "u32": 4_294_967_295}


class Mapping(dict):  # type: ignore[type-arg]
    """Values by key, with the line of each key."""

    __slots__ = ("lines",)


def load(data: bytes) -> Mapping:
    """The tree of a document, each mapping with its lines."""
    parser = _yaml.CParser(data)
    get = parser.get_event
    for _ in range(2):
        get()

    def node(event):  # type: ignore[no-untyped-def]
        kind = event.__class__
        if kind is ScalarEvent:
            text = event.value
            if event.implicit[0]:
                if text.isdecimal():
                    return int(text)
                if text[:2] == "0x":
                    return int(text, 16)
            return text
        if kind is MappingStartEvent:
            node_mapping = Mapping()
            node_mapping.lines = lines = {}
            event = get()
            while event.__class__ is not MappingEndEvent:
                key = event.value
                if key in node_mapping:
                    sys.exit(f"{event.start_mark.line + 1}: the key {key} is there twice")
                lines[key] = event.start_mark.line + 1
                node_mapping[key] = node(get())
                event = get()
            return node_mapping
        assert kind is SequenceStartEvent
        items = []
        event = get()
        while event.__class__ is not SequenceEndEvent:
            items.append(node(event))
            event = get()
        return items

    root: Mapping = node(get())
    return root


def checked(tree: Mapping) -> list[Mapping]:
    """The registers of a tree without faults."""
    enums = {enum["name"]: {member["value"] for member in enum["members"]} for enum in tree["enums"]}
    flags = {word["name"] for word in tree["flags"]}
    registers: list[Mapping] = [row for group in tree["registers"] for row in group["rows"]]
    names: set[str] = set()
    free = 0
    faults = []
    for row in registers:
        line = row.lines["name"]
        if row["name"] in names or not row["name"].isidentifier():
            faults.append(f"{line}: the name {row['name']} is there twice, or is none")
        names.add(row["name"])
        if row["at"] < free:
            faults.append(f"{line}: {row['name']} lies on the one before it")
        free = row["at"] + (2 if row["type"] == "u32" else 1)
        if row["access"] not in ACCESS or row["type"] not in SIZES:
            faults.append(f"{line}: {row['name']} has an unknown access or type")
        if "range" in row:
            low, _, high = row["range"].partition("..")
            if not 0 <= int(low) <= row.get("default", 0) <= int(high) <= SIZES[row["type"]]:
                faults.append(f"{line}: the range of {row['name']} does not fit")
        if row.get("enum", "") and row["enum"] not in enums:
            faults.append(f"{line}: there is no enum {row['enum']}")
        if row.get("flags", "") and row["flags"] not in flags:
            faults.append(f"{line}: there is no word {row['flags']}")
    if faults:
        sys.exit("\n".join(faults))
    return registers


def header(tree: Mapping, registers: list[Mapping]) -> str:
    """A C header: addresses, ranges, values and masks."""
    lines = ["#pragma once", "#include <stdint.h>", ""]
    for enum in tree["enums"]:
        members = ", ".join(
            f"{enum['name'].upper()}_{member['name'].upper()} = {member['value']}" for member in enum["members"]
        )
        lines.append(f"enum {enum['name']} {{ {members} }};")
    for word in tree["flags"]:
        lines += [f"#define {word['name'].upper()}_{b['name'].upper()} (1u << {b['bit']})" for b in word["bits"]]
    for row in registers:
        name = row["name"].upper()
        label = row["label"].replace("*/", "* /")
        lines.append(f"/* {label}; {row.get('doc', '')} {row['source']} */")
        lines.append(f"#define {name}_ADDRESS 0x{row['at']:04X}u")
        if "range" in row:
            low, _, high = row["range"].partition("..")
            lines += [f"#define {name}_MIN {low}", f"#define {name}_MAX {high}"]
    return "\n".join(lines) + "\n"


def markdown(tree: Mapping, registers: list[Mapping]) -> str:
    """Tables of registers, enums and words."""
    titles = "| address | name | label | type | range | unit | source |"
    lines = [f"# {tree['device']['name']}", "", titles, "|" + "---|" * 7]
    for row in registers:
        label = row["label"].replace("|", "\\|")
        unit = f"{row['scale']} {row['unit']}" if "unit" in row else ""
        lines.append(
            f"| 0x{row['at']:04X} | `{row['name']}` | {label} | {row['type']} | {row.get('range', '')} | {unit} "
            f"| {row['source']} |"
        )
    for parts, key in ((tree["enums"], "members"), (tree["flags"], "bits")):
        for part in parts:
            lines += ["", f"## {part['name']}", "", "| number | name |", "|---|---|"]
            lines += [f"| {each.get('value', each.get('bit'))} | {each['name']} |" for each in part[key]]
    return "\n".join(lines) + "\n"


def python(tree: Mapping, registers: list[Mapping]) -> str:
    """A module with enums, words of bits, and a table of registers."""
    lines = ["from enum import IntEnum, IntFlag", ""]
    for enum in tree["enums"]:
        lines += ["", f"class {enum['name'].title()}(IntEnum):"]
        lines += [f"    {member['name'].upper()} = {member['value']}" for member in enum["members"]]
    for word in tree["flags"]:
        lines += ["", f"class {word['name'].title()}(IntFlag):"]
        lines += [f"    {member['name'].upper()} = {1 << member['bit']}" for member in word["bits"]]
    lines += ["", "REGISTERS = {"]
    for row in registers:
        label = row["label"].replace("\\", "\\\\").replace('"', '\\"')
        lines.append(f'    "{row["name"]}": (0x{row["at"]:04X}, "{row["type"]}", "{row["access"]}", "{label}"),')
    return "\n".join([*lines, "}"]) + "\n"


def main(specs: str, out: str) -> None:
    """Compiles the device in each folder."""
    os.makedirs(out, exist_ok=True)
    for name in sorted(os.listdir(specs)):
        with open(os.path.join(specs, name, "device.yaml"), "rb") as source:
            tree = load(source.read())
        registers = checked(tree)
        for ending, function in (("h", header), ("md", markdown), ("py", python)):
            with open(os.path.join(out, f"{name}.{ending}"), "w", encoding="utf-8") as file:
                file.write(function(tree, registers))


if __name__ == "__main__":
    main(*sys.argv[1:])
