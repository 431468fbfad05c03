"use strict";
const assert = require("node:assert");
const test = require("node:test");
const { componentTests, findings, reason, scenario, together, verdicts } = require("../source/results");

const REPORT = `<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="eventchain" tests="4" failures="1" errors="0" time="56.000">
  <testsuite name="scenarios" tests="3" failures="1" errors="0" time="14.000" skipped="1">
    <testcase classname="eventchain.scenarios" name="fast" time="14.000" file="scenarios/fast.yaml" line="1" status="run">
      <failure message="not met: speed &lt;= 2&#10;km/h" type="not passed"></failure>
    </testcase>
    <testcase classname="eventchain.scenarios" name="slow" time="1.000" file="scenarios/slow.yaml" line="1" status="run"/>
    <testcase classname="eventchain.scenarios" name="never" time="1.000" file="scenarios/never.yaml" line="1" status="notrun">
      <skipped message="not simulated"/>
    </testcase>
  </testsuite>
  <testsuite name="component tests" tests="1" failures="0" errors="0" time="0" skipped="0">
    <testcase classname="eventchain.component-tests" name="Brake: near" time="0" file="tests/Brake.yaml" line="2" status="run"/>
  </testsuite>
</testsuites>
`;

test("verdicts are read with their places", () => {
  assert.deepStrictEqual(
    verdicts(REPORT).map(({ suite, name, file, line, outcome, text }) => [suite, name, file, line, outcome, text]),
    [
      ["scenarios", "fast", "scenarios/fast.yaml", 1, "failed", "not met: speed <= 2\nkm/h"],
      ["scenarios", "slow", "scenarios/slow.yaml", 1, "passed", ""],
      ["scenarios", "never", "scenarios/never.yaml", 1, "untested", "not simulated"],
      ["component tests", "Brake: near", "tests/Brake.yaml", 2, "passed", ""],
    ],
  );
});

test("a test has passed if all verdicts about it say so", () => {
  const [failed, passed, untested] = verdicts(REPORT);
  assert.strictEqual(together([passed, untested, failed]), failed);
  assert.strictEqual(together([passed, untested]), untested);
  assert.strictEqual(together([passed, passed]), passed);
  assert.strictEqual(together([]), undefined);
});

test("no report holds no verdict", () => {
  assert.deepStrictEqual(verdicts(""), []);
});

test("a run without a verdict says why", () => {
  const json = '{"findings":[{"id":"a","severity":"warning","message":"W"},{"id":"b","severity":"error","message":"E.","file":"f","line":3,"hint":"Do."}]}';
  assert.strictEqual(reason(findings(json), "printed"), "f:3: E. Do.");
  assert.strictEqual(reason([], "first\nlast\n"), "The run says nothing about this test: last");
  assert.strictEqual(reason([], ""), "The run says nothing about this test.");
});

test("a scenario has the name that its file states", () => {
  assert.deepStrictEqual(scenario("# first\nname: 'it''s' # so\nactors:\n  - name: other\n"), { name: "it's", line: 1 });
  assert.deepStrictEqual(scenario("name: plain # said\r\nseed: 1"), { name: "plain", line: 0 });
  assert.strictEqual(scenario("title: x\nname:\n"), undefined);
});

test("tests of a component are found at their items, in any order of keys", () => {
  const text = 'tests:\n- name: near\n  steps:\n  - name: no test\n  inputs: {name: 1}\n\n- requirement: R\n  name: "far: \\"off\\""\nother:\n- name: no\n';
  assert.deepStrictEqual(componentTests(text), [
    { name: "near", line: 1 },
    { name: 'far: "off"', line: 6 },
  ]);
  assert.deepStrictEqual(componentTests("  tests: no\n"), []);
  assert.deepStrictEqual(componentTests("tests:\n    - name: deep\n      inputs: {}\n    - name: too\n"), [
    { name: "deep", line: 1 },
    { name: "too", line: 3 },
  ]);
});
