"use strict";
// Keeps the server's copies of open documents the same as the editor's.

const vscode = require("vscode");
const { asRange } = require("./convert");
const { SELECTOR } = require("../files");

const FULL = 1;
const INCREMENTAL = 2;

class Documents {
  /**
   * @param {any} declared what the server says about synchronisation: a number, or options
   * @param {(method: string, params: any) => void} notify
   */
  constructor(declared, notify) {
    const options = typeof declared === "object" && declared ? declared : { openClose: true, change: declared || 0, save: true };
    this.options = options;
    this.notify = notify;
    /** @type {Set<string>} */
    this.open = new Set();
  }

  register() {
    vscode.workspace.textDocuments.forEach((document) => this.opened(document));
    return vscode.Disposable.from(
      vscode.workspace.onDidOpenTextDocument((document) => this.opened(document)),
      vscode.workspace.onDidChangeTextDocument((event) => this.changed(event)),
      vscode.workspace.onDidSaveTextDocument((document) => this.saved(document)),
      vscode.workspace.onDidCloseTextDocument((document) => this.closed(document)),
    );
  }

  /** @param {vscode.TextDocument} document */
  opened(document) {
    if (this.options.openClose && vscode.languages.match(SELECTOR, document)) {
      this.open.add(document.uri.toString());
      const { languageId, version } = document;
      this.notify("textDocument/didOpen", {
        textDocument: { uri: document.uri.toString(), languageId, version, text: document.getText() },
      });
    }
  }

  /** @param {vscode.TextDocumentChangeEvent} event */
  changed({ document, contentChanges }) {
    if (!this.isOpen(document) || contentChanges.length === 0) {
      return; // An event without changes says that the document is saved, or no longer.
    }
    const textDocument = { uri: document.uri.toString(), version: document.version };
    const parts = contentChanges.map(({ range, text }) => ({ range: asRange(range), text }));
    if (this.options.change === INCREMENTAL) {
      this.notify("textDocument/didChange", { textDocument, contentChanges: parts });
    } else if (this.options.change === FULL) {
      this.notify("textDocument/didChange", { textDocument, contentChanges: [{ text: document.getText() }] });
    }
  }

  /** @param {vscode.TextDocument} document */
  saved(document) {
    const { save } = this.options;
    if (save && this.isOpen(document)) {
      const text = save.includeText ? document.getText() : undefined;
      this.notify("textDocument/didSave", { textDocument: { uri: document.uri.toString() }, text });
    }
  }

  /** @param {vscode.TextDocument} document */
  closed(document) {
    if (this.open.delete(document.uri.toString())) {
      this.notify("textDocument/didClose", { textDocument: { uri: document.uri.toString() } });
    }
  }

  /** @param {vscode.TextDocument} document */
  isOpen(document) {
    return this.open.has(document.uri.toString());
  }
}

module.exports = { Documents };
