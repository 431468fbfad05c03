"use strict";
// Pages for panels, and where the parts of a picture are written.

/** @param {string} text */
const escape = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

/**
 * Returns the page around a picture. Nothing but the extension's own style and script is loaded or run.
 *
 * @param {{svg: string, problem: string}} drawn
 * @param {{nonce: string, source: string, style: string, script: string}} from
 */
function page({ svg, problem }, { nonce, source, style, script }) {
  const policy = `default-src 'none'; style-src ${source}; script-src 'nonce-${nonce}'`;
  const content = svg ? svg.slice(svg.indexOf("<svg")) : `<pre class="problem">${escape(problem)}</pre>`;
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="UTF-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<link rel="stylesheet" href="${style}">
<title>Event chain</title>
</head>
<body>
<main>${content}</main>
<script nonce="${nonce}" src="${script}"></script>
</body>
</html>
`;
}

/**
 * Returns where a component or topic is declared: in XMI by its attribute, in JSON by its key.
 *
 * @param {string} text
 * @param {string} name
 * @returns {{line: number, start: number, end: number} | undefined} positions from 0
 */
function locate(text, name) {
  const quoted = name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
  const isTopic = /[/~]/.test(name);
  const patterns = isTopic
    ? [`topicName="()${quoted}"`, `"topic"\\s*:\\s*"()${quoted}"`]
    : [`<software\\b[^>]*?\\bname="()${quoted}"`, `"name"\\s*:\\s*"()${quoted}"`];
  for (const pattern of patterns) {
    const found = new RegExp(pattern).exec(text);
    if (found) {
      const offset = found.index + found[0].length - 1 - name.length;
      const before = text.slice(0, offset).split(/\r\n|\r|\n/);
      const start = before[before.length - 1].length;
      return { line: before.length - 1, start, end: start + name.length };
    }
  }
  return undefined;
}

/**
 * Returns the report as a panel may show it. It states what may run in it; one that does not may run nothing.
 *
 * @param {string} html
 */
function report(html) {
  if (/<meta http-equiv="Content-Security-Policy" content="default-src 'none';/.test(html)) {
    return html;
  }
  const policy = `<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">`;
  return /<head>/.test(html) ? html.replace("<head>", `<head>${policy}`) : policy + html;
}

module.exports = { escape, locate, page, report };
