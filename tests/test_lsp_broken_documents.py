"""`fieldspec lsp` answers every request on documents that are cut anywhere, without a traceback and without hanging."""

from __future__ import annotations

import asyncio
import random
from pathlib import Path

import pytest
from lsprotocol import types

from bounded import HANGING
from editing import Editor, copied, editor_of_the_verb, place_of
from proofs import IS_WHOLE

CUTS = 40 if IS_WHOLE else 15


@pytest.mark.proof
async def test_every_request_on_a_document_that_is_cut_has_an_answer(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    specs = copied(tmp_path, "glider-x", "wattmeter")
    chance = random.Random(37)
    async with editor_of_the_verb(specs) as session:
        names = ["glider-x/device.yaml", "wattmeter/device.yaml", "wattmeter/versions/2.yaml"]
        for name in names:
            await session.opened(name)
        for _ in range(CUTS):
            name = chance.choice(names)
            text = session.text(name)
            first, last = sorted(chance.randrange(len(text) + 1) for _ in range(2))
            text = chance.choice([text[:first], text[last:], text[:first] + text[last:], text[:first] + "\ufeff\0{"])
            await session.typed(name, text)
            await asyncio.wait_for(asked(session, name, text, chance), HANGING)
    assert "Traceback" not in capfd.readouterr().err


async def asked(session: Editor, name: str, text: str, chance: random.Random) -> None:
    """Sends all requests at some places, and at one that is not there."""
    client, document = session.client, types.TextDocumentIdentifier(session.uri(name))
    places = [place_of(text, chance.randrange(len(text) + 1)) for _ in range(3)]
    await client.text_document_document_symbol_async(types.DocumentSymbolParams(document))
    await client.text_document_folding_range_async(types.FoldingRangeParams(document))
    await client.text_document_document_link_async(types.DocumentLinkParams(document))
    for position in (*places, types.Position(10**6, 10**6)):
        await client.text_document_hover_async(types.HoverParams(document, position))
        await client.text_document_definition_async(types.DefinitionParams(document, position))
        context = types.ReferenceContext(include_declaration=True)
        await client.text_document_references_async(types.ReferenceParams(context, document, position))
        await client.text_document_completion_async(types.CompletionParams(document, position))
        selection = types.Range(*sorted((places[0], position), key=lambda place: (place.line, place.character)))
        offered = types.CodeActionParams(document, selection, types.CodeActionContext([]))
        await client.text_document_code_action_async(offered)
        rename = client.text_document_rename_async(types.RenameParams(document, position, "other"))
        (answer,) = await asyncio.gather(rename, return_exceptions=True)
        assert getattr(answer, "code", types.LSPErrorCodes.RequestFailed) == types.LSPErrorCodes.RequestFailed
