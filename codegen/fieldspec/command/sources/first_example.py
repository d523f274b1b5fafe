"""Right frames of a new device: the request that reads its first registers, and the response."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.codec.layout.values import Raw
from fieldspec.codec.reference import codec
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.project import read
from fieldspec.targets.vectors.idle_reads import idle_reads
from fieldspec.tools.simulator.simulation import usual_unit_address


def examples(name: str, files: Mapping[str, bytes]) -> Iterator[str]:
    """The lines of the section of a spec; none where nothing reads registers, or the spec has errors."""
    spec = read(files).devices[name]
    device, findings = spec.at(spec.versions()[-1])
    layout = None if has_errors(findings) else device_layout(device)
    first = next(idle_reads(layout), None) if layout is not None else None
    if layout is None or first is None:
        return
    yield "# One right frame of the manual for each message: the check decodes and encodes it."
    yield "examples:"
    message = first.block.message
    for id, direction, values in (
        ("read-first", "request", first.request_values),
        ("first", "response", first.response_values),
    ):
        stated_values = _stated_values(layout, first.link, direction, message, values)
        frame = codec(layout).links[first.link].encode(direction, message, stated_values)
        reply = "reply_to: read-first, " if direction == "response" else ""
        yield f"  - {{id: {id}, {reply}link: {first.link}, direction: {direction}, message: {message}, source: 1 L1,"
        yield f'     frame: "{frame.hex(" ").upper()}", values: {spec_text(stated_values)}}}'


def _stated_values(
    layout: DeviceLayout, link: str, direction: str, message: str, values: Mapping[str, Raw]
) -> dict[str, Raw]:
    """The values that nothing else in the frame decides, sent to the usual unit."""
    parts = {part.name: part for part in layout.links[link].frame(direction).header if part.is_argument}
    body = layout.messages[message].data(direction)
    fields = [field.name for field in body.fields if field.field.measures is None and not field.field.reserved]
    stated_values = {name: value for name, value in values.items() if name in parts or name in fields}
    units = {part.name: usual_unit_address(layout) for part in parts.values() if part.role == "unit_address"}
    return {**stated_values, **units}
