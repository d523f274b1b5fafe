"""Outputs leave out the single facts that they cannot express, say so, and have all others as ever."""

from __future__ import annotations

import csv
import io
import os
import re
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from external_tools import require_tool
from fieldspec.cli import main
from fieldspec.codec.layout.device import device_layout
from fieldspec.codec.layout.omissions import expressed
from fieldspec.codec.layout.refusal import Refusal
from fieldspec.codec.reference import codec
from fieldspec.command.pipeline import merged_refusals, refusals
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic, has_errors
from fieldspec.language.model.fact import Fact
from fieldspec.language.reading.project import read
from fieldspec.targets import OUTPUTS
from fieldspec.targets.controllers.dialects import DIALECTS
from fieldspec.targets.controllers.omissions import for_dialect
from fieldspec.targets.queries.backend import remaining as remaining_queries
from fieldspec.targets.wireshark.backend import dissector
from layouts import SPECS, layouts, newest
from matiec import VARIABLE
from random_devices.queries import queries
from random_devices.queries_judge import Queries
from random_devices.structured_text_judge import StructuredText
from wireshark_output.dissection import FIRST_PORT, Item, Packet, dissected, port_options
from wireshark_output.test_wireshark_streams import PORT, columns, stream

FOLDER = Path(__file__).parent / "omitting"
MIXER = newest(FOLDER, "mixer")
PLC = ("scl", "st", "twincat", "plcopen", "iec")
LEFT_OUT = {
    "plc": {
        *("register torque", "register places", "table batches", "record text", "record recipe"),
        *("message read_log", "message read_texts", "message read_recipe"),
    },
    "tables": {
        *("register places", "table batches", "record text", "record recipe"),
        *("message read_log", "message read_texts", "message read_recipe"),
    },
}
GOOD = ("read_registers", "write_register", "write_registers", "read_state", "read_weight")
ABSENT = ("ReadLog", "ReadTexts", "ReadRecipe", "ST_Mixer_Text", "ST_Mixer_Recipe", "Torque", "uiPlaces", "BATCHES")
"""Names that no declaration and no statement of a PLC has; comments at the head of a file have some."""


@pytest.fixture(scope="module")
def specs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("specs")
    for root, path in ((SPECS, "protocols/modbus.yaml"), (FOLDER, "mixer/device.yaml")):
        (folder / path).parent.mkdir()
        (folder / path).write_bytes((root / path).read_bytes())
    return folder


@cache
def texts_of(name: str) -> dict[str, str]:
    """The files of an output of the mixer that are texts."""
    return {path: text for path, text in OUTPUTS[name].files([MIXER]).items() if isinstance(text, str)}


def without_comments(text: str) -> str:
    """Statements of a PLC without comments of all kinds."""
    text = re.sub(r"\(\*.*?\*\)|<!--.*?-->", "", text, flags=re.S)
    text = re.sub(r"<Comment>.*?</Comment>|<documentation>.*?</documentation>", "", text, flags=re.S)
    text = re.sub(r"<addData>\s*<data name=\"[^\"]*documentation.*", "", text, flags=re.S)
    return re.sub(r"//[^\n]*", "", text)


