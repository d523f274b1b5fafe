"""Random devices as a whole: the sections of a spec, drawn in the order in which they refer to one another."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import yaml
from hypothesis import strategies as st

from random_devices import (
    drawn_buses,
    drawn_links,
    drawn_messages,
    drawn_records,
    drawn_registers,
    drawn_versions,
    drawn_words,
)
from random_devices.draft import Draft, Spec
from random_specs import NumberText

MANUAL = {"title": "The manual of chance", "file": "chance.txt", "sha256": "0" * 64, "lines": 99999}
VERSIONS = ("1.0", "2.0")
SECTIONS = (
    *("device", "versions", "spaces", "links", "signals", "conversions", "messages", "records", "enums", "flags"),
    *("registers", "tables", "parameters"),
)


@st.composite
def devices(draw: Any) -> Spec:
    """The spec of a random device, by section."""
    draft = Draft(draw)
    spec = draft.spec
    spec["device"] = {"id": "chance", "name": "Chance", "vendor": "Nobody", "manual": MANUAL}
    if draft.chance(25):
        draft.versions = VERSIONS
        members = [{"id": name, "source": draft.source()} for name in VERSIONS]
        spec["versions"] = [{"line": "firmware", "builds": True, "members": members}]
    draft.byte_order = draft.pick(("big", "little"))
    draft.word_order = "" if draft.chance(3) else draft.pick(("big", "little"))
    draft.sends_characters = draft.chance(30)
    draft.code_bits = (
        draft.pick((8, 8, 16, 8, 8, 24, 8, 8, 8, 64)) if draft.chance(90) else draft.pick((32, 40, 48, 56))
    )
    draft.code_flag = 1 << (draft.code_bits - 1 if draft.chance(70) else draft.number(3, draft.code_bits - 1))
    spec["enums"] = drawn_words.enums(draft)
    spec["flags"] = drawn_words.flags(draft)
    spec["enums"] += drawn_words.derived_enums(draft)
    spec["records"] = drawn_records.records(draft)
    if draft.chance(18):
        drawn_buses.add_bus(draft)
        drawn_versions.tell_versions(draft)
        return {section: spec[section] for section in SECTIONS if spec.get(section)}
    spec["spaces"] = drawn_registers.spaces(draft)
    kinds = draft.pick(((True,), (True, True), (False,), (True, False), (True, True, True), (True, False, False)))
    spec["links"] = [drawn_links.link(draft, coded) for coded in kinds]
    coded = [link["name"] for link, is_coded in zip(spec["links"], kinds, strict=True) if is_coded]
    others = [link["name"] for link in spec["links"] if link["name"] not in coded]
    if coded and draft.chance(60):
        spec["registers"] = drawn_registers.register_groups(draft)
        spec["tables"] = drawn_registers.tables(draft)
    if not spec.get("registers") and not spec.get("tables"):
        spec["spaces"] = []
    spec["parameters"] = drawn_registers.parameters(draft) if draft.chance(45) else []
    if others:
        spec["signals"] = drawn_words.signals(draft)
        spec["conversions"] = drawn_words.conversions(draft)
    spec["messages"] = drawn_messages.messages(draft, coded, others)
    drawn_versions.tell_versions(draft)
    drawn_messages.mark_exceptions(draft)
    drawn_messages.draw_response_codes(draft)
    drawn_messages.leave_unrequested(draft)
    drawn_words.place_bits(draft)
    return {section: spec[section] for section in SECTIONS if spec.get(section)}


class _Dumper(yaml.CSafeDumper if yaml.__with_libyaml__ else yaml.SafeDumper):
    def ignore_aliases(self, data: Any) -> bool:
        return True


_Dumper.add_representer(
    NumberText, lambda dumper, number: dumper.represent_scalar("tag:yaml.org,2002:float", str(number))
)


def text_of(spec: Mapping[str, Any]) -> str:
    """The text of a spec file."""
    return yaml.dump(spec, Dumper=_Dumper, sort_keys=False, width=120, allow_unicode=True, default_flow_style=None)
