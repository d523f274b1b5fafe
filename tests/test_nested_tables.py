"""The elements of a table may have records in records, in lists too: their values are registers like any others."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest

from captures.bulk import Sent, decoded, values
from command_line import CommandLine
from external_tools import require_tool
from fieldspec.cli import main
from fieldspec.codec.explain.hazards import CLEARS, hazards_by_fact
from fieldspec.codec.layout.read_plan import read_plan
from fieldspec.codec.reference import codec
from fieldspec.testing import SimulatedDevice, simulation
from fieldspec.tools.captures.decoding import Choices
from fieldspec.tools.evidence.redaction import Redaction
from fieldspec.tools.evidence.secrets import Secrets
from js_output.explanations import explained_by_node, explained_by_python
from oven import DATA, FOLDER, LAYOUT, RAW, module, output_folder, read_frames
from wireshark_output.expectations import Case, expect, results

BASE = LAYOUT.tables["programs"].table.base
SECONDS = 60
TIME = "programs[0].steps[0].begin"


@pytest.fixture
def device() -> Iterator[SimulatedDevice]:
    """An oven at delivery."""
    with simulation("oven", ports={"tcp": "tcp://127.0.0.1:0"}, folder=str(FOLDER)) as running:
        yield running


def live(device: SimulatedDevice, *arguments: str) -> int:
    """Runs a verb of `fieldspec live`."""
    place = ("--port", device.place, "--link", "tcp", "--unit", "1", "--timeout", "2")
    return main(["live", "oven", *arguments, *place, "--specs", str(FOLDER)])


def put(device: SimulatedDevice, first: int, data: bytes) -> None:
    """Sets the words from an address on."""
    words = device.simulation.engine.memory.words
    for at in range(0, len(data), 2):
        words["", first + at // 2] = int.from_bytes(data[at : at + 2], "big")


def test_a_frame_has_a_row_for_each_value_of_the_records_in_an_element(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    request, response = read_frames(BASE, DATA)
    run = CommandLine(capsys, monkeypatch, FOLDER)
    options = ("--request", request.hex(), "--link", "tcp", "--direction", "response")
    rows = run.json("decode", "oven", response.hex(), *options)["registers"]
    assert {row["path"]: row["number"] for row in rows} == {
        f"programs[0].{path}": raw.decode() if isinstance(raw, bytes) else raw for path, raw in RAW.items()
    }
    assert b"".join(bytes.fromhex(row["raw"]) for row in rows) == DATA
    by_path = {row["path"].partition(".")[2]: row for row in rows}
    assert [by_path[path]["value"] for path in ("steps[0].target", "steps[0].limits[0].low")] == ["180.5 °C", "12.5 °C"]
    assert by_path["steps[0].limits[1].low"]["value"] == "-400 °C"
    assert [by_path[path]["access"] for path in ("changed.hour", "steps[0].begin.hour")] == ["ro", "rw"]


@pytest.mark.parametrize(
    ("first", "start", "end"), [(0, 0, len(DATA)), (3, 6, 26), (-4, 0, 4), (9, 18, 22), (19, 38, 46)]
)
def test_the_explainer_in_javascript_has_the_same_rows(first: int, start: int, end: int) -> None:
    data = bytes(max(0, -2 * first)) + DATA[start:end]
    request, response = read_frames(BASE + first, data)
    path = str(output_folder("js") / "oven/v1_explain.js")
    options = {"link": "tcp", "direction": "response"}
    job = {"module": path, "frame": response.hex(), "request": request.hex(), "options": options}
    (have,) = explained_by_node([job])[0]
    assert have == explained_by_python(LAYOUT, job)
    assert any(row["path"].startswith("programs[0].") for row in have["registers"] if row["path"])


def test_a_dissector_shows_them() -> None:
    require_tool("tshark")
    request, response = read_frames(BASE, DATA)
    for case, items in results([Case(LAYOUT, "tcp", "response", "", request, response)]):
        expect(case, items)
        titles = [item.line for item in items if item.name == "oven.programs.steps.limits.low"]
        assert [title.partition(":")[0] for title in titles] == [
            f"0x{address:04X} Low of steps[{step}].limits[{limit}] of programs[0]"
            for address, step, limit in ((0x105, 0, 0), (0x108, 0, 1), (0x10E, 1, 0), (0x111, 1, 1))
        ]


@pytest.mark.parametrize(
    ("address", "words", "text"),
    [
        (BASE + 1, "0x1800", "programs[0].steps[0].begin.hour is 24: wrong: should be 0..23"),
        (BASE + 2, "0,4001", "programs[0].steps[0].target is 400.1 °C: wrong: should be 0.0..400.0 °C"),
        (BASE + 19, "0", "programs[0].changed.hour at 0x0113 can only be read"),
    ],
)
def test_a_value_that_cannot_be_written_is_refused(
    address: int, words: str, text: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    run = CommandLine(capsys, monkeypatch, FOLDER)
    fields = ("station=1", "transaction=1", f"address={address}", f"values={words}")
    result = run("encode", "oven", "write_registers", *fields)
    assert result.code == 2
    assert text in result.err


def test_a_quantity_is_written_at_the_address_of_a_nested_value(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    run = CommandLine(capsys, monkeypatch, FOLDER)
    fields = ("station=1", "transaction=1", f"address={BASE + 2}", "values=180.5 °C")
    assert run("encode", "oven", "write_registers", *fields).out.strip().endswith("00 02 04 00 00 07 0D")


def test_a_simulated_device_has_them_and_the_generated_client_reads_them(device: SimulatedDevice) -> None:
    put(device, BASE, DATA)
    with module("transports").tcp(*device.place.removeprefix("tcp://").split(":")) as transport:
        client = module("oven.client").Client(transport, timeout=SECONDS)
        record = next(iter(client.read_table(module("oven.v1").programs)))
    step = record.steps[1]
    assert (record.number, step.begin.hour, step.target, step.limits[1].low) == (7, 22, 4000, 9)
    assert (record.changed.minute, record.owner.tag) == (2, "ab12")


def test_values_are_read_and_written_by_their_names(
    device: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    put(device, BASE, DATA)
    assert live(device, "write", "programs[0].steps[1].target=12.5 °C", "--yes") == 0
    assert live(device, "write", "programs[0].steps[1].limits[0].exponent=3", "--yes") == 0
    capsys.readouterr()
    assert live(device, "read", "programs[0].steps[1]", "programs[0].changed", "--format", "json") == 0
    rows = {row["name"]: row["value"] for row in json.loads(capsys.readouterr().out)}
    wanted = {path: raw for path, raw in RAW.items() if path.startswith(("steps[1]", "changed"))}
    wanted |= {"steps[1].target": 125, "steps[1].limits[0].exponent": 3}
    assert rows == {f"programs[0].{path}": raw for path, raw in wanted.items()}
    assert live(device, "write", "programs[0].changed.hour=1", "--yes") == 2


def test_a_dump_has_the_words_of_all_values(device: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    put(device, BASE, DATA)
    assert live(device, "dump", "-") == 0
    lines = capsys.readouterr().out.splitlines()[1:]
    words = {int(address, 16): int(word) for address, word in (line.split(",") for line in lines)}
    assert b"".join(words[BASE + at].to_bytes(2, "big") for at in range(len(DATA) // 2)) == DATA
    assert not {0x200, 0x202} & set(words)  # what reading clears is read by its name alone
    assert {0x201, 0x203} <= set(words)


def test_reading_a_record_that_reading_clears_clears_its_values(
    device: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    put(device, 0x200, bytes.fromhex("0C22 0007"))
    for hour, minute in ((12, 34), (0, 0)):
        assert live(device, "read", "alarms[1].when", "--format", "json") == 0
        assert [row["value"] for row in json.loads(capsys.readouterr().out)] == [hour, minute]
    assert live(device, "read", "alarms[1].code", "--format", "json") == 0
    assert [row["value"] for row in json.loads(capsys.readouterr().out)] == [7]
    names = hazards_by_fact(LAYOUT)["read"][CLEARS]
    assert names == ["records/time/hour", "records/time/minute"]
    assert {unit.name: unit.refused for unit in read_plan(LAYOUT).left_out} == {
        f"alarms[{number}].when": "is cleared by reading" for number in (1, 2)
    }


def test_a_value_of_a_record_that_takes_effect_after_a_restart_says_so(
    device: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    assert live(device, "write", "programs[0].number=3", "programs[0].steps[0].limits[1].low=0", "--dry-run") == 0
    notes = capsys.readouterr().err.splitlines()
    assert {note for note in notes if "restart" in note} == {
        f"programs[0].{path}: it takes effect after a restart" for path in ("number", "steps[0].limits[1].low")
    }
    assert "records/program/number" in hazards_by_fact(LAYOUT)["write"]["it takes effect after a restart"]


def test_frames_in_bulk_and_redacted_ones_have_the_same_values() -> None:
    request, response = read_frames(BASE, DATA)
    frames = [Sent(0, "request", request), Sent(0, "response", response)]
    have = {row.register: row for row in values(decoded(LAYOUT, frames, Choices("tcp")))}
    numbers = {f"programs[0].{path}": raw for path, raw in RAW.items() if isinstance(raw, int)}
    assert {path: have[path].raw for path in numbers} == numbers
    assert have["programs[0].owner.tag"].text == "ab12"
    reference = codec(LAYOUT).links["tcp"]
    asked = reference.decode(request, "request").values
    redaction = Redaction(LAYOUT, Secrets())
    redacted = redaction.frame("tcp", "response", response, reference.decode(response, "response"), asked)
    assert (redacted[:-6], redacted[-2:]) == (response[:-6], response[-2:])
    assert redacted[-6:-2] not in (b"ab12", b"")
    assert redaction.replaced == {"records/owner/tag": 1}


def test_pages_list_the_values_in_the_records_of_an_element() -> None:
    page = (output_folder("docs") / "oven/1.md").read_text("utf-8")
    lines = [line for line in page.splitlines() if "steps[k].limits[l].low" in line]
    assert len(lines) == 1
    assert "`+5 + 9k + 3l`" in lines[0]
    assert "`rw`" in lines[0]
    (changed,) = [line for line in page.splitlines() if "changed.minute" in line]
    assert "second byte" in changed
    assert "`ro`" in changed


def test_values_that_share_a_word_are_written_together(
    device: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    put(device, BASE, DATA)
    words, hour, minute = device.simulation.engine.memory.words, f"{TIME}.hour", f"{TIME}.minute"
    assert live(device, "write", f"{minute}=59", f"{hour}=23", "--yes", "--trace") == 0
    printed = capsys.readouterr()
    assert printed.out.splitlines() == [f"{minute}: 59", f"{hour}: 23"]
    assert printed.err.count("01 06 01 01 17 3B") == 2  # one request, and its answer
    assert words["", BASE + 1] == 0x173B
    assert live(device, "write", f"{hour}=1", f"{minute}=2", "--dry-run") == 0
    assert capsys.readouterr().out.startswith(f"{hour}, {minute}: ")
    assert words["", BASE + 1] == 0x173B
    assert live(device, "write", "programs[0].level=3", "--yes") == 0
    assert words["", BASE + 22] == 0x035A  # what is reserved is written as it must be
    capsys.readouterr()
    for texts, reason in (
        ((f"{hour}=4",), f"{hour} shares a word with {minute}, and is written together with that alone"),
        ((f"{hour}=4", f"{minute}=60"), f"{minute} is 60"),
    ):
        assert live(device, "write", *texts, "--yes") == 2
        assert reason in capsys.readouterr().err
    assert words["", BASE + 1] == 0x173B


def test_a_backup_is_restored_with_values_that_share_a_word(
    device: SimulatedDevice, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    memory, saved, points = device.simulation.engine.memory.words, tmp_path / "saved.csv", tmp_path / "points.csv"
    put(device, BASE, DATA)
    assert live(device, "backup", str(saved)) == 0
    assert live(device, "points", "download", str(points), "--table", "programs") == 0
    assert "left out: changed.hour can only be read" in capsys.readouterr().err
    for file, verb in ((saved, ("restore",)), (points, ("points", "upload"))):
        put(device, BASE, bytes(len(DATA)))
        put(device, BASE, b"\0\1")
        assert live(device, *verb, str(file), "--yes") == 0
        content = b"".join(memory["", BASE + at].to_bytes(2, "big") for at in range(len(DATA) // 2))
        assert content == DATA[:38] + b"\0\0" + DATA[40:]
        capsys.readouterr()
    put(device, BASE + 1, b"\6\1")
    assert live(device, "compare", str(saved), "--format", "json") == 1
    (row,) = json.loads(capsys.readouterr().out)
    assert row == {"name": f"{TIME}.minute", "address": BASE + 1, "device": "1", "file": "30"}
    text = points.read_text("utf-8").replace("6,30", "6,", 1)
    points.write_text(text, "utf-8")
    assert live(device, "points", "upload", str(points), "--yes") == 1
    assert f"{TIME}.hour shares a word with {TIME}.minute" in capsys.readouterr().err
    assert memory["", BASE + 1] == 0x0601
