"use strict";
const assert = require("node:assert");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const test = require("node:test");
const { api, stage } = require("./vscode");
const { Client } = require("../source/lsp/client");

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "eventchain-test-"));
const received = path.join(folder, "received");
test.after(() => fs.rmSync(folder, { recursive: true }));

const FILE = "file:///t.mtl";

/** A document whose text changes by edits, as the editor tells of them. */
function documentOf(text, languageId = "mtl") {
  const document = { uri: api.Uri.parse(FILE), languageId, version: 1, getText: () => text };
  const edit = (start, end, replacement) => {
    const at = (offset) => {
      const before = text.slice(0, offset).split("\n");
      return new api.Position(before.length - 1, before[before.length - 1].length);
    };
    const change = { range: new api.Range(at(start), at(end)), text: replacement };
    text = text.slice(0, start) + replacement + text.slice(end);
    document.version++;
    stage.documents.Change.fire({ document, contentChanges: [change] });
  };
  return { document, edit };
}

function client(fault) {
  stage.messages.length = 0;
  stage.log.length = 0;
  fs.writeFileSync(received, "");
  const log = { append: (text) => stage.log.push(text), appendLine: (text) => stage.log.push(text), show: () => undefined };
  const env = { ...process.env, FAULT: fault || "", RECEIVED: received };
  const start = { command: process.execPath, args: [path.join(__dirname, "server.js")], env };
  return new Client(async () => start, log, "1");
}

async function until(what, condition) {
  for (let i = 0; i < 1000; i++) {
    const found = condition();
    if (found) {
      return found;
    }
    await new Promise((resolve) => setTimeout(resolve, 10));
  }
  throw new Error(`never: ${what}; ${stage.messages} ${stage.log}`);
}

const heard = () => fs.readFileSync(received, "utf8").split("\n").filter(Boolean).map((line) => JSON.parse(line));
const found = () => stage.shown.get(FILE) || [];

test("findings follow the text, and are gone with the server", async () => {
  const { document, edit } = documentOf("one\nis wrong\n");
  api.workspace.textDocuments = [document, { ...document, uri: api.Uri.parse("file:///x.py"), languageId: "python" }];
  const server = client();
  await server.start();
  const [diagnostic] = await until("finding", () => found().length === 1 && found());
  assert.deepStrictEqual([diagnostic.range.start.line, diagnostic.range.start.character], [1, 3]);
  assert.deepStrictEqual([diagnostic.severity, diagnostic.message, diagnostic.code.value], [1, "This is wrong.", "test.wrong"]);
  edit(0, 3, "wrong\n");
  await until("second finding", () => found().length === 2);
  assert.strictEqual(found()[1].range.start.line, 2);
  edit(0, 5, "right");
  await until("one finding", () => found().length === 1);
  await server.dispose();
  assert.strictEqual(stage.shown.size, 0);
  assert.strictEqual(stage.providers.size, 0);
  assert.deepStrictEqual(stage.messages, []);
  const methods = heard().map(({ method }) => method);
  assert.deepStrictEqual(methods.slice(-2), ["shutdown", "exit"]);
  assert.strictEqual(methods.filter((method) => method === "textDocument/didOpen").length, 1);
  assert.deepStrictEqual(heard()[0].params.initializationOptions, { metamodels: ["m.ecore"], timeLimit: 30 });
});

test("what the server declares is asked of it, and nothing else", async () => {
  api.workspace.textDocuments = [documentOf("wrong").document];
  const server = client();
  await server.start();
  await until("finding", () => found().length === 1);
  const hover = stage.providers.get("registerHoverProvider");
  const { contents } = await hover.provideHover(api.workspace.textDocuments[0], new api.Position(0, 1));
  assert.match(contents.value, /A \*word\*\./);
  assert.strictEqual(stage.providers.has("registerInlayHintsProvider"), false);
  assert.strictEqual(await stage.commands.get("eventchain.test.run")(), "eventchain.test.run");
  const actions = stage.providers.get("registerCodeActionsProvider");
  const whole = new api.Range(0, 0, 0, 5);
  api.CodeActionKind = { Empty: { append: (value) => ({ value }) } };
  api.CodeAction = class {};
  api.WorkspaceEdit = class {
    set(uri, edits) {
      this.edits = edits;
    }
  };
  api.TextEdit = class {
    constructor(range, text) {
      Object.assign(this, { range, text });
    }
  };
  const [fix] = await actions.provideCodeActions(api.workspace.textDocuments[0], whole, { diagnostics: found() });
  assert.strictEqual(fix.edit.edits[0].text, "right");
  await server.dispose();
});

test("a server that has crashed is started again, but not forever", async () => {
  const { document, edit } = documentOf("wrong");
  api.workspace.textDocuments = [document];
  const server = client("crash");
  await server.start();
  for (let i = 1; i <= 4; i++) {
    await until(`start ${i}`, () => server.isRunning && found().length > 0);
    const before = server.process;
    edit(0, 0, "x");
    await until(`end ${i}`, () => server.process !== before);
  }
  await until("message", () => stage.messages.length === 1);
  assert.match(stage.messages[0], /Eventchain's language server has ended: exit code 1/);
  assert.strictEqual(stage.shown.size, 0);
  assert.strictEqual(heard().filter(({ method }) => method === "initialize").length, 4);
  await server.dispose();
});

test("a program without a language server is no fault", async () => {
  const server = client("usage");
  await server.start();
  await until("status", () => /no language server/.test(stage.status.text));
  assert.deepStrictEqual(stage.messages, []);
});

test("what the machine lacks is said once", async () => {
  const server = client("lacks");
  await server.start();
  await until("message", () => stage.messages.length === 1);
  assert.match(stage.messages[0], /has ended: eventchain: There is no Java here\./);
  assert.strictEqual(server.starts.length, 1);
});

test("a server that prints something else is ended, with what it printed", async () => {
  const server = client("prints");
  await server.start();
  await until("message", () => stage.messages.length === 1);
  assert.match(stage.messages[0], /wrote something else than messages: Hello!/);
});
