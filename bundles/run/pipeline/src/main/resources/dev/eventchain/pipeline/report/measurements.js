// How long messages and nodes took, beside what the model has of it.

function latencyRange(measured, limit, end) {
  const at = (value) => `${(100 * Math.min(1, value / end)).toFixed(2)}%`;
  const [low, middle, high] = [measured.minimum, measured.median, measured.maximum].map(number);
  return svg("svg", { class: "ranges", "aria-hidden": "true" },
    svg("line", { class: "base", x1: 0, x2: "100%", y1: 10, y2: 10 }),
    low === null || high === null ? null : svg("line", { class: "span", x1: at(low), x2: at(high), y1: 10, y2: 10 }),
    middle === null ? null : svg("circle", { class: "median", cx: at(middle), cy: 10, r: 3.5 }),
    limit === null ? null : svg("line", { class: "limit", x1: at(limit), x2: at(limit), y1: 2, y2: 18 }));
}

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
  return table("Hops over all scenarios, times in ms", columns, rows, { dense: true });
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
