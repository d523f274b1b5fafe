"""Serves a folder of pages to the browsers of this machine."""

from __future__ import annotations

import os
import re
import sys
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from fieldspec.tools.carriers.carrier import CarrierError

HOST = "127.0.0.1"
"""Only this machine reaches it."""

_LOCAL = re.compile(r"(127\.0\.0\.1|localhost)(:[0-9]+)?", re.IGNORECASE)
"""The names by which browsers of this machine ask. They leave out the port where it is 80."""

_INDEXES = ("", "index.html", "index.htm")
"""What may be sent for a path: the file itself, or an index of the folder."""


class _Handler(SimpleHTTPRequestHandler):
    """Files of a folder, always as they are now, to who asks for them by the name of this machine."""

    def send_head(self):  # type: ignore[no-untyped-def]
        """Refuses names that lead here from elsewhere, by which pages of others could read these, and links that lead
        out of the folder, which the author of the specs may have put there.
        """
        if not _LOCAL.fullmatch(self.headers.get("Host", "")):
            self.send_error(403, "use the address that fieldspec printed")
        elif not self._is_within():
            self.send_error(404, "there is no such page")
        else:
            return super().send_head()
        return None

    def _is_within(self) -> bool:
        """Whether what may be sent is in the folder, wherever links lead."""
        folder = os.path.join(os.path.realpath(self.directory), "")
        path = self.translate_path(self.path)
        try:
            files = [os.path.realpath(os.path.join(path, index)) for index in _INDEXES]
        except ValueError:  # characters that no path has
            return False
        return all(os.path.join(file, "").startswith(folder) for file in files)

    def end_headers(self) -> None:
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def list_directory(self, path: object) -> None:
        """Refuses to list a folder: one without an index has no page."""
        self.send_error(404, "there is no such page")

    def log_message(self, format: str, *arguments: object) -> None:
        """Logs nothing."""


class _Server(ThreadingHTTPServer):
    def handle_error(self, request: object, client_address: object) -> None:
        """Logs nothing of clients that leave while they are answered."""
        if not isinstance(sys.exc_info()[1], ConnectionError):
            super().handle_error(request, client_address)  # type: ignore[arg-type]


class PageServer:
    """A server of the files below a folder, at `address`. Port 0 takes one that is free. Raises CarrierError."""

    def __init__(self, folder: Path, port: int) -> None:
        try:
            self._server = _Server((HOST, port), partial(_Handler, directory=str(folder)))
        except OSError as error:
            raise CarrierError(f"cannot serve pages on port {port}: {error.strerror}") from None
        self._serves = False
        self.address = f"http://{HOST}:{self._server.server_address[1]}/"

    def serve(self) -> None:
        """Answers requests, until `close` or an interrupt."""
        self._serves = True
        self._server.serve_forever(poll_interval=0.2)

    def close(self) -> None:
        """Closes the server and releases its port."""
        if self._serves:
            self._server.shutdown()
        self._server.server_close()
