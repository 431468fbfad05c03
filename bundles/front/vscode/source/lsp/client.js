"use strict";
// The editor's side of the language server: starts it, tells it what happens, shows what it finds.

const { spawn } = require("child_process");
const vscode = require("vscode");
const convert = require("./convert");
const { Documents } = require("./documents");
const { CAPABILITIES, Features } = require("./features");
const { ResponseError, UnknownMethod, Wire } = require("./wire");
const { PATTERNS } = require("../files");

/** A server that ends so often within so many milliseconds is not started again. */
const MOST_STARTS = 4;
const WITHIN_MS = 180_000;
const SHUTDOWN_MS = 3_000;

class Client {
  /**
   * @param {() => Promise<{command: string, args: string[], env: NodeJS.ProcessEnv} | undefined>} find what to start; undefined if something is missing, of which people know
   * @param {vscode.OutputChannel} log
   * @param {string} version of the extension
   */
  constructor(find, log, version) {
    this.find = find;
    this.log = log;
    this.version = version;
    this.diagnostics = vscode.languages.createDiagnosticCollection("eventchain");
    /** The last start that was asked for. */
    this.last = Promise.resolve();
    /** @type {string[]} */
    this.executable = [];
    /** @type {number[]} */
    this.starts = [];
    /** @type {vscode.Disposable[]} */
    this.disposables = [];
    /** @type {Map<string, vscode.Disposable>} */
    this.watched = new Map();
    this.status = vscode.languages.createLanguageStatusItem("eventchain.server", [{ language: "mtl" }, { language: "ocl" }]);
    this.status.name = "Eventchain";
    this.say("stopped", vscode.LanguageStatusSeverity.Warning);
  }

  /**
   * @param {string} text
   * @param {vscode.LanguageStatusSeverity} severity
   */
  say(text, severity = vscode.LanguageStatusSeverity.Information) {
    this.status.text = `Eventchain: ${text}`;
    this.status.severity = severity;
    this.status.command = { title: "Restart", command: "eventchain.restartServer" };
  }

  get isRunning() {
    return Boolean(this.features);
  }

  async start() {
    const program = await this.find();
    if (!program) {
      this.say("the language server could not be started", vscode.LanguageStatusSeverity.Error);
      return;
    }
    this.starts.push(Date.now());
    this.say("starting");
    const folders = vscode.workspace.workspaceFolders || [];
    const process = spawn(program.command, program.args, {
      env: program.env,
      cwd: folders.length > 0 && folders[0].uri.scheme === "file" ? folders[0].uri.fsPath : undefined,
    });
    this.process = process;
    /** @type {string[]} */
    const said = [];
    process.stderr.on("data", (chunk) => {
      this.log.append(String(chunk));
      said.push(String(chunk));
      said.splice(0, said.length - 20);
    });
    process.on("error", (error) => said.push(error.message));
    process.on("close", (code) => this.ended(process, code, said.join("")));
    this.wire = new Wire(process.stdout, process.stdin, {
      request: (method, params) => this.serve(method, params),
      notification: (method, params) => this.notified(method, params),
      broken: (error) => {
        said.push(error.message);
        process.kill();
      },
    });
    try {
      await this.initialize(this.wire, folders);
    } catch (error) {
      // The end of the process says why.
      this.log.appendLine(String(error));
    }
  }

  /**
   * @param {Wire} wire
   * @param {readonly vscode.WorkspaceFolder[]} folders
   */
  async initialize(wire, folders) {
    const asFolder = (/** @type {vscode.WorkspaceFolder} */ folder) => ({ uri: folder.uri.toString(), name: folder.name });
    const result = await wire.request("initialize", {
      processId: process.pid,
      clientInfo: { name: `${vscode.env.appName} with Eventchain ${this.version}`, version: vscode.version },
      locale: vscode.env.language,
      rootUri: folders.length > 0 ? folders[0].uri.toString() : null,
      workspaceFolders: folders.map(asFolder),
      initializationOptions: this.settings(),
      capabilities: {
        general: { positionEncodings: ["utf-16"] },
        textDocument: {
          ...CAPABILITIES,
          synchronization: { didSave: true },
          publishDiagnostics: { relatedInformation: true, codeDescriptionSupport: true, tagSupport: { valueSet: [1, 2] }, versionSupport: true, dataSupport: true },
        },
        window: { workDoneProgress: true, showMessage: { messageActionItem: {} }, showDocument: { support: true } },
        workspace: {
          applyEdit: true,
          configuration: true,
          workspaceFolders: true,
          symbol: {},
          executeCommand: {},
          didChangeWatchedFiles: { dynamicRegistration: true, relativePatternSupport: true },
          workspaceEdit: { documentChanges: true, resourceOperations: ["create", "rename", "delete"] },
          codeLens: { refreshSupport: true },
          inlayHint: { refreshSupport: true },
          semanticTokens: { refreshSupport: true },
        },
      },
    });
    wire.notify("initialized", {});
    const { capabilities } = result;
    const documents = new Documents(capabilities.textDocumentSync, (method, params) => wire.notify(method, params));
    this.features = new Features(capabilities, (method, params, token) => this.ask(method, params, token));
    this.disposables.push(
      this.features.register(),
      documents.register(),
      vscode.workspace.onDidChangeConfiguration(
        (event) =>
          event.affectsConfiguration("eventchain") &&
          wire.notify("workspace/didChangeConfiguration", { settings: { eventchain: this.settings() } }),
      ),
      vscode.workspace.onDidChangeWorkspaceFolders(({ added, removed }) =>
        wire.notify("workspace/didChangeWorkspaceFolders", {
          event: { added: added.map(asFolder), removed: removed.map(asFolder) },
        }),
      ),
      ...this.commands(capabilities.executeCommandProvider),
    );
    this.watch("", PATTERNS.map((globPattern) => ({ globPattern })));
    this.say("running");
  }