def test_a_build_says_what_it_leaves_out_every_time_and_succeeds(
    specs: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ["build", "--specs", str(specs), "--out", str(tmp_path)]
    printed = []
    for extra in ([], [], ["--to", "python"], []):
        assert main([*arguments, *extra]) == 0
        printed.append(capsys.readouterr().out)
    assert printed[0].count("warning[") == 11
    assert "error[" not in printed[0]
    assert printed[1].count("warning[") == printed[3].count("warning[") == 11, "the second build says it again"
    assert "warning[" not in printed[2]
    assert "queries, kv: record recipe, message read_recipe are left out" in printed[0]
    assert "wireshark: records/recipe/title is shown as bytes" in printed[0]
    assert "scl, st, twincat, plcopen, iec: message read_log is left out" in printed[0]
    assert main([*arguments, "--check"]) == 0


def test_an_output_with_an_error_says_nothing_of_what_it_would_leave_out(tmp_path: Path) -> None:
    (finding, *_) = OUTPUTS["st"].refusals([MIXER])
    error = Diagnostic("plc_frames_supported", "no frame", finding.span, help=LEAVE_OUT)
    merged = merged_refusals("mixer", {"st": [error, finding], "kv": [finding]})
    assert [own.help.partition(":")[0] for own in merged] == ["st cannot express it; build the others", "kv"]


@pytest.mark.parametrize("name", [*PLC, "queries", "kv"])
def test_each_omission_is_named_with_its_reason_in_the_generated_files(name: str) -> None:
    texts = texts_of(name)
    expected = LEFT_OUT["plc" if name in PLC else "tables"]
    if name == "kv":
        (words,) = (text for path, text in texts.items() if path.endswith("_words.csv"))
        rows = [row for row in csv.DictReader(io.StringIO(words.lstrip("\ufeff"))) if row["area"] == "left out"]
        assert {row["name"] for row in rows} == expected
        assert all(row["label"] for row in rows)
        return
    if name == "twincat":
        # The objects of a project are many: what is left out is said once.
        texts = {path: text for path, text in texts.items() if path.endswith("project_items.xml")}
    for path, text in texts.items():
        if path.endswith(".csv"):
            continue
        omitted = re.findall(r"(?:register|table|record|message) \w+(?=: \w+ (?:is|has|begins|varies))", text)
        assert set(omitted) == expected, path


@pytest.mark.parametrize("name", PLC)
def test_a_controller_has_no_function_and_no_member_of_what_is_left_out(name: str) -> None:
    code = "\n".join(map(without_comments, texts_of(name).values()))
    assert [word for word in ABSENT if word.lower() in code.lower()] == []
    for message in GOOD:
        pascal = "".join(word.title() for word in message.split("_"))
        assert re.search(rf"ParseRtu{pascal}\b", code), message
    assert "BATCH" in code.upper(), "the record of both tables is there"


def test_functions_do_what_the_reference_does_by_an_interpreter(tmp_path: Path) -> None:
    assert StructuredText(MIXER, tmp_path).answers(queries(MIXER, 5, 40))


@pytest.mark.skipif(VARIABLE not in os.environ, reason="matiec is not there")
def test_functions_do_what_the_reference_does_compiled_by_matiec(tmp_path: Path) -> None:
    assert StructuredText(MIXER, tmp_path, is_compiled=True).answers(queries(MIXER, 6, 40))


def test_a_response_to_a_message_that_is_left_out_is_refused_as_ever() -> None:
    layout = for_dialect(MIXER, DIALECTS["st"]).layout
    link = layout.links["rtu"]
    assert [message.name for message in link.messages_with_code(0x2B)] == ["read_weight", "read_texts"]
    assert list(link.subcodes("response")) == [0x2B]
    assert "read_texts" not in link.messages
    body = without_comments(texts_of("st")["mixer_v1.st"]).partition("FUNCTION F_Mixer_ParseRtuReadWeight ")[2]
    first = body.partition("END_FUNCTION")[0]
    assert re.search(r"<> BYTE#16#0D\) THEN\s+F_Mixer_ParseRtuReadWeight := E_Mixer_CodecStatus.UnknownCode", first)


def test_tasks_that_need_what_is_left_out_have_no_block() -> None:
    text = texts_of("st")["mixer_v1.st"]
    assert "//     look: it needs registers/torque, which is left out" in text
    assert "FB_Mixer_Turn" in text
    assert "FB_Mixer_Look" not in text


def refused(fact: Fact) -> Refusal:
    return Refusal(fact, Diagnostic("plc_numbers_fit", "no", fact.place.whole, help=LEAVE_OUT))


def test_a_task_that_is_watched_by_what_is_left_out_does_not_apply(monkeypatch: pytest.MonkeyPatch) -> None:
    layout = newest(SPECS, "tc100")
    state = next(register.register for register in layout.registers if "servo_state" in register.register.roles)
    monkeypatch.setattr("fieldspec.targets.controllers.omissions.number_refusals", lambda *_: [refused(state)])
    before = {task.name: task for task in layout.device.tasks}
    after = {task.name: task for task in for_dialect(layout, DIALECTS["st"]).layout.device.tasks}
    changed = {name for name in before if after[name].not_applicable != before[name].not_applicable}
    assert {"servo_on", "servo_off", "home", "move_absolute", "move_relative", "run_point"} <= changed
    assert "read_alarm" not in changed
    assert state.place.path in after["home"].not_applicable


def test_what_is_read_by_means_of_a_fact_is_left_out_with_it() -> None:
    layout = newest(FOLDER.parent / "moving", "recorder")
    registers = {own.name: own.register for own in layout.registers}
    result = expressed(layout, [refused(registers["event_count"])])
    assert [own.title for own in result.omissions] == ["register event_count", "table events"]
    assert "its number of elements is in event_count, which is left out" in result.omissions[1].reason
    assert list(result.layout.tables) == ["settings"]
    assert result.layout.device.register("event_count") is None
    assert result.layout.identity == layout.identity


def test_the_record_of_exception_responses_cannot_be_left_out() -> None:
    record = MIXER.records["exception"]
    fact = record.fields[0].field
    assert has_errors(expressed(MIXER, [refused(fact)]).findings)
    assert not has_errors(expressed(MIXER, [refused(fact)], reads_exceptions=False).findings)


def test_a_part_of_a_frame_cannot_be_left_out() -> None:
    part = MIXER.links["rtu"].request.parts[0].part
    result = expressed(MIXER, [refused(part)])
    assert (has_errors(result.findings), result.omissions) == (True, ())


@pytest.mark.parametrize("engine", ["duckdb", "polars"])
def test_queries_of_the_others_decode_as_the_reference_does(engine: str) -> None:
    asked = queries(MIXER, 7, 40)
    judge = Queries(MIXER, engine)
    assert judge.engine is not None
    assert all(not answer.again for answer in judge.answers(asked))
    names = set(judge.names.values())
    assert {"read_state_response", "read_weight_response", "batch"} <= names
    assert not {"read_log_response", "read_texts_response", "text", "recipe"} & names
    assert "places" not in {register.name for register in remaining_queries(MIXER).layout.registers}


def test_a_word_map_has_the_areas_of_the_others_alone() -> None:
    (words,) = (text for path, text in texts_of("kv").items() if path.endswith("_words.csv"))
    rows = [row for row in csv.DictReader(io.StringIO(words.lstrip("\ufeff"))) if row["device"]]
    areas = {row["area"] for row in rows}
    assert not [area for area in areas if "read_log" in area or "read_texts" in area or "read_recipe" in area]
    assert {"registers 0x0010..0x0015", "registers 0x0017..0x001B", "table plan"} <= areas
    assert {"read_state on rtu request", "read_weight on tcp response"} <= areas


def test_a_dissector_is_a_program_of_lua(tmp_path: Path) -> None:
    path = tmp_path / "mixer.lua"
    path.write_text(dissector(MIXER), "utf-8")
    subprocess.run([require_tool("luac5.2"), "-p", str(path)], check=True)
    head = path.read_text("utf-8").partition("local device")[0]
    assert "Not decoded, and shown as bytes:" in head
    assert "-- data of the response of message read_log: events has fields after it" in head


PORTS = {("mixer", "rtu", ""): FIRST_PORT, ("mixer", "tcp", ""): FIRST_PORT + 1}


def frame(link: str, direction: str, message: str, **values: Any) -> bytes:
    """A frame as the reference makes it."""
    head = {"transaction": 7, "protocol": 0} if link == "tcp" else {}
    return codec(MIXER).links[link].encode(direction, message, {**head, "station": 1, **values})


def conversations(link: str, *exchanges: tuple[bytes, bytes]) -> list[list[Item]]:
    """What tshark shows of the response of each exchange, after its request."""
    port = PORTS["mixer", link, ""]
    packets = [
        Packet(40000 + number, port, direction, data)
        for number, exchange in enumerate(exchanges)
        for direction, data in zip(("request", "response"), exchange, strict=True)
    ]
    return dissected([MIXER], packets, port_options(MIXER, PORTS))[1::2]


def conversation(link: str, request: bytes, response: bytes) -> list[Item]:
    """What tshark shows of a response after its request."""
    (items,) = conversations(link, (request, response))
    return items


def values_by_name(items: list[Item]) -> dict[str, str]:
    return {item.name: item.value for item in items}


LOG = {"count": 2, "events": [0x0102, 0x0304], "newest": 9}
TEXTS = {"interface": 14, "texts": [{"number": 1, "size": 3, "value": "abc"}, {"number": 2, "size": 0, "value": ""}]}


@pytest.mark.parametrize("link", ["rtu", "tcp"])
def test_a_dissector_shows_the_others_as_ever(link: str) -> None:
    weight = frame(link, "response", "read_weight", interface=13, weight=70000)
    recipe = {"recipe": {"duration": 60, "title": "dough"}, "uses": 3}
    of_state, of_weight, of_recipe = conversations(
        link,
        (
            frame(link, "request", "read_state", stage=2),
            frame(link, "response", "read_state", stage=2, speed=-15, mode=1),
        ),
        (frame(link, "request", "read_weight", interface=13), weight),
        (frame(link, "request", "read_recipe", number=1), frame(link, "response", "read_recipe", **recipe)),
    )
    visible = values_by_name(of_state)
    assert (visible["mixer.read_state.speed"], visible["mixer.read_state.mode"]) == ("-15", "1")
    assert "mixer.frame.opaque" not in visible
    assert values_by_name(of_weight)["mixer.read_weight.weight"] == "70000"
    visible = values_by_name(of_recipe)
    assert (visible["mixer.recipe.duration"], visible["mixer.read_recipe.uses"]) == ("60", "3")
    assert bytes.fromhex(visible["mixer.recipe.title"].replace(":", "")) == b"dough   "


UNDECODED: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "read_log": ({"first": 0}, LOG),
    "read_texts": ({"interface": 14}, TEXTS),
}


