// What the page shows besides the model: reasons, scenarios, proofs, validation, findings, ranges, times, origin.

const data = record(JSON.parse(document.getElementById("data").textContent));
const scenarios = records(data.scenarios);
const faults = records(data.faults);
const requirements = records(data.requirements);
const validation = records(data.validation);
const stages = records(data.stages);
const diagnostics = sortedDiagnostics(records(data.diagnostics));
const nodes = records(data.nodes);
const hops = records(data.hops);
const topics = records(data.topics);
const failedScenarios = scenarios.filter((scenario) => scenario.passed !== true);
const unproved = requirements.filter((requirement) => requirement.proved !== true);
const errors = diagnostics.filter((diagnostic) => severityOf(diagnostic) === "ERROR");

function severityOf(diagnostic) {
  return text(diagnostic.severity).toUpperCase();
}

function sortedDiagnostics(all) {
  const rank = (diagnostic) => ["ERROR", "WARNING"].indexOf(severityOf(diagnostic)) >>> 0;
  return all.map((diagnostic, index) => ({ diagnostic, index }))
    .sort((one, other) => rank(one.diagnostic) - rank(other.diagnostic) || one.index - other.index)
    .map((entry) => entry.diagnostic);
}

function titleOf(scenario) {
  return text(scenario.title) || text(scenario.name) || "Scenario without a name";
}

function scenarioId(scenario) {
  return "scenario-" + (scenarios.indexOf(scenario) + 1);
}

function most(values, choose) {
  const known = values.map(number).filter((value) => value !== null);
  return known.length > 0 ? choose(...known) : null;
}

/** A section with its heading, a sentence on what it shows, and its content. */
function section(id, title, lead, ...content) {
  return html("section", { id, "aria-labelledby": id + "-title" },
    html("h2", { id: id + "-title" }, title), lead ? html("p", { class: "lead" }, lead) : null, content);
}

// Head

function verdictOf(project) {
  const word = text(project.verdict);
  return word === "passed" || word === "failed" ? word : "incomplete";
}

function ownSummary() {
  return scenarios.length > 0
    ? `${scenarios.length - failedScenarios.length} of ${count(scenarios.length, "scenario")} passed`
    : "No scenario was run.";
}

function reasons() {
  const result = stages.filter((stage) => ["failed", "waiting"].includes(text(stage.status)))
    .map((stage) => [html("a", { href: "#stages" }, `Stage ${text(stage.name)}`), detailOf(stage.details)]);
  for (const scenario of failedScenarios) {
    const missed = records(scenario.criteria).filter((criterion) => criterion.passed !== true)
      .map((criterion) => text(criterion.text) + (text(criterion.measured) ? ` (${text(criterion.measured)})` : ""));
    const said = outcomeOf(scenario).word === "failed" ? "not met: " : "not tested: ";
    result.push([html("a", { href: "#" + scenarioId(scenario) }, titleOf(scenario)), detailOf(missed.join("; "), said)]);
  }
  errors.forEach((error) => result.push([html("a", { href: "#diagnostics" }, code(text(error.id))), detailOf(error.message)]));
  return result;
}

function detailOf(value, before = "") {
  const all = text(value);
  return all === "" ? "" : ": " + before + (all.length > 240 ? all.slice(0, 239) + "\u2026" : all);
}

function reasonList() {
  const all = reasons();
  const shown = all.slice(0, 12);
  const rest = all.length - shown.length;
  return all.length === 0 ? null : html("ul", { class: "reasons", "aria-label": "Why" },
    shown.map((reason) => html("li", null, sign("bad"), html("span", null, reason))),
    rest > 0 ? html("li", null, html("span"), `and ${rest} more`) : null);
}

