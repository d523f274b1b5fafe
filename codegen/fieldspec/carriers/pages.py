"""Serves a folder of pages to the browsers of this machine."""

from __future__ import annotations

from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from fieldspec.carriers.carrier import CarrierError

HOST = "127.0.0.1"
"""Nobody but this machine reaches it."""


class _Handler(SimpleHTTPRequestHandler):
    """Files of a folder, always as they are now, to who asks for them by the name of this machine."""

    def send_head(self):  # type: ignore[no-untyped-def]
        """Refuses names that lead here from elsewhere, by which pages of others could read these."""
        if self.headers.get("Host", "").rpartition(":")[0] not in (HOST, "localhost"):
            self.send_error(403, "use the address that fieldspec printed")
            return None
        return super().send_head()

    def end_headers(self) -> None:
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def list_directory(self, path: object) -> None:
        """Refuses to list a folder: one without an index has no page."""
        self.send_error(404, "there is no such page")

    def log_message(self, format: str, *arguments: object) -> None:
        """Says nothing of requests."""


class PageServer:
    """A server of the files below a folder, at `address`. Port 0 takes one that is free. Raises CarrierError."""

    def __init__(self, folder: Path, port: int) -> None:
        try:
            self._server = ThreadingHTTPServer((HOST, port), partial(_Handler, directory=str(folder)))
        except OSError as error:
            raise CarrierError(f"cannot serve pages on port {port}: {error.strerror}") from None
        self.address = f"http://{HOST}:{self._server.server_address[1]}/"

    def serve(self) -> None:
        """Answers requests, until `close` or an interrupt."""
        self._server.serve_forever(poll_interval=0.2)

    def close(self) -> None:
        """Ends the server and gives its port back."""
        self._server.server_close()
