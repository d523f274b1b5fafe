"""`fieldspec lsp` leads from a source to the line of the manual, where its text is beside the project."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from lsprotocol import types

from editing import Editor, copied, editor, numbers, place_of

GIZMO = "gizmo/device.yaml"
ROW = "{at: 0, name: speed, type: i16, unit: rpm, access: ro, source: L10}"
TEXT = "".join(f"line {number}: 速度 ``` [x](http://example.com)\n" for number in range(1, 100))


async def links(session: Editor, name: str) -> list[types.DocumentLink]:
    """The links of a document."""
    document = types.TextDocumentIdentifier(session.uri(name))
    return [*(await session.client.text_document_document_link_async(types.DocumentLinkParams(document)) or ())]


def with_manual(folder: Path, name: str) -> Path:
    """The text of a manual in the folder of manuals beside the specs."""
    path = folder / "manuals" / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(TEXT, "utf-8")
    return path


async def test_every_source_has_a_link_to_each_interval_of_lines_that_it_cites(tmp_path: Path) -> None:
    specs = copied(tmp_path, "gizmo")
    path = with_manual(tmp_path, "gizmo.txt")
    async with editor(specs) as session:
        text = session.text(GIZMO).replace(ROW, ROW.replace("source: L10", 'label: 速度𝄞, source: "1 L10-12, 20; L30"'))
        await session.opened(GIZMO, text)
        document_links = await links(session, GIZMO)
    # By the text alone: each source, and how many intervals it has.
    cited = re.findall(r"source: \"?([^}\"\n]*)", text)
    assert len(document_links) == sum(len(re.findall(r"L\d+|, \d+", source)) for source in cited)
    start = text.index("L10-12")
    places = {(*numbers(link.range)[:2], link.target) for link in document_links}
    for offset, line in ((0, 10), (len("L10-12, "), 20), (len("L10-12, 20; "), 30)):
        position = place_of(text, start + offset)
        assert (position.line, position.character, f"{path.as_uri()}#L{line}") in places


async def test_the_line_that_a_source_cites_is_in_its_hover_and_ends_no_block_of_code(tmp_path: Path) -> None:
    from markdown_it import MarkdownIt

    specs = copied(tmp_path, "gizmo")
    with_manual(tmp_path, "gizmo.txt")
    async with editor(specs) as session:
        await session.opened(GIZMO)
        text = session.text(GIZMO)
        position = place_of(text, text.index(ROW) + ROW.index("L10"))
        document = types.TextDocumentIdentifier(session.uri(GIZMO))
        hover = await session.client.text_document_hover_async(types.HoverParams(document, position))
    assert hover is not None
    assert isinstance(hover.contents, types.MarkupContent)
    fences = [node.content for node in MarkdownIt().parse(hover.contents.value) if node.type == "fence"]
    assert fences[0] == f"    10  {TEXT.splitlines()[9]}\n"
    assert "speed" in fences[1]  # the fact, as `show` has it


@pytest.mark.parametrize("name", ["../secret.txt", "/etc/hostname", "link.txt"])
async def test_no_link_leaves_the_folder_of_manuals(tmp_path: Path, name: str) -> None:
    specs = copied(tmp_path, "gizmo")
    with_manual(tmp_path, "other.txt")
    (tmp_path / "secret.txt").write_text(TEXT, "utf-8")
    (tmp_path / "manuals" / "link.txt").symlink_to(tmp_path / "secret.txt")
    async with editor(specs) as session:
        text = session.text(GIZMO).replace("file: gizmo.txt", f"file: {name}")
        await session.opened(GIZMO, text)
        assert await links(session, GIZMO) == []


async def test_without_the_text_there_is_no_link(tmp_path: Path) -> None:
    specs = copied(tmp_path, "gizmo")
    async with editor(specs) as session:
        await session.opened(GIZMO)
        assert await links(session, GIZMO) == []