function keyFigures() {
  const criteria = scenarios.flatMap((scenario) => records(scenario.criteria));
  const slowest = most(scenarios.map((scenario) => record(scenario.latency).maximum), Math.max);
  const limit = most(scenarios.map((scenario) => scenario.latencyLimit), Math.min);
  const evaluations = most(validation.map((one) => one.evaluations), (...all) => all.reduce((sum, one) => sum + one, 0));
  const violations = most(validation.map((one) => one.violations), (...all) => all.reduce((sum, one) => sum + one, 0));
  return figures("figures", [
    ["Scenarios passed", scenarios.length ? `${scenarios.length - failedScenarios.length} of ${scenarios.length}` : null],
    ["Requirements and rules proved", requirements.length ? `${requirements.length - unproved.length} of ${requirements.length}` : null],
    ["Criteria met", criteria.length ? `${criteria.filter((criterion) => criterion.passed === true).length} of ${criteria.length}` : null],
    ["Longest latency of the chain", slowest === null ? null : latency(slowest), limit === null ? "" : `limit ${latency(limit)}`],
    ["Constraint evaluations", evaluations === null ? null : whole(evaluations), `${whole(violations ?? 0)} violated`],
  ]);
}

/** Adds signs, reasons and key figures to the verdict. */
function completeHead() {
  const verdict = verdictOf(record(data.project));
  const box = document.querySelector("div.verdict");
  box.querySelector(".status").prepend(sign({ passed: "good", failed: "bad", incomplete: "warn" }[verdict]));
  const summary = box.querySelector(".summary");
  summary.textContent = summary.textContent || ownSummary();
  box.append(...[verdict === "passed" ? null : reasonList()].filter(Boolean));
  box.after(keyFigures());
}

// Event chain

/** Draws the picture into its place. */
function completeChain() {
  const holder = document.querySelector("#chain .chain");
  if (!holder) {
    return;
  }
  drawChain(record(data.chain), holder);
  holder.after(chainKey());
}

function chainKey() {
  const box = (name) => svg("svg", { width: 22, height: 14, "aria-hidden": "true" }, svg("rect", { class: "node " + name, x: 1, y: 1, width: 20, height: 12, rx: 2 }));
  const signal = (points, kind = "") => svg("svg", { width: 22, height: 14, "aria-hidden": "true" }, svg("polygon", { class: "topic" + kind, points }));
  const external = records(record(data.chain).boxes).some((each) => each.external === true);
  return html("p", { class: "chain-key" },
    html("span", null, box("generated"), "generated node"), html("span", null, box("existing"), "existing node"),
    html("span", null, signal("1 1, 21 1, 21 13, 1 13, 6 7"), "topic from the outside"), html("span", null, signal("1 1, 16 1, 21 7, 16 13, 1 13"), "topic to the outside"),
    external ? html("span", null, signal("1 1, 16 1, 21 7, 16 13, 1 13", " external"), "signal that leaves the chain, as a requirement asks") : null);
}

/** What never came, before the picture of what should have brought it. */
function completeSilence() {
  const silent = diagnostics.filter((diagnostic) => text(diagnostic.id) === "simulation.node.silent");
  const lead = document.querySelector("#chain .lead");
  if (lead && silent.length > 0) {
    lead.after(html("div", { class: "notice" }, html("strong", null, "Never received"),
      html("ul", null, silent.map((diagnostic) => html("li", null, text(diagnostic.message))))));
  }
}

// Requirements

/** The row of a requirement: the model's, or a new one for what the model does not know. */
function requirementRow(requirement, index, body) {
  const name = text(requirement.id);
  const known = [...body.rows].find((row) => row.dataset.requirement === name);
  if (known) {
    return known;
  }
  const row = body.insertRow();
  fill(row, { role: "row", "data-requirement": name }, [
    html("th", { scope: "row", role: "rowheader" }, html("span", { id: "rule-" + (index + 1) }, name), html("div", { class: "statement" }, text(requirement.text))),
    ["Components", "Files", "Proved by"].map((label) => html("td", { role: "cell", "data-label": label }))]);
  row.cells[1].append(codes(requirement.components));
  return row;
}

