"use strict";
// The picture of a project's event chain, as `eventchain diagram` draws it: a click goes to the element.

const { execFile } = require("child_process");
const crypto = require("crypto");
const fs = require("fs");
const os = require("os");
const path = require("path");
const vscode = require("vscode");
const { locate, page } = require("./picture");
const { nameOf } = require("./projects");

/** Where a chain is written, the file that people edit first. */
const MODELS = ["model/chain.xmi", "out/chain.json", "out/chain.xmi"];

class ChainView {
  /**
   * @param {import("./tasks").Program} find
   * @param {vscode.Uri} extension
   */
  constructor(find, extension) {
    this.find = find;
    this.media = vscode.Uri.joinPath(extension, "media");
    /** @type {Map<string, vscode.WebviewPanel>} */
    this.panels = new Map();
    /** @type {WeakMap<vscode.WebviewPanel, string>} */
    this.drawn = new WeakMap();
  }

  /** @param {string} project */
  async show(project) {
    const shown = this.panels.get(project);
    if (shown) {
      shown.reveal();
      await this.draw(project, shown);
      return;
    }
    const panel = vscode.window.createWebviewPanel(
      "eventchain.chain",
      `Event chain: ${nameOf(project)}`,
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, localResourceRoots: [this.media] },
    );
    this.panels.set(project, panel);
    const watchers = MODELS.map((name) =>
      vscode.workspace.createFileSystemWatcher(new vscode.RelativePattern(vscode.Uri.file(project), name)),
    );
    watchers.forEach((watcher) => {
      watcher.onDidChange(() => this.drawSoon(project, panel));
      watcher.onDidCreate(() => this.drawSoon(project, panel));
    });
    panel.onDidDispose(() => {
      this.panels.delete(project);
      watchers.forEach((watcher) => watcher.dispose());
    });
    panel.webview.onDidReceiveMessage((message) => this.open(project, String(message.name)));
    panel.webview.html = "<p>Drawing the event chain ...</p>";
    await this.draw(project, panel);
  }

  /**
   * Draws again once the files have come to rest: drawing may write some of them.
   *
   * @param {string} project
   * @param {vscode.WebviewPanel} panel
   */
  drawSoon(project, panel) {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.panels.get(project) === panel && this.draw(project, panel), 500);
  }

  /**
   * @param {string} project
   * @param {vscode.WebviewPanel} panel
   */
  async draw(project, panel) {
    const drawn = await this.picture(project);
    if (this.panels.get(project) !== panel || (drawn.svg && drawn.svg === this.drawn.get(panel))) {
      return; // It was closed meanwhile, or nothing has changed.
    }
    this.drawn.set(panel, drawn.svg);
    const uri = (/** @type {string} */ name) => panel.webview.asWebviewUri(vscode.Uri.joinPath(this.media, name)).toString();
    panel.webview.html = page(drawn, {
      nonce: crypto.randomBytes(16).toString("base64"),
      source: panel.webview.cspSource,
      style: uri("chain.css"),
      script: uri("chain.js"),
    });
  }

  /**
   * @param {string} project
   * @returns {Promise<{svg: string, problem: string}>}
   */
  async picture(project) {
    const program = await this.find();
    if (!program) {
      return { svg: "", problem: "Something is missing to draw it; see the message." };
    }
    const folder = await fs.promises.mkdtemp(path.join(os.tmpdir(), "eventchain-"));
    try {
      const words = [program.script, "diagram", ".", "--kind", "activity", "-o", folder];
      const said = await new Promise((resolve) => {
        execFile(program.command, words, { cwd: project, env: program.env }, (error, out, err) =>
          resolve(error ? (out + err).trim() || error.message : ""),
        );
      });
      const svg = await fs.promises.readFile(path.join(folder, "activity.svg"), "utf8").catch(() => "");
      return { svg, problem: svg ? "" : said || "The program drew nothing." };
    } finally {
      await fs.promises.rm(folder, { recursive: true, force: true });
    }
  }

  /**
   * Opens the element that a part of the picture shows.
   *
   * @param {string} project
   * @param {string} name of a component, or a topic
   */
  async open(project, name) {
    for (const model of MODELS) {
      const file = path.join(project, model);
      const text = await fs.promises.readFile(file, "utf8").catch(() => "");
      const found = locate(text, name);
      if (found) {
        const selection = new vscode.Range(found.line, found.start, found.line, found.end);
        await vscode.window.showTextDocument(vscode.Uri.file(file), { selection, viewColumn: vscode.ViewColumn.One });
        return;
      }
    }
    vscode.window.showInformationMessage(`No file of the project's chain names ${name}.`);
  }

  dispose() {
    clearTimeout(this.timer);
    [...this.panels.values()].forEach((panel) => panel.dispose());
  }
}

module.exports = { ChainView };
