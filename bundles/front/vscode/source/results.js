"use strict";
// What files of tests hold, and what the program's reports say about them.

/**
 * @typedef {{name: string, line: number}} Named a name in a file, with its line from 0
 * @typedef {{suite: string, name: string, file: string, line: number, outcome: "passed" | "failed" | "untested", text: string}} Verdict
 * @typedef {{message: string, file?: string, line?: number, column?: number, hint?: string, severity: string}} Finding
 */

const ENTITIES = { amp: "&", lt: "<", gt: ">", quot: '"', apos: "'" };

/** @param {string} text */
function unescape(text) {
  return text.replace(/&(#x?[0-9a-f]+|\w+);/gi, (whole, name) => {
    if (name[0] === "#") {
      return String.fromCodePoint(/^#x/i.test(name) ? parseInt(name.slice(2), 16) : Number(name.slice(1)));
    }
    return ENTITIES[/** @type {"amp"} */ (name)] || whole;
  });
}

/** @param {string} text a scalar of YAML on one line, as names are */
function scalar(text) {
  const quoted = /^"((?:\\.|[^"\\])*)"|^'((?:''|[^'])*)'/.exec(text);
  if (!quoted) {
    return text.replace(/\s+#.*$/, "").trim();
  }
  return quoted[1] === undefined ? quoted[2].replace(/''/g, "'") : quoted[1].replace(/\\(["\\])/g, "$1");
}

/**
 * Returns the name of the scenario in a file; none if it has no name yet.
 *
 * @param {string} text
 * @returns {Named | undefined}
 */
function scenario(text) {
  const lines = text.split(/\r\n|\r|\n/);
  const line = lines.findIndex((each) => /^name:\s*\S/.test(each));
  return line < 0 ? undefined : { name: scalar(lines[line].slice("name:".length).trim()), line };
}

/**
 * Returns the tests of a component in a file.
 *
 * @param {string} text
 * @returns {Named[]}
 */
function componentTests(text) {
  const lines = text.split(/\r\n|\r|\n/);
  const found = [];
  let indent = -1;
  let start = -1;
  for (let i = lines.findIndex((line) => /^tests:\s*(#.*)?$/.test(line)) + 1; i > 0 && i < lines.length; i++) {
    const item = /^(\s*)-\s+/.exec(lines[i]);
    if (/^[^\s#-]/.test(lines[i])) {
      break; // The next key of the document.
    }
    indent = indent < 0 && item ? item[1].length : indent;
    const begins = item && item[1].length === indent;
    start = begins ? i : start;
    const key = begins ? lines[i].slice(item[0].length) : lines[i].slice(indent + 2);
    const deeper = !begins && !/^\s*$/.test(lines[i].slice(0, indent + 2));
    const name = start >= 0 && !deeper && /^name:\s*(\S.*)$/.exec(key);
    if (name) {
      found.push({ name: scalar(name[1]), line: start });
      start = -1;
    }
  }
  return found;
}

/**
 * Reads the program's report in JUnit XML.
 *
 * @param {string} xml
 * @returns {Verdict[]}
 */
function verdicts(xml) {
  /** @type {Verdict[]} */
  const all = [];
  for (const suite of xml.matchAll(/<testsuite name="([^"]*)"[^>]*>([\s\S]*?)<\/testsuite>/g)) {
    for (const one of suite[2].matchAll(/<testcase ([^>]*?)(?:\/>|>([\s\S]*?)<\/testcase>)/g)) {
      all.push(verdict(unescape(suite[1]), one[1], one[2] || ""));
    }
  }
  return all;
}

/**
 * @param {string} suite
 * @param {string} attributes
 * @param {string} content
 * @returns {Verdict}
 */
function verdict(suite, attributes, content) {
  /** @param {string} name @param {string} text */
  const value = (name, text) => unescape((new RegExp(`(?:^|\\s)${name}="([^"]*)"`).exec(text) || ["", ""])[1]);
  const problem = /<(failure|error|skipped)\b([^>]*)/.exec(content);
  const ran = value("status", attributes) !== "notrun";
  const failed = ran && problem && problem[1] !== "skipped";
  return {
    suite,
    name: value("name", attributes),
    file: value("file", attributes),
    line: Number(value("line", attributes) || 0),
    // What neither ran nor failed is not passed.
    outcome: failed ? "failed" : ran && !problem ? "passed" : "untested",
    text: problem ? value("message", problem[2]) : "",
  };
}

/**
 * Puts the verdicts about one test together, of which a scenario may have several, such as with and without a fault:
 * passed only if all are, and if there is one.
 *
 * @param {Verdict[]} all
 * @returns {Verdict | undefined}
 */
function together(all) {
  return all.find((each) => each.outcome === "failed") || all.find((each) => each.outcome === "untested") || all[0];
}

/**
 * Reads the findings of the program's report in JSON.
 *
 * @param {string} json
 * @returns {Finding[]}
 */
function findings(json) {
  return JSON.parse(json).findings;
}

/**
 * Returns why a run has no verdict about a test: the first error, else what was printed last.
 *
 * @param {Finding[]} found
 * @param {string} printed
 */
function reason(found, printed) {
  const error = found.find((each) => each.severity === "error");
  if (error) {
    const place = error.file ? `${error.file}${error.line ? `:${error.line}` : ""}: ` : "";
    return `${place}${error.message}${error.hint ? ` ${error.hint}` : ""}`;
  }
  const last = printed.trim().split(/\r?\n/).pop();
  return last ? `The run says nothing about this test: ${last}` : "The run says nothing about this test.";
}

module.exports = { componentTests, findings, reason, scenario, together, verdicts };
