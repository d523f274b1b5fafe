"""All checks by name, and how they are run.

A check yields findings and knows nothing of allowances: they are applied here, once for all checks.
"""

from __future__ import annotations

from collections.abc import Container, Iterator

from fieldspec.checks.access_steps_fit_space import access_steps_fit_space
from fieldspec.checks.accesses_agree import accesses_agree
from fieldspec.checks.accesses_complete import accesses_complete
from fieldspec.checks.accesses_fit_space import accesses_fit_space
from fieldspec.checks.addresses_ascending import addresses_ascending
from fieldspec.checks.addresses_disjoint import addresses_disjoint
from fieldspec.checks.addresses_fit_messages import addresses_fit_messages
from fieldspec.checks.addresses_within_space import addresses_within_space
from fieldspec.checks.aliases_agree import aliases_agree
from fieldspec.checks.allowances_used import allowances_used
from fieldspec.checks.bases_apply import bases_apply
from fieldspec.checks.bit_numbers_apply import bit_numbers_apply
from fieldspec.checks.bits_match_range import bits_match_range
from fieldspec.checks.bits_unique import bits_unique
from fieldspec.checks.bits_within_width import bits_within_width
from fieldspec.checks.bounds_ordered import bounds_ordered
from fieldspec.checks.broadcast_apart import broadcast_apart
from fieldspec.checks.can_frames_complete import can_frames_complete
from fieldspec.checks.choices_complete import choices_complete
from fieldspec.checks.codes_fit_link import codes_fit_link
from fieldspec.checks.commands_are_triggers import commands_are_triggers
from fieldspec.checks.conversions_match_signals import conversions_match_signals
from fieldspec.checks.copies_agree import copies_agree
from fieldspec.checks.counts_apply import counts_apply
from fieldspec.checks.counts_match_repeats import counts_match_repeats
from fieldspec.checks.data_words_match import data_words_match
from fieldspec.checks.decimal_equals_hex import decimal_equals_hex
from fieldspec.checks.default_within_range import default_within_range
from fieldspec.checks.defaults_writable import defaults_writable
from fieldspec.checks.descriptions_differ import descriptions_differ
from fieldspec.checks.detections_apply import detections_apply
from fieldspec.checks.digits_fit import digits_fit
from fieldspec.checks.directions_agree import directions_agree
from fieldspec.checks.elements_match_table import elements_match_table
from fieldspec.checks.enum_contiguous import enum_contiguous
from fieldspec.checks.enum_names_unique import enum_names_unique
from fieldspec.checks.enum_values_unique import enum_values_unique
from fieldspec.checks.enum_within_range import enum_within_range
from fieldspec.checks.examples_fit_registers import examples_fit_registers
from fieldspec.checks.exception_marks_distinct import exception_marks_distinct
from fieldspec.checks.exponents_apply import exponents_apply
from fieldspec.checks.facts_verified import facts_verified
from fieldspec.checks.finding import Allowance, Check, allowances, covered
from fieldspec.checks.flags_forms_agree import flags_forms_agree
from fieldspec.checks.frame_length_matches import frame_length_matches
from fieldspec.checks.gaps_declared import gaps_declared
from fieldspec.checks.header_names_distinct import header_names_distinct
from fieldspec.checks.identifiers_consistent import identifiers_consistent
from fieldspec.checks.illegible_inferred import illegible_inferred
from fieldspec.checks.inferred_keys_present import inferred_keys_present
from fieldspec.checks.keys_fit_type import keys_fit_type
from fieldspec.checks.keys_have_effect import keys_have_effect
from fieldspec.checks.labels_consistent import labels_consistent
from fieldspec.checks.labels_unique import labels_unique
from fieldspec.checks.lengths_hold import lengths_hold
from fieldspec.checks.limits_ordered import limits_ordered
from fieldspec.checks.limits_within import limits_within
from fieldspec.checks.links_complete import links_complete
from fieldspec.checks.lookups_agree import lookups_agree
from fieldspec.checks.lookups_regular import lookups_regular
from fieldspec.checks.measures_match_repeats import measures_match_repeats
from fieldspec.checks.member_numbers_ascending import member_numbers_ascending
from fieldspec.checks.messages_complete import messages_complete
from fieldspec.checks.names_unique import names_unique
from fieldspec.checks.numbers_regular import numbers_regular
from fieldspec.checks.offsets_match_layout import offsets_match_layout
from fieldspec.checks.orders_agree import orders_agree
from fieldspec.checks.parameter_bytes_complete import parameter_bytes_complete
from fieldspec.checks.parameter_messages_complete import parameter_messages_complete
from fieldspec.checks.parameter_numbers_ascending import parameter_numbers_ascending
from fieldspec.checks.parameter_numbers_within_range import parameter_numbers_within_range
from fieldspec.checks.parameters_fit_messages import parameters_fit_messages
from fieldspec.checks.ports_usable import ports_usable
from fieldspec.checks.printed_names_match import printed_names_match
from fieldspec.checks.printed_names_whole import printed_names_whole
from fieldspec.checks.priorities_decide import priorities_decide
from fieldspec.checks.provenance_stated import provenance_stated
from fieldspec.checks.range_ends_match import range_ends_match
from fieldspec.checks.range_within_enum import range_within_enum
from fieldspec.checks.range_within_type import range_within_type
from fieldspec.checks.record_size_matches import record_size_matches
from fieldspec.checks.records_filled import records_filled
from fieldspec.checks.records_finite import records_finite
from fieldspec.checks.references_resolve import references_resolve
from fieldspec.checks.registers_fill_words import registers_fill_words
from fieldspec.checks.repeat_last import repeat_last
from fieldspec.checks.replies_agree import replies_agree
from fieldspec.checks.restatements_agree import restatements_agree
from fieldspec.checks.roles_unique import roles_unique
from fieldspec.checks.segments_complete import segments_complete
from fieldspec.checks.senses_differ import senses_differ
from fieldspec.checks.sentinels_distinct import sentinels_distinct
from fieldspec.checks.series_regular import series_regular
from fieldspec.checks.siblings_agree import siblings_agree
from fieldspec.checks.signals_placed import signals_placed
from fieldspec.checks.sources_ascending import sources_ascending
from fieldspec.checks.sources_present import sources_present
from fieldspec.checks.spaces_reachable import spaces_reachable
from fieldspec.checks.spans_match_layout import spans_match_layout
from fieldspec.checks.statements_agree import statements_agree
from fieldspec.checks.states_disjoint import states_disjoint
from fieldspec.checks.steps_possible import steps_possible
from fieldspec.checks.subindices_match_elements import subindices_match_elements
from fieldspec.checks.table_fields_readable import table_fields_readable
from fieldspec.checks.tasks_complete import tasks_complete
from fieldspec.checks.text_fits_words import text_fits_words
from fieldspec.checks.texts_fit import texts_fit
from fieldspec.checks.triggers_writable import triggers_writable
from fieldspec.checks.types_fit_space import types_fit_space
from fieldspec.checks.unit_addresses_match import unit_addresses_match
from fieldspec.checks.units_known import units_known
from fieldspec.checks.value_within_range import value_within_range
from fieldspec.checks.varying_widths_end import varying_widths_end
from fieldspec.checks.widths_fit_place import widths_fit_place
from fieldspec.checks.wire_numbers_match import wire_numbers_match
from fieldspec.checks.words_match_type import words_match_type
from fieldspec.checks.write_range_applies import write_range_applies
from fieldspec.checks.write_range_within_range import write_range_within_range
from fieldspec.diagnostics import Diagnostic, in_order
from fieldspec.model.device import Device
from fieldspec.source import Span

