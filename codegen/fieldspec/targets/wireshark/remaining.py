"""The facts that a dissector shows: facts that it cannot decode are shown as bytes."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from fieldspec.codec.layout.absences import Absences, Cause, absences
from fieldspec.codec.layout.bases import base_refusals
from fieldspec.codec.layout.characters import character_refusals
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.inner_list_refusals import inner_list_refusals
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.omissions import Omission, warning
from fieldspec.codec.layout.package_codecs import checksum_refusals
from fieldspec.codec.layout.record import FieldLayout, RecordLayout, RegisterLayout
from fieldspec.codec.layout.refusal import Refusal
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.language.model.record import Case, Field
from fieldspec.language.model.registers import Register
from fieldspec.language.model.value import Value
from fieldspec.targets.wireshark.values import digit_patterns

_READER = "the dissector"


@dataclass(frozen=True, slots=True)
class Remaining:
    """A device with bytes in place of the values that a dissector does not decode, and without tables that move.

    `records` are the records that it shows only as bytes, `bodies` such data of messages, by message and direction.
    `omissions` say what is shown as bytes or left out. `findings` are errors and warnings. `digits` are patterns of the
    digits among such bytes, by the paths of their facts.
    """

    layout: DeviceLayout
    records: Collection[str]
    bodies: Collection[tuple[str, str]]
    omissions: tuple[Omission, ...]
    findings: tuple[Diagnostic, ...]
    digits: Mapping[str, list[bytes]]


def remaining(layout: DeviceLayout) -> Remaining:
    """The facts of a device that a dissector shows, with those that it leaves out."""
    refusals = [
        *_parameters_in_bytes(layout),
        *character_refusals(layout, _READER),
        *checksum_refusals(layout, _READER),
        *base_refusals(layout, _READER),
        *inner_list_refusals(layout, _READER),
    ]
    if not refusals:
        return Remaining(layout, (), (), (), (), {})
    separate = set(_separate_values(layout))
    in_place = [refusal for refusal in refusals if refusal.path in separate]
    absent = absences(layout, [refusal for refusal in refusals if refusal.path not in separate])
    deeds = {id(refusal.finding): [f"{refusal.path} is shown as bytes"] for refusal in in_place}
    omissions = [Omission(refusal.path, refusal.finding.message) for refusal in in_place]
    for title, deed, causes in _absent(absent):
        omissions.append(Omission(title, causes[0].reason))
        for finding in {id(cause.finding): cause.finding for cause in causes}.values():
            deeds.setdefault(id(finding), []).append(f"{title} {deed}")
    findings = {id(refusal.finding): refusal.finding for refusal in refusals}.values()
    return Remaining(
        _in_bytes(layout, {refusal.path for refusal in in_place}, absent),
        absent.records,
        absent.bodies,
        tuple(omissions),
        (
            *absent.findings,
            *(
                warning(finding, ", ".join(deeds[id(finding)]))
                for finding in findings
                if id(finding) in deeds and not any(finding is other for other in absent.findings)
            ),
        ),
        {refusal.path: patterns for refusal in in_place if (patterns := _digit_patterns(refusal.fact))},
    )


def _digit_patterns(fact: Fact) -> list[bytes]:
    """The patterns of the digits of a register, a field or a case; none for other values."""
    value = fact.value if isinstance(fact, Register | Field | Case) else None
    return digit_patterns(value) if value is not None else []


def _parameters_in_bytes(layout: DeviceLayout) -> Iterator[Refusal]:
    """A refusal of each field with the bytes of a parameter."""
    for message in layout.messages.values():
        for record in (message.request, message.response):
            for field in record.fields:
                if field.carries_bytes:
                    text = f"{field.name} of {message.name} has the bytes of a parameter, which the dissector does not"
                    place = field.field.place["parameter"]
                    finding = Diagnostic(
                        "wireshark_parameters_typed", f"{text} read as its value", place, help=LEAVE_OUT
                    )
                    yield Refusal(field.field, finding)


def _separate_values(layout: DeviceLayout) -> Iterator[str]:
    """The paths of the values that can be bytes in their place: nothing else is read by means of their numbers."""
    for register in layout.registers:
        yield register.register.place.path
    for record in layout.records.values():
        yield from _separate_fields(record, ())
    for message in layout.messages.values():
        access = message.message.single_access
        names = (access.start, access.count, access.values) if access is not None else ()
        for record in (message.request, message.response):
            yield from _separate_fields(record, names)


def _separate_fields(record: RecordLayout, names: Collection[str]) -> Iterator[str]:
    if record.selector is not None:
        yield from (case.case.place.path for case in record.fields[-1].cases if not case.value.width)
    for field in record.fields:
        value = field.value
        if value is None or value.width or field.field.measures is not None or field.bits_of:
            continue
        if value.parameter is not None and not field.carries_bytes:
            continue
        if field is not record.selector and field.name not in names and not _is_varying_list(record, field):
            yield field.field.place.path


def _is_varying_list(record: RecordLayout, field: FieldLayout) -> bool:
    """Whether a field is a list, and its place or that of the field after it differs from frame to frame."""
    return (field.count is None or field.packing is not None) and record.inner_lists is not None


def _absent(absent: Absences) -> Iterator[tuple[str, str, tuple[Cause, ...]]]:
    """A fact that a dissector does not decode: its replacement in words, and the reason. It shows records in messages
    alone.
    """
    for name, causes in absent.registers.items():
        yield f"register {name}", "is left out", causes
    for name, causes in absent.tables.items():
        yield f"table {name}", "is left out", causes
    for (name, direction), causes in absent.bodies.items():
        yield f"data of the {direction} of message {name}", "are shown as bytes", causes


def _in_bytes(layout: DeviceLayout, paths: Collection[str], absent: Absences) -> DeviceLayout:
    """The layout with bytes in place of some values, and without the registers and tables that are absent."""
    records: dict[str, RecordLayout] = {}
    for name, record in layout.records.items():
        records[name] = _record(record, paths, records)
    return replace(
        layout,
        records=records,
        messages={
            name: MessageLayout(
                message.message,
                name,
                _record(message.request, paths, records),
                _record(message.response, paths, records),
            )
            for name, message in layout.messages.items()
        },
        registers=tuple(_register(own, paths) for own in layout.registers if own.name not in absent.registers),
        tables={
            name: replace(table, record=records[table.record.name])
            for name, table in layout.tables.items()
            if name not in absent.tables
        },
    )


def _record(record: RecordLayout, paths: Collection[str], records: dict[str, RecordLayout]) -> RecordLayout:
    fields = tuple(_field(field, paths, records) for field in record.fields)
    refused = [case for field in fields for case in field.cases if case.case.place.path in paths]
    if not refused and all(field is other for field, other in zip(fields, record.fields, strict=True)):
        return record
    by_name = {field.name: field for field in fields}
    selector = by_name[record.selector.name] if record.selector is not None else None
    in_bytes = {number for case in refused for number in case.numbers}
    chosen = {}
    for number, own in record.chosen.items():
        *before, last = _record(own, paths, records).fields
        if number in in_bytes and last.value is not None:
            last = replace(last, value=_bytes(last.value))
        chosen[number] = replace(own, fields=(*before, last))
    return replace(record, fields=fields, selector=selector, chosen=chosen)


def _field(field: FieldLayout, paths: Collection[str], records: dict[str, RecordLayout]) -> FieldLayout:
    if field.record is not None:
        inner = records[field.record.name]
        return field if inner is field.record else replace(field, record=inner)
    if field.value is None or field.field.place.path not in paths:
        return field
    return replace(field, field=replace(field.field, signal="", same_as=""), value=_bytes(field.value))


def _register(layout: RegisterLayout, paths: Collection[str]) -> RegisterLayout:
    if layout.register.place.path not in paths:
        return layout
    return replace(layout, register=replace(layout.register, value=_bytes(layout.register.value)))


def _bytes(value: Value) -> Value:
    """A value as bytes of which only the number is known."""
    scale, offset = type(value.scale)(1), type(value.offset)(0)
    bare = replace(value, type=PRIMITIVES["bytes"], digits="", places=0, has_blanks=False, text_form=None, width=0)
    bare = replace(bare, scale=scale, scale_text="", scale_by="", offset=offset, unit="", parameter=None)
    return replace(bare, enum="", flags="", sentinels=(), default=None, const=None, ranges=None, write_ranges=None)
