"""`fieldspec lsp`: what the findings of the whole project take after a key, and answers, in time of the processor.

Besides, the findings wait 50 ms for another key.
"""

from __future__ import annotations

import json
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path
from statistics import median
from typing import Any

from peers import registers
from processes import FIELDSPEC, limited, work_of
from rows import Row, printed

ANSWERS = (
    ("hover", "hover", "name: "),
    ("completion", "completion of a word", "access: "),
    ("completion", "completion of an address", "at: "),
    ("codeAction", "code actions", "access: "),
)
"""The requests, their names in the table, and the words after which they ask."""

ROUNDS = {1000: 5, 10_000: 3}
"""By number of registers."""


class Server:
    """A server with a document of a folder of specs."""

    def __init__(self, folder: Path, path: Path) -> None:
        self.process = subprocess.Popen((*FIELDSPEC, "lsp"), stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.uri, self.text, self.version = path.as_uri(), path.read_text("utf-8"), 0
        self.send("initialize", {"processId": None, "rootUri": folder.as_uri(), "capabilities": {}}, 1)
        self.wait("id")
        self.send("initialized", {})
        document = {"uri": self.uri, "languageId": "yaml", "version": 0, "text": self.text}
        self.send("textDocument/didOpen", {"textDocument": document})
        self.wait("textDocument/publishDiagnostics")

    def send(self, method: str, parameters: Any, number: int | None = None) -> None:
        message = {"jsonrpc": "2.0", "method": method, "params": parameters, **({"id": number} if number else {})}
        body = json.dumps(message).encode()
        assert self.process.stdin is not None
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self.process.stdin.flush()

    def wait(self, what: str) -> None:
        """Reads messages to the first with a method, or with an `id`."""
        assert self.process.stdout is not None
        while True:
            size = 0
            while line := self.process.stdout.readline().strip():
                size = int(line.rpartition(b":")[2]) if line.lower().startswith(b"content-length") else size
            message = json.loads(self.process.stdout.read(size))
            if what in (message.get("method"), "id" if "id" in message and "method" not in message else None):
                return

    def typed(self, text: str) -> float:
        """Milliseconds of the processor from a key to the findings."""
        self.version += 1
        before = work_of(self.process.pid)
        document = {"uri": self.uri, "version": self.version}
        self.send("textDocument/didChange", {"textDocument": document, "contentChanges": [{"text": text}]})
        self.wait("textDocument/publishDiagnostics")
        return work_of(self.process.pid) - before

    def asked(self, request: str, line: int, word: str) -> float:
        """Milliseconds of the processor that an answer takes about the place after a word of a line."""
        before = work_of(self.process.pid)
        position = {"line": line, "character": self.text.split("\n")[line].index(word) + len(word)}
        selected = {"range": {"start": position, "end": position}, "context": {"diagnostics": []}}
        place = selected if request == "codeAction" else {"position": position}
        self.send(f"textDocument/{request}", {"textDocument": {"uri": self.uri}, **place}, 2)
        self.wait("id")
        return work_of(self.process.pid) - before


def rows() -> Iterator[Row]:
    """The rows, by number of registers."""
    for count, rounds in ROUNDS.items():
        with tempfile.TemporaryDirectory() as folder:
            for name, text in registers.spec(count).items():
                path = Path(folder, "specs", name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            server = Server(Path(folder).resolve(), path.resolve())
            try:
                yield from _of(f"lsp, {count:,} registers", server, rounds, 0.3 * count)
            finally:
                server.process.kill()
                server.process.wait()


def _of(group: str, server: Server, rounds: int, limit: float) -> Iterator[Row]:
    lines = server.text.split("\n")
    row = next(line for line, text in enumerate(lines) if "name: value_" in text)
    sound = [server.typed(f"{server.text}# {turn}\n") for turn in range(rounds)]
    wrong = [server.typed(server.text.replace("access: rw", f"acces{turn}: rw", 1)) for turn in range(rounds)]
    server.typed(server.text)
    yield limited(group, "findings after a key", median(sound), "ms", limit)
    yield limited(group, "findings after a slip", median(wrong), "ms", limit)
    for request, name, word in ANSWERS:
        answers = [server.asked(request, row + turn, word) for turn in range(rounds)]
        yield limited(group, name, median(answers), "ms", limit)


if __name__ == "__main__":
    printed(rows())
