"use strict";
// A small language server for tests of the client: `node server.js`, with what goes wrong in FAULT. It reports each
// "wrong" in a document, and writes what it receives to the file RECEIVED.

const fs = require("node:fs");
const { Wire } = require("../source/lsp/wire");

const { FAULT, RECEIVED } = process.env;
if (FAULT === "usage") {
  process.stderr.write("Unmatched argument: 'lsp'\n");
  process.exit(2);
}
if (FAULT === "lacks") {
  process.stderr.write("eventchain: There is no Java here.\n");
  process.exit(3);
}
const texts = new Map();

function record(method, params) {
  fs.appendFileSync(RECEIVED, `${JSON.stringify({ method, params })}\n`);
}

function places(uri) {
  return [...(texts.get(uri) || "").matchAll(/wrong/g)].map(({ index }) => {
    const before = texts.get(uri).slice(0, index).split("\n");
    const start = { line: before.length - 1, character: before[before.length - 1].length };
    return { start, end: { line: start.line, character: start.character + "wrong".length } };
  });
}

function check(uri) {
  const diagnostics = places(uri).map((range) => ({
    range,
    severity: 2,
    code: "test.wrong",
    codeDescription: { href: "file:///rules/test.wrong.md" },
    source: "eventchain",
    message: "This is wrong.",
  }));
  wire.notify("textDocument/publishDiagnostics", { uri, diagnostics });
}

const answers = {
  initialize: () => ({
    capabilities: {
      textDocumentSync: { openClose: true, change: 2, save: true },
      hoverProvider: true,
      completionProvider: { triggerCharacters: ["."] },
      definitionProvider: true,
      renameProvider: { prepareProvider: true },
      documentSymbolProvider: true,
      codeActionProvider: true,
      codeLensProvider: {},
      executeCommandProvider: { commands: ["eventchain.test.run"] },
    },
  }),
  shutdown: () => null,
  "textDocument/hover": () => ({ contents: { kind: "markdown", value: "A *word*." } }),
  "textDocument/completion": () => [{ label: "right", kind: 3, detail: "what is meant" }],
  "textDocument/definition": ({ textDocument: { uri } }) => ({ uri, range: places(uri)[0] }),
  "textDocument/prepareRename": ({ textDocument: { uri } }) => places(uri)[0],
  "textDocument/rename": ({ textDocument: { uri }, newName }) => ({
    changes: { [uri]: places(uri).map((range) => ({ range, newText: newName })) },
  }),
  "textDocument/documentSymbol": ({ textDocument: { uri } }) =>
    places(uri).map((range) => ({ name: "wrong", kind: 12, range, selectionRange: range })),
  "textDocument/codeAction": ({ textDocument: { uri }, context: { diagnostics } }) =>
    diagnostics.map((found) => ({
      title: "Replace by 'right'",
      kind: "quickfix",
      diagnostics: [found],
      edit: { changes: { [uri]: [{ range: found.range, newText: "right" }] } },
    })),
  "textDocument/codeLens": ({ textDocument: { uri } }) =>
    places(uri).map((range) => ({ range, command: { title: "Run", command: "eventchain.test.run", arguments: [1] } })),
  "workspace/executeCommand": ({ command }) => command,
};

const notified = {
  "textDocument/didOpen": ({ textDocument: { uri, text } }) => texts.set(uri, text) && check(uri),
  "textDocument/didChange": ({ textDocument: { uri }, contentChanges }) => {
    for (const { range, text } of contentChanges) {
      const lines = texts.get(uri).split("\n");
      const offset = ({ line, character }) => lines.slice(0, line).join("\n").length + (line > 0 ? 1 : 0) + character;
      const old = texts.get(uri);
      texts.set(uri, old.slice(0, offset(range.start)) + text + old.slice(offset(range.end)));
    }
    check(uri);
    if (FAULT === "crash") {
      process.exit(1);
    }
  },
  exit: () => process.exit(0),
};

const wire = new Wire(process.stdin, process.stdout, {
  request(method, params) {
    record(method, params);
    if (!answers[method]) {
      throw new Error(`no ${method}`);
    }
    return answers[method](params);
  },
  notification(method, params) {
    record(method, params);
    (notified[method] || (() => undefined))(params);
  },
  broken: (error) => process.stderr.write(`${error.message}\n`),
});
if (FAULT === "prints") {
  process.stdout.write("Hello!\r\n\r\n");
}
process.stdin.on("end", () => process.exit(0));