function requirementLink(name) {
  const row = [...document.querySelectorAll("tr[data-requirement]")].find((one) => one.dataset.requirement === name);
  return row ? html("a", { href: "#" + row.querySelector("[id]").id }, name) : name;
}

/** A link to a file beside this page, whatever its name says. */
function fileLink(name, shown) {
  return html("a", { href: "./" + name.split("/").map(encodeURIComponent).join("/") }, code(shown));
}

function rangeText(first, last) {
  return first === last ? whole(first) : `${whole(first)}\u2013${whole(last)}`;
}

/** Lines one after the other become one range. */
function rangesOf(lines) {
  const ranges = [];
  for (const line of lines) {
    const last = ranges[ranges.length - 1];
    if (last && number(line.first) <= last.last + 1) {
      last.last = Math.max(last.last, number(line.last));
    } else {
      ranges.push({ first: number(line.first), last: number(line.last) });
    }
  }
  return ranges;
}

/** A generated file, with the lines that a component made, and the line of the template behind each. */
function generatedItem(file) {
  const lines = records(file.lines).filter((line) => number(line.first) !== null && number(line.last) !== null);
  const ranges = rangesOf(lines).map((range) => rangeText(range.first, range.last)).join(", ");
  const title = `${count(lines.reduce((sum, line) => sum + line.last - line.first + 1, 0), "line")} for ${text(file.node)}`;
  return html("li", { class: "generated" }, fileLink(text(file.file), text(file.file)),
    html("details", { title }, html("summary", { class: "small" }, `${/^\d+$/.test(ranges) ? "line" : "lines"} ${ranges}`),
      html("ol", { class: "small lines" }, lines.map((line) => html("li", null, html("span", { class: "muted" }, rangeText(line.first, line.last) + " "), code(text(line.from)))))));
}

function proofItem(proof) {
  const scenario = text(proof.kind) === "scenario" ? scenarios.find((one) => text(one.name) === text(proof.name)) : null;
  const { tone, word } = outcomeOf(proof);
  const passed = tone === "good";
  const name = scenario ? html("a", { href: "#" + scenarioId(scenario) }, titleOf(scenario)) : code(text(proof.name));
  const kind = scenario ? "" : text(proof.kind);
  return html("li", { class: "proof" }, sign(tone), html("span", null, passed ? unseen("passed: ") : null, name,
    html("span", { class: "small muted" }, kind ? " " + kind : ""), passed ? null : html("strong", { class: tone }, " " + word)));
}

/** The number of standard faults that the criteria of a requirement notice, and which they do not. */
function strengthItem(strength) {
  const noticed = number(strength?.noticed);
  if (noticed === null) {
    return null;
  }
  const all = number(strength.sampleOf);
  const words = `Notices ${noticed} of ${count(number(strength.faults), "fault")}${all === null ? "" : `, a sample of ${all}`}`;
  const missed = records(strength.unnoticed).map((one) => html("li", null, text(one.fault),
    one.nearest ? html("span", { class: "muted" }, `; nearest: ${text(one.nearest.criterion)} in ${text(one.nearest.scenario)}`) : null));
  return missed.length === 0 ? html("p", { class: "small" }, words)
    : html("details", { class: "small" }, html("summary", null, words), html("p", null, "Not noticed:"), html("ul", null, missed));
}

