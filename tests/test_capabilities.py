"""The tables of capabilities are complete and fresh, and what they say is so."""

from __future__ import annotations

import os
import zlib
from pathlib import Path

import pytest

from capability_derivation import Key, changed_outputs, is_refused, legal_keys, stored_witnesses
from fieldspec.command import rules
from fieldspec.command.pipeline import layouts, load
from fieldspec.command.rendering.capabilities import COLUMNS, ROWS, capabilities, page
from fieldspec.language.schema.capabilities import CHECK, effects
from fieldspec.targets import OUTPUTS
from fieldspec.targets.controllers.capabilities import ADAPTED, CONSTRUCTS, EXACT, REFUSED
from fieldspec.targets.controllers.rules import RULES as PLC_RULES
from fieldspec.targets.rules import RULES as OUTPUT_RULES

PAGE = Path(__file__).parent.parent / "docs" / "capabilities.md"
FRACTION = 1 if os.environ.get("FIELDSPEC_CAPABILITIES") == "all" else 100
"""One key of so many is derived; `make capabilities` derives them all."""
CASES = Path(__file__).parent / "cases"

REFUSALS = {
    "wide_lists": "plc_numbers_fit",
    "text_lists": "plc_arrays_flat",
    "images": "plc_images_exact",
    "wide_floats": "plc_reals_fit",
    "absent_reals": "plc_reals_present",
    "digits": "plc_numbers_binary",
    "formed_texts": "plc_texts_ascii",
    "inner_lists": "plc_lists_last",
    "escaped_frames": "plc_frames_supported",
    "other_frames": "plc_frames_supported",
    "can_frames": "plc_frames_supported",
    "byte_registers": "plc_spaces_supported",
    "moving_tables": "plc_addresses_constant",
    "pieces": "plc_values_whole",
}
"""Constructs that some output refuses by a rule, and whose failing case needs them."""


def test_the_page_is_what_the_code_writes(accept: bool) -> None:
    if accept:
        PAGE.write_text(page(), "utf-8", newline="\n")
    assert PAGE.read_text("utf-8") == page()


@pytest.mark.parametrize("name", COLUMNS)
def test_every_construct_has_a_level_and_what_is_not_exact_has_a_reason(name: str) -> None:
    value = capabilities(name)
    assert list(value) == list(CONSTRUCTS)
    assert {capability.level for capability in value.values()} <= {EXACT, ADAPTED, REFUSED}
    assert all(bool(capability.reason) == (capability.level != EXACT) for capability in value.values())


@pytest.mark.parametrize("name", ["st", "twincat", "plcopen", "iec", "scl"])
@pytest.mark.parametrize(("construct", "code"), REFUSALS.items())
def test_an_output_refuses_by_a_rule_what_the_matrix_says_and_nothing_else(
    name: str, construct: str, code: str
) -> None:
    spec = load({"gadget/device.yaml": (CASES / code / "failing" / "device.yaml").read_bytes()}).devices["gadget"]
    result = {finding.code for finding in OUTPUTS[name].refusals(layouts(spec))}
    capability = capabilities(name)[construct]
    assert (code in result) == (capability.level == REFUSED)
    assert (code in capability.reason) == (capability.level == REFUSED)


def test_the_page_says_of_each_rule_of_outputs_what_becomes_of_what_breaks_it() -> None:
    named = {code for _, codes, _ in ROWS for code in codes}
    assert named == {*PLC_RULES, *OUTPUT_RULES}


def test_rules_that_the_matrix_names_are_there() -> None:
    named = {
        word.strip(";:,.")
        for name in COLUMNS
        for capability in capabilities(name).values()
        for word in capability.reason.split()
    }
    codes = {word for word in named if word.startswith("plc_")}
    assert codes == set(REFUSALS.values())
    assert all(rules.rule(code) for code in codes)


def row(key: Key) -> set[str]:
    """The outputs that the table says of a key."""
    part, name = key
    return set(effects()[part][name])


def test_every_row_is_about_a_key_of_the_language_and_has_a_witness() -> None:
    rows = {(part, key) for part, keys in effects().items() for key in keys}
    assert rows <= set(legal_keys())
    assert rows == set(stored_witnesses())


def test_every_key_of_the_language_has_a_row() -> None:
    rows = {(part, key) for part, keys in effects().items() for key in keys}
    assert set(legal_keys()) == rows


def test_the_table_is_in_order() -> None:
    assert list(effects()) == sorted(effects())
    assert all(list(keys) == sorted(keys) for keys in effects().values())


DERIVED = sorted(key for key in stored_witnesses() if zlib.crc32("/".join(key).encode()) % FRACTION == 0)


@pytest.mark.parametrize("key", DERIVED, ids="/".join)
def test_a_key_changes_the_outputs_that_the_table_names_and_no_others(key: Key) -> None:
    changed: set[str] = set()
    for witness in stored_witnesses()[key]:
        outputs = {CHECK} if row(key) == {CHECK} and is_refused(witness) else changed_outputs(witness)
        assert outputs is not None, witness
        changed |= outputs
    assert changed == row(key)
