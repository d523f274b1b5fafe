"""The adapters and walks of the documentation parse, and matiec compiles them against stubs of the vendors' blocks."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from blark.parse import parse_source_code

sys.path.insert(0, str(Path(__file__).parent))

from adapter_texts import DOCS, SIEMENS, SIEMENS_WALKS, STRUCTURED, WALKS, called_in, siemens, siemens_types, standard
from scans import of_siemens
from standard_text import named, needed, without_comments
from vendor_blocks import ALL

from fieldspec.targets.iec.backend import source, text
from layouts import SPECS, newest
from matiec import matiec


@pytest.mark.parametrize("block", [*STRUCTURED.values(), *map(of_siemens, SIEMENS.values())])
def test_an_adapter_parses(block: str) -> None:
    result = parse_source_code(block)
    assert result.exception is None, (result.exception, block)


def test_there_are_walks_for_three_people() -> None:
    assert {*WALKS, *SIEMENS_WALKS} == {"PRG_Tc100Axis", "PRG_Esc11Axis", "HiwinEAxis"}


def translated(content: str, folder: Path) -> None:
    """Asserts that matiec takes a text."""
    (folder / "text.st").write_text(content, "utf-8")
    tool = matiec()
    command = [str(tool / "iec2c"), "-I", str(tool / "lib"), "-T", str(folder), str(folder / "text.st")]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (ran.returncode, ran.stderr) == (0, ""), ran.stderr[-2000:]


@pytest.mark.parametrize(
    "name", ["FB_Tc100SerialPort", "FB_Tc100ModbusRequest", "FB_Tc100ModbusMaster", "FB_Esc11SerialPort"]
)
def test_an_adapter_of_codesys_or_twincat_compiles(name: str, tmp_path: Path) -> None:
    device = "Tc100" if "Tc100" in name else "Esc11"
    block = standard(STRUCTURED[name])
    functions = needed(text(source(newest(SPECS, device.lower()))), called_in(block))
    translated(named(without_comments(functions) + ALL + block), tmp_path)


@pytest.mark.parametrize(("device", "name"), [("tc100", "Tc100ModbusMaster"), ("esc11", "Esc11PointToPoint")])
def test_an_adapter_of_tia_portal_compiles(device: str, name: str, tmp_path: Path) -> None:
    block = siemens(SIEMENS[name])
    types = needed(siemens_types(device), called_in(block))
    translated(named(types + ALL + block), tmp_path)


@pytest.mark.parametrize("walk", ["PRG_Tc100Axis", "PRG_Esc11Axis"])
def test_a_walk_compiles_with_its_adapter(walk: str, tmp_path: Path) -> None:
    device = "Tc100" if "Tc100" in walk else "Esc11"
    adapter = standard(STRUCTURED[f"FB_{device}SerialPort"])
    block = standard(WALKS[walk])
    functions = needed(text(source(newest(SPECS, device.lower()))), called_in(block))
    translated(named(without_comments(functions) + ALL + adapter + block), tmp_path)


def test_the_walk_compiles_with_what_the_page_replaces_for_a_ck10(tmp_path: Path) -> None:
    adapter, walk = STRUCTURED["FB_Tc100SerialPort"], WALKS["PRG_Tc100Axis"]
    page = (DOCS / "plc.md").read_text("utf-8")
    rows = re.findall(r"^\| `(uiSpeed [^`]+)`[^|]* \| `([^`]+)` \|$", page, re.MULTILINE)
    assert len(rows) == 2
    longest = re.findall(r"^\| `(\d+)` in the adapter[^|]* \| `(\d+)` \|$", page, re.MULTILINE)
    stands = ALL
    for before, after in [("Tc100", "Ck10"), *rows, *longest]:
        assert before in adapter + walk
        adapter, walk, stands = (content.replace(before, after) for content in (adapter, walk, stands))
    adapter, walk = standard(adapter), standard(walk)
    functions = needed(text(source(newest(SPECS, "ck10"))), called_in(walk))
    translated(named(without_comments(functions) + stands + adapter + walk), tmp_path)


def test_the_walk_for_tia_portal_compiles_with_its_adapters(tmp_path: Path) -> None:
    adapters = "".join(siemens(SIEMENS[f"HiwinETelegram111{way}"]) for way in ("Input", "Output"))
    block = siemens(SIEMENS_WALKS["HiwinEAxis"])
    types = needed(siemens_types("hiwin-e"), called_in(adapters + block))
    translated(named(types + ALL + adapters + block), tmp_path)
