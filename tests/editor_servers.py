"""Servers of `fieldspec lsp` that are forked from a process that has imported what they need, each for one editor."""

from __future__ import annotations

import multiprocessing
import socket
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from multiprocessing.context import BaseContext

from bounded import HANGING


@cache
def _processes() -> BaseContext:
    has_fork_server = "forkserver" in multiprocessing.get_all_start_methods()
    context = multiprocessing.get_context("forkserver" if has_fork_server else "spawn")
    context.set_forkserver_preload(["fieldspec.command.editor.answers", "editor_servers"])
    return context


def serve(listener: socket.socket) -> None:
    """Serves the first editor that connects, as the verb does the one that has started it."""
    from fieldspec.command.editor.answers import server

    connection, _ = listener.accept()
    with connection.makefile("rb") as asked, connection.makefile("wb") as answers:
        server(None, None).start_io(asked, answers)


@contextmanager
def server_address() -> Iterator[tuple[str, int]]:
    """The address of a new server, which has ended after the block."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        process = _processes().Process(target=serve, args=(listener,), daemon=True)
        process.start()
        host, port = listener.getsockname()
        yield host, port
    process.join(HANGING)
