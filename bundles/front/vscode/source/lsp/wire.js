"use strict";
// Messages of JSON-RPC over two streams, as the language server protocol frames them.

const HEADER_END = Buffer.from("\r\n\r\n");
const CANCELLED = -32800;

/** The answer of a server that could not do what was asked. */
class ResponseError extends Error {
  /** @param {{code: number, message: string}} error */
  constructor(error) {
    super(error.message);
    this.code = error.code;
  }

  /** Whether nobody needs the answer any more, so that nobody has to be told. */
  get isCancelled() {
    // What a server calls content modified or request cancelled is a race, not a fault.
    return this.code === CANCELLED || this.code === -32801 || this.code === -32802;
  }
}

/** One connection. What is asked gets one answer, also after the connection has ended: an error. */
class Wire {
  /**
   * @param {import("stream").Readable} input
   * @param {import("stream").Writable} output
   * @param {{request: (method: string, params: any) => any, notification: (method: string, params: any) => void, broken: (error: Error) => void}} listener
   */
  constructor(input, output, listener) {
    this.output = output;
    this.listener = listener;
    /** @type {Map<number, {resolve: (result: any) => void, reject: (error: Error) => void}>} */
    this.waiting = new Map();
    this.next = 1;
    this.ended = false;
    this.rest = Buffer.alloc(0);
    input.on("data", (/** @type {Buffer} */ chunk) => this.read(chunk));
    input.on("end", () => this.end());
    output.on("error", () => this.end());
  }

  /**
   * @param {string} method
   * @param {any} params
   * @param {{onCancellationRequested: (f: () => void) => any, isCancellationRequested: boolean}} [token]
   * @returns {Promise<any>}
   */
  request(method, params, token) {
    if (this.ended) {
      return Promise.reject(new Error("The language server has ended."));
    }
    const id = this.next++;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.send({ id, method, params });
      const cancel = () => this.waiting.has(id) && this.notify("$/cancelRequest", { id });
      if (token && token.isCancellationRequested) {
        cancel();
      } else if (token) {
        token.onCancellationRequested(cancel);
      }
    });
  }

  /**
   * @param {string} method
   * @param {any} [params]
   */
  notify(method, params) {
    if (!this.ended) {
      this.send({ method, params });
    }
  }

  /** @param {object} message */
  send(message) {
    const body = Buffer.from(JSON.stringify({ jsonrpc: "2.0", ...message }));
    this.output.write(Buffer.concat([Buffer.from(`Content-Length: ${body.length}\r\n\r\n`), body]));
  }

  /** @param {Buffer} chunk */
  read(chunk) {
    this.rest = Buffer.concat([this.rest, chunk]);
    while (!this.ended) {
      const headerEnd = this.rest.indexOf(HEADER_END);
      if (headerEnd < 0) {
        return;
      }
      const length = /content-length:\s*(\d+)/i.exec(this.rest.toString("ascii", 0, headerEnd));
      if (!length) {
        // Somebody printed to standard output; where the next message starts is not known.
        const start = this.rest.toString("utf8", 0, Math.min(headerEnd, 200));
        this.end();
        this.listener.broken(new Error(`The language server wrote something else than messages: ${start}`));
        return;
      }
      const start = headerEnd + HEADER_END.length;
      const end = start + Number(length[1]);
      if (this.rest.length < end) {
        return;
      }
      const body = this.rest.toString("utf8", start, end);
      this.rest = this.rest.subarray(end);
      this.message(body);
    }
  }

  /** @param {string} body */
  message(body) {
    let message;
    try {
      message = JSON.parse(body);
    } catch (error) {
      this.end();
      this.listener.broken(new Error(`The language server wrote no JSON: ${body.slice(0, 200)}`));
      return;
    }
    if (message.method === undefined) {
      this.answer(message);
    } else if (message.id === undefined) {
      this.listener.notification(message.method, message.params);
    } else {
      this.serve(message);
    }
  }

  /** @param {{id: number, result?: any, error?: {code: number, message: string}}} message */
  answer(message) {
    const waiting = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (waiting && message.error) {
      waiting.reject(new ResponseError(message.error));
    } else if (waiting) {
      waiting.resolve(message.result);
    }
  }

  /** @param {{id: number, method: string, params: any}} message */
  async serve(message) {
    try {
      const result = await this.listener.request(message.method, message.params);
      this.send({ id: message.id, result: result === undefined ? null : result });
    } catch (error) {
      const unknown = error instanceof UnknownMethod;
      this.send({ id: message.id, error: { code: unknown ? -32601 : -32603, message: String(error) } });
    }
  }

  /** Ends the connection: whoever waits for an answer gets an error. */
  end() {
    this.ended = true;
    for (const { reject } of this.waiting.values()) {
      reject(new Error("The language server has ended."));
    }
    this.waiting.clear();
  }
}

/** A request of the server that this client does not know. */
class UnknownMethod extends Error {}

module.exports = { ResponseError, UnknownMethod, Wire };
