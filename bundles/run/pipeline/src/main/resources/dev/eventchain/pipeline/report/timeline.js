// What happened in a scenario of a storyboard, a row for each event, over the time of its plots.

const ROW = { top: 20, height: 34, title: 13, bar: 20, thick: 6, axis: 20 };

/** So many times of an event stand beside its name. */
const SPANS = 3;

/** The rows of a scenario: the times of each event, in the order in which they first happened. */
function rowsOf(scenario) {
  const rows = new Map();
  for (const each of records(scenario.happened)) {
    const start = number(each.start);
    if (start !== null) {
      const name = text(each.name);
      rows.set(name, rows.get(name) ?? { name, once: text(each.kind) !== "event", spans: [] });
      rows.get(name).spans.push({ start, end: number(each.end) });
    }
  }
  return [...rows.values()];
}

/** When something happened, in words. */
function spokenSpan(row, span) {
  const at = figure(span.start, 2, "s");
  if (row.once || span.end === span.start) {
    return at;
  }
  return span.end === null ? `from ${at} on` : `${at} to ${figure(span.end, 2, "s")}`;
}

function spokenRow(row) {
  return row.spans.map((span) => spokenSpan(row, span)).join(", ");
}

/** A bar for what lasts, to the end of the run if it did not end before, and a mark for what does not. */
function drawSpan(row, span, frame, y, last) {
  const from = frame.toX(span.start);
  const to = frame.toX(Math.min(span.end ?? last, last));
  return row.once || to - from < 2
    ? svg("line", { class: row.once ? "once" : "span", x1: from, x2: from, y1: y - 4, y2: y + ROW.thick + 4 })
    : svg("rect", { class: span.end === null ? "span open" : "span", x: from, y, width: to - from, height: ROW.thick });
}

/** Draws the rows at a width; returns the picture and how to move its cursor. */
function drawTimeline(rows, samples, width) {
  const frame = frameOf(samples, PLOT.left, width - PLOT.right);
  const last = samples.time[samples.time.length - 1];
  const bottom = ROW.top + rows.length * ROW.height;
  const spoken = rows.map((row) => `${row.name}: ${spokenRow(row)}`).join("; ");
  const picture = svg("svg", { class: "timeline", role: "img", "aria-label": `Storyboard: ${spoken}`, viewBox: `0 0 ${width} ${bottom + ROW.axis}` },
    svg("text", { class: "title", x: frame.left, y: ROW.title }, "Storyboard"));
  frame.marks.values.forEach((mark) => {
    const x = frame.toX(mark);
    picture.append(svg("line", { class: "grid", x1: x, x2: x, y1: ROW.top, y2: bottom }));
  });
  rows.forEach((row, index) => {
    const top = ROW.top + index * ROW.height;
    picture.append(svg("text", { x: frame.left, y: top + ROW.title }, row.name),
      svg("text", { class: "value", x: frame.right, y: top + ROW.title }, row.spans.length > SPANS ? count(row.spans.length, "time") : spokenRow(row)),
      svg("line", { class: "axis", x1: frame.left, x2: frame.right, y1: top + ROW.bar + ROW.thick / 2, y2: top + ROW.bar + ROW.thick / 2 }),
      ...row.spans.map((span) => drawSpan(row, span, frame, top + ROW.bar, last)));
  });
  drawTimeAxis(picture, frame, bottom);
  const cursor = svg("line", { class: "cursor", y1: ROW.top, y2: bottom });
  picture.append(cursor);
  const move = (index) => {
    cursor.setAttribute("x1", frame.toX(samples.time[index]));
    cursor.setAttribute("x2", frame.toX(samples.time[index]));
  };
  return { picture, move };
}

/** The time line of a scenario, empty without a storyboard; `draw()` fits it to a width. */
function timelineOf(scenario, samples) {
  const rows = rowsOf(scenario);
  const element = html("div");
  let line = null;
  return {
    element,
    draw(width) {
      line = rows.length > 0 ? drawTimeline(rows, samples, width) : null;
      element.replaceChildren(...(line ? [line.picture] : []));
    },
    move(index) {
      line?.move(index);
    },
  };
}