CHECKS: tuple[tuple[str, Check], ...] = (
    ("access_steps_fit_space", access_steps_fit_space),
    ("accesses_agree", accesses_agree),
    ("accesses_complete", accesses_complete),
    ("accesses_fit_space", accesses_fit_space),
    ("addresses_ascending", addresses_ascending),
    ("addresses_disjoint", addresses_disjoint),
    ("addresses_fit_messages", addresses_fit_messages),
    ("addresses_within_space", addresses_within_space),
    ("aliases_agree", aliases_agree),
    ("bases_apply", bases_apply),
    ("bit_numbers_apply", bit_numbers_apply),
    ("bits_match_range", bits_match_range),
    ("bits_unique", bits_unique),
    ("bits_within_width", bits_within_width),
    ("bounds_ordered", bounds_ordered),
    ("broadcast_apart", broadcast_apart),
    ("can_frames_complete", can_frames_complete),
    ("choices_complete", choices_complete),
    ("codes_fit_link", codes_fit_link),
    ("commands_are_triggers", commands_are_triggers),
    ("conversions_match_signals", conversions_match_signals),
    ("copies_agree", copies_agree),
    ("counts_apply", counts_apply),
    ("counts_match_repeats", counts_match_repeats),
    ("data_words_match", data_words_match),
    ("decimal_equals_hex", decimal_equals_hex),
    ("default_within_range", default_within_range),
    ("defaults_writable", defaults_writable),
    ("descriptions_differ", descriptions_differ),
    ("detections_apply", detections_apply),
    ("digits_fit", digits_fit),
    ("directions_agree", directions_agree),
    ("elements_match_table", elements_match_table),
    ("enum_contiguous", enum_contiguous),
    ("enum_names_unique", enum_names_unique),
    ("enum_values_unique", enum_values_unique),
    ("enum_within_range", enum_within_range),
    ("examples_fit_registers", examples_fit_registers),
    ("exception_marks_distinct", exception_marks_distinct),
    ("exponents_apply", exponents_apply),
    ("facts_verified", facts_verified),
    ("flags_forms_agree", flags_forms_agree),
    ("frame_length_matches", frame_length_matches),
    ("gaps_declared", gaps_declared),
    ("header_names_distinct", header_names_distinct),
    ("identifiers_consistent", identifiers_consistent),
    ("illegible_inferred", illegible_inferred),
    ("inferred_keys_present", inferred_keys_present),
    ("keys_fit_type", keys_fit_type),
    ("keys_have_effect", keys_have_effect),
    ("labels_consistent", labels_consistent),
    ("labels_unique", labels_unique),
    ("lengths_hold", lengths_hold),
    ("limits_ordered", limits_ordered),
    ("limits_within", limits_within),
    ("links_complete", links_complete),
    ("lookups_agree", lookups_agree),
    ("lookups_regular", lookups_regular),
    ("measures_match_repeats", measures_match_repeats),
    ("member_numbers_ascending", member_numbers_ascending),
    ("messages_complete", messages_complete),
    ("names_unique", names_unique),
    ("numbers_regular", numbers_regular),
    ("offsets_match_layout", offsets_match_layout),
    ("orders_agree", orders_agree),
    ("parameter_bytes_complete", parameter_bytes_complete),
    ("parameter_messages_complete", parameter_messages_complete),
    ("parameter_numbers_ascending", parameter_numbers_ascending),
    ("parameter_numbers_within_range", parameter_numbers_within_range),
    ("parameters_fit_messages", parameters_fit_messages),
    ("ports_usable", ports_usable),
    ("printed_names_match", printed_names_match),
    ("printed_names_whole", printed_names_whole),
    ("priorities_decide", priorities_decide),
    ("provenance_stated", provenance_stated),
    ("range_ends_match", range_ends_match),
    ("range_within_enum", range_within_enum),
    ("range_within_type", range_within_type),
    ("record_size_matches", record_size_matches),
    ("records_filled", records_filled),
    ("records_finite", records_finite),
    ("references_resolve", references_resolve),
    ("registers_fill_words", registers_fill_words),
    ("repeat_last", repeat_last),
    ("replies_agree", replies_agree),
    ("restatements_agree", restatements_agree),
    ("roles_unique", roles_unique),
    ("segments_complete", segments_complete),
    ("senses_differ", senses_differ),
    ("sentinels_distinct", sentinels_distinct),
    ("series_regular", series_regular),
    ("siblings_agree", siblings_agree),
    ("signals_placed", signals_placed),
    ("sources_ascending", sources_ascending),
    ("sources_present", sources_present),
    ("spaces_reachable", spaces_reachable),
    ("spans_match_layout", spans_match_layout),
    ("statements_agree", statements_agree),
    ("states_disjoint", states_disjoint),
    ("steps_possible", steps_possible),
    ("subindices_match_elements", subindices_match_elements),
    ("table_fields_readable", table_fields_readable),
    ("tasks_complete", tasks_complete),
    ("text_fits_words", text_fits_words),
    ("texts_fit", texts_fit),
    ("triggers_writable", triggers_writable),
    ("types_fit_space", types_fit_space),
    ("unit_addresses_match", unit_addresses_match),
    ("units_known", units_known),
    ("value_within_range", value_within_range),
    ("varying_widths_end", varying_widths_end),
    ("widths_fit_place", widths_fit_place),
    ("wire_numbers_match", wire_numbers_match),
    ("words_match_type", words_match_type),
    ("write_range_applies", write_range_applies),
    ("write_range_within_range", write_range_within_range),
)

