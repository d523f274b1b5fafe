"""A server of `fieldspec lsp` that has met the capabilities of an editor, and a process that has judged some devices.

Servers that are forked from this process need not compile, import and read again what takes half a second.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from lsprotocol import types
from pytest_lsp import client_capabilities

import parsed_once
from editing import copied
from fieldspec.command.editor.answers import server
from fieldspec.command.editor.projects import EditedProject

assert parsed_once  # as in the tests

READY = server(None, None)
"""The server, for one editor."""

_converter = READY.protocol._converter
_begin = types.InitializeRequest(1, types.InitializeParams(client_capabilities("visual_studio_code")))
_converter.structure(_converter.unstructure(_begin), types.InitializeRequest)

with tempfile.TemporaryDirectory() as _folder:
    _project = EditedProject(copied(Path(_folder), "gizmo", "glider-x", "wattmeter"))
    _project.read({})
    _project.findings()
