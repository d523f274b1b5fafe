"""All rules of changes by name, with the effects that they can have."""

from __future__ import annotations

from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.changes.comparison import Comparison
from fieldspec.language.changes.descriptions import Rule
from fieldspec.language.changes.reasons import stated_reasons, with_reason
from fieldspec.language.changes.rules.addresses import (
    index_changed,
    number_changed,
    register_moved,
    space_changed,
    stride_changed,
    table_moved,
)
from fieldspec.language.changes.rules.carriers import (
    default_link_changed,
    network_changed,
    serial_changed,
    timing_changed,
)
from fieldspec.language.changes.rules.enums import (
    aliases_changed,
    enum_changed,
    member_added,
    member_removed,
    member_renumbered,
    openness_changed,
)
from fieldspec.language.changes.rules.facts import (
    applicability_changed,
    availability_changed,
    documentation_changed,
    example_changed,
    fact_added,
    fact_removed,
    renamed,
)
from fieldspec.language.changes.rules.flags import (
    bit_moved,
    edge_changed,
    flags_changed,
    polarity_changed,
    reserved_changed,
    state_changed,
)
from fieldspec.language.changes.rules.links import (
    broadcast_changed,
    building_changed,
    check_changed,
    code_changed,
    detection_changed,
    exception_response_changed,
    framing_changed,
    role_changed,
    sending_changed,
)
from fieldspec.language.changes.rules.ranges import (
    access_changed,
    default_changed,
    handling_changed,
    limit_changed,
    range_narrowed,
    range_widened,
    restart_changed,
)
from fieldspec.language.changes.rules.records import case_changed, count_changed, field_moved, length_changed
from fieldspec.language.changes.rules.values import (
    byte_order_changed,
    const_changed,
    conversion_changed,
    scale_changed,
    sentinel_changed,
    type_changed,
    unit_changed,
)
from fieldspec.language.model.device import Device

_W, _S, _B, _D = Effect

RULES: tuple[tuple[str, Rule, tuple[Effect, ...]], ...] = (
    ("access_changed", access_changed, (_B,)),
    ("aliases_changed", aliases_changed, (_S, _D)),
    ("applicability_changed", applicability_changed, (_B,)),
    ("availability_changed", availability_changed, (_S, _B)),
    ("bit_moved", bit_moved, (_W, _D)),
    ("broadcast_changed", broadcast_changed, (_W, _B)),
    ("building_changed", building_changed, (_S,)),
    ("byte_order_changed", byte_order_changed, (_W,)),
    ("case_changed", case_changed, (_W, _B)),
    ("check_changed", check_changed, (_W,)),
    ("code_changed", code_changed, (_W, _D)),
    ("const_changed", const_changed, (_W,)),
    ("conversion_changed", conversion_changed, (_W,)),
    ("count_changed", count_changed, (_W, _S, _B)),
    ("default_changed", default_changed, (_W, _B)),
    ("default_link_changed", default_link_changed, (_B,)),
    ("detection_changed", detection_changed, (_B,)),
    ("documentation_changed", documentation_changed, (_D,)),
    ("edge_changed", edge_changed, (_B,)),
    ("enum_changed", enum_changed, (_W, _S)),
    ("example_changed", example_changed, (_D,)),
    ("exception_response_changed", exception_response_changed, (_W,)),
    ("fact_added", fact_added, (_W, _B, _D)),
    ("fact_removed", fact_removed, (_W, _S, _B, _D)),
    ("field_moved", field_moved, (_W,)),
    ("flags_changed", flags_changed, (_W, _S)),
    ("framing_changed", framing_changed, (_W,)),
    ("handling_changed", handling_changed, (_B,)),
    ("index_changed", index_changed, (_W, _D)),
    ("length_changed", length_changed, (_W,)),
    ("limit_changed", limit_changed, (_B, _D)),
    ("member_added", member_added, (_B, _D)),
    ("member_removed", member_removed, (_W, _D)),
    ("member_renumbered", member_renumbered, (_W, _D)),
    ("network_changed", network_changed, (_B,)),
    ("number_changed", number_changed, (_W, _D)),
    ("openness_changed", openness_changed, (_S, _B)),
    ("polarity_changed", polarity_changed, (_W,)),
    ("range_narrowed", range_narrowed, (_B,)),
    ("range_widened", range_widened, (_B,)),
    ("register_moved", register_moved, (_W,)),
    ("renamed", renamed, (_S, _D)),
    ("reserved_changed", reserved_changed, (_W, _B)),
    ("restart_changed", restart_changed, (_B,)),
    ("role_changed", role_changed, (_W, _B)),
    ("scale_changed", scale_changed, (_W,)),
    ("sending_changed", sending_changed, (_W, _B)),
    ("sentinel_changed", sentinel_changed, (_W, _S, _B)),
    ("serial_changed", serial_changed, (_B,)),
    ("space_changed", space_changed, (_W, _B, _D)),
    ("state_changed", state_changed, (_W,)),
    ("stride_changed", stride_changed, (_W,)),
    ("table_moved", table_moved, (_W,)),
    ("timing_changed", timing_changed, (_B,)),
    ("type_changed", type_changed, (_W,)),
    ("unit_changed", unit_changed, (_W,)),
)


def changes(old: Device, new: Device) -> list[Change]:
    """The differences of two versions of a device: the gravest first, then by fact."""
    reasons = stated_reasons(old, new)
    comparison = Comparison(old, new, reasons.renames)
    all_changes = (with_reason(change, reasons) for _, rule, _ in RULES for change in rule(comparison))
    return sorted(all_changes, key=Change.order)
