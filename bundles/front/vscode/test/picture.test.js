"use strict";
const assert = require("node:assert");
const test = require("node:test");
const { locate, page, report } = require("../source/picture");

test("components and topics are found where they are declared", () => {
  const xmi = '<e:EventChain name="Brake">\r\n  <software\n    description="a &lt; b" name="Brake"/>\n  <data name="Brake" topicName="/a/b"/>\n';
  assert.deepStrictEqual(locate(xmi, "Brake"), { line: 2, start: 33, end: 38 });
  assert.deepStrictEqual(locate(xmi, "/a/b"), { line: 3, start: 32, end: 36 });
  assert.strictEqual(locate(xmi, "/a"), undefined);
  const json = '[{"name": "Brake",\n "input": [{"topic": "/a/b"}]}]';
  assert.deepStrictEqual(locate(json, "Brake"), { line: 0, start: 11, end: 16 });
  assert.deepStrictEqual(locate(json, "/a/b"), { line: 1, start: 22, end: 26 });
});

test("a page runs nothing but its own script", () => {
  const from = { nonce: "N", source: "vscode:", style: "s.css", script: "s.js" };
  const drawn = page({ svg: '<?xml version="1.0"?>\n<svg/>', problem: "" }, from);
  assert.match(drawn, /content="default-src 'none'; style-src vscode:; script-src 'nonce-N'"/);
  assert.match(drawn, /<main><svg\/><\/main>/);
  assert.match(page({ svg: "", problem: "a <b>" }, from), /<pre class="problem">a &#60;b&#62;<\/pre>/);
});

test("a report without a policy of its own runs nothing", () => {
  const own = `<html><head><meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'sha256-x'">`;
  assert.strictEqual(report(own), own);
  const policy = `<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">`;
  assert.strictEqual(report("<html><head><script>x</script>"), `<html><head>${policy}<script>x</script>`);
  assert.strictEqual(report("<script>x</script>"), `${policy}<script>x</script>`);
});
