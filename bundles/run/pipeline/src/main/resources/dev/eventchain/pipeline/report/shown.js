// The values that signals had in all scenarios, and those that none of them has shown.

function shownTable(caption, all, gaps) {
  const columns = [{ name: "Signal", row: true, width: "34%" }, { name: "Values", width: "24%" },
    { name: "Most episodes", number: true, width: "14%" }, ...(gaps ? [{ name: "No scenario shows", width: "28%" }] : [])];
  const rows = all.map((signal) => ({ cells: [
    [code(text(signal.name)), html("div", { class: "small muted" }, text(signal.writer) ? `from ${text(signal.writer)}` : "from outside")],
    text(signal.shown), number(signal.episodes) === null ? "" : whole(signal.episodes),
    ...(gaps ? [list(signal.unshown).flatMap((words, index) => (index > 0 ? [html("br"), breakable(words)] : [breakable(words)]))] : [])] }));
  return table(caption, columns, rows, { stack: true });
}

function shownSection() {
  const signals = records(data.signals);
  if (signals.length === 0) {
    return null;
  }
  const open = signals.filter((signal) => list(signal.unshown).length > 0);
  const rest = signals.filter((signal) => !open.includes(signal));
  return section("signals", "What no scenario has shown",
    "Software that does it wrong would pass as well. An episode is a time in which a signal is true, or away from its value at rest; those of the scenario with the most are counted.",
    open.length > 0 ? shownTable("Signals of which scenarios show a part", open, true) : html("p", { class: "none" }, "Nothing that is looked for."),
    rest.length === 0 ? null : html("details", { class: "printed" }, html("summary", null, count(rest.length, open.length > 0 ? "other signal" : "signal")),
      shownTable("Values of all other signals", rest, false)));
}
