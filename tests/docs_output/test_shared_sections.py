"""What the pages of several versions share is what each page would have alone."""

from __future__ import annotations

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.targets.docs import html, markdown
from fieldspec.targets.docs.context import Holding
from fieldspec.targets.docs.document import Document, Section, code, text_piece
from fieldspec.targets.docs.page import page
from fieldspec.targets.docs.site import device_place
from layouts import SPECS, TEST_SPECS, layouts

SEVERAL = [versions for root in (SPECS, TEST_SPECS) for versions in layouts(root).values() if len(versions) > 1]


PLACE = device_place("A")


def forms(document: Document) -> tuple[str, str]:
    return html.page(document, PLACE), markdown.page(document)


@pytest.mark.proof(3)
@pytest.mark.parametrize("versions", SEVERAL, ids=[versions[0].device.id for versions in SEVERAL])
def test_pages_that_are_made_together_are_those_that_are_made_alone(versions: list[DeviceLayout]) -> None:
    holding = Holding(versions)
    together = [forms(document) for document in [page(layout, holding) for layout in versions]]
    assert together == [forms(page(layout, Holding(versions))) for layout in versions]


@pytest.mark.parametrize(
    ("anchors", "wanted"), [(["parts/one/bit"], "#parts/one/bit"), (["parts/one"], "#parts/one"), ([], "")]
)
def test_a_shared_section_leads_to_what_each_page_has(anchors: list[str], wanted: str) -> None:
    shared = Section("user", (code("a link", "#parts/one/bit"),), rendered={})
    parent = Section("all", (text_piece("All"),), (), (shared,))
    there = Section("parts/one/bit", (text_piece("A bit"),))
    first = html.page(Document("A", "", "0", "", (), (parent, there)), PLACE)
    assert '<h3><a href="#parts/one/bit"><code>a link</code></a></h3>' in first
    others = (Section(anchor, (text_piece("Other"),)) for anchor in anchors)
    text = html.page(Document("A", "", "0", "", (), (parent, *others)), PLACE)
    link = f'<a href="{wanted}"><code>a link</code></a>' if wanted else "<code>a link</code>"
    assert f"<h3>{link}</h3>" in text
