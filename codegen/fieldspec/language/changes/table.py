"""All rules of changes by name, with the effects that they can have."""

from __future__ import annotations

from fieldspec.foundation.classes import replace
from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.changes.comparison import Comparison
from fieldspec.language.changes.descriptions import Rule
from fieldspec.language.changes.reasons import stated_reasons
from fieldspec.language.changes.rules import addresses, carriers, enums, facts, flags, links, ranges, records, values
from fieldspec.language.model.device import Device

_W, _S, _B, _D = Effect

_EFFECTS: dict[str, tuple[Effect, ...]] = {
    "access_changed": (_B,),
    "aliases_changed": (_S, _D),
    "applicability_changed": (_B,),
    "availability_changed": (_S, _B),
    "bit_moved": (_W, _D),
    "broadcast_changed": (_W, _B),
    "building_changed": (_S,),
    "byte_order_changed": (_W,),
    "case_changed": (_W, _B),
    "check_changed": (_W,),
    "code_changed": (_W, _D),
    "const_changed": (_W,),
    "conversion_changed": (_W,),
    "count_changed": (_W, _S, _B),
    "default_changed": (_W, _B),
    "default_link_changed": (_B,),
    "detection_changed": (_B,),
    "documentation_changed": (_D,),
    "edge_changed": (_B,),
    "enum_changed": (_W, _S),
    "example_changed": (_D,),
    "exception_response_changed": (_W,),
    "fact_added": (_W, _B, _D),
    "fact_removed": (_W, _S, _B, _D),
    "field_moved": (_W,),
    "flags_changed": (_W, _S),
    "framing_changed": (_W,),
    "handling_changed": (_B,),
    "index_changed": (_W, _D),
    "length_changed": (_W,),
    "limit_changed": (_B, _D),
    "member_added": (_B, _D),
    "member_removed": (_W, _D),
    "member_renumbered": (_W, _D),
    "network_changed": (_B,),
    "number_changed": (_W, _D),
    "openness_changed": (_S, _B),
    "polarity_changed": (_W,),
    "range_narrowed": (_B,),
    "range_widened": (_B,),
    "register_moved": (_W,),
    "renamed": (_S, _D),
    "reserved_changed": (_W, _B),
    "restart_changed": (_B,),
    "role_changed": (_W, _B),
    "scale_changed": (_W,),
    "sending_changed": (_W, _B),
    "sentinel_changed": (_W, _S, _B),
    "serial_changed": (_B,),
    "space_changed": (_W, _B, _D),
    "state_changed": (_W,),
    "stride_changed": (_W,),
    "table_moved": (_W,),
    "timing_changed": (_B,),
    "type_changed": (_W,),
    "unit_changed": (_W,),
}
_MODULES = (addresses, carriers, enums, facts, flags, links, ranges, records, values)
_FUNCTIONS: dict[str, Rule] = {name: function for module in _MODULES for name, function in vars(module).items()}

RULES = tuple((name, _FUNCTIONS[name], effects) for name, effects in _EFFECTS.items())
"""Each rule: its name, which is that of its function, the function, and its effects."""


def changes(old: Device, new: Device) -> list[Change]:
    """The differences of two versions of a device: the gravest first, then by fact."""
    reasons = stated_reasons(old, new)
    comparison = Comparison(old, new, reasons.renames)
    all_changes = (
        replace(change, rule=name, reason=reasons.of(change.path))
        for name, rule, _ in RULES
        for change in rule(comparison)
    )
    return sorted(all_changes, key=Change.order)