/** Adds files and proofs to the requirements of the model, and the design rules, which it does not hold. */
function completeRequirements() {
  const all = document.getElementById("requirements");
  const body = all.querySelector("tbody");
  requirements.forEach((requirement, index) => {
    const row = requirementRow(requirement, index, body);
    const proved = requirement.proved === true;
    const proofs = records(requirement.proofs);
    row.classList.toggle("unproved", !proved);
    row.cells[2].append(html("ul", null, list(requirement.files).map((file) => html("li", null, code(file))), records(requirement.generated).map(generatedItem)));
    row.cells[3].append(...[proved ? null : status("warn", proofs.length === 0 ? "Not proved: nothing tests it" : "Not proved"),
      html("ul", null, proofs.map(proofItem)), strengthItem(requirement.strength)].filter(Boolean));
  });
  all.hidden = body.rows.length === 0;
  if (unproved.length > 0) {
    body.closest("table").before(html("p", { class: "notice" },
      html("strong", null, `Not proved: ${count(unproved.length, "requirement")}. `),
      unproved.flatMap((requirement, index) => [index > 0 ? ", " : "", requirementLink(text(requirement.id))])));
  }
}

function validationSection() {
  if (validation.length === 0) {
    return null;
  }
  const columns = [{ name: "Model", row: true }, { name: "Result" }, { name: "Constraints", number: true },
    { name: "Elements", number: true }, { name: "Evaluations", number: true }, { name: "Violations", number: true }];
  const rows = validation.map((one) => {
    const result = number(one.violations) === null || number(one.evaluations) === null ? ["warn", "Unknown"]
      : one.evaluations === 0 ? ["bad", "Nothing checked"] : one.violations > 0 ? ["bad", "Violated"] : ["good", "Holds"];
    return { cells: [code(text(one.model)), status(...result), whole(one.constraints), whole(one.elements), whole(one.evaluations), whole(one.violations)] };
  });
  return section("validation", "Validation", "OCL constraints, the standard ones and those made from the design rules, evaluated on each model.",
    table("Validated models", columns, rows));
}

function placeOf(diagnostic) {
  const file = text(diagnostic.file);
  const place = [file, ...[diagnostic.line, diagnostic.column].filter((value) => number(value) > 0)].filter((part) => part !== "").join(":");
  return [file ? code(place) : null, text(diagnostic.element) ? code(diagnostic.element) : null,
    text(diagnostic.rule) ? html("span", null, "rule ", code(diagnostic.rule)) : null, code(text(diagnostic.id))].filter(Boolean);
}

function diagnosticItem(diagnostic) {
  const [tone, word] = { ERROR: ["bad", "Error"], WARNING: ["warn", "Warning"] }[severityOf(diagnostic)] ?? ["none", "Note"];
  return html("li", null, html("div", null, status(tone, word)), html("div", null,
    html("p", null, text(diagnostic.message)),
    text(diagnostic.hint) ? html("p", { class: "muted" }, text(diagnostic.hint)) : null,
    html("p", { class: "where" }, placeOf(diagnostic).map((part) => html("span", null, part)))));
}

function diagnosticSection() {
  const shown = diagnostics.slice(0, 10);
  const rest = diagnostics.slice(10);
  return section("diagnostics", "Diagnostics", null,
    diagnostics.length === 0 ? html("p", { class: "none" }, "None.") : html("ol", { class: "diagnostics first" }, shown.map(diagnosticItem)),
    rest.length === 0 ? null : html("details", null, html("summary", null, `${rest.length} more`),
      html("ol", { class: "diagnostics" }, rest.map(diagnosticItem))));
}

// Times

function latencyRange(measured, limit, end) {
  const at = (value) => `${(100 * Math.min(1, value / end)).toFixed(2)}%`;
  const [low, middle, high] = [measured.minimum, measured.median, measured.maximum].map(number);
  return svg("svg", { class: "ranges", "aria-hidden": "true" },
    svg("line", { class: "base", x1: 0, x2: "100%", y1: 10, y2: 10 }),
    low === null || high === null ? null : svg("line", { class: "span", x1: at(low), x2: at(high), y1: 10, y2: 10 }),
    middle === null ? null : svg("circle", { class: "median", cx: at(middle), cy: 10, r: 3.5 }),
    limit === null ? null : svg("line", { class: "limit", x1: at(limit), x2: at(limit), y1: 2, y2: 18 }));
}

const QUANTILES = [["minimum", "Minimum"], ["median", "Median"], ["percentile99", "99 %"], ["maximum", "Maximum"]];

