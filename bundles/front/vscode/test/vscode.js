"use strict";
// As much of VS Code's interface as the client of the language server needs to run in a test.

const Module = require("node:module");

class Position {
  constructor(line, character) {
    Object.assign(this, { line, character });
  }
}

class Range {
  constructor(start, end, endLine, endCharacter) {
    const isNumbers = typeof start === "number";
    this.start = isNumbers ? new Position(start, end) : start;
    this.end = isNumbers ? new Position(endLine, endCharacter) : end;
  }
}

class Disposable {
  constructor(dispose) {
    this.dispose = dispose;
  }

  static from(...all) {
    return new Disposable(() => all.forEach((each) => each.dispose()));
  }
}

class EventEmitter {
  constructor() {
    this.listeners = new Set();
    this.event = (listener) => {
      this.listeners.add(listener);
      return new Disposable(() => this.listeners.delete(listener));
    };
  }

  fire(value) {
    this.listeners.forEach((listener) => listener(value));
  }

  dispose() {
    this.listeners.clear();
  }
}

class MarkdownString {
  constructor() {
    this.value = "";
  }

  appendMarkdown(text) {
    this.value += text;
  }
}

class Diagnostic {
  constructor(range, message, severity) {
    Object.assign(this, { range, message, severity });
  }
}

const uri = (text) => ({ scheme: text.split(":")[0], fsPath: text.replace("file://", ""), toString: () => text });
const events = ["Open", "Change", "Save", "Close"].map((kind) => [kind, new EventEmitter()]);
const providers = new Map();
const commands = new Map();
const shown = new Map();
const messages = [];
const log = [];
const nothing = () => new Disposable(() => undefined);

/** What tests look at and cause. */
const stage = { commands, documents: Object.fromEntries(events), log, messages, providers, shown };

const api = {
  Diagnostic,
  Disposable,
  EventEmitter,
  Hover: class {
    constructor(contents) {
      this.contents = contents;
    }
  },
  LanguageStatusSeverity: { Information: 0, Warning: 1, Error: 2 },
  MarkdownString,
  Position,
  Range,
  Uri: { parse: uri, file: (path) => uri(`file://${path}`) },
  commands: {
    registerCommand(name, action) {
      if (commands.has(name)) {
        throw new Error(`${name} exists`);
      }
      commands.set(name, action);
      return new Disposable(() => commands.delete(name));
    },
  },
  env: { appName: "Test", language: "en" },
  languages: new Proxy(
    {
      createDiagnosticCollection: () => ({
        set: (of, found) => shown.set(of.toString(), found),
        clear: () => shown.clear(),
        dispose: () => shown.clear(),
      }),
      createLanguageStatusItem: () => Object.assign(stage, { status: { dispose: () => undefined } }).status,
      match: (selector, document) => (document.languageId === "mtl" ? 10 : 0),
    },
    {
      get: (target, name) =>
        target[name] ||
        ((selector, provider) => {
          providers.set(name, provider);
          return new Disposable(() => providers.delete(name));
        }),
    },
  ),
  version: "1.85.0",
  window: {
    showErrorMessage: async (text) => void messages.push(text),
    showWarningMessage: async (text) => void messages.push(text),
    showInformationMessage: async (text) => void messages.push(text),
  },
  workspace: {
    textDocuments: [],
    workspaceFolders: undefined,
    createFileSystemWatcher: () => ({ onDidCreate: nothing, onDidChange: nothing, onDidDelete: nothing, dispose: () => undefined }),
    getConfiguration: () => ({ get: (name) => ({ metamodels: ["m.ecore"], timeLimit: 30 })[name] }),
    onDidChangeConfiguration: nothing,
    onDidChangeWorkspaceFolders: nothing,
    ...Object.fromEntries(events.map(([kind, emitter]) => [`onDid${kind}TextDocument`, emitter.event])),
  },
};

/** Lets `require("vscode")` find this interface. */
const original = Module._load;
Module._load = (request, ...rest) => (request === "vscode" ? api : original(request, ...rest));

module.exports = { api, stage };
