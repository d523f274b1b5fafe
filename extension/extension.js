// Starts `fieldspec lsp` for the specs of a workspace, and shows what it answers.
"use strict";

const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

/** The client while the extension is active. */
let client;

/** A client of the server that the settings name. */
function newClient() {
  const settings = vscode.workspace.getConfiguration("fieldspec");
  const [command, ...first] = settings.get("program");
  const manuals = settings.get("manuals");
  const server = { command, args: [...first, "lsp", ...(manuals ? ["--manuals", manuals] : [])] };
  return new LanguageClient("fieldspec", "fieldspec", server, {
    documentSelector: [{ scheme: "file", language: "yaml" }],
    synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher("**/*.yaml") },
    initializationOptions: { showsAnswers: true },
    middleware: { executeCommand: shown },
  });
}

/** Runs a command of the server, and opens the text that it answers beside the document. */
async function shown(command, args, next) {
  const answer = await next(command, args);
  if (typeof answer === "string") {
    const document = await vscode.workspace.openTextDocument({ content: answer, language: "plaintext" });
    await vscode.window.showTextDocument(document, { viewColumn: vscode.ViewColumn.Beside, preview: true });
  }
  return answer;
}

/** Starts the server, or says how to install it. */
async function start() {
  client = newClient();
  try {
    await client.start();
  } catch (error) {
    const text = `fieldspec lsp does not start: ${error.message}. Install it by: pip install 'fieldspec[lsp]'`;
    vscode.window.showErrorMessage(text);
  }
}

async function stop() {
  const running = client;
  client = undefined;
  if (running !== undefined && running.needsStop()) {
    await running.stop();
  }
}

async function activate(context) {
  const restart = async () => {
    await stop();
    await start();
  };
  context.subscriptions.push(
    vscode.commands.registerCommand("fieldspec.restart", restart),
    vscode.workspace.onDidChangeConfiguration((event) => event.affectsConfiguration("fieldspec") && restart()),
  );
  await start();
}

module.exports = { activate, deactivate: stop };
