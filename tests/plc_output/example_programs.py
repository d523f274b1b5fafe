"""The examples of docs/plc.md as the standard's dialect, compiled: vendors' blocks and calls become variables.

Whoever runs the scans plays those blocks: it sets their outputs before a scan and reads their inputs after it.
"""

from __future__ import annotations

import re
from pathlib import Path

from compiled import Block, Compiled
from loaded import program_of
from page import example
from scans import constants, of_siemens
from st_syntax import parsed
from standard_text import ARRAY, anonymous, named, without_comments
from test_docs_telegram import declared

from fieldspec.targets.iec.backend import source
from fieldspec.targets.iec.backend import text as standard_text
from fieldspec.targets.scl.backend import files as scl_files
from fieldspec.targets.st.backend import text
from layouts import SPECS, newest

STATUS_BITS = (
    *("readyToSwitchOn", "readyToOperate", "operationEnabled", "alarm", "homingComplete"),
    *("traversingTaskAcknowledged", "targetReached"),
)
CONTROL_BITS = ("onMember", "enableOperation", "startTraversingTask")
CHANNEL = """
FUNCTION_BLOCK ModbusChannel
VAR_INPUT xExecute : BOOL; iChannelIndex : INT; END_VAR
VAR_OUTPUT xDone : BOOL; xError : BOOL; END_VAR
VAR iCalls : INT; END_VAR
iCalls := 1;
END_FUNCTION_BLOCK
"""
SERIAL = """
FUNCTION_BLOCK ClearComBuffer VAR_INPUT xUnused : BOOL; END_VAR VAR_OUTPUT Cleared : BOOL; END_VAR
Cleared := TRUE;
END_FUNCTION_BLOCK
FUNCTION_BLOCK SendByteBlock
VAR_INPUT SendByte : BYTE; END_VAR VAR_OUTPUT Busy : BOOL; Calls : INT; END_VAR
Calls := Calls + 1;
END_FUNCTION_BLOCK
FUNCTION_BLOCK ReceiveByteBlock
VAR_INPUT xUnused : BOOL; END_VAR VAR_OUTPUT ByteReceived : BOOL; ReceivedByte : BYTE; Calls : INT; END_VAR
Calls := Calls + 1;
END_FUNCTION_BLOCK
"""


def codesys(device: str, name: str) -> tuple[str, str]:
    """The types and functions of a device, and an example that uses them, for CODESYS or TwinCAT."""
    device_program = program_of(SPECS, device)
    known = constants(text(device_program))
    members = {
        f"{item.name}.{member.name}": str(member.value)
        for item in device_program.declared.enums
        for member in item.members
    }
    bases = {enum.name: enum.base.name for enum in device_program.declared.enums}
    program = without_comments(example("iecst", name))
    program = re.sub(r"\bGVL_(?!Serial)\w+\.\w+", lambda match: known[match.group().lower()], program)
    program = re.sub(r"\bE_\w+\.\w+", lambda match: members[match.group()], program)
    program = re.sub(r"\bE_\w+", lambda match: bases[match.group()], program)
    functions = standard_text(source(newest(SPECS, device)))
    kinds: dict[str, str] = {}

    def called(match: re.Match[str]) -> str:
        low, high, of = match.groups()
        kind = f"T_{device_program.declared.world.names.device}_{of}_{low}_{high}"
        if f" {kind} :" not in functions:
            kinds[kind] = f"TYPE {kind} : ARRAY [{low}..{high}] OF {of}; END_TYPE\n"
        return kind

    program = ARRAY.sub(called, program)
    return functions, "".join(kinds.values()) + program


