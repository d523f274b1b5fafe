"""The adapters and programs that are written for controllers, in the dialect of the standard, which matiec compiles."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from scans import of_siemens
from standard_text import without_comments
from test_scl_execution import siemens_text

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.targets.controllers.adapters import programs
from fieldspec.targets.controllers.adapters.programs import Source
from fieldspec.targets.controllers.structured.program import program
from fieldspec.targets.iec.backend import source
from fieldspec.targets.scl.project import project
from layouts import SPECS, newest
from shared_results import shared

DOCS = Path(__file__).resolve().parents[2] / "docs"
ACTIONS = {"ReadRegs": 3, "WriteSingleRegister": 6, "WriteRegs": 16}
"""The actions of the block of Tc2_ModbusRTU, and their function codes."""
PARAMETERS = {"udiPort": 1, "udiStopBits": 2, "udiParity": 3, "udiBaudrate": 4, "udiByteSize": 6}
"""Members of COM.CAA_Parameter_Constants; a test only tells them apart."""
UNLENT = re.compile(
    r",?\s*\b(?:Buffer|TxBuffer|RxBuffer|pComIn|pComOut|pParameterList|MB_DB) := (?:\w+\([^)]*\)|[#\w.]+)"
)
"""Buffers that a stand-in does not need."""


OBJECT = re.compile(
    r'^(?:// (GVL_\w+)\n.*?^END_VAR\n|(FUNCTION_BLOCK|PROGRAM) "?(\w+)"?\n.*?^END_\2\n)', re.MULTILINE | re.DOTALL
)
DEVICES = ("tc100", "ck10", "esc11", "hiwin-e")


def sources(house: str, layout: DeviceLayout) -> tuple[Source, ...]:
    """What a controller gets for a device beside its types, functions and blocks."""
    if house == "siemens":
        tia = project(layout)
        return tuple(programs.siemens(tia.declared.world, tia.declared.dialect.spelling, tia.routines))
    if house == "standard":
        iec = source(layout)
        return tuple(programs.standard(iec.declared.world, iec.spelling, iec.routines))
    maker = {"codesys": programs.codesys, "twincat": programs.twincat}[house]
    st = program(layout)
    return tuple(maker(st.declared.world, st.spelling, st.routines))


def program_texts(house: str, *devices: str) -> dict[str, str]:
    """The blocks and programs that a controller gets for some devices, by their names."""
    return shared(f"programs_{house}_{'_'.join(devices)}", lambda: _program_texts(house, devices))


def _program_texts(house: str, devices: Sequence[str]) -> dict[str, str]:
    return {
        name: text
        for device in devices
        for item in sources(house, newest(SPECS, device))
        for name, text in objects(item).items()
    }


def objects(text: Source) -> dict[str, str]:
    """The blocks, programs and lists of a text by their names."""
    return {match[1] or match[3]: match[0] for match in OBJECT.finditer(text.text)}


CODESYS = program_texts("codesys", *DEVICES)
TWINCAT = program_texts("twincat", *DEVICES)
SIEMENS = program_texts("siemens", *DEVICES)
STRUCTURED = CODESYS | {name: TWINCAT[name] for name in ("FB_Esc11_SerialPort", "FB_Tc100_ModbusMaster")}
"""The adapters that are run: one of each kind."""


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
    if re.search(r"GVL_\w+Serial\.eError", block):
        block = re.sub(r"GVL_\w+Serial\.eError", "iLineError", block).replace(
            "\nVAR\n", "\nVAR\n    iLineError : INT;\n", 1
        )
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
    """The words of a text, the generated blocks and functions that it uses among them."""
    return re.findall(r"\b[A-Za-z]\w+", content)
