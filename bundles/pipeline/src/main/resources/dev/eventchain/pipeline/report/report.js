// The page: verdict, scenarios, chain, requirements, validation, findings, times, origin.

const data = record(JSON.parse(document.getElementById("data").textContent));
const scenarios = records(data.scenarios);
const requirements = records(data.requirements);
const validation = records(data.validation);
const stages = records(data.stages);
const diagnostics = sortedDiagnostics(records(data.diagnostics));
const nodes = records(data.nodes);
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
  const result = stages.filter((stage) => text(stage.status) === "failed")
    .map((stage) => [html("a", { href: "#stages" }, `Stage ${text(stage.name)}`), detailOf(stage.details)]);
  for (const scenario of failedScenarios) {
    const missed = records(scenario.criteria).filter((criterion) => criterion.passed !== true)
      .map((criterion) => text(criterion.text) + (text(criterion.measured) ? ` (${text(criterion.measured)})` : ""));
    result.push([html("a", { href: "#" + scenarioId(scenario) }, titleOf(scenario)), detailOf(missed.join("; "), "not met: ")]);
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
  const gap = most(scenarios.map((scenario) => scenario.minimalGap), Math.min);
  const impact = most(scenarios.map((scenario) => scenario.impactSpeed), Math.max);
  const slowest = most(scenarios.map((scenario) => record(scenario.latency).maximum), Math.max);
  const limit = most(scenarios.map((scenario) => scenario.latencyLimit), Math.min);
  const evaluations = most(validation.map((one) => one.evaluations), (...all) => all.reduce((sum, one) => sum + one, 0));
  const violations = most(validation.map((one) => one.violations), (...all) => all.reduce((sum, one) => sum + one, 0));
  return figures("figures", [
    ["Scenarios passed", scenarios.length ? `${scenarios.length - failedScenarios.length} of ${scenarios.length}` : null],
    ["Requirements proved", requirements.length ? `${requirements.length - unproved.length} of ${requirements.length}` : null],
    impact !== null ? ["Hardest impact", figure(impact * 3.6, 1, "km/h")] : ["Smallest gap", gap === null ? null : figure(gap, 1, "m")],
    ["Slowest brake command", slowest === null ? null : latency(slowest), limit === null ? "" : `limit ${latency(limit)}`],
    ["Constraint evaluations", evaluations === null ? null : whole(evaluations), `${whole(violations ?? 0)} violated`],
  ]);
}

function head() {
  const project = record(data.project);
  const verdict = verdictOf(project);
  const title = text(project.title) || text(project.name) || "Untitled project";
  const words = { passed: "Passed", failed: "Failed", incomplete: "Incomplete: no verdict" };
  document.title = `${words[verdict].split(":")[0]} \u00b7 ${title} \u00b7 Eventchain`;
  return html("header", null,
    html("p", { class: "kicker" }, "Eventchain report", text(project.name) ? [" \u00b7 ", text(project.name)] : null),
    html("h1", null, title),
    html("div", { class: "verdict " + verdict },
      html("p", { class: "word" }, status({ passed: "good", failed: "bad", incomplete: "warn" }[verdict], words[verdict])),
      html("p", { class: "summary" }, text(project.summary) || ownSummary()),
      verdict === "passed" ? null : reasonList()),
    keyFigures());
}

// Event chain

function dataList(entries) {
  const topics = new Map();
  records(entries).forEach((entry) => topics.set(text(entry.topic), [...(topics.get(text(entry.topic)) ?? []), entry]));
  return topics.size === 0 ? null : html("ul", null, [...topics].map(([topic, fields]) => html("li", null, code(topic),
    html("div", { class: "small muted" }, breakable([fields[0].messageType, fields[0].qos].map(text).filter(Boolean).join(" \u00b7 "))),
    html("div", { class: "small" }, breakable(fields.map(fieldText).join(", "))))));
}

function fieldText(entry) {
  const [name, field, unit] = [text(entry.name), text(entry.field), text(entry.unit)];
  return name + (field && field !== name ? ` = ${field}` : "") + (unit && unit !== "1" ? ` (${unit})` : "");
}

