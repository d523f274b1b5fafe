"""`fieldspec mcp`: the verbs that explain and read devices, as tools of the Model Context Protocol.

Each call is a process of its own: what a verb prints is its result, and nothing that it does reaches the protocol.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from collections.abc import Sequence

from fieldspec.command.console.usage import UsageError
from fieldspec.command.sources import specs
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.tools.live.parameter_access import ParameterAccess
from fieldspec.tools.live.register_access import RegisterAccess

if TYPE_CHECKING:
    from fieldspec.command.serving.mcp_server import Server
    from fieldspec.language.model.fact import Fact


SECONDS = 120
"""How long a verb may take."""

INSTRUCTIONS = (
    "Specs of motion controllers: registers, messages, frames, tasks, and the evidence that they are right. A device "
    "is written DEVICE or DEVICE@VERSION. Every fact has its source in the manual; what is unknown is marked so."
)


@dataclass(frozen=True, slots=True)
class Places:
    """Where devices are that may be talked to, by the names that the caller uses, and the options of all calls."""

    ports: dict[str, str]
    options: tuple[str, ...]


def run(arguments: argparse.Namespace) -> int:
    """Serves the tools on standard input and output until the client ends. Raises UsageError."""
    try:
        from fieldspec.command.serving.mcp_server import Server
    except ImportError:
        raise UsageError("the server needs the SDK of the protocol: pip install 'fieldspec[mcp]'") from None
    ports: dict[str, str] = {}
    for text in arguments.port or ():
        device, mark, place = text.partition("=")
        if not mark or not place:
            raise UsageError(f"`{text}` is not a place; write it as DEVICE=/dev/ttyUSB0, DEVICE=socket://HOST:PORT")
        specs.spec_at(arguments.specs, device)
        ports[device] = place
    if arguments.allow_writes and not ports:
        raise UsageError("--allow-writes needs a device to write to: --port DEVICE=WHERE")
    options = ("--specs", arguments.specs) if arguments.specs else ()
    server = Server("fieldspec", instructions=INSTRUCTIONS, log_level="ERROR")
    _add_explanations(server, options)
    if ports:
        _add_reads(server, Places(ports, options))
    if arguments.allow_writes:
        _add_writes(server, Places(ports, options))
    server.run("stdio")
    return 0


def _add_explanations(server: Server, options: tuple[str, ...]) -> None:
    """Adds the tools that only read specs."""
    from mcp.types import ToolAnnotations

    reads = ToolAnnotations(read_only_hint=True, open_world_hint=False)

    @server.tool(annotations=reads)
    def devices() -> str:
        """The devices that have a spec, with their versions."""
        return _verb("devices", (), options)

    @server.tool(annotations=reads)
    def show(device: str, item: str = "") -> str:
        """A device, or one of its items: a register, parameter, message or enum, by its name, address or code."""
        return _verb("show", (device, *([item] if item else [])), options)

    @server.tool(annotations=reads)
    def decode(device: str, frame: str, direction: str = "", link: str = "", message: str = "") -> str:
        """Explains a frame byte by byte. `frame` has the bytes in hexadecimal, `direction` is request or response."""
        named_options = (("--direction", direction), ("--link", link), ("--message", message))
        return _verb("decode", (device, frame), (*_options(named_options), *options))

    @server.tool(annotations=reads)
    def audit(device: str) -> str:
        """The evidence that the spec of a device is right, and where it is missing."""
        return _verb("audit", (device,), options)


def _add_reads(server: Server, places: Places) -> None:
    """Adds the tool that reads devices."""
    from mcp.types import ToolAnnotations

    @server.tool(annotations=ToolAnnotations(read_only_hint=True))
    def read(device: str, names: list[str]) -> str:
        """Reads values of a device that is connected, by names, roles or addresses, as JSON.

        What reading clears is refused, and so are names that only say what is written.
        """
        _refuse_hazards(places, device, names)
        own = ("--port", _place(places, device), "--format", "json", *places.options)
        return _verb("live", (device, "read", *names), own)

    @server.tool(annotations=ToolAnnotations(read_only_hint=True, open_world_hint=False))
    def connected() -> list[str]:
        """The devices that are connected."""
        return list(places.ports)


def _add_writes(server: Server, places: Places) -> None:
    """Adds the tool that writes to devices."""
    from mcp.types import ToolAnnotations

    @server.tool(annotations=ToolAnnotations(read_only_hint=False, destructive_hint=True, idempotent_hint=False))
    def write(device: str, assignments: list[str], confirmed: bool = False) -> str:
        """Writes values, each as NAME=VALUE, and reads them back. A machine may move.

        Without `confirmed`, values that start, energize or release something, are stored permanently or wear out memory
        are not written: the answer then lists them. Confirm only what a person has agreed to.
        """
        own = ("--port", _place(places, device), *(["--yes"] if confirmed else []), *places.options)
        return _verb("live", (device, "write", *assignments), own)


def _options(named_options: Sequence[tuple[str, str]]) -> list[str]:
    return [f"{option}={value}" for option, value in named_options if value]


def _place(places: Places, device: str) -> str:
    """The place of a device. Raises ToolError for one that is not connected."""
    from mcp.server.mcpserver.exceptions import ToolError

    if device not in places.ports:
        raise ToolError(f"{device} is not connected; connected are {', '.join(places.ports)}")
    return places.ports[device]


def _refuse_hazards(places: Places, device: str, names: Sequence[str]) -> None:
    """Raises ToolError for names of values that reading clears."""
    from mcp.server.mcpserver.exceptions import ToolError

    _place(places, device)
    spec, version = specs.spec_at(places.options[1] if places.options else None, device)
    layout = specs.layout_of(spec, version)
    registers = RegisterAccess(layout)
    facts: list[Fact] = [fact for name in names for _, own in registers.named(name) for fact in (own.fact, own.outer)]
    for link in layout.links.values():
        parameters = ParameterAccess(layout, link)
        facts += [signal.fact for name in names for signal in parameters.named(name)]
    for fact in facts:
        handling = getattr(fact, "handling", None)
        if handling is not None and handling.clears_on_read:
            raise ToolError(f"reading clears {fact.name}: it is not read here")


def _verb(verb: str, words: Sequence[str], options: Sequence[str]) -> str:
    """The output of a verb. Raises ToolError with what it says where it ends with an error."""
    from mcp.server.mcpserver.exceptions import ToolError

    for word in words:
        if word.startswith("-"):
            raise ToolError(f"`{word}` is not a name and no value here")
    if any("\0" in text for text in (*words, *options)):
        raise ToolError("a text has a zero byte, which no name and no value has")
    command = [sys.executable, "-m", "fieldspec", verb, *options, *words]
    try:
        done = subprocess.run(
            command,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            encoding="utf-8",
            errors="backslashreplace",
            timeout=SECONDS,
            check=False,
        )
    except subprocess.TimeoutExpired:
        raise ToolError(f"{verb} takes longer than {SECONDS} seconds") from None
    except OSError as error:
        raise ToolError(f"{verb} cannot be started: {error.strerror}") from None
    if done.returncode:
        raise ToolError("\n".join(text for text in (done.stdout.strip(), done.stderr.strip()) if text))
    return done.stdout + done.stderr
