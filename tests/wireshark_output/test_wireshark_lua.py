"""The functions of a dissector that need nothing of Wireshark do the same in old and in new Lua."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from external_tools import require_tool
from fieldspec.language.diagnostics import has_errors
from fieldspec.targets.wireshark.backend import dissector, refusals
from fieldspec.targets.wireshark.text import WIDTH, Data, table
from layouts import SPECS, TEST_SPECS, layouts

DEVICES = {
    name: versions[-1]
    for root in (SPECS, TEST_SPECS)
    for name, versions in layouts(root).items()
    if not has_errors(refusals(versions))
}
PROGRAM = Path(__file__).with_name("loaded.lua")


def frames(device: str) -> list[tuple[str, str, bytes, bool]]:
    """Requests with codes, which a codec accepts, and the same with a wrong bit where a checksum covers it."""
    rows = []
    for example in DEVICES[device].device.examples.values():
        link = DEVICES[device].links[example.link]
        frame, is_binary = example.frame, link.link.transmission == "binary"
        if example.direction != "request" or example.refused or link.request.role("code") is None:
            continue
        rows.append((example.link, "request", frame, True))
        if link.request.checksums and is_binary and not link.link.start:
            rows.append((example.link, "request", frame[:1] + bytes((frame[1] ^ 0x10,)) + frame[2:], False))
    return rows


@pytest.mark.parametrize("device", [name for name in DEVICES if frames(name)])
def test_old_and_new_lua_recognize_the_same_frames(device: str, tmp_path: Path) -> None:
    rows = frames(device)
    script, lines = tmp_path / "dissector.lua", tmp_path / "frames.txt"
    script.write_text(dissector(DEVICES[device]), "utf-8")
    lines.write_text("".join(f"{link} {direction} {data.hex()}\n" for link, direction, data, _ in rows), "utf-8")
    answers = []
    for lua in ("lua5.2", "lua5.4"):
        command = [require_tool(lua), str(PROGRAM), str(script), str(lines)]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
        assert run.returncode == 0, run.stderr
        answers.append(run.stdout.splitlines())
    old, new = answers
    assert old == new
    assert [line.split()[0] == "true" for line in new] == [fits for _, _, _, fits in rows]


TABLES: list[tuple[Data, str]] = [
    ({"a": 1}, "{ a = 1 }"),
    ([[]], "{ {} }"),
    ({"a": None, "end": "x", "b": [True, [2, 3]]}, '{ ["end"] = "x", b = { true, { 2, 3 } } }'),
]


@pytest.mark.parametrize(("value", "line"), TABLES)
def test_a_table_is_one_line_exactly_where_it_has_room(value: Data, line: str) -> None:
    assert table(value, WIDTH - len(line)) == line
    assert len(table(value, WIDTH - len(line) + 1).splitlines()) > 1
