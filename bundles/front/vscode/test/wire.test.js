"use strict";
const assert = require("node:assert");
const { PassThrough } = require("node:stream");
const test = require("node:test");
const { ResponseError, UnknownMethod, Wire } = require("../source/lsp/wire");

function connected(listener = {}) {
  const input = new PassThrough();
  const output = new PassThrough();
  const heard = { notifications: [], broken: [] };
  const wire = new Wire(input, output, {
    request: () => null,
    notification: (method, params) => heard.notifications.push([method, params]),
    broken: (error) => heard.broken.push(error.message),
    ...listener,
  });
  const framed = (message) => {
    const body = Buffer.from(JSON.stringify({ jsonrpc: "2.0", ...message }));
    return Buffer.concat([Buffer.from(`Content-Length: ${body.length}\r\n\r\n`), body]);
  };
  const sent = () => {
    const text = (output.read() || Buffer.alloc(0)).toString();
    return text.split(/Content-Length: \d+\r\n\r\n/).filter(Boolean).map((body) => JSON.parse(body));
  };
  return { wire, input, framed, sent, heard };
}

const moment = () => new Promise((resolve) => setImmediate(resolve));

test("messages are read however they are cut, with any characters", async () => {
  const { input, framed, heard } = connected();
  for (const byte of framed({ method: "m", params: "é😀" })) {
    input.write(Buffer.from([byte]));
  }
  input.write(Buffer.concat([framed({ method: "a" }), framed({ method: "b" })]));
  await moment();
  assert.deepStrictEqual(heard.notifications, [["m", "é😀"], ["a", undefined], ["b", undefined]]);
});

test("answers reach whoever asked", async () => {
  const { wire, input, framed, sent } = connected();
  const [first, second] = [wire.request("one", {}), wire.request("two", {})];
  assert.deepStrictEqual(sent().map(({ id, method }) => [id, method]), [[1, "one"], [2, "two"]]);
  input.write(framed({ id: 2, error: { code: -32603, message: "no" } }));
  input.write(framed({ id: 1, result: null }));
  assert.strictEqual(await first, null);
  await assert.rejects(second, (error) => error instanceof ResponseError && error.message === "no" && !error.isCancelled);
});

test("what nobody needs any more is cancelled once", async () => {
  const { wire, sent } = connected();
  let cancel;
  wire.request("slow", {}, { isCancellationRequested: false, onCancellationRequested: (f) => (cancel = f) });
  sent();
  cancel();
  assert.deepStrictEqual(sent(), [{ jsonrpc: "2.0", method: "$/cancelRequest", params: { id: 1 } }]);
});

test("whoever waits learns that the server has ended", async () => {
  const { wire, input } = connected();
  const waiting = wire.request("never", {});
  input.end();
  await assert.rejects(waiting, /has ended/);
  await assert.rejects(wire.request("late", {}), /has ended/);
});

test("something else than messages ends the connection, with what it was", async () => {
  const { wire, input, heard } = connected();
  input.write("Hello!\r\n\r\n");
  await moment();
  assert.deepStrictEqual(heard.broken, ["The language server wrote something else than messages: Hello!"]);
  await assert.rejects(wire.request("late", {}), /has ended/);
});

test("requests of the server are answered, also those that are not known", async () => {
  const { input, framed, sent } = connected({
    request: (method) => {
      if (method !== "known") {
        throw new UnknownMethod(method);
      }
      return [1];
    },
  });
  input.write(framed({ id: "a", method: "known" }));
  input.write(framed({ id: "b", method: "unknown" }));
  await moment();
  await moment();
  const answers = Object.fromEntries(sent().map((answer) => [answer.id, answer]));
  assert.deepStrictEqual([answers.a.result, answers.b.error.code], [[1], -32601]);
});
