"""Readers that Kaitai Struct makes of a .ksy file."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

TOOLS = Path(__file__).resolve().parent.parent / "tools"


def reader(name: str) -> Any:
    """The class made of `<name>.ksy` beside this file; `from_bytes` reads."""
    source = Path(__file__).with_name(f"{name}.ksy")
    command = ["node", str(TOOLS / "kaitai.js"), str(source)]
    text = subprocess.run(command, cwd=TOOLS, capture_output=True, text=True, check=True).stdout
    module: dict[str, Any] = {}
    exec(text, module)
    return module[name.title()]
