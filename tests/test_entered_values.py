"""Values as people enter them on the command line: records of constants, infinities, and bits of words."""

from __future__ import annotations

from pathlib import Path

import pytest

from command_line import CommandLine

SPEC = """
device: {id: gadget, name: Gadget, vendor: Maker, manual: {title: Manual, file: gadget.txt, sha256: "%s", lines: 9}}
links:
  - name: line
    source: 1 L3
    byte_order: big
    request: &frame [{name: code, role: code, type: u8}, {name: body, role: body}]
    response: *frame
records:
  - {name: fixed, source: 1 L4, fields: [{name: first, type: u8, const: 7}, {name: last, type: u8, const: 8}]}
messages:
  - name: ask
    code: 1
    source: 1 L4
    request: [{name: head, record: fixed}, {name: force, type: f32}]
    response: []
  - name: drive
    code: 2
    source: 2 L2
    request: [{name: control, type: u8, flags: control}]
    response: []
flags:
  - name: control
    type: u8
    source: 2 L2
    bits: [{bit: 0, name: enable}, {bits: 1..3, name: mode, enum: mode}, {bits: 4..7, name: speed}]
enums:
  - {name: mode, source: 2 L2, members: [{value: 0, name: hold}, {value: 1, name: travel}]}
""" % ("0" * 64)


@pytest.fixture
def gadget(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> CommandLine:
    folder = tmp_path / "specs" / "gadget"
    folder.mkdir(parents=True)
    (folder / "device.yaml").write_text(SPEC, encoding="utf-8")
    return CommandLine(capsys, monkeypatch, folder.parent)


@pytest.mark.parametrize(("force", "bits"), [("inf", "7F 80 00 00"), ("-inf", "FF 80 00 00")])
def test_infinities_are_encoded(gadget: CommandLine, force: str, bits: str) -> None:
    assert gadget("encode", "gadget", "ask", "head=", f"force={force}").lines == [f"01 07 08 {bits}"]


def test_a_record_of_constants_is_given_by_its_name_alone(gadget: CommandLine) -> None:
    assert gadget("encode", "gadget", "ask", "head=", "force=1").lines == ["01 07 08 3F 80 00 00"]


@pytest.mark.parametrize(
    "bits",
    [
        ["control=enable,mode=travel,speed=5"],
        ["control.enable=1", "control.mode=travel", "control.speed=5"],
        ["control=0x53"],
    ],
)
def test_bits_of_a_word_are_given_together_or_one_by_one(gadget: CommandLine, bits: list[str]) -> None:
    assert gadget("encode", "gadget", "drive", *bits).lines == ["02 53"]


def test_a_word_has_no_other_members_than_its_bits(gadget: CommandLine) -> None:
    run = gadget("encode", "gadget", "drive", "control.mode=travel", "control.brake=1")
    assert run.code == 2
    assert "`brake` is not a bit of control: enable, mode, speed" in run.err
