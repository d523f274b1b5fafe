"""A device without an error is judged once, not at each verb that makes or reads its frames."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from command_line import TEST_SPECS
from fieldspec.command.console.usage import UsageError
from fieldspec.command.sources.specs import sound_at
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.tools.proofs import running
from fieldspec.tools.proofs.running import Outcome
from test_codecs_of_packages import SCALE

DEVICE = "gadget"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Specs that a test may change, and a cache without entries."""
    monkeypatch.setenv("FIELDSPEC_CACHE", str(tmp_path / "cache"))
    for name in ("protocols", DEVICE):
        shutil.copytree(TEST_SPECS / name, tmp_path / "specs" / name)
    return tmp_path / "specs"


@pytest.fixture
def judged(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The devices that are judged from here on."""
    devices: list[str] = []
    outcome = running.outcome

    def noted(spec: DeviceSpec) -> Outcome:
        devices.append(spec.id)
        return outcome(spec)

    monkeypatch.setattr(running, "outcome", noted)
    return devices


def test_a_device_without_an_error_is_judged_once(folder: Path, judged: list[str]) -> None:
    specs = [sound_at(str(folder), DEVICE)[0] for _ in range(3)]
    assert judged == [DEVICE]
    assert {spec.id for spec in specs} == {DEVICE}


def test_a_device_that_has_changed_is_judged_again(folder: Path, judged: list[str]) -> None:
    sound_at(str(folder), DEVICE)
    path = folder / DEVICE / "device.yaml"
    path.write_text(path.read_text("utf-8") + "# more\n", "utf-8")
    sound_at(str(folder), DEVICE)
    assert judged == [DEVICE, DEVICE]


def test_a_device_with_an_error_is_refused_each_time(folder: Path, judged: list[str]) -> None:
    path = folder / DEVICE / "device.yaml"
    path.write_text(path.read_text("utf-8") + "colour: red\n", "utf-8")
    for _ in range(2):
        with pytest.raises(UsageError, match="the spec of gadget has 1 error"):
            sound_at(str(folder), DEVICE)


def test_a_device_with_a_codec_of_a_package_is_judged_each_time(folder: Path, judged: list[str]) -> None:
    scale = folder / "scale" / "device.yaml"
    scale.parent.mkdir()
    scale.write_text(SCALE, "utf-8")
    for _ in range(2):
        sound_at(str(folder), "scale")
    assert judged == ["scale", "scale"]
