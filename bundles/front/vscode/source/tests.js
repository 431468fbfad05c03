"use strict";
// Scenarios and tests of components in VS Code's test explorer; the program runs and judges them.

const { execFile } = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");
const vscode = require("vscode");
const { nameOf, projects } = require("./projects");
const { componentTests, findings, reason, scenario, together, verdicts } = require("./results");

const FILES = "**/{scenarios,tests}/**/*.{yaml,yml}";
const SCENARIOS = "scenarios";
const COMPONENTS = "tests";

/** Scenarios may be in folders of their own, tests of components may not. */
const WHERE = { [SCENARIOS]: "scenarios/**/*.{yaml,yml}", [COMPONENTS]: "tests/*.yaml" };
const MOST_OUTPUT = 64 * 1024 * 1024;

class Tests {
  /** @param {import("./tasks").Program} find */
  constructor(find) {
    this.find = find;
    this.controller = vscode.tests.createTestController("eventchain", "Eventchain");
    this.controller.refreshHandler = () => this.discover();
    this.controller.createRunProfile("Run", vscode.TestRunProfileKind.Run, (request, token) => this.run(request, token), true);
    const watcher = vscode.workspace.createFileSystemWatcher(FILES);
    const settings = vscode.workspace.createFileSystemWatcher("**/eventchain.yaml", false, true);
    const again = () => this.discoverSoon();
    this.disposables = [
      this.controller,
      watcher,
      settings,
      ...[watcher.onDidCreate, watcher.onDidChange, watcher.onDidDelete, settings.onDidCreate, settings.onDidDelete].map((event) =>
        event(again),
      ),
    ];
    this.discovered = this.discover();
  }

  discoverSoon() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.discover(), 300);
  }

  async discover() {
    const all = await projects();
    const items = await Promise.all(all.map((folder) => this.project(folder)));
    this.controller.items.replace(items.filter((item) => item.children.size > 0));
  }

  /** @param {string} folder */
  async project(folder) {
    const item = this.controller.createTestItem(folder, nameOf(folder), vscode.Uri.file(folder));
    const scenarios = await this.files(folder, SCENARIOS, (file, text) => this.scenario(file, text));
    const components = await this.files(folder, COMPONENTS, (file, text) => this.component(file, text));
    for (const [name, label, children] of /** @type {[string, string, vscode.TestItem[]][]} */ ([
      [SCENARIOS, "Scenarios", scenarios],
      [COMPONENTS, "Components", components],
    ])) {
      if (children.length > 0) {
        const group = this.controller.createTestItem(path.join(folder, name), label, vscode.Uri.file(path.join(folder, name)));
        group.children.replace(children);
        item.children.add(group);
      }
    }
    return item;
  }

  /**
   * @param {string} folder
   * @param {"scenarios" | "tests"} kind
   * @param {(file: vscode.Uri, text: string) => vscode.TestItem | undefined} read
   */
  async files(folder, kind, read) {
    const pattern = new vscode.RelativePattern(vscode.Uri.file(folder), WHERE[kind]);
    const files = await vscode.workspace.findFiles(pattern);
    const items = [];
    for (const file of files.sort((a, b) => (a.path < b.path ? -1 : 1))) {
      try {
        items.push(read(file, await fs.promises.readFile(file.fsPath, "utf8")));
      } catch {
        // It has been deleted meanwhile.
      }
    }
    return /** @type {vscode.TestItem[]} */ (items.filter(Boolean));
  }

  /**
   * @param {vscode.Uri} file
   * @param {string} text
   */
  scenario(file, text) {
    const found = scenario(text);
    if (!found) {
      return undefined; // The language server says so.
    }
    const item = this.controller.createTestItem(file.fsPath, found.name, file);
    item.range = new vscode.Range(found.line, 0, found.line, 0);
    return item;
  }

  /**
   * @param {vscode.Uri} file
   * @param {string} text
   */
  component(file, text) {
    const found = componentTests(text);
    const item = this.controller.createTestItem(file.fsPath, path.basename(file.path, path.extname(file.path)), file);
    for (const { name, line } of found) {
      const test = this.controller.createTestItem(`${file.fsPath}:${line}`, name, file);
      test.range = new vscode.Range(line, 0, line, 0);
      item.children.add(test);
    }
    return found.length > 0 ? item : undefined;
  }

  /**
   * @param {vscode.TestRunRequest} request
   * @param {vscode.CancellationToken} token
   */
  async run(request, token) {
    await vscode.workspace.saveAll(false);
    const excluded = new Set(request.exclude || []);
    /** @type {Map<string, {project: vscode.TestItem, tests: vscode.TestItem[]}>} */
    const chosen = new Map();
    const choose = (/** @type {vscode.TestItem} */ item) => {
      if (excluded.has(item)) {
        return;
      }
      if (item.children.size > 0) {
        item.children.forEach(choose);
        return;
      }
      const project = projectOf(item);
      const entry = chosen.get(project.id) || { project, tests: [] };
      entry.tests.push(item);
      chosen.set(project.id, entry);
    };
    (request.include || [...this.controller.items].map(([, item]) => item)).forEach(choose);
    const run = this.controller.createTestRun(request);
    for (const { project, tests } of chosen.values()) {
      tests.forEach((test) => run.enqueued(test));
      if (!token.isCancellationRequested) {
        await this.runProject(project, tests, run, token);
      }
    }
    run.end();
  }

  /**
   * @param {vscode.TestItem} project
   * @param {vscode.TestItem[]} tests
   * @param {vscode.TestRun} run
   * @param {vscode.CancellationToken} token
   */
  async runProject(project, tests, run, token) {
    const program = await this.find();
    if (!program) {
      tests.forEach((test) => run.errored(test, new vscode.TestMessage("Something is missing to run it; see the message.")));
      return;
    }
    const reports = await fs.promises.mkdtemp(path.join(os.tmpdir(), "eventchain-"));
    try {
      tests.forEach((test) => run.started(test));
      const words = [program.script, ...this.words(project, tests, reports)];
      run.appendOutput(`$ eventchain ${words.slice(1).join(" ")}\r\n`);
      const printed = await execute(program, words, project.id, run, token);
      if (token.isCancellationRequested) {
        tests.forEach((test) => run.skipped(test));
      } else {
        await this.judge(tests, reports, printed, run);
      }
    } finally {
      await fs.promises.rm(reports, { recursive: true, force: true });
    }
  }

  /**
   * Returns the command: all scenarios give a verdict, some give none, and without scenarios nothing is simulated.
   *
   * @param {vscode.TestItem} project
   * @param {vscode.TestItem[]} tests
   * @param {string} reports
   */
  words(project, tests, reports) {
    const all = project.children.get(path.join(project.id, SCENARIOS));
    const scenarios = tests.filter((test) => test.parent === all).map((test) => test.label);
    const some = all && scenarios.length < all.children.size;
    return [
      "run",
      ".",
      ...(scenarios.length === 0 ? ["--to", "implement"] : ["--no-strength"]),
      ...(some ? scenarios.flatMap((name) => ["--scenario", name]) : []),
      ...["--report", `junit=${path.join(reports, "junit.xml")}`],
      ...["--report", `json=${path.join(reports, "findings.json")}`],
    ];
  }

  /**
   * @param {vscode.TestItem[]} tests
   * @param {string} reports
   * @param {string} printed
   * @param {vscode.TestRun} run
   */
  async judge(tests, reports, printed, run) {
    const read = (/** @type {string} */ name) => fs.promises.readFile(path.join(reports, name), "utf8").catch(() => "");
    const json = await read("findings.json");
    const found = json ? findings(json) : [];
    const judged = verdicts(await read("junit.xml"));
    for (const test of tests) {
      const line = /** @type {vscode.Range} */ (test.range).start.line + 1;
      const verdict = together(
        judged.filter(
          (each) =>
            isAbout(each, test) &&
            (isScenario(test) ? each.suite === "scenarios" : each.suite === "component tests" && each.line === line),
        ),
      );
      if (verdict && verdict.outcome === "passed") {
        run.passed(test);
      } else if (verdict && verdict.outcome === "failed") {
        run.failed(test, messages(test, verdict, found));
      } else {
        run.errored(test, message(test, (verdict && verdict.text) || reason(found, printed)));
      }
    }
  }

  dispose() {
    clearTimeout(this.timer);
    this.disposables.forEach((each) => each.dispose());
  }
}