@pytest.mark.parametrize("link", ["rtu", "tcp"])
def test_a_dissector_shows_the_data_of_a_message_that_it_does_not_decode_as_bytes(link: str) -> None:
    exchanges = [
        (frame(link, "request", message, **asked), frame(link, "response", message, **answered))
        for message, (asked, answered) in UNDECODED.items()
    ]
    for message, (_, response), items in zip(UNDECODED, exchanges, conversations(link, *exchanges), strict=True):
        visible = values_by_name(items)
        assert visible["mixer.frame.message"] == message
        body = response[8:] if link == "tcp" else response[2:-2]
        assert bytes.fromhex(visible["mixer.frame.opaque"].replace(":", "")) == body, message
        known = ("mixer.read_", "mixer.expert", "_ws.expert")
        assert not [item for item in items if item.name.startswith(known)], message
        assert not [item for item in items if item.name == "mixer.frame.undecoded"], message


@pytest.mark.parametrize("link", ["rtu", "tcp"])
def test_a_dissector_finds_the_frames_behind_data_that_it_does_not_decode(link: str) -> None:
    log = frame(link, "response", "read_log", **LOG)
    pieces = [
        ("request", frame(link, "request", "read_log", first=0)),
        ("response", log[:6]),
        ("response", log[6:]),
        ("request", frame(link, "request", "read_state", stage=2)),
        ("response", frame(link, "response", "read_state", stage=2, speed=5, mode=0)),
    ]
    names = ["frame.direction", "frame.message", "frame.opaque", "read_state.speed"]
    rows = columns(MIXER, stream(pieces), names, "-o", f"mixer.{link}_tcp:{PORT}")
    assert [row[1:] for row in rows if row[0] == "response"] == [
        ["read_log", "02010203040009", ""],
        ["read_state", "", "5"],
    ]


