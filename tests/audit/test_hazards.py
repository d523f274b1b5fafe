"""What may go wrong when values are read and written shows, of registers, fields, parameters, messages and bits."""

from __future__ import annotations

import pytest

from fieldspec.tools.audit.hazards import KINDS, hazards, undivided
from fieldspec.tools.audit.sources import inferred_keys, sourced_facts
from layouts import SPECS, layout_at, newest
from spec_files import gadget

HEAD = "registers:\n  - group: all\n    section: '1'\n    defaults: {type: u16, access: rw}\n    rows:\n"
SAVE = "      - {at: 99, name: save, trigger: true, const: 1, memory: nonvolatile, source: L9}\n"
FLAGS = "flags: [{name: word, type: u16, section: '1', source: L1, bits: [{bit: 0, name: a}, {bit: 1, name: b%s}]}]\n"


def kinds(text: str, name: str) -> list[tuple[str, str]]:
    hazards_of_device = hazards(layout_at(gadget(text), "1"))
    return [(hazard.kind.name, hazard.why) for hazard in hazards_of_device if hazard.name == name]


@pytest.mark.parametrize(
    ("keys", "expected"),
    [
        ("", []),
        ("trigger: true", [("trigger", "started by writing")]),
        ("trigger: true, const: 5", [("trigger", "started by 0x5")]),
        ("access: wo", [("write_only", "access wo")]),
        ("clears_on_read: true", [("clears_on_read", "cleared by reading")]),
        ("same_as: save, type: u16", [("alias", "the same as save")]),
        ("type: u32, atomic: true", [("atomic", "2 words")]),
        ("restart: true", [("restart", "restart")]),
        ("saved_by: registers/save", [("save", "saved by registers/save")]),
        (
            "memory: volatile, saved_by: registers/save",
            [("save", "lost when the power is switched off, unless saved by registers/save")],
        ),
        ("opposite_of: registers/save", [("opposite", "against registers/save")]),
        ("memory: nonvolatile", [("wear", "the permitted number of writes is not printed")]),
        ("memory: nonvolatile, access: ro", []),
        ("endurance: 100000", [("wear", "100000 writes")]),
        ("endurance: limited", [("wear", "a limited number of writes; the number is not printed")]),
        ("endurance: unlimited", [("wear", "an unlimited number of writes")]),
        ("flags: word", [("shared_word", "2 things, 14 bits without a meaning")]),
        ("flags: word, access: ro", []),
    ],
    ids=str,
)
def test_a_register_is_a_hazard_for_what_is_said_of_it(keys: str, expected: list[tuple[str, str]]) -> None:
    row = f"      - {{at: 1, name: held, source: L2{', ' + keys if keys else ''}}}\n"
    assert kinds(FLAGS % "" + HEAD + row + SAVE, "held") == expected


def test_bits_that_act_at_an_edge_or_are_true_at_0_are_hazards() -> None:
    assert kinds(FLAGS % ", edge: rising, active: low", "b") == [
        ("active_low", "0 while it holds"),
        ("edge", "its rising edge"),
    ]


def test_bits_that_have_registers_of_their_own_are_counted() -> None:
    rows = "      - {at: 1, name: held, flags: word, source: L2}\n      - {at: 2, name: a, source: L3}\n"
    ((_, why),) = kinds(FLAGS % "" + HEAD + rows, "held")
    assert why == "2 things, 14 bits without a meaning, 1 of them with registers of their own"