MOST_FINDINGS = 200
"""How many findings one check may have; more of them help nobody."""

_BY_NAME = dict(CHECKS)

INSTALLED: dict[str, Check] = {}
"""The checks of installed packages, by their codes; `commands` adds them."""


def run(device: Device, without: Container[str] = ()) -> list[Diagnostic]:
    """The findings of all checks, `without` those of some, in order."""
    all_allowances = list(allowances(device))
    by_check: dict[str, list[Allowance]] = {}
    for allowance in all_allowances:
        by_check.setdefault(allowance.check, []).append(allowance)
    used: set[Allowance] = set()
    names = [name for name in (*_BY_NAME, *INSTALLED) if name not in without]
    findings = [finding for name in names for finding in _unallowed(device, name, by_check.get(name, []), used)]
    checks = {**_BY_NAME, **INSTALLED}
    unused = () if "allowances_used" in without else allowances_used(all_allowances, used, checks)
    return in_order([*findings, *unused])


def run_named(device: Device, name: str) -> list[Diagnostic]:
    """The findings of one check, in order."""
    if name == "allowances_used":
        return [finding for finding in run(device) if finding.code == name]
    return in_order(_unallowed(device, name, list(allowances(device, name)), set()))


def _unallowed(
    device: Device, name: str, own_allowances: list[Allowance], used: set[Allowance]
) -> Iterator[Diagnostic]:
    """The findings of a check that no allowance covers; the allowances that cover a finding are added to `used`."""
    own: list[tuple[Allowance, list[Span]]] = []
    count = 0
    for finding in (_BY_NAME.get(name) or INSTALLED[name])(device):
        own = own or [(allowance, allowance.spans()) for allowance in own_allowances]
        covering = [allowance for allowance, spans in own if covered(finding, spans)]
        used.update(covering)
        if covering:
            continue
        if count == MOST_FINDINGS:
            text = f"`{name}` has more than {MOST_FINDINGS} findings; the rest is not listed"
            yield Diagnostic("too_many_findings", text, finding.span, help="correct the first findings")
            return
        count += 1
        yield finding
