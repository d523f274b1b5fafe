"""What outputs refuse that read lists only where they come last."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.refusal import Refusal
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic

_OPTIONAL, _IN_BITS = "is optional", "has its count in some bits of a field"
_ENDING = "ends where an element says so"
_READ = {
    _OPTIONAL: "fields that are always sent",
    _IN_BITS: "counts that are whole fields",
    _ENDING: "lists that come last or have a count",
}
_LISTS = "lists that come last, of elements of one size"
_KEYS = ("more_if", "present_if", "packed_bits", "repeat", "record")


def inner_list_refusals(layout: DeviceLayout, reader: str, for_controllers: bool = False) -> list[Refusal]:
    """A refusal of each list with fields after it, a count in bits or elements that end it, and of each optional field,
    which `reader` does not read.
    """
    bodies = [body for message in layout.messages.values() for body in message.bodies]
    lists = {
        field.field.place.path: (field.field, problem)
        for body in (*layout.records.values(), *bodies)
        for field in body.sent_fields
        if (problem := _problem(body, field))
    }
    return [
        Refusal(
            field,
            Diagnostic(
                "plc_lists_last" if for_controllers else "output_lists_last",
                f"{field.name} {problem}, and {reader} reads only {_READ.get(problem, _LISTS)}",
                field.place[next((key for key in _KEYS if key in field.place), "choice")],
                help=LEAVE_OUT,
            ),
        )
        for field, problem in lists.values()
    ]


def _problem(body: RecordLayout, field: FieldLayout) -> str:
    """Why such outputs do not read a field; empty where they do."""
    if field.continuation is not None:
        return _ENDING
    if field.presence is not None:
        return _IN_BITS if field.has_count_in_bits else _OPTIONAL
    if body.inner_lists is None or not field.varies or field.in_room:
        return ""  # a text that varies in length is refused itself, and with it what has it
    if field.value is not None and field.value.packed_bits:
        return f"has numbers of {field.value.packed_bits} bits"
    if field is not body.sent_fields[-1]:
        return f"has {'several types and ' * bool(field.forms)}fields after it"
    if field.forms:
        return "has several types, in a record or after fields without a fixed size"
    record = field.record
    if (
        record is None
        or record.size is not None
        or any(own.value is not None and own.value.width for own in record.fields)
    ):
        return ""
    return "has elements that differ in size" if field.is_list else "differs in size"
