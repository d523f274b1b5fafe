"""What functions for controllers do not convert: frames, digits of signals, spaces of bytes, wide enums."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.foundation.classes import replace
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.language.model.address_space import BYTE
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.language.model.value import Value
from fieldspec.targets.controllers.dialects import Dialect
from fieldspec.targets.controllers.enums import coded
from fieldspec.targets.controllers.routines.checksums import is_supported
from fieldspec.targets.controllers.routines.world import has_common_type, raw_bounds


def with_supported_links(layout: DeviceLayout, dialect: Dialect) -> tuple[DeviceLayout, list[Diagnostic]]:
    """The layout without the links whose frames the dialect has no functions for, and a finding for each of these."""
    links, findings = {}, []
    for name, link in layout.links.items():
        reasons = list(_unsupported(link))
        for fact, key, description in reasons[:1]:
            text = f"{description}; there are no functions for that in {dialect.title}"
            findings.append(Diagnostic("plc_frames_supported", text, fact.place[key], help=LEAVE_OUT))
        if not reasons:
            links[name] = link
    return (replace(layout, links=links), findings) if findings else (layout, [])


def _unsupported(link: LinkLayout) -> Iterator[tuple[Fact, str, str]]:
    """The facts that no function expresses, each with its key and a description."""
    if link.link.is_can:
        yield link.link, "can", f"{link.name} is a CAN bus"
    elif link.link.escape is not None:
        yield link.link, "escape", f"{link.name} escapes bytes"
    elif link.link.preamble is not None:
        yield link.link, "preamble", f"{link.name} has a preamble of varying length"
    if link.has_uncoded_exceptions:
        yield link.link, "exception_response", f"{link.name} marks exception responses that carry no code"
    for frame in (link.request, link.response):
        checks = frame.checksums
        for check in checks:
            if not is_supported(check.algorithm):
                key = "checksum" if "checksum" in check.part.place else "algorithm"
                stated = f"{check.part.stated_algorithm} with a prefix" if check.part.prefix else check.algorithm
                yield check.part, key, f"the checksum {check.name} of {link.name} has the algorithm {stated}"
            if check.digits:
                yield check.part, "digits", f"the checksum {check.name} of {link.name} is sent as digits"
        shared = next((part for part in frame.header if part.width), None)
        if shared is not None:
            yield shared.part, "bits", f"{shared.name} of {link.name} shares its bytes with other parts"
        if len(checks) > 1:
            last = checks[-1].part
            yield last, "name", f"{link.name} has {len(checks)} checksums in a frame"


def without_digits(layout: DeviceLayout) -> DeviceLayout:
    """The layout without the digits of signals: bytes hold them, and other facts about them are left out."""
    if not any(signal.value.digits for signal in layout.device.signals.values()):
        return layout
    signals = {name: replace(signal, value=_bytes(signal.value)) for name, signal in layout.device.signals.items()}
    return replace(layout, device=replace(layout.device, signals=signals))


def _bytes(value: Value) -> Value:
    if not value.digits:
        return value
    kind = PRIMITIVES["bytes"]
    scale, offset = type(value.scale)(1), type(value.offset)(0)
    bare = replace(value, type=kind, digits="", places=0, has_blanks=False, scale=scale, scale_text="", offset=offset)
    return replace(bare, enum="", flags="", sentinels=(), unit="", default=None, ranges=None, write_ranges=None)


def with_supported_spaces(layout: DeviceLayout, dialect: Dialect) -> tuple[DeviceLayout, list[Diagnostic]]:
    """The layout without the groups of registers in spaces of bytes, and a finding for each of these."""
    device, findings = layout.device, []
    for group in device.groups:
        if device.space(group.space).unit == BYTE:
            text = f"an address of the registers in {group.name} is a byte; there are no functions for that in "
            text += dialect.title
            findings.append(Diagnostic("plc_spaces_supported", text, group.place["group"], help=LEAVE_OUT))
    if not findings:
        return layout, []
    groups = tuple(group for group in device.groups if device.space(group.space).unit != BYTE)
    registers = tuple(register for register in layout.registers if register.register.unit_size > 1)
    return replace(layout, device=replace(device, groups=groups), registers=registers), findings


_MOST = (1 << 63) - 1


def wide_enums(layout: DeviceLayout, dialect: Dialect) -> Iterator[Diagnostic]:
    """A finding for each enum that no type holds, and for each whose codes are too great for the list of texts."""
    for name, (low, high) in raw_bounds(layout).items():
        if not has_common_type(low, high):
            text = f"values with {name} may be negative, or 2^63 and more; {dialect.title} has no type for both"
            yield Diagnostic("plc_enums_fit", text, layout.device.enums[name].place["name"], help=LEAVE_OUT)
    if not dialect.texts:
        return
    for enum, texts in coded(layout.device):
        if max(text.code for text in texts) > _MOST:
            text = f"{enum.name} has codes from 2^63 on with texts; lists of texts have a signed column of codes"
            yield Diagnostic("plc_enums_fit", text, enum.place["name"], help=LEAVE_OUT)
