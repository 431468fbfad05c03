"use strict";
const assert = require("node:assert");
const test = require("node:test");
const { problemPatterns } = require("../package.json").contributes;

/** Returns what a pattern finds in a line, by the names of its groups. */
function found(name, line) {
  const pattern = problemPatterns.find((each) => each.name === name);
  const groups = new RegExp(pattern.regexp).exec(line);
  const names = ["file", "line", "column", "severity", "message", "code"].filter((part) => pattern[part]);
  return groups && names.map((part) => groups[pattern[part]]);
}

const PLACED = "/a b/chain.xmi:5:3: error: The name 'class' cannot be one [of Python]: no. [ocl.violated SoftwareNode::Name]";
const OF_FILE = "/a b/out: warning: It cannot be written: no. [output.unwritable]";

test("findings with a line are found, with what they say", () => {
  const message = "The name 'class' cannot be one [of Python]: no.";
  const all = ["/a b/chain.xmi", "5", "3", "error", message, "ocl.violated SoftwareNode::Name"];
  assert.deepStrictEqual(found("eventchain", PLACED), all);
  assert.strictEqual(found("eventchain", OF_FILE), null);
});

test("findings about a file are found, and only these", () => {
  const all = ["/a b/out", "warning", "It cannot be written: no.", "output.unwritable"];
  assert.deepStrictEqual(found("eventchain-file", OF_FILE), all);
  assert.strictEqual(found("eventchain-file", PLACED), null);
});

test("other lines are no findings", () => {
  for (const line of ["  hint: Use a letter.", "      <software name='error: '", "FAILED: 2 errors", "1 error, 0 warnings in 2 files"]) {
    assert.deepStrictEqual([found("eventchain", line), found("eventchain-file", line)], [null, null]);
  }
});
