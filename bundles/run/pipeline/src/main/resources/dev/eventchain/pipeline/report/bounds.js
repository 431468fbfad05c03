// Upper bounds on latencies: where their time goes, beside what was measured, and what periods do to them.

/** A bar of waiting and execution, part after part, beside the limit. */
function latencyBar(before, parts, scale, maximum, label) {
  const place = (time) => Math.round((10000 * time) / scale);
  const bar = svg("svg", { class: "passage-bar", viewBox: "0 0 10000 100", preserveAspectRatio: "none", role: "img", "aria-label": label },
    svg("rect", { class: "rest", x: 0, y: 0, width: 10000, height: 100 }));
  let start = 0;
  const add = (time, kind) => {
    if (number(time) > 0) {
      bar.append(svg("rect", { class: kind, x: place(start), y: 0, width: place(time), height: 100 }));
      start += time;
    }
  };
  add(before, "waiting");
  for (const part of parts) {
    add(part.waiting, "waiting");
    add(part.execution, "execution");
  }
  if (number(maximum) !== null) {
    bar.append(svg("line", { class: "limit", x1: place(maximum), x2: place(maximum), y1: 0, y2: 100, "vector-effect": "non-scaling-stroke" }));
  }
  return bar;
}

function boundTable(latency, parts) {
  const columns = [{ name: "Component or message", row: true }, { name: "Waiting", number: true }, { name: "Execution or transport", number: true }, { name: "Share", number: true },
    { name: "Period", number: true }, { name: "Twice as often saves", number: true }, { name: "Largest period that holds", number: true }];
  const known = number(latency.maximum) !== null;
  const largest = (part) => number(part.largest) !== null ? milliseconds(part.largest)
    : known && number(part.period) !== null ? "none alone" : "\u2013";
  const rows = parts.map((part) => ({ cells: [code(text(part.component)), milliseconds(part.waiting), milliseconds(part.execution),
    figure(part.percent, 1, "%"), milliseconds(part.period), milliseconds(part.saved), largest(part)] }));
  if (latency.before > 0) {
    rows.unshift({ cells: ["before the first component", milliseconds(latency.before), "", figure((100 * latency.before) / latency.bound, 1, "%"), "", "", ""] });
  }
  return table(`Parts of the bound of ${nameOfLatency(latency)} in ms`, columns, rows);
}

function nameOfLatency(latency) {
  return text(latency.constraint) || "the whole chain";
}

/** What periods and phases do to a bound, in a sentence. */
function remedies(latency, parts) {
  const best = parts.filter((part) => number(part.saved) > 0).sort((one, other) => other.saved - one.saved)[0];
  const aligned = record(latency.aligned);
  const phases = records(aligned.releases).map((release) => `${text(release.component)} ${milliseconds(release.phase)}`).join(", ");
  return html("p", { class: "small" },
    best ? `The period of ${text(best.component)} helps most: executed twice as often, it takes ${milliseconds(best.saved)} ms off the bound. ` : "",
    number(aligned.bound) !== null && aligned.bound < latency.bound
      ? `With timers of one clock, released at ${phases} ms, the bound would be ${milliseconds(aligned.bound)} ms.` : "");
}

function boundFigure(latency) {
  const parts = records(latency.parts);
  const measured = record(latency.measured);
  const found = records(measured.parts);
  const title = html("strong", null, nameOfLatency(latency));
  const ends = [text(latency.type), " from what comes to ", code(text(latency.first)), " to what ", code(text(latency.last)), " makes of it"];
  if (number(latency.bound) === null) {
    return html("figure", { class: "passage" }, html("figcaption", null, title, ": ", ends, `, no bound is known; by the times that are known, at least ${milliseconds(latency.known)} ms`),
      html("ul", null, list(latency.unknown).map((reason) => html("li", null, text(reason)))));
  }
  const scale = 1.02 * Math.max(latency.bound, number(latency.maximum) ?? 0, number(measured.longest) ?? 0);
  const over = number(latency.maximum) !== null && latency.bound > latency.maximum;
  return html("figure", { class: "passage" },
    html("figcaption", null, title, ": ", ends, ", at most ", html("strong", null, milliseconds(latency.bound), " ms"),
      number(latency.maximum) === null ? "" : ` of ${milliseconds(latency.maximum)} ms allowed`,
      over ? [", ", html("strong", { class: "bad" }, "some phases exceed it")] : "",
      number(measured.longest) === null ? ", not measured" : [`, up to ${milliseconds(measured.longest)} ms measured in `, html("em", null, text(measured.scenario))]),
    latencyBar(latency.before, parts, scale, latency.maximum, `Bound of ${milliseconds(latency.bound)} ms, part by part`),
    found.length > 0 ? latencyBar(0, found, scale, latency.maximum, `Measured: ${milliseconds(measured.longest)} ms, part by part`) : null,
    boundTable(latency, parts),
    remedies(latency, parts),
    html("p", { class: "small muted" }, text(latency.assumes)));
}

