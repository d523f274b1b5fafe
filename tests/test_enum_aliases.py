"""A value with several names: encoders take all of them, and it is read as the one to write."""

from __future__ import annotations

import pytest

from command_line import TEST_SPECS, CommandLine
from fieldspec.codec.layout.values import raw_value
from fieldspec.targets import OUTPUTS
from layouts import newest
from python_package import module_of

COUNTER = newest(TEST_SPECS, "counter")
OVERRUN = 0x800001


@pytest.mark.parametrize("name", ["overrun", "overflow", "lost_count"])
def test_a_name_of_a_member_stands_for_its_value(name: str) -> None:
    (field,) = (field for field in COUNTER.device.records["counts"].fields if field.name == "state")
    assert field.value is not None
    assert raw_value(COUNTER.device, "state", field.value, name) == OVERRUN


def test_an_alias_in_python_is_the_member_itself() -> None:
    state = module_of(COUNTER).State
    assert state.OVERFLOW is state.LOST_COUNT is state(OVERRUN)
    assert state(OVERRUN).name == "OVERRUN"
    assert [member.name for member in state] == ["IDLE", "OVERRUN"]


@pytest.mark.parametrize(
    ("output", "text"),
    [
        ("c", "STATE_OVERFLOW 0x00800001u"),
        ("js", f"Overflow: {OVERRUN},"),
        ("js", f"readonly LostCount: {OVERRUN};"),
        ("docs", "Also `overflow`, `lost_count`"),
        ("st", "also overflow, lost_count"),
    ],
)
def test_an_output_has_the_aliases(output: str, text: str) -> None:
    assert any(text in content for content in OUTPUTS[output].files([COUNTER]).values() if isinstance(content, str))


def test_an_enum_is_shown_with_its_aliases(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    result = CommandLine(capsys, monkeypatch, TEST_SPECS)("show", "counter", "state")
    assert result.code == 0
    assert "overrun, also overflow, lost_count" in result.out