def test_a_dissector_reports_data_that_are_too_short_for_a_message_that_it_does_not_decode() -> None:
    whole = frame("tcp", "response", "read_log", **LOG)
    cut = whole[:5] + bytes([4]) + whole[6:8] + whole[8:10]
    items = conversation("tcp", frame("tcp", "request", "read_log", first=0), cut)
    assert [item for item in items if "incomplete" in item.name]


def test_a_dissector_shows_a_register_of_digits_as_bytes_beside_the_others() -> None:
    response = frame("tcp", "response", "read_registers", byte_count=6, values=[1, 0x0002, 0x0100])
    asked = frame("tcp", "request", "read_registers", address=0x15, word_count=3)
    visible = values_by_name(conversation("tcp", asked, response))
    assert bytes.fromhex(visible["mixer.places"].replace(":", "")) == b"\x00\x02"
    assert visible["mixer.batch_address"] == "256"


def test_devices_without_such_facts_lose_nothing() -> None:
    for versions in layouts(SPECS).values():
        assert refusals(versions, OUTPUTS) == []
        layout = versions[-1]
        assert for_dialect(layout, DIALECTS["st"]).layout is layout


ANCHORED = f"""
device: {{id: chance, name: N, vendor: V, manual: {{title: T, file: t.txt, sha256: "{"0" * 64}", lines: 9}}}}
links:
  - {{name: line, source: 1 L1, byte_order: big, frame: [{{name: c, role: code, type: u8}}, {{name: b, role: body}}]}}
messages:
  - {{name: call, code: 1, source: 1 L2, request: &a [{{name: t, type: text, length: 9, varies: true}}], response: *a}}
"""


def test_what_both_directions_share_is_left_out_once() -> None:
    device = read({"chance/device.yaml": ANCHORED.encode()}).devices["chance"]
    findings = OUTPUTS["queries"].refusals([device_layout(device.at("1")[0])])
    assert [finding.help for finding in findings] == ["message call is left out"]