def tc100(folder: Path) -> Compiled:
    """The TC100: before a scan come the start, the target, the answer of the channel and the words that it reads."""
    functions, program = codesys("tc100", "PRG_Tc100Move")
    program = program.replace("IoDrvModbus.ModbusChannel", "ModbusChannel").replace("Slave := TC100, ", "")
    encoded = (
        *(("xStart", "bool"), ("diTarget", "dint"), ("fbChannel.xDone", "bool"), ("fbChannel.xError", "bool")),
        *(("aStatus", ("array", 0, 1, "word")), ("aMonitor", ("array", 0, 10, "word"))),
    )
    read = (
        *(("xDone", "bool"), ("xError", "bool"), ("iStep", "int")),
        *(("fbChannel.xExecute", "bool"), ("fbChannel.iChannelIndex", "int"), ("wServo", "word"), ("wCommand", "word")),
        ("aPosition", ("array", 0, 1, "word")),
    )
    block = Block("PRG_Tc100Move", encoded, read)
    return Compiled(functions + CHANNEL + program, folder, block, parsed(anonymous(functions)))


def esc11(folder: Path) -> Compiled:
    """The ESC11: before a scan come the start and the answers of the blocks that send and receive a byte."""
    functions, program = codesys("esc11", "PRG_Esc11Grip")
    program = re.sub(r"(?:, )?\b(?:Buffer|TxBuffer|RxBuffer) := GVL_Serial\.\w+", "", program)
    program = re.sub(r": (SendByte|ReceiveByte);", r": \1Block;", program)
    text = (
        *(("xStart", "bool"), ("fbSend.Busy", "bool")),
        *(("fbReceive.ByteReceived", "bool"), ("fbReceive.ReceivedByte", "byte")),
    )
    read = (
        *(("xDone", "bool"), ("xError", "bool"), ("iStep", "int"), ("fbClear.Cleared", "bool")),
        *(("fbSend.SendByte", "byte"), ("fbSend.Calls", "int"), ("fbReceive.Calls", "int")),
    )
    block = Block("PRG_Esc11Grip", text, read)
    return Compiled(functions + SERIAL + program, folder, block, parsed(anonymous(functions)))


def telegram_111(folder: Path) -> Compiled:
    """The HIWIN E: before a scan come the inputs, what both calls return, and the telegram that was received."""
    result = {
        path: content for path, content in scl_files([newest(SPECS, "hiwin-e")]).items() if isinstance(content, str)
    }
    texts = {path: content.replace("\r\n", "\n") for path, content in result.items()}
    data = next(content for path, content in texts.items() if path.endswith(".db"))
    match = re.search(r'^DATA_BLOCK "HiwinETelegram111"\n.*?(STRUCT.*?END_STRUCT;)', data, re.MULTILINE | re.DOTALL)
    assert match
    directions = re.findall(r'(\w+) : "(\w+)";', match.group(1))
    types = "\n".join(dict.fromkeys(declared(texts, [kind for _, kind in directions])))
    members = " ".join(f"{name} : {kind};" for name, kind in directions)
    types = of_siemens(types) + f"\nTYPE typeBlock : STRUCT {members} END_STRUCT; END_TYPE\n"
    program = of_siemens(example("scl", "HiwinETelegram111Move")).replace("HW_IO", "WORD")
    program = re.sub(r"DPRD_DAT\([^)]*\)", "readResult", program)
    program = re.sub(r"DPWR_DAT\([^)]*\)", "writeResult", program)
    own = "HiwinETelegram111 : typeBlock; readResult : INT; writeResult : INT;"
    program = program.replace("\nVAR\n", f"\nVAR {own}\n", 1)
    # SCL takes a reserved word in quotes for a name, and behind a point without them.
    types, program = (re.sub(r"\bon\b", "onMember", without_comments(item)) for item in (types, program))
    text = (
        *(("enable", "bool"), ("execute", "bool"), ("target", "dint"), ("velocity", "dint")),
        *(("readResult", "int"), ("writeResult", "int")),
        *((f"HiwinETelegram111/fromDevice.statusWord1.{name}", "bool") for name in STATUS_BITS),
        ("HiwinETelegram111/fromDevice.positioningStatusWord2.traversingCommandActive", "bool"),
    )
    read = (
        *(("done", "bool"), ("error", "bool"), ("state", "int")),
        *((f"HiwinETelegram111/toDevice.controlWord1.{name}", "bool") for name in CONTROL_BITS),
        ("HiwinETelegram111/toDevice.mdiTargetPosition", "dint"),
    )
    block = Block("HiwinETelegram111Move", text, read)
    return Compiled(named(types + program), folder, block, parsed(types))
