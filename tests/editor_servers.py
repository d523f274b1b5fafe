"""Servers of `fieldspec lsp` that are forked from a process that has a ready one, each for one editor."""

from __future__ import annotations

import multiprocessing
import os
import socket
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from multiprocessing import forkserver
from multiprocessing.context import BaseContext

import pytest

from bounded import HANGING


@cache
def _processes() -> BaseContext:
    has_fork_server = "forkserver" in multiprocessing.get_all_start_methods()
    context = multiprocessing.get_context("forkserver" if has_fork_server else "spawn")
    context.set_forkserver_preload(["ready_server"])
    if has_fork_server:
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("PYTHONPATH", os.pathsep.join(sys.path))  # where the process finds what it loads
            forkserver.ensure_running()
    return context


def serve(listener: socket.socket) -> None:
    """Serves the first editor that connects, as the verb does the one that has started it."""
    from ready_server import READY

    connection, _ = listener.accept()
    with connection.makefile("rb") as asked, connection.makefile("wb") as answers:
        READY.start_io(asked, answers)


@contextmanager
def server_address() -> Iterator[tuple[str, int]]:
    """The address of a new server, which has ended after the block."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        process = _processes().Process(target=serve, args=(listener,), daemon=True)
        process.start()
        host, port = listener.getsockname()
        yield host, port
    process.join(HANGING)