function chainSection() {
  const chain = record(data.chain);
  const chainNodes = records(chain.nodes);
  if (chainNodes.length === 0 && records(chain.edges).length === 0) {
    return null;
  }
  const holder = html("div", { class: "chain", tabindex: 0, role: "region", "aria-label": "Picture of the event chain" });
  whenShown.push(() => {
    let width = 0;
    new ResizeObserver(() => {
      if (holder.clientWidth !== width && holder.clientWidth > 0) {
        width = holder.clientWidth;
        drawChain(chain, holder);
      }
    }).observe(holder);
    drawChain(chain, holder);
  });
  const generated = chainNodes.filter((node) => text(node.origin) === "GENERATED").length;
  const columns = [{ name: "Node", row: true, width: "27%" }, { name: "Origin", width: "12%" },
    { name: "Inputs", width: "26%" }, { name: "Outputs", width: "26%" }, { name: "Satisfies", width: "9%" }];
  const rows = chainNodes.map((node) => ({ cells: [
    [code(text(node.name)), text(node.description) ? html("div", { class: "small muted" }, text(node.description)) : null],
    [html("span", { class: "nowrap" }, originOf(node)), number(node.frequency) === null ? null : [html("br"), figure(node.frequency, node.frequency % 1 ? 1 : 0, "Hz")]],
    dataList(node.inputs), dataList(node.outputs),
    list(node.satisfies).length === 0 ? null : html("ul", null, list(node.satisfies).map((name) => html("li", null, requirementLink(text(name))))),
  ] }));
  return section("chain", "Event chain",
    [code(text(chain.name)), `: ${count(chainNodes.length, "node")}, ${generated} of them generated from the requirements.`],
    holder, chainKey(), chainNodes.length > 0 ? table("Nodes of the event chain", columns, rows, { stack: true }) : null);
}

function chainKey() {
  const box = (name) => svg("svg", { width: 22, height: 14, "aria-hidden": "true" }, svg("rect", { class: "node " + name, x: 1, y: 1, width: 20, height: 12, rx: 2 }));
  const circle = svg("svg", { width: 12, height: 12, "aria-hidden": "true" }, svg("circle", { class: "terminal", cx: 6, cy: 6, r: 4 }));
  return html("p", { class: "chain-key" },
    html("span", null, box("generated"), "generated node"), html("span", null, box("existing"), "existing node"),
    html("span", null, circle, "topic from or to the outside"));
}

// Requirements

function requirementId(name) {
  const index = requirements.findIndex((requirement) => text(requirement.id) === name);
  return index < 0 ? null : "requirement-" + (index + 1);
}

function requirementLink(name) {
  const id = requirementId(name);
  return id ? html("a", { href: "#" + id }, name) : name;
}

function proofItem(proof) {
  const passed = proof.passed === true;
  const scenario = text(proof.kind) === "scenario" ? scenarios.find((one) => text(one.name) === text(proof.name)) : null;
  const name = scenario ? html("a", { href: "#" + scenarioId(scenario) }, titleOf(scenario)) : code(text(proof.name));
  const kind = scenario ? "" : text(proof.kind);
  return html("li", { class: "proof" }, sign(passed ? "good" : "bad"), html("span", null, passed ? unseen("passed: ") : null, name,
    html("span", { class: "small muted" }, kind ? " " + kind : ""), passed ? null : html("strong", { class: "bad" }, " failed")));
}

function requirementSection() {
  if (requirements.length === 0) {
    return null;
  }
  const columns = [{ name: "Requirement", row: true, width: "34%" }, { name: "Components", width: "17%" },
    { name: "Files", width: "21%" }, { name: "Proved by", width: "28%" }];
  const rows = requirements.map((requirement, index) => {
    const proved = requirement.proved === true;
    const proofs = records(requirement.proofs);
    return { className: proved ? null : "unproved", cells: [
      [html("span", { id: "requirement-" + (index + 1) }, text(requirement.id)), html("div", { class: "statement" }, text(requirement.text))],
      codes(requirement.components), codes(requirement.files),
      [proved ? null : status("warn", proofs.length === 0 ? "Not proved: nothing tests it" : "Not proved"),
        html("ul", null, proofs.map(proofItem))],
    ] };
  });
  const notice = unproved.length === 0 ? null : html("p", { class: "notice" },
    html("strong", null, `Not proved: ${count(unproved.length, "requirement")}. `),
    unproved.flatMap((requirement, index) => [index > 0 ? ", " : "", requirementLink(text(requirement.id))]));
  return section("requirements", "Requirements", "From each requirement to the components that meet it, their files, and what proves it.",
    notice, table("Requirements and their proofs", columns, rows, { stack: true }));
}

