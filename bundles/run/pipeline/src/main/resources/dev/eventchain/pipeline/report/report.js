// The data and the page: what it shows besides the model, in order.

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

/** Whether a finding says of a criterion what its scenario says. */
function isOfCriterion(diagnostic) {
  return ["simulation.criterion.failed", "simulation.criterion.untested"].includes(text(diagnostic.id)) && scenarios.length > 0;
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

// Event chain

/** Draws the picture into its place. */
function completeChain() {
  const holder = document.querySelector("#chain .chain");
  if (!holder) {
    return;
  }
  drawChain(record(data.chain), holder);
  const nodesOfModel = document.querySelector("#chain table");
  const folded = html("details", { class: "printed" }, html("summary", null, "What each node does, its inputs and outputs"));
  nodesOfModel.before(folded);
  folded.append(nodesOfModel);
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

function silentNodes() {
  return diagnostics.filter((diagnostic) => text(diagnostic.id) === "simulation.node.silent");
}

/** What never came, before the picture of what should have brought it. */
function completeSilence() {
  const silent = silentNodes();
  const lead = document.querySelector("#chain .lead");
  if (lead && silent.length > 0) {
    lead.after(html("div", { class: "notice" }, html("strong", null, "Never received"),
      html("ul", null, silent.map((diagnostic) => html("li", null, text(diagnostic.message))))));
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
  const own = diagnostics.filter((diagnostic) => !isOfCriterion(diagnostic));
  const told = diagnostics.filter(isOfCriterion);
  const rest = own.slice(10);
  const folded = (words, all) => (all.length === 0 ? null : html("details", null, html("summary", null, words), html("ol", { class: "diagnostics" }, all.map(diagnosticItem))));
  return section("diagnostics", "Diagnostics", null,
    own.length > 0 ? html("ol", { class: "diagnostics first" }, own.slice(0, 10).map(diagnosticItem)) : told.length > 0 ? null : html("p", { class: "none" }, "None."),
    folded(`${rest.length} more`, rest), folded(`${count(told.length, "finding")} already shown with their scenarios`, told));
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
      time === null || stage.status === "not run" ? "\u2013" : duration(time), time === null ? "" : bar, text(stage.details)] };
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

/** Whether a section shows a part of what went wrong. */
function isToldThere(id) {
  return (id === "chain" && silentNodes().length > 0) || (id === "validation" && validation.some((one) => one.violations !== 0 || !(one.evaluations > 0)))
    || (id === "measurements" && document.querySelector("#measurements .bad") !== null)
    || (id === "stages" && stages.some((stage) => ["failed", "waiting"].includes(text(stage.status)) && text(stage.name) !== "simulate"));
}

/** Folds a section to its heading: whoever looks for a failure scrolls past it. */
function foldSection(id) {
  const found = document.getElementById(id);
  if (found) {
    const heading = found.querySelector("h2");
    const rest = [...found.children].filter((child) => child !== heading);
    found.append(html("details", { class: "folded" }, html("summary", null, heading), rest));
  }
}

/** Opens what folds the place that the address names. */
function unfold() {
  const target = document.getElementById(location.hash.slice(1));
  const inside = target?.matches("section") ? target.querySelector(":scope > details") : target?.closest("details");
  for (let each = inside; each; each = each.parentElement.closest("details")) {
    each.open = true;
  }
}

function page() {
  const content = document.getElementById("content");
  const made = (id) => document.getElementById(id);
  const shown = (id) => (made(id).hidden ? null : made(id));
  completeRequirements();
  const findings = diagnosticSection();
  const other = errors.some((error) => !isOfCriterion(error));
  const sections = [other ? findings : null, scenarioSection(), faultSection(), made("chain"), shown("requirements"), shownSection(), validationSection(),
    other ? null : findings, made("measurements"), stageSection(), retrievedSection(), conversationSection(), provenanceSection()].filter(Boolean);
  const links = sections.map((one) => html("li", null, html("a", { href: "#" + one.id }, one.querySelector("h2").textContent)));
  document.querySelector("header").after(html("nav", { class: "contents", "aria-label": "Contents" }, html("ul", null, links)));
  content.replaceChildren(...sections);
  completeHead();
  completeChain();
  completeSilence();
  completeMeasurements();
  completeBounds();
  completeFlow();
  if (verdictOf(record(data.project)) !== "passed") {
    ["chain", "signals", "validation", "measurements", "stages", "retrieved", "conversations", "provenance"].filter((id) => !isToldThere(id)).forEach(foldSection);
  }
  addEventListener("hashchange", unfold);
  addEventListener("beforeprint", () => document.querySelectorAll("details.printed, details.folded").forEach((one) => (one.open = true)));
  unfold();
  whenShown.forEach((action) => action());
}

page();
