"""Whatever a text of a spec has in it, it is a text in every output: a fixed share of what `make fuzz-texts` tries."""

from __future__ import annotations

import keyword
import random
import unicodedata
from pathlib import Path
from typing import Any

import pytest
import yaml

from fieldspec.cli import main
from fieldspec.language.reading.project import read
from fieldspec.targets.python import text as python_text
from hostile_texts import fuzz
from hostile_texts.filled_specs import filled_files
from hostile_texts.poison import FRAGMENTS, harmless, poison
from hostile_texts.structures import ParserError, structures
from random_devices.agreement import JUDGES, compare

VERBS = (
    ("check", "{device}"),
    ("show", "{device}"),
    ("show", "{device}", "registers/total"),
    ("export", "{device}"),
    ("matrix", "{device}"),
    ("layout", "{device}", "cycle", "--target", "c"),
)
ASKED = ("python", "access", "javascript", "explainer", "tcc")
RESERVED = {
    "c": "auto bool break case char const continue default do double else enum extern float for goto if inline int long"
    " register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while asm"
    " errno stdin eof null true false linux unix main class new delete this template typename namespace operator",
    "javascript": "arguments await constructor debugger eval export extends finally function implements instanceof"
    " interface let package private prototype protected public super tostring typeof undefined var with yield",
    "st": "array at by dint dword end_if end_var exit function_block lint lreal mod of or program real repeat sint step"
    " string task then time to type udint until usint var_input word wstring xor action and by_ref pointer ref_to",
    "lua": "elseif end local nil not repeat then until and or",
    "python": " ".join(word.lower() for word in keyword.kwlist) + " self cls mro init len match type",
}


@pytest.mark.proof(2)
@pytest.mark.parametrize(("device", "seed"), [("hostile", 1), ("gizmo", 3), ("glider-x", 2)])
def test_poison_in_every_text_changes_the_structure_of_no_output(device: str, seed: int) -> None:
    assert list(fuzz.differences(device, seed)) == []


@pytest.mark.parametrize(
    ("path", "right", "wrong"),
    [
        ("x.py", '"""a"""\nx = "b"', '"""a"""\nx = "b"; y = "c"'),
        ("x.h", "/* a */ int x;", "/* a */ b */ int x;"),
        ("x.html", "<!DOCTYPE html><title>a</title><p>a", "<!DOCTYPE html><title>a</title><p><i>a</i>"),
        ("x.md", "# a\n\nb c", "# a\n\n- b c"),
        ("x.st", "x := 'a'; (* b *)", "x := 'a'; (* b *) y := 1; (**)"),
        ("x.xml", "<a>b</a>", "<a><b/></a>"),
        ("x.csv", "a,b\n", "a,b,c\n"),
        ("x.json", '{"a": "b"}', '{"a": "b", "c": "d"}'),
        ("x.lua", "x = 'a'", "x = 'a' os.exit()"),
        ("x.sql", "-- a\nSELECT 'b';", "-- a\nDROP TABLE b; SELECT 'b';"),
        ("x.js", 'x = "a";', 'x = "a"; alert(1); "";'),
    ],
)
def test_a_text_that_is_more_than_a_text_is_noticed(path: str, right: str, wrong: str) -> None:
    def structure(text: str) -> Any:
        try:
            return dict(structures({path: text.encode()}))
        except ParserError:
            return None

    assert structure(right) is not None
    assert structure(wrong) != structure(right)


def test_a_formula_in_a_table_is_noticed() -> None:
    with pytest.raises(ParserError, match="formula"):
        dict(structures({"x.csv": b"a,=1+1\n"}))


def test_poison_has_the_fragments_of_every_language() -> None:
    chance = random.Random(1)
    texts = [poison(chance) for _ in range(3000)]
    assert [
        name for name, pieces in FRAGMENTS.items() if not any(piece in text for piece in pieces for text in texts)
    ] == []
    assert harmless('a "b"\n*/ é') == "x xxx\nxx é"


