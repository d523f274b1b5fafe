"""Frames that functions for programmable controllers cannot build or check."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.foundation.classes import replace
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.language.model.fact import Fact
from fieldspec.targets.controllers.dialects import Dialect
from fieldspec.targets.controllers.routines.checksums import is_supported


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
        if len(checks) > 1:
            last = checks[-1].part
            yield last, "name", f"{link.name} has {len(checks)} checksums in a frame"