/** Adds titles, ranges and limits to the latencies, and the time on this host, which is no part of the model, to the nodes. */
function completeMeasurements() {
  const rows = [...document.querySelectorAll("tr[data-scenario]")];
  const end = 1.12 * most(scenarios.flatMap((scenario) => [record(scenario.latency).maximum, scenario.latencyLimit]), Math.max);
  for (const row of rows) {
    const scenario = scenarios.find((one) => text(one.name) === row.dataset.scenario);
    const limit = scenario ? number(scenario.latencyLimit) : null;
    if (scenario && number(record(scenario.latency).maximum) !== null) {
      row.cells[0].replaceChildren(titleOf(scenario));
      row.cells[1].append(latencyRange(scenario.latency, limit, end));
      if (limit !== null && scenario.latency.maximum > limit) {
        row.cells[5].replaceChildren(html("strong", { class: "bad" }, row.cells[5].textContent, unseen(" over the limit")));
      }
    }
    row.cells[6].append(milliseconds(limit));
  }
  for (const node of nodes) {
    const row = [...document.querySelectorAll("tr[data-node]")].find((one) => one.dataset.node === text(node.name));
    const host = record(node.hostExecutionTime);
    if (row && number(host.median) !== null) {
      const [median, maximum] = [...row.cells].slice(-2);
      const times = number(node.timesWorstCase) ?? 0;
      median.append(milliseconds(host.median));
      maximum.append(milliseconds(host.maximum));
      row.cells[0].append(times > 1 ? html("div", { class: "small muted" }, `${times.toFixed(1)} times the worst case of the model`) : "");
    }
  }
}

/** A count of how often a number of the model was exceeded; a dash where the model states none or nothing was there to exceed it. */
function exceeded(count) {
  const [times, of] = [number(record(count).times), number(record(count).of)];
  if (times === null) {
    return "\u2013";
  }
  const words = `${whole(times)} of ${whole(of)}`;
  return [times > 0 ? html("strong", null, words) : words, html("div", { class: "small muted" }, `over ${milliseconds(count.limit)} ms`)];
}

const HOP_TIMES = [["minimum", "Shortest"], ["mean", "Mean"], ["median", "Median"], ["maximum", "Longest"]];

/** From one that writes a topic to one that reads it, over all scenarios: how long samples waited, and what became of them. */
function hopTable() {
  const columns = [{ name: "Hop", row: true },
    ...HOP_TIMES.map(([, name]) => ({ name: `${name} wait`, number: true })), { name: "Oldest when read", number: true },
    { name: "Published", number: true }, { name: "Read", number: true }, { name: "Never read", number: true },
    { name: "Unread at the end", number: true }, { name: "Too old", number: true }, { name: "Late", number: true }];
  const rows = hops.map((hop) => {
    const [waiting, samples] = [record(hop.waiting), record(hop.samples)];
    const times = number(waiting.count) === null ? ["not measured", "", "", "", ""]
      : [...HOP_TIMES.map(([name]) => milliseconds(waiting[name])), milliseconds(record(hop.age).maximum)];
    const counts = ["published", "read", "neverRead", "unreadAtEnd"].map((name) => whole(samples[name]));
    const ends = html("div", { class: "small muted" }, `${text(hop.writer)} to ${text(hop.reader)}`);
    return { cells: [[code(text(hop.topic)), ends], ...times, ...counts, exceeded(hop.tooOld), exceeded(hop.late)] };
  });
  return table("Hops over all scenarios, times in ms", columns, rows);
}

function topicTable() {
  const columns = [{ name: "Topic", row: true }, { name: "Published", number: true },
    { name: "Dropped by the bench", number: true }, { name: "Lost on the way", number: true }];
  const rows = topics.map((topic) => ({ cells: [code(text(topic.name)), whole(topic.published),
    whole(topic.dropped), number(topic.lost) === null ? "not counted" : whole(topic.lost)] }));
  return table("Messages by topic, over all scenarios", columns, rows);
}

