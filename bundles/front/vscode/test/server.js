"use strict";
// A small language server for tests of the client: `node server.js`, with what goes wrong in FAULT. It reports each
// "wrong" in a document, and writes what it receives to the file RECEIVED.

const fs = require("node:fs");
const { StreamMessageReader, StreamMessageWriter, createMessageConnection } = require("vscode-jsonrpc/node");

const { FAULT, RECEIVED } = process.env;
if (FAULT === "usage") {
  process.stderr.write("Unmatched argument: 'lsp'\n");
  process.exit(2);
}
if (FAULT === "lacks") {
  process.stderr.write("eventchain: There is no Java here.\n");
  process.exit(3);
}
if (FAULT === "prints") {
  process.stdout.write("Hello!\r\n\r\n");
}
const connection = createMessageConnection(new StreamMessageReader(process.stdin), new StreamMessageWriter(process.stdout));

function record(method, params) {
  fs.appendFileSync(RECEIVED, `${JSON.stringify({ method, params })}\n`);
}

function check(uri, text) {
  const diagnostics = [...text.matchAll(/wrong/g)].map(({ index }) => {
    const before = text.slice(0, index).split("\n");
    const start = { line: before.length - 1, character: before[before.length - 1].length };
    const range = { start, end: { line: start.line, character: start.character + "wrong".length } };
    return { range, severity: 2, code: "test.wrong", source: "eventchain", message: "This is wrong." };
  });
  connection.sendNotification("textDocument/publishDiagnostics", { uri, diagnostics });
}

const answers = {
  initialize: () => {
    if (FAULT === "refuses") {
      throw new Error("Not today.");
    }
    return { capabilities: { textDocumentSync: 1, executeCommandProvider: { commands: ["eventchain.test.run"] } } };
  },
  shutdown: () => null,
  "workspace/executeCommand": () => {
    if (FAULT === "crash") {
      process.exit(1);
    }
    return null;
  },
};
const notified = {
  "textDocument/didOpen": ({ textDocument: { uri, text } }) => check(uri, text),
  "textDocument/didChange": ({ textDocument: { uri }, contentChanges: [{ text }] }) => check(uri, text),
  exit: () => process.exit(0),
};

connection.onRequest((method, params) => {
  record(method, params);
  return answers[method](params);
});
connection.onNotification((method, params) => {
  record(method, params);
  (notified[method] || (() => undefined))(params);
});
connection.listen();
