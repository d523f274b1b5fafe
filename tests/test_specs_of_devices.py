"""The made-up devices are specs that `check` accepts, but for those whose defects other tests need."""

from __future__ import annotations

import pytest

from command_line import TEST_SPECS
from fieldspec.cli import main

DEFECTIVE = {"hostile", "meter", "widget"}
DEVICES = sorted(path.parent.name for path in TEST_SPECS.glob("*/device.yaml"))


@pytest.mark.parametrize("device", [device for device in DEVICES if device not in DEFECTIVE])
def test_check_finds_no_error_in_a_made_up_device(capsys: pytest.CaptureFixture[str], device: str) -> None:
    code = main(["check", device, "--specs", str(TEST_SPECS)])
    printed = capsys.readouterr()
    assert (code, printed.err) == (0, ""), printed.out
