"""The adapters and walks of the documentation as text of the standard's dialect, which matiec compiles."""

from __future__ import annotations

import re
from pathlib import Path

from scans import of_siemens
from standard_text import without_comments
from test_scl_execution import siemens_text

DOCS = Path(__file__).resolve().parents[2] / "docs"
ACTIONS = {"ReadRegs": 3, "WriteSingleRegister": 6, "WriteRegs": 16}
"""The actions of the block of Tc2_ModbusRTU, and their function codes."""
PARAMETERS = {"udiPort": 1, "udiStopBits": 2, "udiParity": 3, "udiBaudrate": 4, "udiByteSize": 6}
"""Members of COM.CAA_Parameter_Constants; a test only tells them apart."""
UNLENT = re.compile(
    r",?\s*\b(?:Buffer|TxBuffer|RxBuffer|pComIn|pComOut|pParameterList|MB_DB) := (?:\w+\([^)]*\)|[#\w.]+)"
)
"""Buffers that a stand-in does not need."""


def blocks(language: str, page: str) -> dict[str, str]:
    """The blocks and programs of a page by their names."""
    texts = re.findall(rf"^```{language}\n(.*?)^```$", (DOCS / page).read_text("utf-8"), re.MULTILINE | re.DOTALL)
    matches = ((re.match(r'(?:FUNCTION_BLOCK|PROGRAM) "?(\w+)', text), text) for text in texts)
    return {match.group(1): text for match, text in matches if match}


STRUCTURED = blocks("iecst", "plc-adapters.md")
SIEMENS = blocks("scl", "plc-adapters.md")
PROGRAMS = blocks("iecst", "plc.md")
WALKS = {name: block for name, block in PROGRAMS.items() if name.endswith("Axis")}
SIEMENS_WALKS = {name: block for name, block in blocks("scl", "plc.md").items() if name.endswith("Axis")}


def standard(block: str) -> str:
    """A block for CODESYS or TwinCAT: pointers are lent variables, and what a vendor declares is a number."""
    block = without_comments(block)
    block = re.sub(r"\bCOM\.(Open|Close|Read|Write)\b", r"Com\1", block)
    block = block.replace("COM.ERROR.TIME_OUT", "5001").replace("COM.ERROR.NO_ERROR", "0")
    block = re.sub(r"\b(COM\.ERROR|COM\.PARITY\.\w+|COM\.STOPBIT\.\w+)", _number, block)
    block = re.sub(r"COM\.CAA_Parameter_Constants\.(\w+)", lambda match: str(PARAMETERS[match.group(1)]), block)
    block = re.sub(r"\bIoDrvModbus\.|\bCAA\.(?=HANDLE)|\bRTS_IEC_(?=HANDLE)", "", block).replace(": HANDLE", ": UDINT")
    block = re.sub(r"\bfbMaster\.(\w+)\(", lambda match: _action(match), block)
    block = UNLENT.sub("", re.sub(r": (SendByte|ReceiveByte);", r": \1Block;", block))
    block = re.sub(r"ADR\(([\w.]+)\)", r"\1", block).replace("SIZEOF(aBytes)", "255")
    block = block.replace(": ComError_t", ": INT").replace("COMERROR_NOERROR", "0")
    block = _labels(re.sub(r"\(\s*,", "(", block))
    if "GVL_Serial.eError" in block:
        block = block.replace("GVL_Serial.eError", "iLineError").replace("\nVAR\n", "\nVAR\n    iLineError : INT;\n", 1)
    return block


def _number(match: re.Match[str]) -> str:
    numbers = {"NONE": 0, "EVEN": 2, "ODD": 1, "ONESTOPBIT": 0, "TWOSTOPBITS": 2}
    return "UINT" if match.group() == "COM.ERROR" else f"INT#{numbers[match.group().rpartition('.')[2]]}"


def _action(match: re.Match[str]) -> str:
    code = ACTIONS.get(match.group(1))
    return match.group() if code is None else f"fbMaster(FunctionCode := {code}, "


def siemens(block: str) -> str:
    """A block for TIA Portal; what DPRD_DAT and DPWR_DAT return is a variable."""
    block = of_siemens(without_comments(block)).replace("TON_TIME", "TON")
    block = re.sub(r": (HW_IO|PORT);", ": WORD;", block)
    if re.search(r"DP(RD|WR)_DAT", block):
        block = re.sub(r"\bDP(?:RD|WR)_DAT\([^)]*\)", "returned", block)
        block = block.replace("\nVAR\n", "\nVAR\n    returned : INT;\n", 1)
    return _labels(re.sub(r"\(\s*,", "(", UNLENT.sub("", block)))


def _labels(block: str) -> str:
    """A text whose cases are decimal, as the standard has them."""
    return re.sub(r"(?<![#\w])16#([0-9A-F]+)", lambda match: str(int(match.group(1), 16)), block)


def siemens_types(device: str) -> str:
    """The types, functions and blocks for TIA Portal, without texts of codes."""
    content = without_comments(siemens_text(device)).replace("TON_TIME", "TON")
    content = re.sub(r"^TYPE \w+CodeText :.*?^END_TYPE$", "", content, flags=re.MULTILINE | re.DOTALL)
    return re.sub(r"\bon\b", "onMember", content)


def called_in(content: str) -> list[str]:
    """The generated blocks and functions that a text uses."""
    return re.findall(r"\bFB?_\w+", content)
