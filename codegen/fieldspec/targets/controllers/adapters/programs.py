"""What serves the ports of a device on a controller, and the programs around it, as text."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import Name
from fieldspec.targets.controllers.adapters.settings import Settings, lines, settings
from fieldspec.targets.controllers.dialects import Spelling
from fieldspec.targets.controllers.routines.blocks.kinds import port_constants
from fieldspec.targets.controllers.routines.blocks.ports import FRAMES, axis_key, cyclic, own_links
from fieldspec.targets.controllers.routines.printer import constants_section, parameter, type_text
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import BYTE, StructType, sequence
from fieldspec.targets.controllers.statements.routine import Routine, sorted_constants
from fieldspec.targets.templates import fill

SIEMENS_RATES = {9600: 6, 19200: 7, 38400: 8, 57600: 9, 115200: 11}
"""The codes of the rates that Port_Config takes."""
TERMINAL_RATES = {9600: 6, 19200: 7, 38400: 8, 57600: 9, 115200: 10}
TERMINAL_FRAMES = {"8N1": 3, "8E1": 4, "8O1": 5}
"""The values of 80n0:11 and 80n0:15 of the terminals EL60xx."""
ALTERNATIVE = "modbus_request"
"""The name of a source that takes the place of another one, so that a project has one of the two."""
_BLOCK = re.compile(r"^(?:FUNCTION_BLOCK|PROGRAM)\b.*?^END_(?:FUNCTION_BLOCK|PROGRAM)$", re.MULTILINE | re.DOTALL)
_BODY = re.compile(r"^END_VAR\n(?=\n|BEGIN)", re.MULTILINE)
"""The end of the variables of a block."""
_WORD_CODES = {"read": {3}, "write": {6, 16}}
_WORD_CHECK = "crc16_modbus"


@dataclass(frozen=True, slots=True)
class Station:
    """A port of a device with its ready program `panel`, and what a controller needs to serve it.

    A line has a `link` with its settings and, where the port has words, a `client` that makes frames of them.
    `shared` says whether vendors have a block for the frames of the link. A telegram has neither.
    """

    panel: Routine
    link: LinkLayout | None = None
    settings: Settings | None = None
    client: str = ""
    shared: bool = False
    telegram: MessageLayout | None = None


def stations(world: World, routines: Sequence[Routine]) -> Iterator[Station]:
    """The ports of a device that have a ready program and can be served."""
    panels = {routine.name: routine for routine in routines if routine.name.endswith("Panel")}
    for message in cyclic(world.layout):
        panel = panels.get(world.block(message.name, "panel"))
        if panel is not None:
            yield Station(panel, telegram=message)
    panel = panels.get(world.block("panel"))
    if panel is None:
        return
    names = {routine.name for routine in routines}
    for link in own_links(world.layout):
        line = settings(world.layout, link, world.frame.high + 1)
        client = world.block(link.name, "client")
        if line is not None and (not world.layout.registers or client in names):
            yield Station(panel, link, line, client if client in names else "", _is_shared(link))
            return


def _is_shared(link: LinkLayout) -> bool:
    """Whether the frames of a link are those that blocks of vendors make: by codes and check, and words after them."""
    codes = {message.message.code_of("request") for message in link.exchanged.values() if message.message.single_access}
    checks = {part.algorithm for part in link.request.parts if part.algorithm}
    return _WORD_CODES["read"] <= codes and bool(_WORD_CODES["write"] & codes) and checks == {_WORD_CHECK}


@dataclass(frozen=True, slots=True)
class Source:
    """A text with blocks and programs: what its file is named by, the lines of its comment, and the text."""

    name: str
    remarks: tuple[str, ...]
    text: str


def codesys(world: World, spelling: Spelling, routines: Sequence[Routine]) -> Iterator[Source]:
    """What CODESYS gets: for a line CAA SerialCom, and where vendors have a block for the frames, that one besides."""
    for station in stations(world, routines):
        if station.telegram is not None:
            yield _image(world, spelling, station, "map it to", "", "")
            continue
        remarks = _about(station, "library CAA SerialCom; call both programs every 5 ms")
        yield _filled(
            world, spelling, station, ("codesys_serial_port.st.j2", "codesys_program.st.j2"), "program", remarks
        )
        if station.shared and station.client:
            remarks = _about(station, "in place of the serial port: libraries IoDrvModbus and SysCom")
            yield _filled(world, spelling, station, ("codesys_modbus_request.st.j2",), ALTERNATIVE, remarks)


def twincat(world: World, spelling: Spelling, routines: Sequence[Routine]) -> Iterator[Source]:
    """What TwinCAT gets: for a line Tc2_ModbusRTU where that makes the frames, else Tc2_SerialCom."""
    for station in stations(world, routines):
        if station.telegram is not None:
            yield _image(world, spelling, station, "link it to", " AT %I*", " AT %Q*")
        elif station.shared and station.client:
            remarks = _about(station, "library Tc2_ModbusRTU (TF6255)", *_terminal(station.settings))
            yield _filled(world, spelling, station, ("twincat_modbus_master.st.j2",), "program", remarks)
        else:
            needs = "library Tc2_SerialCom (TF6340); a task of 1 ms for the line"
            remarks = _about(station, needs, *_terminal(station.settings))
            yield _filled(world, spelling, station, ("twincat_serial_port.st.j2",), "program", remarks)


def siemens(world: World, spelling: Spelling, routines: Sequence[Routine]) -> Iterator[Source]:
    """What TIA Portal gets: for a line Modbus_Master where it makes the frames, else Send_P2P and Receive_P2P."""
    device = world.names.device
    for station in stations(world, routines):
        templates: tuple[str, ...] = ("siemens_program.scl.j2",)
        remarks: tuple[str, ...]
        if station.telegram is not None:
            remarks = (f"{device}, {Name.of(station.telegram.name).title()}: DPRD_DAT and DPWR_DAT.",)
            templates = ("siemens_telegram.scl.j2", *templates)
            yield _filled(world, spelling, station, templates, station.telegram.name, remarks)
        elif station.shared and station.client:
            remarks = _about(station, "Modbus_Comm_Load and Modbus_Master; call it in each cycle, not in a start-up OB")
            templates = ("siemens_modbus_master.scl.j2", *templates)
            yield _filled(world, spelling, station, templates, "program", remarks, f"{device}_ModbusMaster")
        elif not station.client and station.settings is not None and station.settings.rate in SIEMENS_RATES:
            remarks = _about(
                station, "Port_Config, Send_P2P and Receive_P2P; messages end by a character gap of 55 bits"
            )
            templates = ("siemens_point_to_point.scl.j2", *templates)
            yield _filled(world, spelling, station, templates, "program", remarks, f"{device}_PointToPoint")


def standard(world: World, spelling: Spelling, routines: Sequence[Routine]) -> Iterator[Source]:
    """What other compilers get: a program without an adapter, as the standard has nothing that sends."""
    for station in stations(world, routines):
        name = station.telegram.name if station.telegram is not None else "program"
        remarks = _about(station, "nothing of the standard sends: serve the port as your controller does")
        yield _filled(world, spelling, station, ("standard_program.st.j2",), name, remarks)


def _about(station: Station, needs: str, *further: str) -> tuple[str, ...]:
    if station.link is None or station.settings is None:
        return (f"Needs: {needs}.",)
    return (f"Needs: {needs}.", *lines(station.link, station.settings), *further)


def _terminal(line: Settings | None) -> Iterator[str]:
    """The settings of a Beckhoff terminal, whose factory setting is full duplex."""
    if line is not None and line.rate in TERMINAL_RATES and line.frame in TERMINAL_FRAMES:
        yield (
            f"EL6022, CoE of channel 1: 8000:11 = {TERMINAL_RATES[line.rate]} ({line.rate} bps), 8000:15 = "
            f"{TERMINAL_FRAMES[line.frame]} ({line.frame}), 8000:06 = TRUE (half duplex); channel 2 the same at 8010."
        )


def _image(world: World, spelling: Spelling, station: Station, link: str, inputs: str, outputs: str) -> Source:
    """A telegram in the process image of a controller."""
    message = station.telegram
    assert message is not None
    remarks = (
        f"{Name.of(message.name).title()}: the bytes of the submodule, which are the process image of the program.",
    )
    return _filled(
        world,
        spelling,
        station,
        ("process_image.st.j2",),
        message.name,
        remarks,
        link=link,
        input=inputs,
        output=outputs,
    )


def _filled(
    world: World,
    spelling: Spelling,
    station: Station,
    templates: Sequence[str],
    name: str,
    remarks: tuple[str, ...],
    adapter: str = "",
    **linking: str,
) -> Source:
    """The texts of some templates, one after the other."""
    names, lent = world.names, station.panel.of_role("in_out")
    siemens = spelling.variable.startswith("#")
    local = {name: f"stat{name}" if siemens else f"st{name}" for name in (item.variable.name for item in lent)}
    view: dict[str, object] = {
        "device": names.device,
        "panel": station.panel.name,
        "client": station.client if not siemens else "",
        "settings": station.settings,
        "words": bool(world.layout.registers),
        "telegram": "",
        "adapter": adapter,
        "frames": "" if station.telegram is not None else names.structs.get(FRAMES, ""),
        "lent": ", ".join(
            f"{parameter(name, spelling)} := {spelling.variable.format(text)}" for name, text in local.items()
        ),
        "axes": "".join(
            f"    {local[item.variable.name]} : {type_text(item.variable.type, spelling)};\n"
            for item in lent
            if item.variable.name != "Frames"
        ),
        "last": world.frame.high,
        "length_first": station.link is not None and station.link.request.parts[0].role == "length",
        "rate_code": SIEMENS_RATES.get(station.settings.rate, 0) if station.settings is not None else 0,
        "port": "stFrames" if "Frames" in local or station.client else "stAxis",
        **linking,
    }
    if station.telegram is not None:
        view |= _telegram(world, spelling, station.telegram)
    texts = (_BLOCK.sub(_declared, fill(f"controllers/adapters/{template}", **view)) for template in templates)
    return Source(name, remarks, "\n".join(texts))


def _declared(block: re.Match[str]) -> str:
    """A block with the constants that it names, after its variables."""
    text = block[0]
    names = {item.name: item for item in port_constants() if re.search(rf"\b{item.name}\b", text)}
    section = "".join(f"{line}\n" for line in constants_section(sorted_constants(names.values())))
    return _BODY.sub(lambda match: match[0] + section, text, count=1)


def _telegram(world: World, spelling: Spelling, message: MessageLayout) -> dict[str, object]:
    """The data for the templates of a telegram."""
    sizes = {data.name: data.size or 0 for data in (message.request, message.response)}
    request, response = (sequence(sizes[data.name], BYTE) for data in (message.request, message.response))
    pascal = f"{world.names.device}_{Name.of(message.name).pascal()}"
    status = world.status
    return {
        "telegram": pascal,
        "axis": type_text(StructType(world.names.structs[axis_key(message)]), spelling),
        "request_last": request.high,
        "response_last": response.high,
        "request_bytes": type_text(request, spelling),
        "response_bytes": type_text(response, spelling),
        "pack": world.routine("pack", message.request.name, "bytes"),
        "unpack": world.routine("unpack", message.response.name, "bytes"),
        "status": type_text(status.type, spelling),
        "ok": spelling.member.format(status.type.name, status.of("ok").member, 0),
    }