/** What is left of each scenario with the latency at its bound, beside what the measured one left. */
function delayedTable(latency) {
  const columns = [{ name: "Scenario", row: true }, { name: "Later by", number: true }, { name: "Way at its speed", number: true }, { name: "Result" },
    { name: "Margins, as measured and at the bound" }];
  const margin = (one) => html("div", { class: "small" }, `${text(one.criterion)}: ${figure(one.before, 2, text(one.unit))} \u2192 `,
    number(one.after) === null ? "none" : figure(one.after, 2, text(one.unit)));
  const rows = records(latency.delayed).map((one) => {
    const known = scenarios.find((scenario) => text(scenario.name) === text(one.scenario));
    const changed = records(one.margins).filter((each) => each.before !== each.after);
    const failed = text(one.outcome) !== "passed";
    return { cells: [known ? titleOf(known) : text(one.scenario), `${milliseconds(one.delay)} ms`,
      figure(one.metres, 2, "m"), failed ? html("strong", { class: "bad" }, `${text(one.outcome)}: ${text(one.reason)}`) : "passed",
      changed.length > 0 ? changed.map(margin) : "unchanged"] };
  });
  return table(`Scenarios with a latency of ${milliseconds(latency.known)} ms`, columns, rows);
}

function completeDelays(latency) {
  return records(latency.delayed).length === 0 ? []
    : [html("h3", null, `Scenarios with a latency of ${milliseconds(latency.known)} ms`),
      html("p", { class: "lead" }, "Each scenario was driven again with messages from the world that come later, by what the bound of the whole chain is above the longest latency that was measured in it. "
        + "The way is that of the vehicle at its highest speed in that time."),
      delayedTable(latency)];
}

function processorTable(processor) {
  const columns = [{ name: "Component", row: true }, { name: "Priority", number: true }, { name: "Utilisation", number: true }, { name: "Response time in ms, at most", number: true }];
  const share = (one) => number(one.percent) === null ? "not known" : figure(one.percent, 1, "%");
  const response = (one) => number(one.response) !== null ? milliseconds(one.response)
    : one.tardy === true ? html("strong", { class: "bad" }, "may be after its period") : "not known";
  const rows = records(processor.components).map((one) => ({ cells: [code(text(one.component)), number(one.priority) === null ? "\u2013" : String(one.priority), share(one), response(one)] }));
  return table(`Components on ${text(processor.name)}`, columns, rows);
}

function processorFigure(processor) {
  const used = number(processor.percent) === null ? `at least ${figure(processor.known, 1, "%")} used, the rest is not known` : `${figure(processor.percent, 1, "%")} used`;
  return html("figure", { class: "passage" },
    html("figcaption", null, html("strong", null, text(processor.name)), ": ", processor.known > 100 ? html("strong", { class: "bad" }, used) : used,
      processor.ordered === true ? "" : ", any component may go first"),
    processorTable(processor));
}

function completeProcessors(place) {
  const all = records(data.processors);
  if (all.length > 0) {
    place.append(html("h3", null, "Processors"),
      html("p", { class: "lead" }, "What the components on each processor need at most, by the worst-case execution times and frequencies of the model. In the simulation each has a processor of its own."),
      ...all.map(processorFigure));
  }
}

/** Adds bounds and processors, which are not measured. */
function completeBounds() {
  const place = document.getElementById("measurements");
  const all = records(data.latencies);
  if (place && all.length > 0) {
    place.append(html("h3", null, "Bounds on latencies, in ms"),
      html("p", { class: "lead" }, "What the periods and the worst-case execution and transport times of the model make possible, for all phases of the timers. The second bar is what the longest measured time consists of; "
        + "a simulation has some phases, and may stay below. The largest period that holds is that of one component while the others keep theirs."),
      ...all.map(boundFigure), ...all.flatMap(completeDelays));
  }
  if (place) {
    completeProcessors(place);
  }
}
