"""Compiled C decodes what an idle device answers to reads of all its registers, as the vectors say."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compilers import SANITIZED, require_tool
from driver import settled

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.names import stem
from fieldspec.language.model.encoding import is_array, is_signed
from fieldspec.targets.c.backend import files
from fieldspec.targets.c.delimiters import is_wrapped
from fieldspec.targets.c.values import type_name
from fieldspec.targets.vectors.backend import idle_vectors
from layouts import SPECS, TEST_SPECS, newest

DEVICES = [(SPECS, "ck10"), (SPECS, "tc100"), (TEST_SPECS, "widget")]


def checks(layout: DeviceLayout, read: dict[str, Any]) -> list[str]:
    """Statements of C that open the response of a read and decode each of its registers."""
    naming = settled(layout)
    link = layout.links[read["link"]]
    response = bytes.fromhex(read["response"]["right"])
    wrapped = is_wrapped(link)
    buffer = "buffer, sizeof buffer, " if wrapped else ""
    frame = naming.type("link", link.name, "response", "frame")
    call = naming.function("link", link.name, "response", "open")
    statements = [
        f"{{ {frame} frame; uint8_t buffer[1024]; const uint8_t *words;",
        f"uint8_t data[] = {{{', '.join(map(hex, response))}}};",
        "(void)buffer; memset(&frame, 0, sizeof frame);",
        f"CHECK({call}(data, sizeof data, {buffer}&frame) == 0);",
    ]
    message = layout.messages[read["message"]]
    values = message.response.named(message.message.single_access.values)
    statements.append(f"words = frame.body + {values.offset};")
    registers = {register.name: register for register in layout.registers}
    for full_name, wanted in read["registers"].items():
        name, _, index = full_name.rstrip("]").partition("[")
        if "." in full_name:
            continue  # a field of an element that is not read as a whole
        if name in registers:
            register = registers[name]
            number = int(index) - register.register.index_from if index else 0
            at = 2 * (register.address + number * register.stride - read["address"])
            if is_array(register.register.value.encoding):
                continue
            out = type_name(register.register.answer)
            function = naming.function("register", name, "decode")
            literal = f"{int(wanted)}" if is_signed(register.register.value.encoding) else f"{int(wanted)}ull"
            statements.append(f"{{ {out} value; CHECK({function}(words + {at}, &value) == 0 && value == {literal}); }}")
            continue
        table = layout.tables[name]
        at = 2 * (table.table.address(int(index)) - read["address"])
        record = naming.type("record", table.record.name)
        decode = naming.function("record", table.record.name, "decode")
        statements.append(f"{{ {record} value; CHECK({decode}(words + {at}, {2 * table.words}, &value) == 0); }}")
    return [*statements, "}"]


@pytest.mark.parametrize(("root", "device"), DEVICES, ids=[device for _, device in DEVICES])
def test_every_register_of_an_idle_device_is_decoded(root: Path, device: str, tmp_path: Path) -> None:
    layout = newest(root, device)
    for path, text in files([layout]).items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    lines = [statement for read in idle_vectors([layout]) for statement in checks(layout, read)]
    assert len(lines) > 20
    main = "\n".join(
        [
            f'#include "{stem(layout.device.id, layout.device.version)}.h"',
            "#include <stdio.h>",
            "#include <string.h>",
            '#define CHECK(test) do { if (!(test)) { printf("%s\\n", #test); failed = 1; } } while (0)',
            "int main(void) { int failed = 0;",
            *lines,
            "return failed; }",
        ]
    )
    (tmp_path / "main.c").write_text(main, encoding="utf-8")
    program = tmp_path / "main"
    require_tool(SANITIZED[0])
    subprocess.run([*SANITIZED, "-w", "-o", str(program), str(tmp_path / "main.c")], check=True)
    result = subprocess.run([str(program)], capture_output=True, text=True, check=False)
    assert (result.returncode, result.stdout) == (0, "")
