"""The adapters and walks of the documentation parse, and matiec compiles them against stubs of the vendors' blocks."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from blark.parse import parse_source_code

sys.path.insert(0, str(Path(__file__).parent))

from scans import of_siemens
from standard_text import ARRAY, named, needed, without_comments
from test_scl_execution import siemens_text

from fieldspec.backends.iec.backend import source, text
from layouts import SPECS, newest
from matiec import matiec

DOCS = Path(__file__).resolve().parents[2] / "docs"
STUBS = """
FUNCTION_BLOCK ComWrite VAR_INPUT xExecute : BOOL; hCom : UDINT; szSize : UDINT; udiTimeOut : UDINT; END_VAR
VAR_OUTPUT xDone : BOOL; xError : BOOL; END_VAR xDone := xExecute; END_FUNCTION_BLOCK
FUNCTION_BLOCK ComRead VAR_INPUT xExecute : BOOL; hCom : UDINT; udiTimeOut : UDINT; END_VAR
VAR_OUTPUT xDone : BOOL; xError : BOOL; szSize : UDINT; END_VAR xDone := xExecute; END_FUNCTION_BLOCK
FUNCTION_BLOCK ModbusRequest VAR_INPUT hComPort : UDINT; xExecute : BOOL; usiSlaveAddr : USINT; uiFunctionCode : UINT;
uiReadOffset : UINT; uiReadLen : UINT; uiWriteOffset : UINT; uiWriteLen : UINT; tTimeout : TIME; END_VAR
VAR_OUTPUT xBusy : BOOL; xDone : BOOL; xError : BOOL; byModbusErrorCode : BYTE; END_VAR
xDone := xExecute; END_FUNCTION_BLOCK
FUNCTION_BLOCK ClearComBuffer VAR_OUTPUT Busy : BOOL; END_VAR Busy := FALSE; END_FUNCTION_BLOCK
FUNCTION_BLOCK SendByteBlock VAR_INPUT SendByte : BYTE; END_VAR VAR_OUTPUT Busy : BOOL; END_VAR
Busy := FALSE; END_FUNCTION_BLOCK
FUNCTION_BLOCK ReceiveByteBlock VAR_OUTPUT ByteReceived : BOOL; ReceivedByte : BYTE; END_VAR
ByteReceived := TRUE; END_FUNCTION_BLOCK
FUNCTION_BLOCK ModbusRtuMasterV2_KL6x22B
VAR_INPUT UnitID : BYTE; Quantity : WORD; MBAddr : WORD; cbLength : UINT; Execute : BOOL; Timeout : TIME; END_VAR
VAR_OUTPUT BUSY : BOOL; Error : BOOL; ErrorId : UDINT; cbRead : UINT; END_VAR BUSY := Execute; END_FUNCTION_BLOCK
FUNCTION_BLOCK Modbus_Master
VAR_INPUT REQ : BOOL; MB_ADDR : UINT; MODE : USINT; DATA_ADDR : UDINT; DATA_LEN : UINT; END_VAR
VAR_OUTPUT DONE : BOOL; BUSY : BOOL; ERROR : BOOL; STATUS : WORD; END_VAR DONE := REQ; END_FUNCTION_BLOCK
FUNCTION_BLOCK Send_P2P VAR_INPUT REQ : BOOL; PORT : WORD; LENGTH : UINT; END_VAR
VAR_OUTPUT DONE : BOOL; ERROR : BOOL; STATUS : WORD; END_VAR DONE := REQ; END_FUNCTION_BLOCK
FUNCTION_BLOCK Receive_P2P VAR_INPUT PORT : WORD; END_VAR
VAR_OUTPUT NDR : BOOL; ERROR : BOOL; STATUS : WORD; LENGTH : UINT; END_VAR NDR := TRUE; END_FUNCTION_BLOCK
"""
"""What the vendors' documentation says of their blocks, without pointers and buffers, which the standard has not."""
POINTED = re.compile(
    r",?\s*\b(?:pBuffer|szBuffer|pMemoryAddr|pWriteBuf|pReadBuf|Buffer|TxBuffer|RxBuffer|DATA_PTR|BUFFER) := "
    r"(?:(?:ADR|SIZEOF)\([^)]*\)|[#\w.]+)"
)


def blocks(language: str, page: str) -> dict[str, str]:
    """The blocks and programs of a page by their names."""
    texts = re.findall(rf"^```{language}\n(.*?)^```$", (DOCS / page).read_text("utf-8"), re.MULTILINE | re.DOTALL)
    named_blocks = {}
    for block in texts:
        match = re.match(r'(?:FUNCTION_BLOCK|PROGRAM) "?(\w+)', block)
        if match:
            named_blocks[match.group(1)] = block
    return named_blocks


