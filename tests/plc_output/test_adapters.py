"""The adapters and programs for controllers parse, and matiec compiles them against stubs of the vendors' blocks."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from blark.parse import parse_source_code

sys.path.insert(0, str(Path(__file__).parent))

from adapter_texts import (
    CODESYS,
    DEVICES,
    SIEMENS,
    STRUCTURED,
    TWINCAT,
    called_in,
    program_texts,
    siemens,
    siemens_types,
    standard,
)
from scans import of_siemens
from standard_text import named, needed, without_comments
from vendor_blocks import ALL

from fieldspec.targets.iec.backend import source, text
from layouts import SPECS, newest
from matiec import matiec

TEXTS = {f"codesys {name}": text for name, text in CODESYS.items()} | {
    f"twincat {name}": text for name, text in TWINCAT.items()
}
SIEMENS_TEXTS = {f"siemens {name}": of_siemens(text) for name, text in SIEMENS.items()}


@pytest.mark.proof(5)
@pytest.mark.parametrize("name", [*TEXTS, *SIEMENS_TEXTS])
def test_an_adapter_or_a_program_parses(name: str) -> None:
    result = parse_source_code((TEXTS | SIEMENS_TEXTS)[name])
    assert result.exception is None, result.exception


@pytest.mark.proof(7)
@pytest.mark.parametrize("house", ["codesys", "twincat", "siemens", "standard"])
@pytest.mark.parametrize("device", DEVICES)
def test_a_device_has_a_program_for_each_controller(house: str, device: str) -> None:
    programs = [name for name in program_texts(house, device) if name.startswith("PRG_") or name.endswith("Program")]
    assert programs


def translated(content: str, folder: Path) -> None:
    """Asserts that matiec takes a text."""
    (folder / "text.st").write_text(content, "utf-8")
    tool = matiec()
    command = [str(tool / "iec2c"), "-I", str(tool / "lib"), "-T", str(folder), str(folder / "text.st")]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (ran.returncode, ran.stderr) == (0, ""), ran.stderr[-2000:]


@pytest.mark.proof(2)
@pytest.mark.parametrize(
    "name", ["FB_Tc100_SerialPort", "FB_Tc100_ModbusRequest", "FB_Tc100_ModbusMaster", "FB_Esc11_SerialPort"]
)
def test_an_adapter_of_codesys_or_twincat_compiles(name: str, tmp_path: Path) -> None:
    device = "Tc100" if "Tc100" in name else "Esc11"
    block = standard(STRUCTURED[name])
    functions = needed(text(source(newest(SPECS, device.lower()))), called_in(block))
    translated(named(without_comments(functions) + ALL + block), tmp_path)


@pytest.mark.proof(1)
@pytest.mark.parametrize(("device", "name"), [("tc100", "Tc100_ModbusMaster"), ("esc11", "Esc11_PointToPoint")])
def test_an_adapter_of_tia_portal_compiles(device: str, name: str, tmp_path: Path) -> None:
    block = siemens(SIEMENS[name])
    types = needed(siemens_types(device), called_in(block))
    translated(named(types + ALL + block), tmp_path)


@pytest.mark.proof(1)
@pytest.mark.parametrize(("device", "name"), [("tc100", "Tc100"), ("ck10", "Ck10"), ("esc11", "Esc11")])
def test_a_program_for_codesys_compiles_with_its_adapter(device: str, name: str, tmp_path: Path) -> None:
    adapter, block = standard(CODESYS[f"FB_{name}_SerialPort"]), standard(CODESYS[f"PRG_{name}"])
    functions = needed(text(source(newest(SPECS, device))), called_in(block))
    (last,) = re.findall(r"aBytes : ARRAY\[0\.\.(\d+)\]", adapter)
    stands = ALL.replace("[0..254]", f"[0..{last}]")
    translated(named(without_comments(functions) + stands + adapter + block), tmp_path)


@pytest.mark.proof(1)
@pytest.mark.parametrize(
    ("device", "name", "port"),
    [
        ("tc100", "Tc100", "ModbusMaster"),
        ("ck10", "Ck10", "ModbusMaster"),
        ("esc11", "Esc11", "SerialPort"),
    ],
)
def test_a_program_for_twincat_compiles_with_its_adapter(device: str, name: str, port: str, tmp_path: Path) -> None:
    adapter, block = standard(TWINCAT[f"FB_{name}_{port}"]), standard(TWINCAT[f"PRG_{name}"])
    functions = needed(text(source(newest(SPECS, device))), called_in(block))
    translated(named(without_comments(functions) + ALL + adapter + block), tmp_path)


@pytest.mark.proof(2)
@pytest.mark.parametrize(
    ("device", "name", "adapters"),
    [
        ("tc100", "Tc100_Program", ["Tc100_ModbusMaster"]),
        ("ck10", "Ck10_Program", ["Ck10_ModbusMaster"]),
        ("esc11", "Esc11_Program", ["Esc11_PointToPoint"]),
        *(
            (
                "hiwin-e",
                f"HiwinE_Telegram{number}Program",
                [f"HiwinE_Telegram{number}{way}" for way in ("Input", "Output")],
            )
            for number in (3, 5, 9, 102, 105, 111)
        ),
    ],
)
def test_a_program_for_tia_portal_compiles_with_its_adapters(
    device: str, name: str, adapters: list[str], tmp_path: Path
) -> None:
    blocks = "".join(siemens(SIEMENS[adapter]) for adapter in adapters) + siemens(SIEMENS[name])
    types = needed(siemens_types(device), called_in(blocks))
    translated(named(types + ALL + blocks), tmp_path)


@pytest.mark.proof(1)
@pytest.mark.parametrize("device", DEVICES)
def test_a_program_of_the_standard_compiles_as_it_is(device: str, tmp_path: Path) -> None:
    blocks = "".join(program_texts("standard", device).values())
    translated(text(source(newest(SPECS, device))) + blocks, tmp_path)
