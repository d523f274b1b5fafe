"""What an audit adds to the documentation of a device: its page, and the lists of versions that lead to it."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from fieldspec.audit.manual_lines import ManualIndex
from fieldspec.audit.report import report
from fieldspec.audit.section import Subject
from fieldspec.backends.docs.backend import index
from fieldspec.backends.docs.changes import page_name
from fieldspec.facts import of_versions
from fieldspec.layout.device import DeviceLayout
from fieldspec.proofs.running import Outcome, errata_proofs
from fieldspec.reading.project import DeviceSpec
from fieldspec.render.audit_html import rendered

NAME = "audit.html"
"""The file of the page, in the folder of the device's documentation."""

_ANCHOR = re.compile(r' id="([^"]+)"')


def pages(
    spec: DeviceSpec,
    layouts: Sequence[DeviceLayout],
    recorded: ManualIndex | None,
    documentation: Mapping[str, bytes],
    known: Outcome | None = None,
) -> dict[str, bytes]:
    """The files by path, relative to the folder of generated files.

    `layouts` are those of all versions, the oldest first, `recorded` is the index of the manual. `documentation` has
    the pages of the versions by path: the audit leads there where they have a fact. `known` is what running
    everything on the device has given, where that has happened.
    """
    newest = layouts[-1]
    proofs = known.proofs if known is not None else errata_proofs(spec)
    subject = Subject(spec, newest, layouts, of_versions(layouts), proofs, recorded, known=known)
    page = rendered(report(subject), newest.device, _documented(newest, documentation))
    texts = {f"{spec.id}/{NAME}": page, **index(layouts, [("audit", NAME)])}
    return {f"docs/{path}": text.encode("utf-8") for path, text in texts.items()}


def _documented(layout: DeviceLayout, documentation: Mapping[str, bytes]) -> dict[str, str]:
    """Where each fact is documented, by its path: a link from beside that page."""
    name = f"{page_name(layout.device.version)}.html"
    text = documentation.get(f"docs/{layout.device.id}/{name}", b"").decode("utf-8")
    return {path: f"{name}#{path}" for path in _ANCHOR.findall(text) if "/" in path}
