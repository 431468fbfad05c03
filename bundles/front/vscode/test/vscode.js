"use strict";
// As much of VS Code's interface as the client of the language server needs to run in a test.

const Module = require("node:module");

class Disposable {
  constructor(dispose) {
    this.dispose = dispose;
  }
}

class EventEmitter {
  constructor() {
    this.listeners = new Set();
    this.event = (listener, self) => {
      const bound = listener.bind(self);
      this.listeners.add(bound);
      return new Disposable(() => this.listeners.delete(bound));
    };
  }

  fire(value) {
    this.listeners.forEach((listener) => listener(value));
  }

  dispose() {
    this.listeners.clear();
  }
}

class Diagnostic {
  constructor(range, message, severity) {
    Object.assign(this, { range, message, severity });
  }
}

class CancellationTokenSource {
  constructor() {
    this.token = { isCancellationRequested: false, onCancellationRequested: nothing };
  }

  cancel() {
    this.token.isCancellationRequested = true;
  }
}

const nothing = () => new Disposable(() => undefined);
const uri = (text) => ({ scheme: text.split(":")[0], fsPath: text.replace("file://", ""), toString: () => text });
const events = ["Open", "Change", "Save", "Close"].map((kind) => [kind, new EventEmitter()]);
const commands = new Map();
const shown = new Map();
const messages = [];

/** What tests look at and cause. */
const stage = { commands, documents: Object.fromEntries(events), messages, shown };

/** A class for everything else, which the packages name when they are loaded. */
function anything() {
  return new Proxy(class {}, { get: (target, name) => (name in target ? target[name] : (target[name] = anything())) });
}

/** Returns an interface with what is given; what is missing is made. */
function withRest(given, make) {
  return new Proxy(given, { get: (target, name) => (name in target ? target[name] : (target[name] = make())) });
}

async function showMessage(text) {
  messages.push(text);
}

const SETTINGS = { metamodels: ["m.ecore"], timeLimit: 30 };

const api = withRest(
  {
    CancellationTokenSource,
    Diagnostic,
    Disposable,
    EventEmitter,
    LanguageStatusSeverity: { Information: 0, Warning: 1, Error: 2 },
    Uri: { parse: uri, file: (path) => uri(`file://${path}`) },
    commands: {
      registerCommand(name, action) {
        if (commands.has(name)) {
          throw new Error(`${name} exists`);
        }
        commands.set(name, action);
        return new Disposable(() => commands.delete(name));
      },
      executeCommand: (name, ...values) => commands.get(name)(...values),
    },
    env: { appName: "Test", language: "en" },
    languages: withRest(
      {
        createDiagnosticCollection: () => ({
          set: (of, found) => shown.set(of.toString(), found),
          clear: () => shown.clear(),
          dispose: () => shown.clear(),
        }),
        createLanguageStatusItem: () => Object.assign(stage, { status: { dispose: () => undefined } }).status,
        match: (selector, document) => (document.languageId === "mtl" ? 10 : 0),
      },
      () => nothing,
    ),
    version: "1.85.0",
    window: withRest(
      { showErrorMessage: showMessage, showWarningMessage: showMessage, showInformationMessage: showMessage },
      () => nothing,
    ),
    workspace: withRest(
      {
        notebookDocuments: [],
        textDocuments: [],
        workspaceFolders: undefined,
        getConfiguration: (section) => ({
          get: (name, otherwise) => (section ? SETTINGS[name] || otherwise : name === "eventchain" ? SETTINGS : otherwise),
        }),
        ...Object.fromEntries(events.map(([kind, emitter]) => [`onDid${kind}TextDocument`, emitter.event])),
      },
      () => nothing,
    ),
  },
  anything,
);

/** Lets `require("vscode")` find this interface. */
const original = Module._load;
Module._load = (request, ...rest) => (request === "vscode" ? api : original(request, ...rest));

module.exports = { api, stage };
