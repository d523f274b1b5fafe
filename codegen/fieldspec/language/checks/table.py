"""All checks by name, and how they are run.

A check yields findings and knows nothing of allowances: they are applied here, once for all checks.
"""

from __future__ import annotations

from collections.abc import Container, Iterable
from importlib import import_module

from fieldspec.foundation.caches import ObjectsKey
from fieldspec.foundation.classes import replace
from fieldspec.foundation.observation import observed, read_attributes
from fieldspec.language.checks.allowances_used import allowances_used
from fieldspec.language.checks.finding import Allowance, Check, Coverage, Findings, allowances
from fieldspec.language.checks.settled import OpenFacts, settle
from fieldspec.language.diagnostics import Diagnostic, are_in_place, in_order
from fieldspec.language.model.device import Device

_NAMES = (
    "access_steps_fit_space",
    "accesses_agree",
    "accesses_complete",
    "accesses_fit_space",
    "addresses_ascending",
    "addresses_disjoint",
    "addresses_fit_messages",
    "addresses_within_space",
    "aliases_agree",
    "bases_apply",
    "bit_numbers_apply",
    "bits_match_range",
    "bits_unique",
    "bits_within_width",
    "bounds_ordered",
    "broadcast_apart",
    "can_frames_complete",
    "choices_complete",
    "codes_fit_link",
    "commands_are_triggers",
    "conversions_match_signals",
    "copies_agree",
    "counts_apply",
    "counts_match_repeats",
    "counts_within_numbers",
    "data_words_match",
    "decimal_equals_hex",
    "default_within_range",
    "defaults_writable",
    "descriptions_differ",
    "detections_apply",
    "digits_fit",
    "directions_agree",
    "elements_match_table",
    "end_marks_apart",
    "enum_contiguous",
    "enum_names_unique",
    "enum_values_unique",
    "enum_within_range",
    "examples_fit_registers",
    "exception_marks_distinct",
    "exponents_apply",
    "facts_verified",
    "flags_forms_agree",
    "frame_length_matches",
    "gaps_declared",
    "header_names_distinct",
    "identifiers_consistent",
    "illegible_inferred",
    "inferred_keys_present",
    "keys_fit_type",
    "keys_have_effect",
    "labels_consistent",
    "labels_unique",
    "lengths_hold",
    "limits_ordered",
    "limits_within",
    "links_complete",
    "lookups_agree",
    "lookups_regular",
    "manual_identified",
    "measures_match_repeats",
    "member_numbers_ascending",
    "messages_complete",
    "names_unique",
    "numbers_regular",
    "offsets_match_layout",
    "orders_agree",
    "packed_lists_complete",
    "parameter_bytes_complete",
    "parameter_messages_complete",
    "parameter_numbers_ascending",
    "parameter_numbers_within_range",
    "parameters_fit_messages",
    "part_bits_complete",
    "ports_usable",
    "presences_complete",
    "printed_names_match",
    "printed_names_whole",
    "priorities_decide",
    "provenance_stated",
    "range_ends_match",
    "range_within_enum",
    "range_within_type",
    "record_size_matches",
    "records_filled",
    "records_finite",
    "references_resolve",
    "registers_fill_words",
    "repeat_last",
    "replies_agree",
    "restatements_agree",
    "roles_unique",
    "segments_complete",
    "senses_differ",
    "sentinels_distinct",
    "series_regular",
    "siblings_agree",
    "signals_placed",
    "sources_ascending",
    "sources_present",
    "spaces_reachable",
    "spans_match_layout",
    "statements_agree",
    "states_disjoint",
    "steps_possible",
    "subindices_match_elements",
    "switches_readable",
    "table_fields_readable",
    "tasks_complete",
    "text_fits_words",
    "texts_fit",
    "triggers_writable",
    "types_fit_space",
    "unit_addresses_match",
    "units_known",
    "value_within_range",
    "varying_widths_end",
    "widths_fit_place",
    "wire_numbers_match",
    "words_match_type",
    "write_range_applies",
    "write_range_within_range",
)
"""The modules that are checks, each with a function of its own name; the other modules are what checks share."""

