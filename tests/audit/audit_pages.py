"""The audits of all devices as pages, the real and the made-up ones, beside the documentation they lead to."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from fieldspec.command.pipeline import output
from fieldspec.command.rendering.audit_html import LINK, pages
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import read
from fieldspec.targets.docs.backend import fact_links
from fieldspec.tools.audit.manual_lines import NAME, parsed
from layouts import SPECS, TEST_SPECS, layout_at


@cache
def projects() -> dict[str, tuple[Path, DeviceSpec]]:
    """All devices by id, with the folder of specs in which each is."""
    specs = {}
    for root in (SPECS, TEST_SPECS):
        files = {path.relative_to(root).as_posix(): path.read_bytes() for path in sorted(root.rglob("*.yaml"))}
        specs |= {name: (root, spec) for name, spec in read(files, folder="specs").devices.items()}
    return specs


@cache
def files(device: str) -> dict[str, str]:
    """What an audit adds to the documentation of a device, and that documentation, by path."""
    root, spec = projects()[device]
    layouts = [layout_at(spec, version) for version in spec.versions()]
    path = root / device / NAME
    index = parsed(f"specs/{device}/{NAME}", path.read_text("utf-8")) if path.exists() else None
    documentation = output("docs", layouts, (LINK,))
    outputs = {**documentation, **pages(spec, layouts, index, fact_links(layouts[-1], documentation))}
    return {name: content.decode("utf-8") for name, content in outputs.items()}


def page(device: str) -> str:
    """The page of a device's audit."""
    return files(device)[f"docs/{device}/audit.html"]