// Validation and findings

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

function latencyTable() {
  const measured = scenarios.filter((scenario) => number(record(scenario.latency).maximum) !== null);
  if (measured.length === 0) {
    return null;
  }
  const end = 1.12 * most(measured.flatMap((scenario) => [scenario.latency.maximum, scenario.latencyLimit]), Math.max);
  const columns = [{ name: "Scenario", row: true }, { name: "Range, median and limit" }, ...QUANTILES.map(([, name]) => ({ name, number: true })),
    { name: "Limit", number: true }, { name: "Count", number: true }];
  const rows = measured.map((scenario) => {
    const limit = number(scenario.latencyLimit);
    const over = limit !== null && scenario.latency.maximum > limit;
    return { cells: [titleOf(scenario), latencyRange(scenario.latency, limit, end),
      ...QUANTILES.map(([key]) => (key === "maximum" && over
        ? html("strong", { class: "bad" }, milliseconds(scenario.latency[key]), unseen(" over the limit")) : milliseconds(scenario.latency[key]))),
      milliseconds(limit), whole(scenario.latency.count)] };
  });
  return [html("h3", null, "From the scan to the brake command, in ms"), table("Latency of the chain in ms", columns, rows)];
}

const QUANTITIES = [["period", "Period"], ["jitter", "Jitter"], ["executionTime", "Execution time, simulated"], ["hostExecutionTime", "Execution time, this host"]];

function nodeTable() {
  const rows = nodes.flatMap((node) => {
    const known = QUANTITIES.filter(([key]) => number(record(node[key]).median) !== null || number(record(node[key]).maximum) !== null);
    return (known.length > 0 ? known : [[null, "no measurement"]]).map(([key, name], index, all) => {
      const values = record(node[key]);
      const first = index === 0;
      return { className: index < all.length - 1 ? "minor" : null, cells: [
        first ? [code(text(node.name)), html("span", { class: "small muted" }, ` ${count(number(node.activations) ?? 0, "activation")}`)] : unseen(text(node.name)),
        name, ...QUANTILES.map(([quantile]) => milliseconds(values[quantile])), whole(values.count)] };
    });
  });
  const columns = [{ name: "Node", row: true }, { name: "Quantity" }, ...QUANTILES.map(([, name]) => ({ name, number: true })), { name: "Count", number: true }];
  return nodes.length === 0 ? null : [html("h3", null, "Nodes, in ms"), table("Measurements of the nodes in ms", columns, rows)];
}

function measurementSection() {
  const content = [latencyTable(), nodeTable()].filter(Boolean);
  return content.length === 0 ? null : section("measurements", "Measurements", null, content);
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
  const pairs = [["Tool", text(origin.tool)], ["Simulation driver", text(origin.driver)], ["LLM provider", text(origin.llm)], ["Recordings", text(origin.recordings)],
    ...models, ["Confinement of components", text(origin.confinement)], ["Python", text(origin.python)], ["Java", text(origin.java)]];
  return pairs.every(([, value]) => value === "") ? null : section("provenance", "Provenance", null, figures("provenance", pairs));
}

// The whole

const whenShown = [];

function page() {
  const findings = diagnosticSection();
  const sections = [errors.length > 0 ? findings : null, scenarioSection(), chainSection(), requirementSection(), validationSection(),
    errors.length > 0 ? null : findings, measurementSection(), stageSection(), provenanceSection()].filter(Boolean);
  const links = sections.map((one) => html("li", null, html("a", { href: "#" + one.id }, one.querySelector("h2").textContent)));
  document.body.prepend(
    html("a", { class: "skip", href: "#content" }, "Skip to the content"),
    head(),
    html("nav", { class: "contents", "aria-label": "Contents" }, html("ul", null, links)),
    html("main", { id: "content" }, sections),
    html("footer", null, "Made by Eventchain. The file holds all it shows and loads nothing."));
  whenShown.forEach((action) => action());
}

page();
