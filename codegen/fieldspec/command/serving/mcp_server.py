"""A server of the Model Context Protocol that takes arguments as its tools publish them, and answers every line."""

from __future__ import annotations

import json
from collections.abc import Mapping
from types import TracebackType
from typing import Any

import anyio
from mcp.server.mcpserver import Context, MCPServer
from mcp.server.mcpserver.exceptions import ToolError
from mcp.server.stdio import stdio_server
from mcp.shared.message import SessionMessage
from mcp.types import INVALID_REQUEST, PARSE_ERROR, ErrorData, JSONRPCError
from pydantic import ValidationError

MOST_BYTES = 30_000
"""The most bytes of the arguments of a call as JSON. They become a command line, and no system takes a longer one."""


class Server(MCPServer[None]):
    """The SDK's server ignores arguments that a tool does not have, takes texts for truth values, and is silent about
    a line that is not a message.
    """

    async def call_tool(self, name: str, arguments: dict[str, Any], context: Context[None, Any] | None = None) -> Any:
        """Calls a tool. Raises ToolError where it ends with an error, or refuses its arguments."""
        schema = next((tool.input_schema for tool in await self.list_tools() if tool.name == name), None)
        if schema is not None:
            _refuse(name, arguments, schema["properties"])
        return await super().call_tool(name, arguments, context)

    async def run_stdio_async(self) -> None:
        """Serves standard input and output until the client ends."""
        async with stdio_server() as (lines, answers):
            options = self._lowlevel_server.create_initialization_options()
            await self._lowlevel_server.run(_Messages(lines, answers), answers, options)


def _refuse(name: str, arguments: Mapping[str, Any], properties: Mapping[str, Any]) -> None:
    """Raises ToolError for arguments that a tool does not have."""
    size = len(json.dumps(arguments))
    if size > MOST_BYTES:
        raise ToolError(f"the arguments of {name} have {size} bytes; send {MOST_BYTES} at most")
    for argument, value in arguments.items():
        if argument not in properties:
            known = ", ".join(properties) or "none"
            raise ToolError(f"{name} has no argument `{argument}`; its arguments are: {known}")
        if properties[argument].get("type") == "boolean" and not isinstance(value, bool):
            raise ToolError(f"`{argument}` of {name} is true or false, without quotation marks")


class _Messages:
    """The messages of a client. An invalid line is answered here; JSON-RPC 2.0, section 5."""

    def __init__(self, lines: Any, answers: Any) -> None:
        self._lines, self._answers = lines, answers

    @property
    def last_context(self) -> Any:
        """The context of the sender of the last message."""
        return self._lines.last_context

    async def receive(self) -> SessionMessage | Exception:
        """The next message."""
        while isinstance(message := await self._lines.receive(), ValidationError):
            await self._answers.send(SessionMessage(_refusal(message)))
        result: SessionMessage | Exception = message
        return result

    async def aclose(self) -> None:
        """Ends it."""
        await self._lines.aclose()

    def __aiter__(self) -> _Messages:
        return self

    async def __anext__(self) -> SessionMessage | Exception:
        try:
            return await self.receive()
        except anyio.EndOfStream:
            raise StopAsyncIteration from None

    async def __aenter__(self) -> _Messages:
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        await self.aclose()


def _refusal(error: ValidationError) -> JSONRPCError:
    """The answer to a line that is not a message, with the number of its request where that can be read."""
    first = error.errors(include_url=False)[0]
    is_text = first["type"] == "json_invalid"
    code = PARSE_ERROR if is_text else INVALID_REQUEST
    request = _request_id(first["input"]) if is_text else None
    return JSONRPCError(jsonrpc="2.0", id=request, error=ErrorData(code=code, message=first["msg"]))


def _request_id(line: str) -> int | str | None:
    """The number of the request in a line with half a surrogate pair, which is JSON, but no text that can be sent."""
    try:
        number = json.loads(line)["id"]
        return number if type(number) is int else str(number.encode(), "utf-8")
    except (ValueError, LookupError, TypeError, AttributeError, RecursionError):
        return None
