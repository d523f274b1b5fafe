"""A generated dissector in tshark, beside one in Lua by hand that shows the same items."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path

from peers.switchboard import spec
from processes import FIELDSPEC, compared, in_turns, run
from rows import Row, printed

from captures import capture

GROUP = "Wireshark"
FRAMES = 20_000
BY_HAND = Path(__file__).parent / "peers" / "dissector_by_hand.lua"


def rows() -> Iterator[Row]:
    """The row: the whole of tshark, which opens the file and prints all items."""
    tshark = shutil.which("tshark")
    if tshark is None:
        raise SystemExit("tshark is missing")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "switchboard").mkdir()
        (folder / "switchboard" / "device.yaml").write_text(spec(is_states=True))
        run((*FIELDSPEC, "build", "switchboard", "--to", "wireshark", "--specs", name, "--out", str(folder / "out")))
        path = folder / "input.pcap"
        capture(path, FRAMES, 20)
        scripts = {"ours": next((folder / "out").rglob("*.lua")), "Lua by hand": BY_HAND}
        commands = {
            own: (tshark, "-n", "-r", str(path), "-X", f"lua_script:{script}", "-V") for own, script in scripts.items()
        }
        os.environ["HOME"] = name  # no settings of a person
        took = in_turns(commands, 3)
        yield compared(GROUP, "Enums and words of bits, all items, in tshark", took, "ours", "Lua by hand", at_most=1.3)


if __name__ == "__main__":
    printed(rows())
