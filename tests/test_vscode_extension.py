"""The extension for Visual Studio Code starts `fieldspec lsp` with what its settings say, and opens what it answers."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from bounded import HANGING
from fieldspec.cli import parser

FOLDER = Path(__file__).parent.parent / "extension"
PACKAGE = json.loads((FOLDER / "package.json").read_text("utf-8"))

# In place of the editor and of its client: objects that note what is asked of them.
STUBS = """
const Module = require("node:module");
const seen = { opened: [], stopped: 0 };
const settings = SETTINGS;
const vscode = {
  workspace: {
    getConfiguration: () => ({ get: (name) => settings[name] }),
    createFileSystemWatcher: (pattern) => pattern,
    onDidChangeConfiguration: () => ({}),
    openTextDocument: async ({ content }) => content,
  },
  window: { showTextDocument: async (text) => seen.opened.push(text) },
  commands: { registerCommand: (name) => ({ name }) },
  ViewColumn: { Beside: 2 },
};
class LanguageClient {
  constructor(id, name, server, options) { Object.assign(seen, { server, options }); }
  async start() {}
  needsStop() { return true; }
  async stop() { seen.stopped += 1; }
}
const load = Module._load;
Module._load = (name, ...rest) =>
  name === "vscode" ? vscode : name === "vscode-languageclient/node" ? { LanguageClient } : load(name, ...rest);
const extension = require(PATH);
(async () => {
  await extension.activate({ subscriptions: [] });
  await seen.options.middleware.executeCommand("fieldspec.explain", [], async () => "a text");
  await extension.deactivate();
  console.log(JSON.stringify(seen));
})();
"""


def run_with(settings: dict[str, Any]) -> dict[str, Any]:
    """What the extension asks of the editor under some settings."""
    node = shutil.which("node")
    if node is None:
        pytest.skip("node is not there")
    path = json.dumps(str(FOLDER / PACKAGE["main"]))
    script = STUBS.replace("SETTINGS", json.dumps(settings)).replace("PATH", path)
    run = subprocess.run([node, "-e", script], capture_output=True, text=True, check=True, timeout=HANGING)
    result: dict[str, Any] = json.loads(run.stdout)
    return result


def defaults() -> dict[str, Any]:
    """The settings as the package states them."""
    properties = PACKAGE["contributes"]["configuration"]["properties"]
    return {name.removeprefix("fieldspec."): setting["default"] for name, setting in properties.items()}


def test_it_starts_the_server_of_the_command_line_and_opens_its_answers() -> None:
    seen = run_with({**defaults(), "manuals": "/manuals"})
    assert seen["server"]["command"] == "fieldspec"
    arguments = parser().parse_args(seen["server"]["args"])
    assert (arguments.verb, arguments.manuals) == ("lsp", "/manuals")
    assert (seen["opened"], seen["stopped"]) == (["a text"], 1)


def test_its_settings_and_commands_are_those_that_the_package_states() -> None:
    text = (FOLDER / "extension.js").read_text("utf-8")
    assert {*re.findall(r'settings\.get\("(\w+)"\)', text)} == {*defaults()}
    commands = [command["command"] for command in PACKAGE["contributes"]["commands"]]
    assert re.findall(r'registerCommand\("([\w.]+)"', text) == commands


def test_the_program_that_runs_cannot_be_chosen_by_a_workspace() -> None:
    properties = PACKAGE["contributes"]["configuration"]["properties"]
    assert properties["fieldspec.program"]["scope"] == "machine"
