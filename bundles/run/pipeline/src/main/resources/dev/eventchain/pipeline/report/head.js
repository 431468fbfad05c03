// The verdict and its reasons, each told once: a scenario says what its criteria missed.

function verdictOf(project) {
  const word = text(project.verdict);
  return word === "passed" || word === "failed" ? word : "incomplete";
}

function ownSummary() {
  return scenarios.length > 0
    ? `${scenarios.length - failedScenarios.length} of ${count(scenarios.length, "scenario")} passed`
    : "No scenario was run.";
}

/** What a scenario missed first: an impact before all else, and what failed before what was not tested. */
function causeOf(scenario) {
  const missed = records(scenario.criteria).filter((criterion) => criterion.passed !== true);
  const hit = (criterion) => text(criterion.measured).startsWith("impact");
  const rank = (criterion) => (outcomeOf(criterion).tone === "bad" ? (hit(criterion) ? 0 : 1) : 2);
  const first = [...missed].sort((one, other) => rank(one) - rank(other))[0];
  return first ? [`${rank(first) < 2 ? "" : "not tested: "}${text(first.text)}: ${text(first.measured)}`, missed.length - 1] : ["", 0];
}

function scenarioReason(scenario) {
  const [cause, others] = causeOf(scenario);
  return { parts: [html("a", { href: "#" + scenarioId(scenario) }, titleOf(scenario)), cause ? ": " + cause : ""],
    rest: others > 0 ? `and ${whole(others)} more ${others === 1 ? "criterion" : "criteria"}` : "" };
}

/** The stages that did not succeed, except one that only says that scenarios failed; the scenarios; and what else is wrong. */
function reasons() {
  const stuck = stages.filter((stage) => ["failed", "waiting"].includes(text(stage.status)) && !(text(stage.name) === "simulate" && failedScenarios.length > 0));
  return [
    ...stuck.map((stage) => ({ parts: [html("a", { href: "#stages" }, `Stage ${text(stage.name)}`), ": " + text(stage.details)] })),
    ...failedScenarios.map(scenarioReason),
    ...errors.filter((error) => !isOfCriterion(error)).map((error) => ({ parts: [html("a", { href: "#diagnostics" }, code(text(error.id))), ": " + text(error.message)] })),
  ];
}

function reasonItem(reason) {
  return html("li", null, sign("bad"), html("span", null, reason.parts), reason.rest ? html("span", { class: "muted" }, reason.rest) : null);
}

function reasonList() {
  const all = reasons();
  const rest = all.slice(12);
  return all.length === 0 ? [] : [
    html("ul", { class: "reasons", "aria-label": "Why" }, all.slice(0, 12).map(reasonItem)),
    rest.length === 0 ? null : html("details", null, html("summary", null, `${rest.length} more`), html("ul", { class: "reasons" }, rest.map(reasonItem)))].filter(Boolean);
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
  box.append(...(verdict === "passed" ? [] : reasonList()));
  box.after(keyFigures());
}
