"""`fieldspec layout` shows where a controller places the members of a record, and reports what it does not know."""

from __future__ import annotations

import pytest
from rich.console import Console

from command_line import SPECS, TEST_SPECS, CommandLine
from fieldspec.command.console import terminal
from fieldspec.targets.controllers.layout.memory import MEMORIES
from layouts import newest


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    """Runs verbs on the specs of the real devices."""
    return CommandLine(capsys, monkeypatch, SPECS)


def test_a_telegram_is_drawn_and_printed_as_a_table(run: CommandLine) -> None:
    ran = run("layout", "hiwin-e", "111", "--target", "tc3:2")
    assert (ran.code, ran.err) == (0, "")
    assert "TwinCAT 3 with pack_mode 2: 24 bytes, on the wire 24" in ran.lines
    assert "   8 | velocity_override             | mdi_target_position           |" in ran.lines
    assert "  12 | (mdi_target_position)         | mdi_velocity                  |" in ran.lines
    row = next(line.split() for line in ran.lines if line.startswith("mdi_target_position"))
    assert row == ["mdi_target_position", "DINT", "10", "4", "10", "swap", "bytes"]


def test_bits_that_share_a_byte_are_listed_by_byte_and_bit(run: CommandLine) -> None:
    ran = run("layout", "hiwin-e", "telegram_111_request", "--target", "s7")
    assert ran.code == 0
    rows = [line.split()[:4] for line in ran.lines]
    assert ["control_word_1.jog_1", "BOOL", "0", "0"] in rows
    assert ["control_word_1.on", "BOOL", "1", "0"] in rows


def test_a_record_that_cannot_be_aligned_as_requested_is_a_finding(run: CommandLine) -> None:
    ran = run("layout", "hiwin-e", "telegram_111_request", "--target", "codesys")
    assert ran.code == 1
    assert "CODESYS without pack_mode: 28 bytes, on the wire 24" in ran.lines
    assert "error[plc_images_exact]" in ran.out
    assert "mdi_target_position begins at byte 12, on the wire at byte 10" in ran.out


def test_a_table_means_its_record_and_equal_elements_are_drawn_once(run: CommandLine) -> None:
    assert run("layout", "tc100", "points", "--target", "s7").out.startswith("point\n")
    drawn = run("layout", "esc11", "read_parameters", "--target", "c")
    assert drawn.lines.count("     :") == 1


def test_a_field_of_several_types_has_a_layout_for_each(run: CommandLine) -> None:
    ran = run("layout", "hiwin-e", "read_parameter_response", "--target", "s7")
    assert "read_parameter_response, format = unsigned_16, word" in ran.lines
    assert "read_parameter_response, format = floating_point_32" in ran.lines


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("tc100", "pont", "--target", "s7"), "there is no record of tc100 pont; did you mean point?"),
        (("tc100", "point", "--target", "s8"), "there is no target s8; choose from c, codesys, s7, tc3:1,"),
        (("tc101", "point", "--target", "s7"), "there is no device tc101; did you mean tc100?"),
        (("tc100", "point"), "the following arguments are required: --target"),
        (("tc100", "--target", "s7"), "the following arguments are required: RECORD"),
    ],
)
def test_an_unknown_name_is_reported_with_the_known_ones(
    capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], message: str
) -> None:
    from fieldspec.cli import main

    assert main(["layout", *arguments]) == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize("device", ["gadget", "gizmo", "glider-x", "hostile", "widget"])
def test_every_record_of_the_made_up_devices_has_a_layout_in_every_memory(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, device: str
) -> None:
    run = CommandLine(capsys, monkeypatch, TEST_SPECS)
    layout = newest(TEST_SPECS, device)
    data = [side for message in layout.messages.values() for side in message.bodies]
    for record in (*layout.records.values(), *(record for record in data if record.fields)):
        for target in MEMORIES:
            ran = run("layout", device, record.name, "--target", target)
            assert ran.code in (0, 1), (record.name, target, ran.err)
            assert ("plc_images_exact" in ran.out) == (ran.code == 1)


def test_digits_are_bytes_and_what_varies_in_width_has_no_layout(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    run = CommandLine(capsys, monkeypatch, TEST_SPECS)
    assert "weight[3]" in run("layout", "weigher", "checkpoint", "--target", "c").out
    behind = run("layout", "weigher", "weigh_samples_request", "--target", "c")
    assert (behind.code, "fields follow samples, which repeats" in behind.err) == (2, True)
    ran = run("layout", "weigher", "measure_response", "--target", "c")
    assert (ran.code, "weight varies in width" in ran.err) == (2, True)


def test_cells_without_content_are_empty(run: CommandLine) -> None:
    lines = run("layout", "hiwin-e", "111", "--target", "tc3:2").lines
    assert lines[0].startswith("telegram_111")
    assert "None" not in "\n".join(lines)


def test_a_drawing_is_not_broken_on_a_narrow_terminal(run: CommandLine, monkeypatch: pytest.MonkeyPatch) -> None:
    wide = [line for line in run("layout", "hiwin-e", "111", "--target", "tc3:2").lines if line.endswith("|")]
    monkeypatch.setattr(terminal, "on_terminal", lambda: True)
    monkeypatch.setattr(terminal, "_console", lambda: Console(width=30, highlight=False))
    narrow = [line for line in run("layout", "hiwin-e", "111", "--target", "tc3:2").lines if line.endswith("|")]
    assert [line for line in narrow if line in wide] == wide
