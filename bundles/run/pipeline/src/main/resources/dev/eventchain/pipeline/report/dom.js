// Reading untrusted data and making elements from it. Text enters the page as text nodes only.

const SVG = "http://www.w3.org/2000/svg";

/** Characters that would reorder or hide what stands beside them. */
const DECEIVING = /[\u0000-\u0008\u000b\u000c\u000e-\u001f\u007f-\u009f\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff]/g;

function text(value) {
  return value === null || value === undefined ? "" : String(value).replace(DECEIVING, "\ufffd");
}

function list(value) {
  return Array.isArray(value) ? value.filter((entry) => entry !== null && entry !== undefined) : [];
}

function record(value) {
  return value !== null && typeof value === "object" && !Array.isArray(value) ? value : {};
}

function records(value) {
  return list(value).map(record);
}

/** A finite number, else null. */
function number(value) {
  return typeof value === "number" && Number.isFinite(value) ? value : null;
}

/** "1 constraint", "2 constraints". */
function count(amount, singular, plural = singular + "s") {
  return `${whole(amount)}\u00a0${amount === 1 ? singular : plural}`;
}

/** A number as people read it; an en dash where it is unknown. */
function figure(value, digits, unit = "") {
  if (number(value) === null) {
    return "\u2013";
  }
  const [units, decimals] = Math.abs(value).toFixed(digits).split(".");
  const grouped = units.replace(/\B(?=(\d{3})+$)/g, "\u202f");
  const sign = value < 0 && Number(value.toFixed(digits)) !== 0 ? "\u2212" : "";
  return sign + grouped + (decimals ? "." + decimals : "") + (unit ? "\u00a0" + unit : "");
}

function whole(value) {
  return figure(value, 0);
}

/** Milliseconds with about three significant digits. */
function milliseconds(value) {
  const size = Math.abs(number(value) ?? 0);
  return figure(value, size === 0 || size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
}

function latency(value) {
  return number(value) === null ? "\u2013" : milliseconds(value) + "\u00a0ms";
}

function fill(parent, attributes, children) {
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (value !== null && value !== undefined && value !== false) {
      parent.setAttribute(name, value === true ? "" : String(value));
    }
  }
  for (const child of children.flat(Infinity)) {
    if (child !== null && child !== undefined && child !== false) {
      parent.append(child instanceof Node ? child : document.createTextNode(text(child)));
    }
  }
  return parent;
}

/** An HTML element. Attribute names and link targets are the page's own, never from the data. */
function html(name, attributes, ...children) {
  return fill(document.createElement(name), attributes, children);
}

function svg(name, attributes, ...children) {
  return fill(document.createElementNS(SVG, name), attributes, children);
}

const SIGNS = {
  good: "M2.5 8.5l3.5 3.5 7.5-8",
  bad: "M3.5 3.5l9 9m0-9l-9 9",
  warn: "M8 2.5v7.5m0 2.5v1.5",
  none: "M3.5 8h9",
};

/** The sign of a result: good, bad, warn or none. Decorative, a word stands beside it. */
function sign(tone) {
  const path = svg("path", {
    d: SIGNS[tone], fill: "none", stroke: "currentColor", "stroke-width": 2.5, "stroke-linecap": "round", "stroke-linejoin": "round",
  });
  return svg("svg", { viewBox: "0 0 16 16", "aria-hidden": "true", class: tone }, path);
}

/** What a scenario or a criterion came to: neither passed nor failed if it was not tested. */
function outcomeOf(judged) {
  if (judged.passed === true) {
    return { tone: "good", word: "passed" };
  }
  return judged.tested === false ? { tone: "warn", word: "not tested" } : { tone: "bad", word: "failed" };
}

/** A sign with its word. */
function status(tone, word) {
  return html("span", { class: "status " + tone }, sign(tone), word);
}

/** A long name that may break behind its separators. */
function breakable(value) {
  return text(value).split(/(?<=[/_.:])/).flatMap((part, index) => (index > 0 ? [html("wbr"), part] : [part]));
}

/** A name from the code. */
function code(value) {
  return html("code", null, breakable(value));
}

function unseen(value) {
  return html("span", { class: "unseen" }, value);
}

/** Code names in a column, one below the other. */
function codes(values) {
  return html("ul", null, list(values).map((value) => html("li", null, code(value))));
}

/** Pairs of a term and what it says, those without a value left out. */
function figures(className, pairs) {
  const known = pairs.filter(([, value]) => value !== null && value !== undefined && value !== "");
  return html("dl", { class: className },
    known.map(([name, value, note]) => html("div", null,
      html("dt", null, name),
      html("dd", null, value, note ? html("small", null, " ", note) : null))));
}

/**
 * A table. Columns: {name, number, row, width, plain}; a column with `row` heads its rows. With `stack` the rows become
 * blocks on a narrow screen, each cell under its column's name unless `plain`; roles are set because other display values may drop them.
 * With `dense` many columns have room.
 */
function table(caption, columns, rows, { stack = false, dense = false } = {}) {
  const role = (name) => (stack ? { role: name } : {});
  const heads = columns.map((column) =>
    html("th", { scope: "col", class: column.number ? "number" : null, ...role("columnheader") }, column.name));
  const result = html("table", { class: stack ? "stack" : null, ...role("table") },
    html("caption", { class: "unseen" }, caption),
    html("colgroup", null, columns.map((column) => html("col", { width: column.width }))),
    html("thead", role("rowgroup"), html("tr", role("row"), heads)),
    html("tbody", role("rowgroup"), rows.map((row) => html("tr", { class: row.className, ...role("row") },
      row.cells.map((cell, index) => tableCell(columns[index], cell, stack))))));
  return stack ? result : html("div", { class: dense ? "scroll dense" : "scroll", tabindex: 0, role: "region", "aria-label": caption }, result);
}

function tableCell(column, cell, stack) {
  const className = column.number ? "number" : null;
  if (column.row) {
    return html("th", { scope: "row", class: className, role: stack ? "rowheader" : null }, cell);
  }
  return html("td", { class: className, role: stack ? "cell" : null, "data-label": stack && !column.plain ? column.name : null }, cell);
}
