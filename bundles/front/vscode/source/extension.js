"use strict";
// What VS Code starts: puts the parts together.

const path = require("path");
const vscode = require("vscode");
const { ChainView } = require("./chain");
const { Client } = require("./client");
const { Missing, findProgram } = require("./program");
const { pickProject } = require("./projects");
const { ReportView } = require("./report");
const { COMMANDS, registerTasks, runTask } = require("./tasks");
const { Tests } = require("./tests");

/** The settings that say how the program is started. */
const STARTING = ["program", "java", "memory"];

/** @param {vscode.ExtensionContext} context */
function activate(context) {
  const log = vscode.window.createOutputChannel("Eventchain");
  const find = () => program(context.extensionPath);
  const client = new Client(
    async () => {
      const found = await find();
      return found && { command: found.command, args: [found.script, "lsp"], env: found.env };
    },
    log,
  );
  const chains = new ChainView(find, context.extensionUri);
  const reports = new ReportView();
  /** @type {(name: string, action: (...values: any[]) => any) => void} */
  const command = (name, action) => {
    context.subscriptions.push(vscode.commands.registerCommand(`eventchain.${name}`, action));
  };
  /** @type {(action: (project: string) => any) => (of?: vscode.Uri) => Promise<void>} */
  const ofProject = (action) => async (of) => {
    const project = await pickProject(of);
    return project && action(project);
  };
  for (const name of COMMANDS) {
    const ofOne = ofProject((project) => runTask(find, client.isRunning && name === "validate", name, project));
    // A code lens names the project's folder and, if it is about one, the scenario.
    command(name, (of, scenario) =>
      typeof of === "string"
        ? runTask(find, false, name, of, ...(typeof scenario === "string" ? ["--scenario", scenario] : []))
        : ofOne(of),
    );
  }
  command("showChain", ofProject((project) => chains.show(project)));
  command("showReport", ofProject((project) => reports.show(project)));
  command("doctor", () => runTask(find, false, "doctor", undefined));
  command("restartServer", () => client.restart());
  command("showLog", () => log.show());
  command("explainFinding", () => explain(client, find));
  context.subscriptions.push(log, client, chains, reports, registerTasks(find), new Tests(find));
  context.subscriptions.push(
    vscode.workspace.onDidChangeConfiguration(
      (event) => STARTING.some((name) => event.affectsConfiguration(`eventchain.${name}`)) && client.restart(),
    ),
  );
  // Not awaited: commands and tests need no server.
  client.restart().catch((error) => log.appendLine(String(error)));
}

/**
 * Returns how to start the program; says what is missing, and returns nothing then.
 *
 * @param {string} extension
 */
async function program(extension) {
  const settings = vscode.workspace.getConfiguration("eventchain");
  try {
    return await findProgram(
      {
        program: settings.get("program", ""),
        javaHome: settings.get("java.home", ""),
        memory: settings.get("memory", ""),
      },
      path.join(extension, "program"),
      process.env,
    );
  } catch (error) {
    if (!(error instanceof Missing)) {
      throw error;
    }
    // Not awaited: whoever asked need not wait until somebody closes the message.
    vscode.window.showErrorMessage(`Eventchain: ${error.message}`, "Open Settings").then((answer) => {
      if (answer) {
        vscode.commands.executeCommand("workbench.action.openSettings", "eventchain");
      }
    });
    return undefined;
  }
}

/**
 * Explains the finding under the cursor, or another one by its id. Shows the page of its rule, or prints it.
 *
 * @param {Client} client
 * @param {import("./tasks").Program} find
 */
async function explain(client, find) {
  const editor = vscode.window.activeTextEditor;
  const here =
    editor &&
    vscode.languages
      .getDiagnostics(editor.document.uri)
      .find((each) => each.source === "eventchain" && each.range.contains(editor.selection.active));
  const code = here && (typeof here.code === "object" ? here.code.value : here.code);
  const id = code || (await vscode.window.showInputBox({ prompt: "The id of a finding, such as ocl.violated" }));
  if (id && !(await client.execute("eventchain.explain", String(id)))) {
    await runTask(find, true, "explain", undefined, String(id));
  }
}

module.exports = { activate };
