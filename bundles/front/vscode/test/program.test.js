"use strict";
const assert = require("node:assert");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const test = require("node:test");
const { Missing, findJava, findProgram } = require("../source/program");

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "eventchain-test-"));
test.after(() => fs.rmSync(folder, { recursive: true }));

function program(name, text = "#!/bin/sh\n") {
  const file = path.join(folder, name);
  fs.mkdirSync(path.dirname(file), { recursive: true });
  fs.writeFileSync(file, text, { mode: 0o755 });
  return file;
}

const says = (text) => (error) => error instanceof Missing && error.message.includes(text);

test("the setting comes before JAVA_HOME, and that before the PATH", async () => {
  const [set, home, onPath] = ["set/bin/java", "home/bin/java", "path/java"].map((name) => program(name));
  const env = { JAVA_HOME: path.join(folder, "home"), PATH: path.join(folder, "path") };
  const seventeen = async () => 17;
  assert.strictEqual(await findJava(path.join(folder, "set"), env, seventeen), set);
  assert.strictEqual(await findJava("", env, seventeen), home);
  assert.strictEqual(await findJava("", { ...env, JAVA_HOME: "/nowhere" }, seventeen), onPath);
});

test("what is missing is said", async () => {
  const env = { PATH: path.join(folder, "path") };
  program("path/java");
  await assert.rejects(findJava("/nowhere", env), says("eventchain.java.home is /nowhere"));
  await assert.rejects(findJava("", { PATH: "" }), says("There is no Java here"));
  await assert.rejects(findJava("", env, async () => 11), says("is Java 11, which is too old"));
  await assert.rejects(findJava("", env), says("does not say which Java it is"));
});

test("a Java is asked for its version", async () => {
  program("eight/bin/java", "#!/bin/sh\necho '    java.specification.version = 1.8' >&2\n");
  program("new/bin/java", "#!/bin/sh\necho '    java.specification.version = 21' >&2\n");
  await assert.rejects(findJava(path.join(folder, "eight"), {}), says("is Java 8, which is too old"));
  assert.ok(await findJava(path.join(folder, "new"), {}));
});

test("the program is that of the setting, else the one inside the extension", async () => {
  program("path/java");
  program("path/bash");
  const inside = program("extension/program/bin/eventchain");
  const own = program("own/eventchain");
  const env = { PATH: path.join(folder, "path") };
  const settings = { program: "", javaHome: "", memory: "2g" };
  const bundled = path.join(folder, "extension/program");
  const seventeen = async () => 17;
  const found = await findProgram(settings, bundled, env, seventeen);
  assert.strictEqual(found.script, inside);
  assert.strictEqual(found.env.EVENTCHAIN_MEMORY, "2g");
  assert.strictEqual((await findProgram({ ...settings, program: own }, bundled, env, seventeen)).script, own);
  await assert.rejects(findProgram({ ...settings, program: "/nowhere/x" }, bundled, env, seventeen), says("/nowhere/x, which is not there"));
  await assert.rejects(findProgram(settings, "/nowhere", env, seventeen), says("does not hold the program"));
});