/** Adds how messages went from node to node, of which the model has the numbers of each scenario. */
function completeFlow() {
  const place = document.getElementById("measurements");
  if (place && hops.length > 0) {
    place.append(html("h3", null, "Hops, over all scenarios, in ms"),
      html("p", { class: "lead" }, "A wait is from the moment at which a message could be seen to the start of the activation that read it first. A latency is the sum of "
        + "its hops: how old each message was when it was read, and the time from there to the next message. When the vehicle reads is not recorded. "
        + "A dash stands where the model states no number, or nothing was there to be counted."),
      hopTable(), topicTable());
  }
}

function stageSection() {
  if (stages.length === 0) {
    return null;
  }
  const longest = most(stages.map((stage) => stage.milliseconds), Math.max) || 1;
  const total = stages.reduce((sum, stage) => sum + (number(stage.milliseconds) ?? 0), 0);
  const tones = { done: ["good", "Done"], unchanged: ["none", "Unchanged"], failed: ["bad", "Failed"] };
  const columns = [{ name: "Stage", row: true, width: "24%" }, { name: "Result", width: "12%", plain: true },
    { name: "Time", number: true, width: "9%", plain: true }, { name: "", width: "21%", plain: true }, { name: "Details", width: "34%", plain: true }];
  const rows = stages.map((stage) => {
    const time = number(stage.milliseconds);
    const bar = svg("svg", { class: "bar " + (text(stage.status) === "failed" ? "failed" : ""), "aria-hidden": "true" },
      svg("rect", { width: `${((100 * (time ?? 0)) / longest).toFixed(2)}%`, height: "100%", rx: 1.5 }));
    return { cells: [text(stage.title) || text(stage.name), status(...(tones[text(stage.status)] ?? ["none", text(stage.status) || "Unknown"])),
      time === null ? "\u2013" : duration(time), time === null ? "" : bar, text(stage.details)] };
  });
  return section("stages", "Stages", `${duration(total)} in all.`, table("Stages and their times", columns, rows, { stack: true }));
}

function duration(time) {
  return time < 1000 ? figure(time, 0, "ms") : figure(time / 1000, 2, "s");
}

function provenanceSection() {
  const origin = record(data.provenance);
  const models = Object.entries(record(origin.models)).map(([task, model]) => [`LLM for ${text(task)}`, text(model)]);
  const pairs = [["Tool", text(origin.tool)], ["Simulation driver", text(origin.driver)], ["Strength of requirements", text(origin.strength)], ["LLM provider", text(origin.llm)], ["Recordings", text(origin.recordings)],
    ...models, ["Confinement of components", text(origin.confinement)], ["Python", text(origin.python)], ["Java", text(origin.java)]];
  return pairs.every(([, value]) => value === "") ? null : section("provenance", "Provenance", null, figures("provenance", pairs));
}

// The whole

const whenShown = [];

function page() {
  const content = document.getElementById("content");
  const made = (id) => document.getElementById(id);
  const shown = (id) => (made(id).hidden ? null : made(id));
  completeRequirements();
  const findings = diagnosticSection();
  const sections = [errors.length > 0 ? findings : null, scenarioSection(), faultSection(), made("chain"), shown("requirements"), validationSection(),
    errors.length > 0 ? null : findings, made("measurements"), stageSection(), conversationSection(), provenanceSection()].filter(Boolean);
  const links = sections.map((one) => html("li", null, html("a", { href: "#" + one.id }, one.querySelector("h2").textContent)));
  document.querySelector("header").after(html("nav", { class: "contents", "aria-label": "Contents" }, html("ul", null, links)));
  content.replaceChildren(...sections);
  completeHead();
  completeChain();
  completeSilence();
  completeMeasurements();
  completeFlow();
  whenShown.forEach((action) => action());
}

page();
