"""A slip in the YAML of a file is a finding that points to it, whichever of PyYAML's parsers reads the file."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
import yaml

from fieldspec.language.reading import yaml_reader
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence
from fieldspec.language.reading.yaml_reader import DEEPEST_TREE, decoded, key_span, parsed
from spec_files import codes, pointed_at, unmarked

DEEP = "[" * (DEEPEST_TREE + 1) + "«[»" + "]" * (DEEPEST_TREE + 2)
LAUGHS = "a: &a [x, x, x, x, x, x, x, x, x, x]\n" + "".join(
    f"{name}: &{name} [{', '.join([f'*{of}'] * 10)}]\n" for of, name in zip("abcdefgh", "bcdefghi", strict=True)
)

SLIPS = {
    "a key that stands twice": ("duplicate_key", "a: 1\n«a»: 2\n"),
    "a key that stands twice in one line": ("duplicate_key", "rows: [{at: 1, name: b, «at»: 2}]\n"),
    "a key that stands twice, once in quotes": ("duplicate_key", "a: 1\n«'a'»: 2\n"),
    "a merge key that stands twice": ("duplicate_key", "a: &a {x: 1}\nb: {<<: *a, «<<»: *a}\n"),
    "an alias without its anchor": ("alias_unknown", "a: «*b»\n"),
    "an alias before its anchor": ("alias_unknown", "a: «*b»\nc: &b 1\n"),
    "a list that holds itself": ("alias_unknown", "a: &a [1, «*a»]\n"),
    "a mapping that holds itself": ("alias_unknown", "a: &a\n  b:\n    - {c: «*a»}\n"),
    "a list that holds itself by a name that stood elsewhere": ("alias_unknown", "a: &a 1\nb: &a [«*a»]\n"),
    "aliases of aliases": ("aliases_grow", LAUGHS.replace("g: &g [*f,", "g: &g [«*f»,")),
    "aliases of deep lists": (
        "too_deep",
        f"a: &a {'[' * 40}{']' * 40}\nb: {'[' * 40}«*a»{']' * 40}\n",
    ),
    "too many levels": ("too_deep", DEEP),
    "a key that is a list": ("key_not_text", "«[a, b]»: 1\n"),
    "a key that is a mapping": ("key_not_text", "? «{a: 1}»\n: 2\n"),
    "a tag": ("tag_used", "a: &b «!!int» 5\n"),
    "a tag that would run code": ("tag_used", "a: «!!python/object/apply:os.system» [x]\n"),
    "a tag of a mapping": ("tag_used", "a: «!x» {b: 1}\n"),
    "a tab that indents": ("tab_indent", "a:\n«\t»b: 1\n"),
    "a tab after blanks": ("tab_indent", "a:\n  «\t»b: 1\n"),
    "a second document": ("several_documents", "a: 1\n«---»\nb: 2\n"),
    "a second document after an end": ("several_documents", "a: 1\n...\n«---»\nb: 2\n"),
    "an unclosed list": ("yaml_syntax", "a: [1, 2\nb: 3\n"),
    "an unclosed quote": ("yaml_syntax", 'a: "b\n'),
    "a colon in a text": ("yaml_syntax", "a: b: c\n"),
    "a text and a mapping": ("yaml_syntax", "a\nb: 1\n"),
    "a NUL": ("yaml_syntax", "a: «\0»\n"),
    "an escape character": ("yaml_syntax", "a: 伺服«\x1b»[31m\n"),
    "a character that is not a character": ("yaml_syntax", "a: 伺服«\uffff»\n"),
    "an escape of no character": ("yaml_syntax", 'a: "\\UFFFFFFFF"\n'),
    "an escape of half a character": ("yaml_syntax", 'a: "\\uD800"\n'),
    "an escape of half a character in a tag": ("yaml_syntax", "a: !%ED%A0%80 b\n"),
    "a version that YAML does not have": ("yaml_syntax", "%YAML 3.0\n---\na: 1\n"),
}
PARSERS = {"python": yaml.Loader} | ({"libyaml": yaml._yaml.CParser} if yaml.__with_libyaml__ else {})


@pytest.fixture(params=list(PARSERS))
def parser(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.setattr(yaml_reader, "_Parser", PARSERS[request.param])
    return str(request.param)


def slips(data: bytes) -> list[yaml_reader.Diagnostic]:
    file, findings = decoded("a.yaml", data)
    return findings or parsed(file)[1]


def node_of(text: str) -> Node:
    file, findings = decoded("a.yaml", text.encode())
    assert codes(findings) == []
    node, findings = parsed(file)
    assert codes(findings) == []
    assert node is not None
    return node


def shape(node: Node) -> object:
    """A tree as plain texts, with the places of its nodes."""
    if isinstance(node, Scalar):
        return node.start, node.end, node.text, node.quoted
    if isinstance(node, Sequence):
        return node.start, [shape(item) for item in node.items]
    spans = {key: key_span(node, key) for key in node.values}
    return node.start, [(key, spans[key].start, spans[key].end, shape(value)) for key, value in node.values.items()]


@pytest.mark.usefixtures("parser")
@pytest.mark.parametrize("ends", ["\n", "\r\n"], ids=["lf", "crlf"])
@pytest.mark.parametrize(("code", "text"), SLIPS.values(), ids=SLIPS)
def test_a_slip_has_a_finding_where_it_is(code: str, text: str, ends: str) -> None:
    clean, start, end = unmarked(text.replace("\n", ends))
    (finding,) = slips(clean.encode())
    assert finding.code == code
    assert finding.message
    if "«" in text:
        assert (finding.span.start, pointed_at(finding.span)) == (start, clean[start:end])


@pytest.mark.parametrize(
    ("text", "encoding", "position"),
    [
        ("a: 1\n", "utf-16", (1, 1)),
        ("a: 1\nb: é\n", "latin-1", (2, 4)),
        ("a: 1\nb: 伺服\n", "gb18030", (2, 4)),
        ("a: 1\nb: 伺服\n", "big5", (2, 4)),
    ],
)
def test_a_file_that_is_not_utf8_has_a_finding_at_its_first_wrong_byte(
    text: str, encoding: str, position: tuple[int, int]
) -> None:
    (finding,) = slips(text.encode(encoding))
    assert (finding.code, finding.span.position()) == ("not_utf8", position)


def test_utf16_without_a_mark_has_a_finding() -> None:
    (finding,) = slips("a: 1\n".encode("utf-16-le"))
    assert (finding.code, finding.span.start) == ("yaml_syntax", 1)


def test_a_wrong_byte_is_located_after_wide_characters() -> None:
    (finding,) = slips("a: 伺服".encode() + b"\xff")
    assert (finding.code, finding.span.position()) == ("not_utf8", (1, 6))


@pytest.mark.usefixtures("parser")
def test_a_byte_order_mark_is_accepted_and_counts_for_no_column() -> None:
    file, findings = decoded("a.yaml", b"\xef\xbb\xbfa: 1\na: 2\n")
    assert codes(findings) == []
    assert codes(parsed(file)[1]) == ["duplicate_key"]
    assert parsed(file)[1][0].span.position() == (2, 1)


def test_a_file_that_is_too_large_has_one_finding() -> None:
    (finding,) = slips(b"#" * (yaml_reader.LARGEST_FILE + 1))
    assert finding.code == "file_too_large"


def test_a_file_of_the_largest_size_is_read() -> None:
    assert slips(b"a: 1\n" + b"#" * (yaml_reader.LARGEST_FILE - 5)) == []


def test_a_file_with_too_many_values_has_one_finding(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(yaml_reader, "LARGEST_TREE", 5)
    assert codes(slips(b"[1, 2, 3, 4]")) == []
    (finding,) = slips(b"[1, 2, 3, 4, 5]")
    assert (finding.code, pointed_at(finding.span)) == ("file_too_large", "5")


@pytest.mark.usefixtures("parser")
@pytest.mark.parametrize("text", ["", "\n\n", "# a comment\n", "\ufeff"])
def test_an_empty_file_has_no_tree_and_no_slip(text: str) -> None:
    file, _ = decoded("a.yaml", text.encode())
    assert parsed(file) == (None, [])


@pytest.mark.usefixtures("parser")
def test_the_deepest_tree_is_read() -> None:
    assert isinstance(node_of("[" * DEEPEST_TREE + "1" + "]" * DEEPEST_TREE), Sequence)


@pytest.mark.usefixtures("parser")
def test_an_alias_has_the_value_of_its_anchor() -> None:
    node = node_of("a: &x {b: [1, 2]}\nc: *x\nd: [*x, *x]\n")
    assert isinstance(node, Mapping)
    assert node.values["a"] == node.values["c"]


@pytest.mark.usefixtures("parser")
def test_an_alias_is_its_own_node_as_the_schema_may_give_it_another_type() -> None:
    node = node_of("a: &x {b: [1, 2]}\nc: *x\n")
    assert isinstance(node, Mapping)
    assert node.values["a"] is not node.values["c"]


KEYS = {
    "in a block": "a: 1\n«b»: 2\n",
    "in quotes": "a: 1\n«'b'»: 2\n",
    "in a block of a list": "- - c: {b: 1}\n    a: [b, b: 1]\n    «b»: 3\n",
    "in braces over several lines": '- {a: b,\n «"b"»: 3, c: 1}\n',
    "after an anchor": "- &x\n  a: 伺服\n  «b»: 1\n",
    "after a question mark": "? a\n: b\n? «b»\n: 1\n",
}


@pytest.mark.usefixtures("parser")
@pytest.mark.parametrize("text", KEYS.values(), ids=KEYS)
def test_a_key_has_its_place(text: str) -> None:
    clean, start, end = unmarked(text)
    node = node_of(clean)
    while isinstance(node, Sequence):
        (node,) = node.items
    assert isinstance(node, Mapping)
    span = key_span(node, "b")
    assert (span.start, span.end) == (start, end)


@pytest.mark.usefixtures("parser")
def test_a_key_that_is_an_alias_has_the_place_where_its_mapping_begins() -> None:
    node = node_of("- &x b\n- {*x : 2}\n")
    assert isinstance(node, Sequence)
    mapping = node.items[1]
    assert isinstance(mapping, Mapping)
    assert [*mapping.values] == ["b"]
    span = key_span(mapping, "b")
    assert (span.start, span.end) == (mapping.start, mapping.start + 1)


def test_a_merged_key_has_the_place_where_it_is_written() -> None:
    node, other = node_of("a: 1\n"), node_of("x: 1\nb: 2\n")
    assert isinstance(node, Mapping)
    assert isinstance(other, Mapping)
    span = key_span(node.with_entry("b", other.values["b"], other), "b")
    assert (span.file, span.start, span.end) == (other.file, 5, 6)


@pytest.mark.usefixtures("parser")
def test_keys_keep_their_order() -> None:
    node = node_of("zebra: 1\napple: 2\n'10': 3\n9: 4\n")
    assert isinstance(node, Mapping)
    assert list(node.values) == ["zebra", "apple", "10", "9"]


def keys_and_values(node: Node) -> Iterator[tuple[str, str]]:
    assert isinstance(node, Mapping)
    for key, value in node.values.items():
        if isinstance(value, Scalar):
            yield key, value.text


@pytest.mark.usefixtures("parser")
def test_scalars_are_text() -> None:
    words = ["on", "No", "010", "12:30", "1e3", "0x10", "0b1", "1_000", ".5", "~", "null", "2024-01-01", "=", "<<"]
    node = node_of("".join(f"k{number}: {word}\n" for number, word in enumerate(words)))
    assert [text for _, text in keys_and_values(node)] == words


@pytest.mark.usefixtures("parser")
@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a: |\n  one\n  two\n", "one\ntwo\n"),
        ("a: >-\n  one\n  two\n", "one two"),
        ("a: 'it''s'\n", "it's"),
        ('a: "\\u4f3a\\t"\n', "伺\t"),
        ("a: one\n  two\n", "one two"),
        ("a: >-\r\n  one\r\n  two\r\n", "one two"),
    ],
)
def test_texts_are_unfolded_and_unescaped(text: str, expected: str) -> None:
    assert list(keys_and_values(node_of(text))) == [("a", expected)]


@pytest.mark.skipif(not yaml.__with_libyaml__, reason="PyYAML was built without libyaml")
@pytest.mark.parametrize("ends", ["\n", "\r\n"], ids=["lf", "crlf"])
def test_both_parsers_give_the_same_tree_with_the_same_places(monkeypatch: pytest.MonkeyPatch, ends: str) -> None:
    text = "# 注\na: {b: 伺服, 'c': \"d\", e: [1, 0x2, [3]]}\nf:\n  - g: >-\n      h\n      i\n    j: &k k\n  - *k\n"
    shapes = []
    for parser in PARSERS.values():
        monkeypatch.setattr(yaml_reader, "_Parser", parser)
        shapes.append(shape(node_of(text.replace("\n", ends))))
    assert shapes[0] == shapes[1]
