"""Tables fit into the terminal: what is too wide stands below its row, and nothing is cut off."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from bounded import HANGING
from fieldspec.command.rendering.blocks import Table, split, width

ROOT = Path(__file__).resolve().parent.parent
TELEGRAM = "04 BF 00 00 00 00 00 00 00 00 FF FF CF C7 10 00 00 00 00 00 00 00 00 00"
DECODE = ["decode", "hiwin-e", "--telegram", "111", "--direction", "received", TELEGRAM]

ROWS = Table(("a", "b", "c", "d"), (("1" * 10, "2" * 10, "3" * 20, "4" * 5),))


@pytest.mark.parametrize(
    ("columns", "stay", "below"),
    [
        (51, (0, 1, 2, 3), ()),
        (50, (0, 1, 3), (2,)),
        (28, (0, 1), (2, 3)),
        (5, (0, 1), (2, 3)),
    ],
)
def test_the_widest_columns_leave_a_table_until_it_fits(
    columns: int, stay: tuple[int, ...], below: tuple[int, ...]
) -> None:
    assert split(ROWS, columns) == (stay, below)


def on_terminal(words: list[str], columns: int) -> list[str]:
    """The lines that a command prints on a terminal of so many columns, without styles."""
    import fcntl
    import pty
    import struct
    import termios

    parent, child = pty.openpty()
    fcntl.ioctl(child, termios.TIOCSWINSZ, struct.pack("HHHH", 50, columns, 0, 0))
    environment = {name: value for name, value in os.environ.items() if name not in ("NO_COLOR", "COLUMNS")}
    command = [sys.executable, "-m", "fieldspec", *words]
    with subprocess.Popen(
        command, cwd=ROOT, stdin=child, stdout=child, stderr=child, env={**environment, "TERM": "xterm"}
    ) as process:
        os.close(child)
        received = b""
        while True:
            try:
                data = os.read(parent, 65536)
            except OSError:  # Linux says so at the end of a terminal
                break
            if not data:
                break
            received += data
        assert process.wait(HANGING) == 0
    os.close(parent)
    return re.sub(r"\x1b\[[0-9;]*m", "", received.decode("utf-8")).splitlines()


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no pseudo-terminals of this kind")
def test_a_telegram_fits_into_eighty_columns_and_nothing_is_cut_off() -> None:
    lines = on_terminal(DECODE, 80)
    assert [line for line in lines if width(line) > 80] == []
    text = "\n".join(lines)
    assert "\u2026" not in text
    for name in ("positioning_control_word_1", "velocity_override", "traversing_task", "MDI_TARPOS", "3.2 L556-557"):
        assert name in text