CHECKS: tuple[tuple[str, Check], ...] = tuple(
    (name, getattr(import_module(f"fieldspec.language.checks.{name}"), name)) for name in _NAMES
)

MOST_FINDINGS = 200
"""The greatest number of findings of one check; more do not help."""

_BY_NAME = dict(CHECKS)

INSTALLED: dict[str, Check] = {}
"""The checks of installed packages, by their codes; `command` adds them."""


_VERDICTS: dict[Check, dict[tuple[str, ...], dict[ObjectsKey, list[Diagnostic]]]] = {}
"""By check, the attributes of devices that it has read, and what it has found in their values."""

MOST_VERDICTS = 100
"""How many values of the same attributes stay."""


def run(device: Device, without: Container[str] = ()) -> list[Diagnostic]:
    """The findings of all checks except those in `without`, in order."""
    all_allowances = list(allowances(device))
    by_check: dict[str, list[Allowance]] = {}
    for allowance in all_allowances:
        by_check.setdefault(allowance.check, []).append(allowance)
    used: set[Allowance] = set()
    names = [name for name in (*_BY_NAME, *INSTALLED) if name not in without]
    findings = [finding for name in names for finding in _unallowed(device, name, by_check.get(name, []), used)]
    if not without:
        settle(device)
    checks = {**_BY_NAME, **INSTALLED}
    unused = () if "allowances_used" in without else allowances_used(all_allowances, used, checks)
    return in_order([*findings, *unused])


def run_named(device: Device, name: str) -> list[Diagnostic]:
    """The findings of one check, in order."""
    if name == "allowances_used":
        return [finding for finding in run(device) if finding.code == name]
    return in_order(_unallowed(device, name, list(allowances(device, name)), set()))


def _findings(device: Device, name: str) -> Findings:
    """The findings of a check. It does not run where it has judged the same objects before."""
    if name in INSTALLED:
        yield from INSTALLED[name](device)
        return
    check = _BY_NAME[name]
    verdicts = _VERDICTS.setdefault(check, {})
    keys: dict[tuple[str, ...], ObjectsKey] = {}
    for attributes, by_values in verdicts.items():
        keys[attributes] = key = _values(device, attributes)
        remembered = by_values.get(key)
        if remembered is not None and are_in_place(remembered):
            yield from remembered
            return
    reading = observed(device)
    findings: list[Diagnostic] = []
    wrong_before = OpenFacts.verdicts_of_wrong
    for unnamed in check(reading):
        finding = replace(unnamed, code=name)
        findings.append(finding)
        yield finding
    if OpenFacts.verdicts_of_wrong != wrong_before:
        return  # so that no check settles them
    attributes = tuple(read_attributes(reading))
    by_values = verdicts.setdefault(attributes, {})
    if len(by_values) >= MOST_VERDICTS:
        del by_values[next(iter(by_values))]
    by_values[keys.get(attributes) or _values(device, attributes)] = findings


def _values(device: Device, attributes: Iterable[str]) -> ObjectsKey:
    """The values of some attributes. Lists are made again from the same objects."""
    values = (getattr(device, name) for name in attributes)
    return ObjectsKey(item for value in values for item in ((tuple, *value) if isinstance(value, tuple) else (value,)))


def _unallowed(device: Device, name: str, own_allowances: list[Allowance], used: set[Allowance]) -> Findings:
    """The findings of a check that no allowance covers; the allowances that cover a finding are added to `used`."""
    coverage: Coverage | None = None
    count = 0
    for finding in _findings(device, name):
        coverage = coverage or Coverage(own_allowances)
        covering = coverage.of(finding)
        used.update(covering)
        if covering:
            continue
        if count == MOST_FINDINGS:
            text = f"`{name}` has more than {MOST_FINDINGS} findings; the rest is not listed"
            yield Diagnostic("too_many_findings", text, finding.span, help="correct the first findings")
            return
        count += 1
        yield finding
