// The faults: what the vehicle did with each of them, and by what it was detected.

const MEANS = { software: "by the software", check: "by a check of the simulation only", failure: "by a failure" };

/** What a fault came to: one that nothing is expected of is neither good nor bad, one without effect says nothing. */
function faultOutcome(fault) {
  if (fault.effective !== true) {
    return ["warn", "No effect"];
  }
  if (fault.judged !== true) {
    return ["none", "Not judged"];
  }
  const { tone, word } = outcomeOf(fault);
  return [tone, word[0].toUpperCase() + word.slice(1)];
}

function faultName(fault, index) {
  return [html("span", { id: "fault-" + (index + 1) }, code(text(fault.name))), html("div", { class: "small muted" }, text(fault.injected)),
    html("div", { class: "small muted" }, faultScenario(fault))];
}

function faultScenario(fault) {
  const scenario = scenarios.find((one) => text(one.name) === text(fault.scenario));
  return scenario ? html("a", { href: "#" + scenarioId(scenario) }, titleOf(scenario)) : code(text(fault.scenario));
}

/** What the vehicle did, beside what it did without the fault. */
function faultDrive(fault) {
  if (fault.effective !== true) {
    return text(fault.effect);
  }
  const did = text(record(fault.vehicle).did);
  const without = text(record(fault.without).did);
  const deviation = record(fault.deviation);
  const distance = number(deviation.distance) ?? 0;
  const moved = distance < 0.001 ? "Moved as without it."
    : `Up to ${figure(distance, 2, "m")} from where it was without it, after ${figure(deviation.time, 2, "s")}.`;
  return [text(fault.ended) ? html("div", null, html("strong", null, "The run was ended: "), text(fault.ended)) : null, html("div", null, did),
    html("div", { class: "small muted" }, did === without ? null : `Without it: ${without}. `, moved),
    text(fault.effect) ? html("div", { class: "small muted" }, text(fault.effect)) : null];
}

/** How many of the scenario's criteria hold; of the others the first ones, and the rest for those who ask. */
function faultCriteria(fault) {
  const own = records(fault.criteria);
  const missed = own.filter((criterion) => criterion.passed !== true);
  const shown = missed.slice(0, 2);
  const rest = missed.slice(2);
  const item = (criterion) => html("li", null, `${criterion.tested === false ? "not tested" : "not met"}: ${text(criterion.text)}: `,
    html("span", { class: "muted" }, text(criterion.measured)));
  return own.length === 0 ? "" : [`${own.length - missed.length} of ${own.length} hold`, html("ul", { class: "small" }, shown.map(item)),
    rest.length === 0 ? null : html("details", null,
      html("summary", { class: "small" }, `${rest.length} more`),
      html("ul", { class: "small" }, rest.map(item)))];
}

function faultDetection(detection) {
  const time = number(detection.time);
  const when = time === null ? "" : ` after ${figure(time, 2, "s")}`;
  return html("li", null, html("strong", null, `${MEANS[text(detection.by)] ?? ""}${when}`), ": ", text(detection.text), " ",
    html("span", { class: "small muted" }, code(text(detection.id))));
}

/** By what it was detected; the first of all, and the rest for those who ask. */
function faultDetections(fault) {
  const all = records(fault.detections);
  if (fault.effective !== true) {
    return "";
  }
  if (all.length === 0) {
    return html("strong", null, "Not detected");
  }
  const rest = all.slice(1);
  return [html("ul", null, faultDetection(all[0])), rest.length === 0 ? null
    : html("details", null, html("summary", { class: "small" }, `${rest.length} more`), html("ul", null, rest.map(faultDetection)))];
}

function faultExpected(fault) {
  const missed = records(fault.expected).filter((criterion) => criterion.passed !== true);
  return [status(...faultOutcome(fault)), fault.effective !== true ? null : html("ul", { class: "small" }, missed.map((criterion) =>
    html("li", null, `${criterion.tested === false ? "not tested" : "expected"}: ${text(criterion.text)}; ${text(criterion.measured)}`)))];
}

function faultSection() {
  if (faults.length === 0) {
    return null;
  }
  const columns = [{ name: "Fault", row: true, width: "20%" }, { name: "The vehicle", width: "21%" },
    { name: "The scenario's own criteria", width: "28%" }, { name: "Detected", width: "20%" }, { name: "Result", width: "11%", plain: true }];
  const rows = faults.map((fault, index) => ({ cells: [faultName(fault, index), faultDrive(fault), faultCriteria(fault),
    faultDetections(fault), faultExpected(fault)] }));
  return section("faults", "Faults",
    "Each fault alone, in a run of its scenario beside the one without it. A fault is judged by what its file expects; the scenario's own criteria are only told.",
    table("Faults", columns, rows, { stack: true }));
}
