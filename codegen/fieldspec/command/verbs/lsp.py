"""`fieldspec lsp`: what an editor asks about specs while they are typed, by the Language Server Protocol."""

from __future__ import annotations

import argparse
import logging
import os
import sys

from fieldspec.command.console.usage import UsageError


def run(arguments: argparse.Namespace) -> int:
    """Serves an editor on standard input and output until it ends. Raises UsageError."""
    try:
        from fieldspec.command.editor.answers import server
        from fieldspec.command.editor.server import is_refusal
    except ImportError:
        raise UsageError("the server needs pygls: pip install 'fieldspec[lsp]'") from None
    editor = server(arguments.specs, arguments.manuals)
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # what anything prints is not an answer
    # What cannot be answered is said in the answer, and is not a fault of the server.
    logging.getLogger("pygls.protocol.json_rpc").addFilter(lambda record: not is_refusal(record.exc_info))
    editor.start_io(sys.stdin.buffer, answers)
    return 0
