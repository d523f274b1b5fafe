"""Classes that Kaitai Struct makes of a .ksy file."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

TOOLS = Path(__file__).resolve().parent.parent / "tools"


def reader(name: str) -> Any:
    """The class made of `<name>.ksy` beside this file; `from_bytes` reads."""
    return _compiled_class(name)


def writer(name: str) -> Any:
    """The same with `--read-write`: `_read` reads; `_check` and `_write` write what the attributes hold."""
    return _compiled_class(name, "--read-write")


def encoded_bytes(record: Any, size: int) -> bytes:
    """The bytes of an object of a class that writes, as the manual of Kaitai Struct says it."""
    from kaitaistruct import BytesIO, KaitaiStream

    stream = KaitaiStream(BytesIO(bytearray(size)))
    record._check()
    record._write(stream)
    data: bytes = stream.to_byte_array()
    return data


def _compiled_class(name: str, *options: str) -> Any:
    source = Path(__file__).with_name(f"{name}.ksy")
    command = ["node", str(TOOLS / "kaitai.js"), str(source), *options]
    text = subprocess.run(command, cwd=TOOLS, capture_output=True, text=True, check=True).stdout
    module: dict[str, Any] = {}
    exec(text, module)
    return module[name.title()]
