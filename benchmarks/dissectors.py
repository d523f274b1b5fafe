"""Generated dissectors in tshark, beside those in Lua by hand that show the same items."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path

from peers import panel, switchboard
from processes import FIELDSPEC, compared, in_turns, run
from rows import Row, printed

from captures import capture, reads

GROUP = "Wireshark"
FRAMES = 20_000
PEERS = Path(__file__).parent / "peers"


def rows() -> Iterator[Row]:
    """The rows: the whole of tshark, which opens the file and prints all items."""
    tshark = shutil.which("tshark")
    if tshark is None:
        raise SystemExit("tshark is missing")
    with tempfile.TemporaryDirectory() as name:
        os.environ["HOME"] = name  # no settings of a person
        folder = Path(name)
        capture(folder / "switchboard.pcap", reads(FRAMES, 20))
        yield _row(
            tshark, folder, "switchboard", switchboard.spec(is_states=True), "Registers: enums and words of bits"
        )
        capture(folder / "panel.pcap", panel.reads(FRAMES), panel.PORT)
        yield _row(tshark, folder, "panel", panel.spec(), "Fields: enums, words of bits and quantities")


def _row(tshark: str, folder: Path, device: str, spec: str, items: str) -> Row:
    (folder / device).mkdir()
    (folder / device / "device.yaml").write_text(spec)
    out = folder / "out" / device
    run((*FIELDSPEC, "build", device, "--to", "wireshark", "--specs", str(folder), "--out", str(out)))
    scripts = {"ours": next(out.rglob("*.lua")), "Lua by hand": PEERS / f"{device}_by_hand.lua"}
    command = (tshark, "-n", "-r", str(folder / f"{device}.pcap"), "-V", "-X")
    took = in_turns({own: (*command, f"lua_script:{script}") for own, script in scripts.items()}, 3)
    return compared(GROUP, f"{items}, all items, in tshark", took, "ours", "Lua by hand", at_most=1.3)


if __name__ == "__main__":
    printed(rows())
