"""`fieldspec lsp` gives the outline of a document, and what can be folded."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from lsprotocol import types

from editing import copied, editor, numbers

NAME = "glider-x/device.yaml"


def paths(symbols: Sequence[types.DocumentSymbol], before: str = "") -> Iterator[tuple[str, types.DocumentSymbol]]:
    for symbol in symbols:
        yield before + symbol.name, symbol
        yield from paths(symbol.children or (), f"{before}{symbol.name}/")


async def test_the_outline_has_every_named_fact_at_its_name(tmp_path: Path) -> None:
    async with editor(copied(tmp_path, "glider-x")) as session:
        text = session.text(NAME)
        await session.opened(NAME)
        document = types.TextDocumentIdentifier(session.uri(NAME))
        answer = await session.client.text_document_document_symbol_async(types.DocumentSymbolParams(document))
    outline = [
        (path, symbol)
        for path, symbol in paths([symbol for symbol in answer or () if isinstance(symbol, types.DocumentSymbol)])
    ]
    lines = text.split("\n")
    for symbol in (symbol for path, symbol in outline if "/" in path):
        line, first, _, last = numbers(symbol.selection_range)
        assert lines[line][first:last] == symbol.name
    expected = re.findall(r"^  - (?:\{)?(?:name|id|group|line|protocol): ([\w-]+)", text, re.MULTILINE)
    assert len(expected) > 40
    names = [path.split("/")[1] for path, _ in outline if path.count("/") == 1]
    assert [name for name in names if name in expected] == expected
    assert "messages/read_parameter/number" in dict(outline)


async def test_sections_and_facts_of_several_lines_can_be_folded(tmp_path: Path) -> None:
    async with editor(copied(tmp_path, "glider-x")) as session:
        lines = session.text(NAME).split("\n")
        await session.opened(NAME)
        document = types.TextDocumentIdentifier(session.uri(NAME))
        answer = await session.client.text_document_folding_range_async(types.FoldingRangeParams(document))
    folded = {(fold.start_line, fold.end_line) for fold in answer or ()}
    alarm = next(number for number, line in enumerate(lines) if line == "  - name: alarm")
    end = next(number for number in range(alarm + 1, len(lines)) if not lines[number].startswith("    "))
    assert (alarm, end - 1) in folded
    assert all(start < last and lines[last].strip() for start, last in folded)
