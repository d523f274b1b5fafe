"""The audit's page among the documentation of a device."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.rendering.audit_html import rendered
from fieldspec.foundation.html_text import clean
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.targets import PageLink
from fieldspec.targets.docs.site import device_place
from fieldspec.tools.audit.manual_lines import ManualIndex
from fieldspec.tools.audit.report import report
from fieldspec.tools.audit.section import Subject
from fieldspec.tools.facts import of_versions
from fieldspec.tools.proofs.running import Outcome, errata_proofs

LINK = PageLink("audit", "audit.html")
"""The entry of the page in the index of a device's documentation."""


def pages(
    spec: DeviceSpec,
    layouts: Sequence[DeviceLayout],
    recorded: ManualIndex | None,
    links: Mapping[str, str],
    known: Outcome | None = None,
) -> dict[str, bytes]:
    """The page of a device's audit, by its path below the folder of all outputs.

    `layouts` are the layouts of all versions, the oldest first; the audit is of the last one. `recorded` is the index
    of the manual, where there is one. `links` lead from paths of facts to where they are documented. `known` is the
    outcome of all checks and proofs of the device, where they have run.
    """
    newest = layouts[-1]
    proofs = known.proofs if known is not None else errata_proofs(spec)
    subject = Subject(spec, newest, layouts, of_versions(layouts), proofs, recorded, known=known)
    page = rendered(report(subject), newest.device, links, device_place(clean(newest.device.name)))
    return {f"docs/{spec.id}/{LINK.file}": page.encode("utf-8")}
