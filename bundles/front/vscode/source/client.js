"use strict";
// The language server's life: starts it, ends it, says what it does. The rest is the language client's.

const { spawn } = require("child_process");
const { once } = require("events");
const vscode = require("vscode");
const { CloseAction, ErrorAction, LanguageClient, RevealOutputChannelOn, State } = require("vscode-languageclient/node");
const { SELECTOR } = require("./files");

/** A server that has ended is started again so often, unless that takes longer than some minutes. */
const MOST_RESTARTS = 3;
const SHUTDOWN_MS = 3_000;

/** A language client whose failures are in the log only; people are told once, when the server is not started again. */
class QuietClient extends LanguageClient {
  /** @type {LanguageClient["error"]} */
  error(message, data) {
    super.error(message, data, false);
  }

  /** @type {LanguageClient["stop"]} */
  stop(timeout) {
    // One that is starting cannot be stopped; the end of its process ends it.
    return super.stop(timeout).catch((error) => this.error("The language server was not stopped", error));
  }
}

/**
 * @typedef {{process: import("child_process").ChildProcess, said: string[], end: Promise<number | null>}} Server
 * A process of the server, the last that it wrote as errors, and its exit code once it has ended.
 */

class Client {
  /**
   * @param {() => Promise<{command: string, args: string[], env: NodeJS.ProcessEnv} | undefined>} find what to start; undefined if something is missing, of which people know
   * @param {vscode.OutputChannel} log
   */
  constructor(find, log) {
    this.find = find;
    this.log = log;
    /** The last start that was asked for. */
    this.last = Promise.resolve();
    /** @type {LanguageClient | undefined} */
    this.client = undefined;
    /** @type {Server | undefined} */
    this.server = undefined;
    this.status = vscode.languages.createLanguageStatusItem("eventchain.server", [{ language: "mtl" }, { language: "ocl" }]);
    this.status.name = "Eventchain";
    this.status.command = { title: "Restart", command: "eventchain.restartServer" };
    this.say("stopped", vscode.LanguageStatusSeverity.Warning);
  }

  /**
   * @param {string} text
   * @param {vscode.LanguageStatusSeverity} severity
   */
  say(text, severity = vscode.LanguageStatusSeverity.Information) {
    this.status.text = `Eventchain: ${text}`;
    this.status.severity = severity;
  }

  get isRunning() {
    return this.client !== undefined && this.client.isRunning();
  }

  async start() {
    const program = await this.find();
    if (!program) {
      this.say("the language server could not be started", vscode.LanguageStatusSeverity.Error);
      return;
    }
    /** @type {QuietClient} */
    const client = new QuietClient("eventchain", "Eventchain", () => this.run(program), {
      documentSelector: SELECTOR,
      synchronize: { configurationSection: "eventchain" },
      diagnosticCollectionName: "eventchain",
      outputChannel: this.log,
      revealOutputChannelOn: RevealOutputChannelOn.Never,
      initializationOptions: settings,
      initializationFailedHandler: () => false,
      errorHandler: { error: (error, message) => this.failed(error, message), closed: () => this.closed(client) },
      middleware: { window: { showDocument } },
    });
    this.client = client;
    this.restarts = client.createDefaultErrorHandler(MOST_RESTARTS);
    client.onDidChangeState(({ newState }) => {
      if (newState !== State.Stopped && client === this.client) {
        this.say(newState === State.Running ? "running" : "starting");
      }
    });
    try {
      await client.start();
    } catch (error) {
      // The end of the process says why.
      this.log.appendLine(String(error));
      this.say("the language server could not be started", vscode.LanguageStatusSeverity.Error);
      if (this.server) {
        ended(this.server); // Not awaited: it may have refused to start, and be there still.
      }
    }
  }

  /**
   * Starts a process of the server.
   *
   * @param {{command: string, args: string[], env: NodeJS.ProcessEnv}} program
   */
  async run({ command, args, env }) {
    const [folder] = vscode.workspace.workspaceFolders || [];
    const process = spawn(command, args, { env, cwd: folder && folder.uri.scheme === "file" ? folder.uri.fsPath : undefined });
    /** @type {string[]} */
    const said = [];
    process.stderr.on("data", (chunk) => {
      said.push(String(chunk));
      said.splice(0, said.length - 20);
    });
    const end = new Promise((resolve) => process.once("close", resolve));
    this.server = { process, said, end };
    process.on("error", (error) => said.push(error.message));
    await once(process, "spawn");
    return process;
  }