  /** What the server has to know of the settings. */
  settings() {
    const settings = vscode.workspace.getConfiguration("eventchain");
    return { metamodels: settings.get("metamodels"), timeLimit: settings.get("timeLimit") };
  }

  /**
   * Lets the server carry out a command, if it has this one.
   *
   * @param {string} command
   * @param {any[]} values
   * @returns {Promise<boolean>} whether it has
   */
  async execute(command, ...values) {
    const has = this.isRunning && this.executable.includes(command);
    if (has) {
      await this.ask("workspace/executeCommand", { command, arguments: values });
    }
    return Boolean(has);
  }

  /**
   * Commands that the server carries out, unless the extension has one of this name.
   *
   * @param {{commands: string[]} | undefined} provider
   */
  commands(provider) {
    const registered = [];
    this.executable = (provider && provider.commands) || [];
    for (const command of this.executable) {
      try {
        registered.push(
          vscode.commands.registerCommand(command, (...values) =>
            this.ask("workspace/executeCommand", { command, arguments: values }),
          ),
        );
      } catch (error) {
        this.log.appendLine(`The command ${command} begins with the extension's own.`);
      }
    }
    return registered;
  }

  /**
   * Asks the server; what went wrong is in the log, and counts as no answer.
   *
   * @param {string} method
   * @param {any} params
   * @param {vscode.CancellationToken} [token]
   */
  async ask(method, params, token) {
    try {
      const result = this.wire && (await this.wire.request(method, params, token));
      return result === undefined ? null : result;
    } catch (error) {
      const refused = error instanceof ResponseError && !error.isCancelled;
      if (refused && (method === "textDocument/rename" || method === "textDocument/prepareRename")) {
        throw error; // The editor shows why.
      }
      if (refused) {
        this.log.appendLine(`${method}: ${error.message}`);
      }
      return null;
    }
  }

  /**
   * @param {string} method
   * @param {any} params
   */
  notified(method, params) {
    if (method === "textDocument/publishDiagnostics") {
      const shown = params.diagnostics.map((/** @type {any} */ found) =>
        Object.assign(convert.diagnostic(found), { item: found }),
      );
      this.diagnostics.set(convert.uri(params.uri), shown);
    } else if (method === "window/logMessage") {
      this.log.appendLine(params.message);
    } else if (method === "window/showMessage") {
      this.showMessage(params);
    } else if (method === "$/progress") {
      this.progress(params);
    }
  }

  /** @param {{token: string | number, value: any}} params */
  progress({ token, value }) {
    this.works = this.works || new Map();
    if (value.kind === "end") {
      this.works.delete(token);
    } else {
      this.works.set(token, [value.title, value.message].filter(Boolean).join(": "));
    }
    const [work] = this.works.values();
    this.say(work || "running");
    this.status.busy = Boolean(work);
  }

  /** @param {{type: number, message: string, actions?: {title: string}[]}} params */
  async showMessage({ type, message, actions = [] }) {
    const show = [vscode.window.showErrorMessage, vscode.window.showWarningMessage][type - 1] || vscode.window.showInformationMessage;
    const title = await show(message, ...actions.map((action) => action.title));
    return title ? { title } : null;
  }

  /**
   * @param {string} method
   * @param {any} params
   */
  async serve(method, params) {
    switch (method) {
      case "workspace/configuration":
        return params.items.map((/** @type {any} */ item) => {
          const value = vscode.workspace.getConfiguration().get(item.section || "eventchain");
          return value === undefined ? null : value;
        });
      case "workspace/applyEdit":
        return { applied: await vscode.workspace.applyEdit(convert.workspaceEdit(params.edit)) };
      case "workspace/workspaceFolders":
        return (vscode.workspace.workspaceFolders || []).map(({ uri, name }) => ({ uri: uri.toString(), name }));
      case "window/showMessageRequest":
        return this.showMessage(params);
      case "window/showDocument":
        return { success: await this.showDocument(params) };
      case "window/workDoneProgress/create":
        return null;
      case "client/registerCapability":
        return params.registrations.forEach((/** @type {any} */ each) => this.registered(each));
      case "client/unregisterCapability":
        return params.unregisterations.forEach((/** @type {{id: string}} */ { id }) => this.unwatch(id));
      case "workspace/codeLens/refresh":
        return this.features && this.features.lensesChanged.fire(undefined);
      case "workspace/inlayHint/refresh":
        return this.features && this.features.hintsChanged.fire(undefined);
      case "workspace/semanticTokens/refresh":
        return this.features && this.features.tokensChanged.fire(undefined);
      default:
        throw new UnknownMethod(method);
    }
  }