STRUCTURED = blocks("iecst", "plc-adapters.md")
SIEMENS = blocks("scl", "plc-adapters.md")
WALKS = {name: block for name, block in blocks("iecst", "plc.md").items() if name.endswith("Axis")}
SIEMENS_WALKS = {name: block for name, block in blocks("scl", "plc.md").items() if name.endswith("Axis")}


@pytest.mark.parametrize("block", [*STRUCTURED.values(), *map(of_siemens, SIEMENS.values())])
def test_an_adapter_parses(block: str) -> None:
    result = parse_source_code(block)
    assert result.exception is None, (result.exception, block)


def test_there_are_walks_for_three_people() -> None:
    assert {*WALKS, *SIEMENS_WALKS} == {"PRG_Tc100Axis", "PRG_Esc11Axis", "HiwinEAxis"}


def standard(block: str, device: str) -> str:
    """A block for CODESYS or TwinCAT as the standard takes it, with arrays by the names of the generated types."""
    block = without_comments(block).replace("COM.Write", "ComWrite").replace("COM.Read", "ComRead")
    block = block.replace("IoDrvModbus.", "").replace("RTS_IEC_HANDLE", "UDINT")
    block = block.replace("CAA.HANDLE", "UDINT").replace("fbMaster.WriteRegs(", "fbMaster(")
    block = block.replace("fbMaster.ReadRegs(", "fbMaster(")
    block = POINTED.sub("", re.sub(r": (SendByte|ReceiveByte);", r": \1Block;", block))
    block = re.sub(r"\(\s*,", "(", block)
    return ARRAY.sub(lambda match: f"T_{device}_{match.group(3)}_{match.group(1)}_{match.group(2)}", block)


def siemens(block: str) -> str:
    """A block for TIA Portal as the standard takes it."""
    block = of_siemens(without_comments(block)).replace("TON_TIME", "TON")
    block = re.sub(r": (HW_IO|PORT);", ": WORD;", block)
    block = re.sub(r"(\w+) := DP(?:RD|WR)_DAT\([^)]*\);", r"\1 := 0;", block)
    return re.sub(r"\(\s*,", "(", POINTED.sub("", block))


def translated(content: str, folder: Path) -> None:
    """Asserts that matiec takes a text."""
    (folder / "text.st").write_text(content, "utf-8")
    tool = matiec()
    command = [str(tool / "iec2c"), "-I", str(tool / "lib"), "-T", str(folder), str(folder / "text.st")]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (ran.returncode, ran.stderr) == (0, ""), ran.stderr[-2000:]


def called_in(content: str) -> list[str]:
    """The generated blocks and functions that a text uses."""
    return re.findall(r"\bFB?_\w+", content)


@pytest.mark.parametrize(
    "name", ["FB_Tc100SerialPort", "FB_Tc100ModbusRequest", "FB_Tc100ModbusMaster", "FB_Esc11SerialPort"]
)
def test_an_adapter_of_codesys_or_twincat_compiles(name: str, tmp_path: Path) -> None:
    device = "Tc100" if "Tc100" in name else "Esc11"
    block = standard(STRUCTURED[name], device)
    functions = needed(text(source(newest(SPECS, device.lower()))), called_in(block))
    translated(functions + STUBS + block, tmp_path)


@pytest.mark.parametrize(("device", "name"), [("tc100", "Tc100ModbusMaster"), ("esc11", "Esc11PointToPoint")])
def test_an_adapter_of_tia_portal_compiles(device: str, name: str, tmp_path: Path) -> None:
    block = siemens(SIEMENS[name])
    types = needed(siemens_types(device), called_in(block))
    translated(named(types + STUBS + block), tmp_path)


def siemens_types(device: str) -> str:
    """The types, functions and blocks for TIA Portal, without texts of codes."""
    content = without_comments(siemens_text(device)).replace("TON_TIME", "TON")
    content = re.sub(r"^TYPE \w+CodeText :.*?^END_TYPE$", "", content, flags=re.MULTILINE | re.DOTALL)
    return re.sub(r"\bon\b", "onMember", content)


@pytest.mark.parametrize("walk", ["PRG_Tc100Axis", "PRG_Esc11Axis"])
def test_a_walk_compiles_with_its_adapter(walk: str, tmp_path: Path) -> None:
    device = "Tc100" if "Tc100" in walk else "Esc11"
    adapter = standard(STRUCTURED[f"FB_{device}SerialPort"], device)
    block = standard(WALKS[walk], device)
    functions = needed(text(source(newest(SPECS, device.lower()))), called_in(block))
    translated(functions + STUBS + adapter + block, tmp_path)


def test_the_walk_for_tia_portal_compiles_with_its_adapters(tmp_path: Path) -> None:
    adapters = "".join(siemens(SIEMENS[f"HiwinETelegram111{way}"]) for way in ("Input", "Output"))
    block = siemens(SIEMENS_WALKS["HiwinEAxis"])
    types = needed(siemens_types("hiwin-e"), called_in(adapters + block))
    translated(named(types + STUBS + adapters + block), tmp_path)
