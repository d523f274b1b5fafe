"""`fieldspec lsp` answers every request on the four devices as they are, in all their files, wherever it is asked."""

from __future__ import annotations

import asyncio
import random
import shutil
from pathlib import Path

import pytest
from lsprotocol import types

from bounded import HANGING
from editing import Editor, editor, place_of

ROOT = Path(__file__).parent.parent
DEVICES = ("ck10", "esc11", "hiwin-e", "tc100")
PLACES = 12
"""Places of each device, in files that are drawn."""


@pytest.mark.proof(1)
@pytest.mark.parametrize("device", DEVICES)
async def test_each_request_has_an_answer_on_a_device_and_no_finding_is_left(
    tmp_path: Path, device: str, capfd: pytest.CaptureFixture[str]
) -> None:
    specs = tmp_path / "specs"
    for folder in ("protocols", device):
        shutil.copytree(ROOT / "specs" / folder, specs / folder)
    chance = random.Random(37)
    names = [f"{device}/{path.name}" for path in sorted((specs / device).glob("*.yaml"))]
    answered: set[str] = set()
    async with editor(specs) as session:
        assert await session.opened(names[0]) == []
        for _ in range(PLACES):
            name = chance.choice(names)
            text = session.text(name)
            if name not in session.open_names:
                await session.opened(name, text.replace("\n", "\r\n") if chance.random() < 0.5 else text)
            offset = chance.randrange(len(text))
            answered |= await asyncio.wait_for(answers(session, name, place_of(text, offset)), HANGING)
    assert answered >= {"hover", "completion", "codeAction", "outline", "folding"}
    assert "Traceback" not in capfd.readouterr().err


async def answers(session: Editor, name: str, position: types.Position) -> set[str]:
    """The requests that have something to say of a place."""
    client, document = session.client, types.TextDocumentIdentifier(session.uri(name))
    place = types.Range(position, position)
    completion = await client.text_document_completion_async(types.CompletionParams(document, position))
    actions = types.CodeActionParams(document, place, types.CodeActionContext([]))
    context = types.ReferenceContext(include_declaration=True)
    answers = {
        "hover": await client.text_document_hover_async(types.HoverParams(document, position)),
        "completion": completion.items if isinstance(completion, types.CompletionList) else completion,
        "codeAction": await client.text_document_code_action_async(actions),
        "definition": await client.text_document_definition_async(types.DefinitionParams(document, position)),
        "references": await client.text_document_references_async(types.ReferenceParams(context, document, position)),
        "outline": await client.text_document_document_symbol_async(types.DocumentSymbolParams(document)),
        "folding": await client.text_document_folding_range_async(types.FoldingRangeParams(document)),
        "links": await client.text_document_document_link_async(types.DocumentLinkParams(document)),
    }
    return {request for request, answer in answers.items() if answer}