@pytest.mark.parametrize("words", VERBS, ids=" ".join)
def test_no_verb_prints_characters_that_control_a_terminal(
    words: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for path, content in filled_files("gadget", 5, str).items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_bytes(content)
    main([*(word.format(device="gadget") for word in words), "--specs", str(tmp_path)])
    captured = capsys.readouterr()
    printed = captured.out + captured.err
    assert captured.out
    control = {char for char in printed if unicodedata.category(char) == "Cc"} - {"\n", "\t"}
    assert control == set()


def device(names: list[str]) -> dict[str, Any]:
    """A device whose fields, members, bits and messages have some names."""

    def fact(name: str, **keys: object) -> dict[str, Any]:
        return {"name": name, "source": "1 L1", **keys}

    parts = [fact("station", role="unit_address", type="u8"), fact("code", role="code", type="u8")]
    parts += [fact("body", role="body"), fact("crc", role="checksum", algorithm="crc16_modbus")]
    words = [fact(name, type="u16") for name in names]
    members = [fact(name, value=number) for number, name in enumerate(names)]
    now = fact("now", type="u32", flags="status")
    manual = {"title": "The manual", "file": "chance.txt", "sha256": "0" * 64, "lines": 99}
    return {
        "device": {"id": "chance", "name": "Chance", "vendor": "Nobody", "manual": manual},
        "links": [
            fact("line", transmission="binary", byte_order="big", word_order="big", request=parts, response=parts)
        ],
        "enums": [fact("mode", members=members)],
        "flags": [fact("status", type="u32", bits=[fact(name, bit=at) for at, name in enumerate(names[:30])])],
        "records": [fact("all", fields=[*words[:40], fact("mode_now", type="u16", enum="mode")])],
        "messages": [
            fact(
                name,
                code=number + 1,
                request=[fact("at", type="u8")],
                response=[now],
            )
            for number, name in enumerate(names[:8])
        ],
        "registers": [
            {
                "group": "all",
                "source": "1 L1",
                "rows": [{**word, "at": at, "access": "rw"} for at, word in enumerate(words)],
            }
        ],
    }


@pytest.mark.parametrize("language", RESERVED)
def test_reserved_words_are_names_in_every_codec(language: str) -> None:
    names = list(dict.fromkeys(RESERVED[language].split()))
    result = compare(device(names), 3, 12, [judge for judge in JUDGES if judge.name in ASKED])
    assert (result.findings, result.disagreements) == ((), [])
    assert result.frames > 0


@pytest.mark.parametrize(
    "name",
    [
        "__init__",
        "__proto__",
        "Speed",
        "speed-limit",
        "x" * 10_000,
        "\uff53peed",
        "\u0455peed",
        "a b",
        "",
        "1a",
        "a__b",
        "a/../b",
        "a.b",
    ],
    ids=ascii,
)
def test_names_that_are_no_words_are_refused(name: str) -> None:
    project = read({"chance/device.yaml": yaml.safe_dump(device([name, "speed"])).encode()})
    assert {finding.code for finding in project.findings} & {"wrong_form", "too_long", "wrong_type", "empty"}


def test_names_that_differ_in_a_joint_alone_are_apart_in_every_codec_or_refused() -> None:
    result = compare(device(["speed_1", "speed1", "a_b_c", "a_bc", "ab_c"]), 3, 12, JUDGES[:2])
    assert set(result.findings) <= {"names_unique", "plc_names_distinct"}
    assert result.disagreements == []


@pytest.mark.parametrize("device_id", ["../x", "a/b", "..", "/etc/x", "a\\b", "con:", "x\n"], ids=ascii)
def test_an_id_that_is_a_path_is_refused(device_id: str) -> None:
    spec = device(["speed"])
    spec["device"]["id"] = device_id
    project = read({"chance/device.yaml": yaml.safe_dump(spec).encode()})
    assert [finding.code for finding in project.findings] != []


def test_texts_of_python_mean_what_they_meant() -> None:
    chance = random.Random(2)
    for _ in range(300):
        text = poison(chance)
        assert eval(python_text.literal(text)) == text
