"use strict";
const assert = require("node:assert");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const test = require("node:test");
const { api, stage } = require("./vscode");
const { Client } = require("../source/client");

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "eventchain-test-"));
const received = path.join(folder, "received");
test.after(() => fs.rmSync(folder, { recursive: true }));

const FILE = "file:///t.mtl";

const documentOf = (text, uri = FILE, languageId = "mtl") => ({ uri: api.Uri.parse(uri), languageId, version: 1, getText: () => text });

let log = [];

// One that a failed test leaves behind would keep this process from ending.
const started = [];
test.afterEach(() => Promise.all(started.splice(0).map((each) => each.dispose())));

function client(fault) {
  stage.messages.length = 0;
  log = [];
  fs.writeFileSync(received, "");
  const channel = { append: (text) => log.push(text), appendLine: (text) => log.push(text), show: () => undefined };
  const env = { ...process.env, FAULT: fault || "", RECEIVED: received };
  const start = { command: process.execPath, args: [path.join(__dirname, "server.js")], env };
  const made = new Client(async () => start, channel);
  started.push(made);
  return made;
}

async function until(what, condition) {
  for (let i = 0; i < 1000; i++) {
    const found = condition();
    if (found) {
      return found;
    }
    await new Promise((resolve) => setTimeout(resolve, 10));
  }
  throw new Error(`never: ${what}; ${stage.messages} ${log.join("\n")}`);
}

// The last line may still be being written.
const heard = () => fs.readFileSync(received, "utf8").split("\n").slice(0, -1).map((line) => JSON.parse(line));
const heardOf = (method) => heard().filter((each) => each.method === method);
const found = () => stage.shown.get(FILE) || [];

test("findings of what is open are shown, and are gone with the server", async () => {
  api.workspace.textDocuments = [documentOf("one\nis wrong\n"), documentOf("wrong", "file:///x.py", "python")];
  const server = client();
  await server.start();
  const [diagnostic] = await until("finding", () => found().length === 1 && found());
  assert.deepStrictEqual([diagnostic.message, diagnostic.code], ["This is wrong.", "test.wrong"]);
  assert.match(stage.status.text, /running/);
  assert.strictEqual(await server.execute("eventchain.test.run"), true);
  assert.strictEqual(await server.execute("eventchain.explain", "a.b"), false);
  await server.dispose();
  assert.strictEqual(stage.shown.size, 0);
  assert.strictEqual(stage.commands.size, 0);
  assert.deepStrictEqual(stage.messages, []);
  assert.deepStrictEqual(heard().slice(-2).map(({ method }) => method), ["shutdown", "exit"]);
  assert.strictEqual(heardOf("textDocument/didOpen").length, 1);
});

test("the server learns the settings when it starts, and again when it is started again", async () => {
  api.workspace.textDocuments = [];
  const server = client();
  await server.restart();
  await server.restart();
  await until("settings", () => heardOf("workspace/didChangeConfiguration").length === 2);
  const settings = { metamodels: ["m.ecore"], timeLimit: 30 };
  assert.deepStrictEqual(heardOf("initialize").map(({ params }) => params.initializationOptions), [settings, settings]);
  assert.deepStrictEqual(heardOf("workspace/didChangeConfiguration")[1].params.settings, { eventchain: settings });
  await server.dispose();
  assert.strictEqual(heardOf("exit").length, 2);
});

test("a server that has crashed is started again, but not forever", async () => {
  api.workspace.textDocuments = [documentOf("wrong")];
  const server = client("crash");
  await server.start();
  let crash;
  for (let i = 1; i <= 4; i++) {
    await until(`start ${i}`, () => heardOf("initialize").length === i && server.isRunning && found().length > 0);
    // Until the server is there again, the command is that of the one before.
    crash = await until(`command ${i}`, () => stage.commands.get("eventchain.test.run") !== crash && stage.commands.get("eventchain.test.run"));
    crash().catch(() => undefined);
    await until(`end ${i}`, () => !server.isRunning && stage.shown.size === 0);
  }
  await until("message", () => stage.messages.length === 1);
  assert.match(stage.messages[0], /Eventchain's language server has ended: exit code 1/);
  assert.match(stage.status.text, /has ended/);
  assert.strictEqual(heardOf("initialize").length, 4);
  await server.dispose();
});

test("a program without a language server is no fault", async () => {
  const server = client("usage");
  await server.start();
  await until("status", () => /no language server/.test(stage.status.text));
  assert.deepStrictEqual(stage.messages, []);
});

test("what the machine lacks is said once, and may be there the next time", async () => {
  const server = client("lacks");
  await server.start();
  await until("message", () => stage.messages.length === 1);
  assert.match(stage.messages[0], /has ended: eventchain: There is no Java here\./);
  await server.restart();
  await until("second message", () => stage.messages.length === 2);
});

test("a server that prints something else is ended, with what it printed", async () => {
  const server = client("prints");
  await server.start();
  await until("message", () => stage.messages.length === 1);
  assert.match(stage.messages[0], /has ended: Message header .* Hello!/);
});

test("a server that refuses to start is ended", async () => {
  const server = client("refuses");
  await server.start();
  const { end } = server.server;
  await server.dispose();
  await end;
  assert.match(log.join("\n"), /Not today/);
  assert.deepStrictEqual(stage.messages, []);
});
