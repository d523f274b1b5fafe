"""`fieldspec lsp` shows what is under the pointer: as `show` and `decode` have it, and the manual of the language."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from lsprotocol import types
from markdown_it import MarkdownIt

from command_line import CommandLine
from editing import Editor, copied, editor
from fieldspec.command.rendering.item import fact_of, items
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.model.fact import Place
from fieldspec.language.model.texts import Example
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, children
from fieldspec.language.reading.yaml_reader import key_spans, parsed
from fieldspec.language.schema.manual import pages
from layouts import newest

ROOT = Path(__file__).parent.parent
DEVICES = ("gizmo", "glider-x", "weigher")


@pytest.fixture
def specs(tmp_path: Path) -> Path:
    return copied(tmp_path, *DEVICES)


def run_of(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, specs: Path) -> CommandLine:
    return CommandLine(capsys, monkeypatch, specs)


def position(span: Span) -> types.Position:
    before = span.file.text[: span.start]
    return types.Position(before.count("\n"), len(before.rpartition("\n")[2].encode("utf-16-le")) // 2)


async def hover_text(session: Editor, span: Span) -> str:
    """The Markdown of a hover."""
    document = types.TextDocumentIdentifier(session.uri(span.file.path))
    answer = await session.client.text_document_hover_async(types.HoverParams(document, position(span)))
    if answer is None:
        return ""
    assert isinstance(answer.contents, types.MarkupContent)
    return answer.contents.value


def stated(place: Place) -> Span | None:
    """A value that stands at a fact, and not at what the fact is a copy or a part of."""
    whole = place.whole
    spans = (value.span for value in place.values.values() if isinstance(value, Scalar))
    return next((span for span in spans if whole.start <= span.start <= span.end <= whole.end), None)


@pytest.mark.parametrize("device", DEVICES)
async def test_a_hover_says_what_show_and_decode_say_word_for_word(
    specs: Path, device: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    layout = newest(specs, device)
    run = run_of(capsys, monkeypatch, specs)
    async with editor(specs) as session:
        for item in items(layout):
            fact = fact_of(item)
            span = stated(fact.place)
            if span is None:
                continue
            text = await hover_text(session, span)
            assert f"`{device}@{layout.device.version} {fact.place.path}`" in text
            if isinstance(fact, Example):
                options = ["--link", fact.link, "--direction", fact.direction]
                options += ["--message", fact.message] if fact.message else []
                if fact.reply_to:
                    options += ["--request", layout.device.examples[fact.reply_to].frame.hex()]
                assert f"```text\n{run('decode', device, fact.frame.hex(), *options).out}```" in text
            else:
                assert f"```text\n{run('show', device, fact.place.path).out}```" in text


def described_keys(text: str, file: str) -> list[tuple[str, Span]]:
    """The keys of a file that the language describes, each once for each key of the mapping that holds it."""
    tree, _ = parsed(SourceFile(file, text))
    key_places: dict[tuple[str, str], Span] = {}

    def search(node: Node, holder: str) -> None:
        for key, span in key_spans(node) if isinstance(node, Mapping) else ():
            key_places.setdefault((holder, key), span)
        for name, child in children(node) if holder not in FREE else ():
            search(child, name if isinstance(name, str) else holder)

    assert tree is not None
    search(tree, "")
    return [(key, span) for (holder, key), span in key_places.items() if holder not in FREE]


FREE = ("allow", "expected", "inferred", "printed", "standard", "values")
"""Keys whose own keys are names of the spec, or keys of the fact that holds them."""


async def test_a_key_is_shown_as_the_manual_of_the_language_has_it(specs: Path) -> None:
    page = re.sub(r"\[([^\]]*)\]\((?:language[\w-]*\.md)?#[^)]*\)", r"\1", "".join(pages().values()))
    rows = set()
    for line in page.splitlines():
        cells = line.replace("\\|", "\0").split("|")
        if len(cells) == 6:
            name, form, _, text = (cell.strip().replace("\0", "|") for cell in cells[1:5])
            rows.add(f"{name}: {form}\n\n{text}")
    async with editor(specs) as session:
        for device in DEVICES:
            file = f"{device}/device.yaml"
            keys = described_keys(session.text(file), file)
            described = [(key, span) for key, span in keys if any(row.startswith(f"`{key}`: ") for row in rows)]
            assert len(described) > 50
            for key, span in described:
                text = await hover_text(session, span)
                # What is needed of the keys of every fact is said in a sentence below the table.
                row, _, words = text.replace(", needed\n", "\n", 1).partition("\n\n|")
                assert row.partition("\n\nPermitted values:")[0].rstrip() in rows, (file, key, words)


# The quantities that the manuals of the devices print for these numbers, which the specs have in counts.
IN_UNITS = {
    "a default": ("ck10/registers-parameters.yaml", r"name: run_current, .*default: (10),", "10 (100 %)"),
    "a value at delivery": ("esc11/behaviour.yaml", r"initial: \S+/stroke, value: (200)", "200 (20.0 mm)"),
    "a value of an example": ("esc11/examples-move.yaml", r"distance: 1.00 mm, speed: (50)", "50 (50 %)"),
    "a value of a step": ("ck10/tasks.yaml", r"write: jog_speed, value: (5000)", "5000 (5000 pps)"),
    "a default that an erratum prints": (
        "ck10/errata.yaml",
        r"printed: \{default: (2147483647)",
        "2147483647 (2147483647 pulse)",
    ),
}


async def test_a_number_has_its_quantity_wherever_it_is_given(tmp_path: Path) -> None:
    specs = copied(tmp_path, "ck10", "esc11")
    async with editor(specs) as session:
        for kind, (name, pattern, quantity) in IN_UNITS.items():
            text = session.text(name).replace("write: jog_speed, argument: speed", "write: jog_speed, value: 5000")
            if name not in session.open_names:
                await session.opened(name, text)
            match = re.search(pattern, text)
            assert match is not None, kind
            answer = await hover_text(session, Span(SourceFile(name, text), *match.span(1)))
            assert answer.startswith(f"`{quantity}`\n"), (kind, answer)


async def test_texts_of_a_spec_end_no_block_of_code_and_make_no_link(specs: Path) -> None:
    name = "gizmo/device.yaml"
    hostile = "```\\n[x](http://example.com) ![](file:///etc/passwd) <script>"
    async with editor(specs) as session:
        text = session.text(name).replace("name: speed,", f'name: speed, doc: "{hostile}", label: "````",')
        await session.opened(name, text)
        start = text.index("rpm")
        answer = await hover_text(session, Span(SourceFile(name, text), start, start + 1))
    nodes = MarkdownIt().parse(answer)
    assert [node.type for node in nodes] == ["paragraph_open", "inline", "paragraph_close", "fence"]
    assert [child.type for node in nodes for child in node.children or ()] == ["code_inline"]
    assert "http://example.com" in nodes[-1].content


async def test_a_version_in_which_a_fact_differs_is_named(tmp_path: Path) -> None:
    specs = copied(tmp_path, "glider-x")
    layout = newest(specs, "glider-x")
    device = layout.device
    async with editor(specs) as session:
        register = next(register for register in device.registers() if register.name == "resolution")
        span = stated(register.place)
        assert span is not None
        assert "differs in" not in await hover_text(session, span)
        name = span.file.path
        text = session.text(name)
        row = text.splitlines()[span.position()[0] - 1]
        both = [row.replace("{at", "{until: '1.0', at"), row.replace("{at", "{since: '1.1', doc: Finer., at")]
        await session.opened(name, text.replace(row, "\n".join(both)))
        changed = SourceFile(name, text.replace(row, "\n".join(both)))
        offset = changed.text.index("Finer.")
        assert "\ndiffers in `1.0`\n" in await hover_text(session, Span(changed, offset, offset + 1))


async def test_a_place_that_says_nothing_has_no_hover_in_a_document_that_is_broken(specs: Path) -> None:
    name = "gizmo/device.yaml"
    async with editor(specs) as session:
        await session.opened(name)
        text = session.text(name)
        broken = text + "enums: [{\n"
        await session.typed(name, broken)
        file = SourceFile(name, broken)
        start = text.index("rpm")
        assert "gizmo@1 registers/speed" in await hover_text(session, Span(file, start, start + 1))
        assert await hover_text(session, Span(file, len(broken) - 2, len(broken))) == ""
