"""A client of an editor's language server, over its standard input and output."""

from __future__ import annotations

import json
import subprocess
import threading
from pathlib import Path
from types import TracebackType
from typing import Any

from bounded import HANGING

Json = dict[str, Any]

LONGEST = 120
"""Seconds after which a server that does not answer is stopped."""

_SETTINGS = {"yaml": {"validate": True, "hover": True, "completion": True, "schemaStore": {"enable": False}}}


class LanguageServer:
    """A running server with the files that are open in it. A position is a line and a column, counted from 0."""

    def __init__(self, command: list[str], folder: Path) -> None:
        self._process = subprocess.Popen(command, cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self._watchdog = threading.Timer(LONGEST, self._process.kill)
        self._watchdog.start()
        self._asked = 0
        self._diagnostics: dict[str, list[Json]] = {}
        self._request(
            "initialize",
            {"processId": None, "rootUri": folder.as_uri(), "capabilities": {"workspace": {"configuration": True}}},
        )
        self._notify("initialized", {})

    def __enter__(self) -> LanguageServer:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._request("shutdown", None)
        self._notify("exit", None)
        self._process.communicate(timeout=HANGING)
        self._watchdog.cancel()

    def opened(self, path: Path, text: str) -> list[Json]:
        """Opens a file with a text that need not be on disk, and returns the server's diagnostics."""
        uri = path.as_uri()
        document = {"uri": uri, "languageId": "yaml", "version": 1, "text": text}
        self._notify("textDocument/didOpen", {"textDocument": document})
        while uri not in self._diagnostics:
            self._answered(self._message())
        return self._diagnostics.pop(uri)

    def closed(self, path: Path) -> None:
        """Closes a file, so that it can be opened with another text."""
        self._notify("textDocument/didClose", {"textDocument": {"uri": path.as_uri()}})

    def completions(self, path: Path, line: int, column: int) -> dict[str, Json]:
        """The completions at a position, by label."""
        items = self._request("textDocument/completion", _position(path, line, column))
        return {item["label"]: item for item in items["items"]}

    def hover(self, path: Path, line: int, column: int) -> str:
        """The hover text at a position."""
        contents = self._request("textDocument/hover", _position(path, line, column))
        return str(contents["contents"]["value"]) if contents else ""

    def _request(self, method: str, params: Any) -> Any:
        self._asked += 1
        self._send({"id": self._asked, "method": method, "params": params})
        while True:
            message = self._message()
            if message.get("id") == self._asked and "method" not in message:
                assert "error" not in message, message
                return message["result"]
            self._answered(message)

    def _notify(self, method: str, params: Any) -> None:
        self._send({"method": method, "params": params})

    def _answered(self, message: Json) -> None:
        """Handles a message of the server."""
        if message.get("method") == "textDocument/publishDiagnostics":
            self._diagnostics[message["params"]["uri"]] = message["params"]["diagnostics"]
        elif "id" in message and "method" in message:
            items = (message["params"] or {}).get("items", [])
            self._send({"id": message["id"], "result": [_SETTINGS.get(item.get("section")) for item in items] or None})

    def _send(self, message: Json) -> None:
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        assert self._process.stdin is not None
        self._process.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self._process.stdin.flush()

    def _message(self) -> Json:
        assert self._process.stdout is not None
        length = 0
        while (line := self._process.stdout.readline().strip()) or not length:
            if not line:
                assert self._process.poll() is None, "the server has ended"
            name, _, value = line.partition(b":")
            if name.lower() == b"content-length":
                length = int(value)
        message: Json = json.loads(self._process.stdout.read(length))
        return message


def _position(path: Path, line: int, column: int) -> Json:
    return {"textDocument": {"uri": path.as_uri()}, "position": {"line": line, "character": column}}
