"""All rules by name, with the effects that they may have, and how they are applied."""

from __future__ import annotations

from fieldspec.changes.access_changed import access_changed
from fieldspec.changes.applicability_changed import applicability_changed
from fieldspec.changes.availability_changed import availability_changed
from fieldspec.changes.bit_moved import bit_moved
from fieldspec.changes.broadcast_changed import broadcast_changed
from fieldspec.changes.building_changed import building_changed
from fieldspec.changes.byte_order_changed import byte_order_changed
from fieldspec.changes.case_changed import case_changed
from fieldspec.changes.change import Change, Effect
from fieldspec.changes.check_changed import check_changed
from fieldspec.changes.code_changed import code_changed
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.const_changed import const_changed
from fieldspec.changes.conversion_changed import conversion_changed
from fieldspec.changes.count_changed import count_changed
from fieldspec.changes.default_changed import default_changed
from fieldspec.changes.documentation_changed import documentation_changed
from fieldspec.changes.edge_changed import edge_changed
from fieldspec.changes.enum_changed import enum_changed
from fieldspec.changes.error_reply_changed import error_reply_changed
from fieldspec.changes.example_changed import example_changed
from fieldspec.changes.fact_added import fact_added
from fieldspec.changes.fact_removed import fact_removed
from fieldspec.changes.field_moved import field_moved
from fieldspec.changes.finding import Rule
from fieldspec.changes.flags_changed import flags_changed
from fieldspec.changes.framing_changed import framing_changed
from fieldspec.changes.handling_changed import handling_changed
from fieldspec.changes.index_changed import index_changed
from fieldspec.changes.length_changed import length_changed
from fieldspec.changes.limit_changed import limit_changed
from fieldspec.changes.member_added import member_added
from fieldspec.changes.member_removed import member_removed
from fieldspec.changes.member_renumbered import member_renumbered
from fieldspec.changes.number_changed import number_changed
from fieldspec.changes.openness_changed import openness_changed
from fieldspec.changes.polarity_changed import polarity_changed
from fieldspec.changes.range_narrowed import range_narrowed
from fieldspec.changes.range_widened import range_widened
from fieldspec.changes.register_moved import register_moved
from fieldspec.changes.renamed import renamed
from fieldspec.changes.reserved_changed import reserved_changed
from fieldspec.changes.restart_changed import restart_changed
from fieldspec.changes.role_changed import role_changed
from fieldspec.changes.scale_changed import scale_changed
from fieldspec.changes.sending_changed import sending_changed
from fieldspec.changes.sentinel_changed import sentinel_changed
from fieldspec.changes.serial_changed import serial_changed
from fieldspec.changes.space_changed import space_changed
from fieldspec.changes.state_changed import state_changed
from fieldspec.changes.stride_changed import stride_changed
from fieldspec.changes.table_moved import table_moved
from fieldspec.changes.timing_changed import timing_changed
from fieldspec.changes.type_changed import type_changed
from fieldspec.changes.unit_changed import unit_changed
from fieldspec.model.device import Device

_W, _S, _B, _D = Effect

RULES: tuple[tuple[str, Rule, tuple[Effect, ...]], ...] = (
    ("access_changed", access_changed, (_B,)),
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
    ("documentation_changed", documentation_changed, (_D,)),
    ("edge_changed", edge_changed, (_B,)),
    ("enum_changed", enum_changed, (_W, _S)),
    ("error_reply_changed", error_reply_changed, (_W,)),
    ("example_changed", example_changed, (_D,)),
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
    ("member_renumbered", member_renumbered, (_W,)),
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
    """What differs between two versions of a device: the gravest first, then by fact."""
    both = Comparison(old, new)
    return sorted((change for _, rule, _ in RULES for change in rule(both)), key=Change.order)