  /** @param {{uri: string, external?: boolean, selection?: any}} params */
  async showDocument({ uri, external, selection }) {
    const target = vscode.Uri.parse(uri);
    if (external || target.scheme !== "file") {
      return vscode.env.openExternal(target);
    }
    if (target.path.endsWith(".md") && !selection) {
      await vscode.commands.executeCommand("markdown.showPreview", target); // such as the page of a rule
    } else {
      await vscode.window.showTextDocument(target, { selection: selection && convert.range(selection) });
    }
    return true;
  }

  /** @param {{id: string, method: string, registerOptions?: any}} registration */
  registered({ id, method, registerOptions }) {
    if (method === "workspace/didChangeWatchedFiles") {
      this.unwatch(""); // The server knows better than the extension what it reads.
      this.watch(id, registerOptions.watchers);
    } else {
      this.log.appendLine(`The server registers ${method}, which this client declares statically only.`);
    }
  }

  /**
   * @param {string} id
   * @param {{globPattern: any, kind?: number}[]} watchers
   */
  watch(id, watchers) {
    const wire = this.wire;
    const all = watchers.flatMap(({ globPattern, kind = 7 }) => {
      const pattern =
        typeof globPattern === "string"
          ? globPattern
          : new vscode.RelativePattern(convert.uri(globPattern.baseUri.uri || globPattern.baseUri), globPattern.pattern);
      const watcher = vscode.workspace.createFileSystemWatcher(pattern, !(kind & 1), !(kind & 2), !(kind & 4));
      const tell = (/** @type {number} */ type) => (/** @type {vscode.Uri} */ uri) =>
        wire && wire.notify("workspace/didChangeWatchedFiles", { changes: [{ uri: uri.toString(), type }] });
      return [watcher, watcher.onDidCreate(tell(1)), watcher.onDidChange(tell(2)), watcher.onDidDelete(tell(3))];
    });
    this.watched.set(id, vscode.Disposable.from(...all));
  }

  /** @param {string} id */
  unwatch(id) {
    const watched = this.watched.get(id);
    this.watched.delete(id);
    if (watched) {
      watched.dispose();
    }
  }

  /**
   * @param {import("child_process").ChildProcess} process
   * @param {number | null} code
   * @param {string} said
   */
  async ended(process, code, said) {
    if (process !== this.process) {
      return; // It was stopped on purpose.
    }
    const answered = this.isRunning;
    this.clear();
    if (code === 2 && !answered) {
      // A program of a setting may be older than the extension; tests, commands and panels need no server.
      this.log.appendLine("This Eventchain has no language server.");
      this.say("this program has no language server", vscode.LanguageStatusSeverity.Warning);
      return;
    }
    const recent = this.starts.filter((time) => time > Date.now() - WITHIN_MS);
    // What a machine lacks (exit code 3) is the same the next time.
    if (code !== 3 && recent.length < MOST_STARTS) {
      this.log.appendLine(`The language server has ended (${code}); it is started again.`);
      await this.start();
      return;
    }
    this.say("the language server has ended", vscode.LanguageStatusSeverity.Error);
    const reason = said.trim().split("\n").pop() || `exit code ${code}`;
    const answer = await vscode.window.showErrorMessage(
      `Eventchain's language server has ended: ${reason}`,
      "Start It Again",
      "Show Log",
    );
    if (answer === "Start It Again") {
      await this.restart();
    } else if (answer) {
      this.log.show();
    }
  }

  /** Forgets everything that came from a server that is gone: its findings may no longer hold. */
  clear() {
    this.process = undefined;
    this.features = undefined;
    this.works = undefined;
    this.status.busy = false;
    this.disposables.splice(0).forEach((each) => each.dispose());
    [...this.watched.keys()].forEach((id) => this.unwatch(id));
    this.diagnostics.clear();
  }

  /** Starts the server, once what was asked before is done, so that there is never more than one. */
  restart() {
    this.last = this.last.catch(() => undefined).then(async () => {
      await this.stop();
      this.starts = [];
      await this.start();
    });
    return this.last;
  }

  async stop() {
    const { process, wire } = this;
    if (!process || !wire) {
      return;
    }
    this.clear();
    this.say("stopped", vscode.LanguageStatusSeverity.Warning);
    const timer = setTimeout(() => process.kill(), SHUTDOWN_MS);
    const closed = new Promise((resolve) => process.once("close", resolve));
    wire.request("shutdown", undefined).then(
      () => wire.notify("exit"),
      () => process.kill(),
    );
    await closed;
    clearTimeout(timer);
  }

  async dispose() {
    await this.stop();
    this.diagnostics.dispose();
    this.status.dispose();
  }
}

module.exports = { Client };