/** @param {vscode.TestItem} test */
function projectOf(test) {
  let project = test;
  while (project.parent) {
    project = project.parent;
  }
  return project;
}

/** @param {vscode.TestItem} test */
function isScenario(test) {
  return Boolean(test.parent) && /** @type {vscode.TestItem} */ (test.parent).id === path.join(projectOf(test).id, SCENARIOS);
}

/**
 * Whether a part of a report is about the file of a test; files in it are relative to the project.
 *
 * @param {{file?: string}} reported
 * @param {vscode.TestItem} test
 */
function isAbout({ file }, test) {
  const { fsPath } = /** @type {vscode.Uri} */ (test.uri);
  return Boolean(file) && path.resolve(projectOf(test).id, /** @type {string} */ (file)) === fsPath;
}

/**
 * @param {vscode.TestItem} test
 * @param {string} text
 * @param {number} [line]
 */
function message(test, text, line) {
  const shown = new vscode.TestMessage(text);
  const at = line === undefined ? /** @type {vscode.Range} */ (test.range).start : new vscode.Position(line - 1, 0);
  shown.location = new vscode.Location(/** @type {vscode.Uri} */ (test.uri), at);
  return shown;
}

/**
 * Returns a message for each finding about a test, at its place; else what the verdict says.
 *
 * @param {vscode.TestItem} test
 * @param {import("./results").Verdict} verdict
 * @param {import("./results").Finding[]} found
 */
function messages(test, verdict, found) {
  const about = found.filter(
    (each) => each.severity === "error" && isAbout(each, test) && (isScenario(test) || each.line === verdict.line),
  );
  return about.length > 0
    ? about.map((each) => message(test, each.message, each.line))
    : [message(test, verdict.text || "failed")];
}

/**
 * Runs the program in a project; returns what it printed.
 *
 * @param {{command: string, env: NodeJS.ProcessEnv}} program
 * @param {string[]} words
 * @param {string} cwd
 * @param {vscode.TestRun} run
 * @param {vscode.CancellationToken} token
 * @returns {Promise<string>}
 */
function execute(program, words, cwd, run, token) {
  return new Promise((resolve) => {
    const child = execFile(
      program.command,
      words,
      { cwd, env: program.env, maxBuffer: MOST_OUTPUT },
      (error, out, err) => resolve(error && !out && !err ? error.message : `${err}\n${out}`),
    );
    const show = (/** @type {string | Buffer} */ chunk) => run.appendOutput(String(chunk).replace(/\r?\n/g, "\r\n"));
    /** @type {import("stream").Readable} */ (child.stdout).on("data", show);
    /** @type {import("stream").Readable} */ (child.stderr).on("data", show);
    token.onCancellationRequested(() => child.kill("SIGINT"));
  });
}

module.exports = { Tests };
