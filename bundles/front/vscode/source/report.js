"use strict";
// The report of a project's last run, in a panel.

const fs = require("fs");
const path = require("path");
const vscode = require("vscode");
const { report } = require("./picture");
const { nameOf } = require("./projects");

const REPORT = "out/report.html";

class ReportView {
  constructor() {
    /** @type {Map<string, vscode.WebviewPanel>} */
    this.panels = new Map();
  }

  /** @param {string} project */
  async show(project) {
    const html = await this.read(project);
    if (!html) {
      const run = "Run";
      const answer = await vscode.window.showInformationMessage(
        `${nameOf(project)} has no report: ${REPORT} is written by a run, and withdrawn when what it says may no longer hold.`,
        run,
      );
      if (answer === run) {
        await vscode.commands.executeCommand("eventchain.run", vscode.Uri.file(project));
      }
      return;
    }
    const shown = this.panels.get(project);
    if (shown) {
      shown.webview.html = html;
      shown.reveal();
      return;
    }
    const panel = vscode.window.createWebviewPanel("eventchain.report", `Report: ${nameOf(project)}`, vscode.ViewColumn.Active, {
      enableScripts: true,
      enableFindWidget: true,
      localResourceRoots: [],
    });
    this.panels.set(project, panel);
    const watcher = vscode.workspace.createFileSystemWatcher(new vscode.RelativePattern(vscode.Uri.file(project), REPORT));
    const update = async () => {
      // A report that is gone says nothing about the project as it is now.
      panel.webview.html = (await this.read(project)) || "<p>The report was withdrawn, since what it said may no longer hold.</p>";
    };
    watcher.onDidChange(update);
    watcher.onDidCreate(update);
    watcher.onDidDelete(update);
    panel.onDidDispose(() => {
      this.panels.delete(project);
      watcher.dispose();
    });
    panel.webview.html = html;
  }

  /** @param {string} project */
  async read(project) {
    const html = await fs.promises.readFile(path.join(project, REPORT), "utf8").catch(() => "");
    return html && report(html);
  }

  dispose() {
    [...this.panels.values()].forEach((panel) => panel.dispose());
  }
}

module.exports = { ReportView };