def test_parameters_messages_and_tables_are_hazards_too() -> None:
    text = """
records: [{name: point, section: "1", source: L1, fields: [{name: x, type: u32, atomic: true}]}]
tables: [{name: points, section: "1", source: L2, base: 0, stride: 2, count: 3, record: point, saved_by: messages/keep}]
messages: [{name: keep, code: 7, section: "1", source: L3, request: [], response: [], endurance: limited}]
parameters: [{name: p, source: 1 L4, type: u16, rows: [{number: 1, name: start, trigger: true, restart: true}]}]
links:
  - name: wire
    byte_order: big
    word_order: big
    source: 1 L1
    request: [{name: code, role: code, type: u8}, {name: body, role: body}]
    response: [{name: code, role: code, type: u8}, {name: body, role: body}]
"""
    places = {(hazard.kind.name, hazard.path, hazard.where) for hazard in hazards(layout_at(gadget(text), "1"))}
    assert places == {
        ("atomic", "records/point/x", "points"),
        ("save", "tables/points", "0x0000, 3 times"),
        ("wear", "messages/keep", "0x07"),
        ("trigger", "parameters/p/start", "1"),
        ("restart", "parameters/p/start", "1"),
    }


def test_registers_of_which_nothing_says_whether_they_may_be_divided_are_listed() -> None:
    rows = "      - {at: 1, name: a, type: u32, source: L2}\n"
    rows += "      - {at: 3, name: b, type: u32, atomic: true, source: L3}\n"
    assert [register.name for register in undivided(layout_at(gadget(HEAD + rows), "1").device)] == ["a"]


def test_the_gravest_hazards_come_first() -> None:
    ranks = [list(KINDS).index(hazard.kind.name) for hazard in hazards(newest(SPECS, "ck10"))]
    assert ranks == sorted(ranks)


@pytest.mark.parametrize(
    ("device", "path", "kind"),
    [
        ("tc100", "registers/servo", "opposite"),
        ("tc100", "registers/motion_command", "trigger"),
        ("ck10", "registers/resolution", "save"),
        ("ck10", "registers/clear_alarm_history", "write_only"),
        ("ck10", "records/point/position", "atomic"),
        ("esc11", "messages/write_points", "wear"),
        ("esc11", "flags/communication_status/servo_off", "opposite"),
        ("hiwin-e", "parameters/drive_parameters/parameter_save", "trigger"),
    ],
)
def test_the_manuals_say_what_is_dangerous(device: str, path: str, kind: str) -> None:
    assert (kind, path) in {(hazard.kind.name, hazard.path) for hazard in hazards(newest(SPECS, device))}


def test_facts_are_told_apart_by_how_many_places_print_them() -> None:
    text = """
registers:
  - group: all
    section: "1"
    source: L1
    rows:
      - {at: 0, name: once, type: u16, source: L2}
      - {at: 1, name: together, type: u16, source: "L3; 2 L5"}
      - {at: 2, name: agreeing, type: u16, unit: mm, source: L4, restated: [{source: 2 L6, unit: mm}]}
      - {at: 3, name: differing, type: u16, unit: mm, source: L5, restated: [{source: 2 L7, unit: mm}]}
      - {at: 4, name: nowhere, type: u16, inferred: {type: It is one word.}}
errata:
  - {id: unit, fact: registers/differing/restated/0, printed: {unit: rpm}, reason: It is a length., confidence: certain,
     effect: range, proof: restatements_agree, source: 2 L7}
"""
    device = layout_at(gadget(text), "1").device
    standings = {fact.path.removeprefix("registers/"): fact.standing for fact in sourced_facts(device)}
    assert standings == {
        "all": "one_place",
        "once": "one_place",
        "together": "together",
        "agreeing": "agreeing",
        "differing": "differing",
        "nowhere": "nowhere",
    }
    assert [(inferred_key.path, inferred_key.key, inferred_key.reason) for inferred_key in inferred_keys(device)] == [
        ("registers/nowhere", "type", "It is one word.")
    ]


def test_a_bit_without_a_place_of_its_own_has_that_of_its_word() -> None:
    facts = {fact.path: fact for fact in sourced_facts(layout_at(gadget(FLAGS % ""), "1").device)}
    assert [source.text() for source in facts["flags/word/a"].sources] == ["1 L1"]
    assert facts["flags/word/a"].inherited
    assert not facts["flags/word"].inherited
