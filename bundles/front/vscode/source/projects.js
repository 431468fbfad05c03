"use strict";
// The projects in the workspace: folders with an eventchain.yaml.

const path = require("path");
const vscode = require("vscode");
const { SETTINGS } = require("./files");

const ELSEWHERE = "**/{node_modules,out,target,build,install,.git}/**";

/** Returns the folders of all projects, in the order of their names. */
async function projects() {
  const files = await vscode.workspace.findFiles(`**/${SETTINGS}`, ELSEWHERE);
  return files.map((file) => path.dirname(file.fsPath)).sort();
}

/** @param {string} folder of a project; its name for people */
function nameOf(folder) {
  const shown = vscode.workspace.asRelativePath(folder, (vscode.workspace.workspaceFolders || []).length > 1);
  return shown === folder ? path.basename(folder) : shown;
}

/**
 * Returns the project around a file, or of the active editor, or else the one that somebody picks.
 *
 * @param {vscode.Uri} [of]
 * @returns {Promise<string | undefined>}
 */
async function pickProject(of) {
  const all = await projects();
  const active = vscode.window.activeTextEditor;
  const file = of || (active && active.document.uri);
  const around = file && all.filter((folder) => file.fsPath === folder || file.fsPath.startsWith(folder + path.sep));
  if (around && around.length > 0) {
    return around.sort((a, b) => b.length - a.length)[0];
  }
  if (all.length === 0) {
    vscode.window.showErrorMessage(`There is no project in this workspace: no folder with an ${SETTINGS}.`);
    return undefined;
  }
  if (all.length === 1) {
    return all[0];
  }
  const items = all.map((folder) => ({ label: nameOf(folder), folder }));
  const picked = await vscode.window.showQuickPick(items, { placeHolder: "Which project?" });
  return picked && picked.folder;
}

module.exports = { nameOf, pickProject, projects };