  /**
   * Ends a server that wrote something else than messages, or takes none.
   *
   * @param {Error} error
   * @param {unknown} message that could not be written
   */
  failed(error, message) {
    if (this.server) {
      if (!message) {
        // Otherwise its exit code, or what it said itself, tells more.
        this.server.said.push(`\n${error.message.replaceAll("\n", " ")}`);
      }
      this.server.process.kill();
    }
    return { action: ErrorAction.Continue };
  }

  /**
   * Decides whether a server that has ended is started again.
   *
   * @param {LanguageClient} client
   * @returns {Promise<import("vscode-languageclient").CloseHandlerResult>}
   */
  async closed(client) {
    const { server, restarts } = this;
    if (client !== this.client || !server || !restarts) {
      return { action: CloseAction.DoNotRestart }; // It was stopped on purpose.
    }
    const answered = client.initializeResult !== undefined;
    const code = await ended(server);
    if (client.diagnostics) {
      client.diagnostics.clear(); // They may no longer hold.
    }
    if (code === 2 && !answered) {
      // A program of a setting may be older than the extension; tests, commands and panels need no server.
      this.log.appendLine("This Eventchain has no language server.");
      this.say("this program has no language server", vscode.LanguageStatusSeverity.Warning);
      return { action: CloseAction.DoNotRestart };
    }
    // What a machine lacks (exit code 3) is the same the next time.
    const result = code === 3 ? { action: CloseAction.DoNotRestart } : await restarts.closed();
    if (client === this.client && result.action === CloseAction.DoNotRestart) {
      this.say("the language server has ended", vscode.LanguageStatusSeverity.Error);
      this.tell(server.said.join("").trim().split("\n").pop() || `exit code ${code}`);
    }
    return client === this.client ? result : { action: CloseAction.DoNotRestart };
  }

  /** @param {string} reason why the server has ended */
  async tell(reason) {
    const message = `Eventchain's language server has ended: ${reason}`;
    const answer = await vscode.window.showErrorMessage(message, "Start It Again", "Show Log");
    if (answer === "Start It Again") {
      await this.restart();
    } else if (answer) {
      this.log.show();
    }
  }

  /**
   * Lets the server carry out a command, if it has this one.
   *
   * @param {string} command
   * @param {any[]} values
   * @returns {Promise<boolean>} whether it has
   */
  async execute(command, ...values) {
    const provider = this.isRunning && this.client && this.client.initializeResult?.capabilities.executeCommandProvider;
    const has = provider && provider.commands.includes(command);
    if (has) {
      await vscode.commands.executeCommand(command, ...values);
    }
    return Boolean(has);
  }

  /** Starts the server, once what was asked before is done, so that there is never more than one. */
  restart() {
    this.last = this.last.catch(() => undefined).then(async () => {
      await this.stop();
      await this.start();
    });
    return this.last;
  }

  async stop() {
    const { client, server } = this;
    this.client = undefined;
    this.server = undefined;
    if (client) {
      this.say("stopped", vscode.LanguageStatusSeverity.Warning);
      if (client.isRunning()) {
        await client.stop(SHUTDOWN_MS);
      } else if (server) {
        server.process.kill();
      }
    }
    if (server) {
      await ended(server);
    }
  }

  async dispose() {
    await this.stop();
    this.status.dispose();
  }
}

/**
 * Waits until a process has ended that should by itself; ends it if it does not.
 *
 * @param {Server} server
 */
async function ended({ process, end }) {
  const timer = setTimeout(() => process.kill(), SHUTDOWN_MS);
  const code = await end;
  clearTimeout(timer);
  return code;
}

/** What the server has to know of the settings when it starts. */
function settings() {
  const all = vscode.workspace.getConfiguration("eventchain");
  return { metamodels: all.get("metamodels"), timeLimit: all.get("timeLimit") };
}

/**
 * Shows pages, such as that of a rule, as they are to be read.
 *
 * @param {import("vscode-languageclient").ShowDocumentParams} params
 * @param {import("vscode-languageclient").ShowDocumentRequest.HandlerSignature} next
 * @returns {Promise<any>}
 */
async function showDocument(params, next) {
  const target = vscode.Uri.parse(params.uri);
  if (params.external || params.selection || target.scheme !== "file" || !target.path.endsWith(".md")) {
    return next(params, new vscode.CancellationTokenSource().token);
  }
  await vscode.commands.executeCommand("markdown.showPreview", target);
  return { success: true };
}

module.exports = { Client };
