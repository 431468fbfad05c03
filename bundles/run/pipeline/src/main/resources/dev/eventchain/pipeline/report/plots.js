// The plots of a scenario: one picture with a panel for each series over one time axis.

const PLOT = { left: 40, right: 10, top: 16, title: 20, gap: 10, axis: 20, height: 64, fallback: 680, between: 14, narrowest: 340, value: 56, letter: 7 };

/** Values beyond so many times the usual one and all limits are cut off: they would hide all others. */
const CUT = 4;

/** The smallest range of a scale, as a part of the largest value. */
const LEAST_RANGE = 0.05;

/** The panels of a scenario, one for each signal, with the limits that its criteria set. */
function panelsOf(scenario) {
  return records(record(scenario.series).signals).map((signal) => {
    const name = text(signal.name);
    const unit = text(signal.unit) === "1" ? "" : text(signal.unit);
    const limits = records(scenario.criteria).flatMap((criterion) => records(criterion.limits))
      .filter((limit) => text(limit.signal) === name).map((limit) => number(limit.value)).filter((value) => value !== null);
    const earlier = records(record(record(scenario.before).series).signals).find((each) => text(each.name) === name);
    const names = new Map(records(signal.names).map((each) => [number(each.value), text(each.name)]));
    return { name, unit, names, before: earlier && Array.isArray(earlier.values) ? earlier.values.map(number) : null, values: Array.isArray(signal.values) ? signal.values.map(number) : [], limits: [...new Set(limits)], absent: text(signal.absent) };
  });
}

/** The samples with a time, each series as long as the time and null where it has no number. */
function samplesOf(scenario) {
  const times = Array.isArray(record(scenario.series).time) ? scenario.series.time.map(number) : [];
  const kept = times.map((time, index) => index).filter((index) => times[index] !== null);
  const panels = panelsOf(scenario).map((panel) => {
    const values = kept.map((index) => panel.values[index] ?? null);
    return { ...panel, values, named: areNames(panel, values), ceiling: ceilingOf(values, panel.limits), digits: digitsOf(values) };
  });
  const before = record(record(scenario.before).series).time;
  return { time: kept.map((index) => times[index]), before: Array.isArray(before) ? before.map((time) => number(time) ?? 0) : null,
    panels: panels.filter((panel) => !isSteady(panel.values)), steady: panels.filter((panel) => isSteady(panel.values)) };
}

/** Returns whether most values have names: a speed with a name for "not available" is still a number. */
function areNames(panel, values) {
  const distinct = [...new Set(values.filter((value) => value !== null))];
  return 2 * distinct.filter((value) => panel.names.has(value)).length > distinct.length;
}

/** What never changes has no plot. */
function steadyList(panels) {
  const item = (panel) => {
    const range = extent(panel.values);
    return html("li", null, html("span", null, panel.name), html("span", { class: "muted" }, range ? reading(panel, range.low) : panel.absent || "no values"));
  };
  return panels.length === 0 ? null : html("details", null, html("summary", null, count(panels.length, "constant signal")),
    html("ul", { class: "steady" }, panels.map(item)));
}

/** Whether a series is a truth value, which changes at once. */
function isTruth(values) {
  return values.every((value) => value === null || value === 0 || value === 1);
}

/** Whether a series has one value only, or none. */
function isSteady(values) {
  const range = extent(values);
  return range === null || range.low === range.high;
}

/** Where a panel is cut off; null if all values have room. */
function ceilingOf(values, limits) {
  const sizes = values.filter((value) => value !== null).sort((one, other) => one - other);
  const high = sizes[sizes.length - 1];
  const usual = CUT * Math.max(sizes[sizes.length >> 1] ?? 0, ...limits);
  return usual > 0 && high > usual ? usual : null;
}

/** Digits that tell the values apart. */
function digitsOf(values) {
  const size = Math.max(0, ...values.filter((value) => value !== null).map(Math.abs));
  return size >= 1000 ? 0 : size >= 100 ? 1 : 2;
}

/** Two to five round values from bottom to top. */
function ticks(bottom, top, atMost) {
  const rough = (top - bottom) / atMost;
  const power = 10 ** Math.floor(Math.log10(rough));
  const steps = [0.2, 0.5, 1, 2, 5, 10].map((factor) => factor * power);
  let index = steps.findIndex((step) => step >= rough * 0.999);
  if (index > 0 && multiples(bottom, top, steps[index]).length < 2) {
    index--; // three of the next finer ones fit: a single label gives no scale
  }
  return { values: multiples(bottom, top, steps[index]), digits: Math.max(0, -Math.floor(Math.log10(steps[index]) + 1e-9)) };
}

function multiples(bottom, top, step) {
  const result = [];
  for (let value = Math.ceil(bottom / step - 1e-9) * step; value <= top + step * 1e-6; value += step) {
    result.push(Math.abs(value) < step * 1e-9 ? 0 : value);
  }
  return result;
}

function extent(values) {
  let low = Infinity;
  let high = -Infinity;
  for (const value of values) {
    if (value !== null) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  }
  return low > high ? null : { low, high };
}

/** The scale of a panel: its values and limits; noise on something that hardly changes does not fill it. */
function domain(panel, range) {
  const low = Math.min(range.low, ...panel.limits);
  const high = panel.ceiling ?? Math.max(range.high, ...panel.limits);
  const missing = Math.max(0, LEAST_RANGE * Math.max(Math.abs(low), Math.abs(high)) - (high - low)) / 2;
  return { low: low - missing, high: high + missing };
}

/** At most four points in a pixel column, its extremes among them: a long series costs no more than the screen is wide. */
function thin(points) {
  const kept = [];
  for (let start = 0, end = 0; start < points.length; start = end) {
    const column = Math.floor(points[start].x);
    let [top, bottom] = [start, start];
    for (end = start; end < points.length && Math.floor(points[end].x) === column; end++) {
      top = points[end].y < points[top].y ? end : top;
      bottom = points[end].y > points[bottom].y ? end : bottom;
    }
    const chosen = new Set([start, Math.min(top, bottom), Math.max(top, bottom), end - 1]);
    chosen.forEach((index) => kept.push(points[index]));
  }
  return kept;
}

/** The stretches of a series without a gap, as points on the screen. */
function stretches(times, values, toX, toY) {
  const result = [];
  let current = null;
  values.forEach((value, index) => {
    if (value === null) {
      current = null;
      return;
    }
    if (current === null) {
      current = [];
      result.push(current);
    }
    current.push({ x: toX(times[index]), y: toY(value) });
  });
  return result.map(thin);
}

/** A path through points, in steps where what it shows changes at once. */
function pathOf(points, inSteps = false) {
  const at = (value) => value.toFixed(1);
  return points.map((point, index) => (index === 0 ? `M${at(point.x)} ${at(point.y)}` : inSteps ? `H${at(point.x)}V${at(point.y)}` : `L${at(point.x)} ${at(point.y)}`)).join("")
    + (points.length === 1 ? "h0.5" : "");
}

/** Where the cursor stands at first: where the first criterion is missed, else where one is decided, else at the end. */
function instantOfInterest(samples, scenario) {
  const decided = records(scenario.criteria).map((criterion) => ({ criterion, time: number(record(criterion.margin).time) }))
    .filter((one) => one.time !== null && one.time > 0);
  const first = decided.find((one) => one.criterion.passed !== true) ?? decided[0];
  return first ? nearest(samples.time, first.time) : samples.time.length - 1;
}

function nearest(times, time) {
  let [low, high] = [0, times.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return time - times[low] <= times[high] - time ? low : high;
}

function reading(panel, value) {
  return value === null ? "\u2013" : panel.names.get(value) ?? figure(value, panel.digits, panel.unit);
}

function spokenSeries(panel, values, range) {
  if (!range) {
    return `${panel.name}: ${panel.absent || "no values"}`;
  }
  const known = values.filter((value) => value !== null);
  const first = reading(panel, known[0]);
  const last = reading(panel, known[known.length - 1]);
  return `${panel.name} over time: starts at ${first}, ends at ${last}, `
    + `smallest ${reading(panel, range.low)}, largest ${reading(panel, range.high)}`;
}

/** Returns the name and unit of a panel, of a long name its end: the names of topics begin alike. */
function fitting(panel, width) {
  const unit = panel.unit ? `, ${panel.unit}` : "";
  const most = Math.floor((width - PLOT.value) / PLOT.letter) - unit.length;
  return (panel.name.length > most ? "\u2026" + panel.name.slice(panel.name.length - most + 1) : panel.name) + unit;
}

/** One panel: its group, the text that holds the cursor's value, and the point on the curve. */
function drawPanel(panel, samples, top, frame) {
  const values = panel.values;
  const range = extent(values);
  const value = svg("text", { class: "value", x: frame.right, y: top + 13 });
  const group = svg("g", { role: "img", "aria-label": spokenSeries(panel, values, range) },
    svg("text", { class: "title", x: frame.left, y: top + 13 }, fitting(panel, frame.right - frame.left), svg("title", null, panel.name)), value);
  const scale = domain(panel, range);
  const base = top + PLOT.title + PLOT.height;
  const toY = (amount) => base - ((Math.min(amount, scale.high + 20 * (scale.high - scale.low)) - scale.low) / (scale.high - scale.low)) * PLOT.height;
  drawScale(group, panel, scale, toY, frame, top);
  const point = svg("circle", { class: "point", r: 3.5 });
  const cursor = svg("line", { class: "cursor", y1: top + PLOT.title, y2: base });
  group.append(drawCurve(samples, panel, toY, frame, top), ...drawThresholds(panel, scale, toY, frame),
    ...drawEvents(frame, top + PLOT.title, base), cursor, point);
  return {
    group,
    update(index) {
      const current = values[index];
      value.textContent = reading(panel, current);
      cursor.setAttribute("x1", frame.toX(samples.time[index]));
      cursor.setAttribute("x2", frame.toX(samples.time[index]));
      const shown = current !== null && current <= scale.high;
      point.setAttribute("visibility", shown ? "visible" : "hidden");
      if (shown) {
        point.setAttribute("cx", frame.toX(samples.time[index]));
        point.setAttribute("cy", toY(current));
      }
    },
  };
}

function drawScale(group, panel, scale, toY, frame, top) {
  for (const mark of frame.marks.values) {
    const x = frame.toX(mark);
    group.append(svg("line", { class: "grid", x1: x, x2: x, y1: top + PLOT.title, y2: top + PLOT.title + PLOT.height }));
  }
  if (panel.named) {
    return; // the value above the plot has its name, for which there is no room here
  }
  const marks = ticks(scale.low, scale.high, 3);
  for (const mark of marks.values) {
    const y = Math.round(toY(mark)) + 0.5;
    group.append(
      svg("line", { class: mark === 0 ? "axis" : "grid", x1: frame.left, x2: frame.right, y1: y, y2: y }),
      svg("text", { class: "tick", x: frame.left - 6, y: y + 3.5 }, figure(mark, marks.digits)));
  }
}

/** The curve, cut off at the edges of its panel. */
function drawCurve(samples, panel, toY, frame, top) {
  const { values, before } = panel;
  const [x, y, width, height] = [frame.left, top + PLOT.title - 1, frame.right - frame.left, PLOT.height + 2];
  const cut = svg("svg", { x, y, width, height, viewBox: `${x} ${y} ${width} ${height}`, overflow: "hidden" });
  if (before !== null && samples.before !== null) {
    for (const points of stretches(samples.before, before.slice(0, samples.before.length), frame.toX, toY)) {
      cut.append(svg("path", { class: "before", d: pathOf(points) }));
    }
  }
  for (const points of stretches(samples.time, values, frame.toX, toY)) {
    cut.append(svg("path", { class: "curve", d: pathOf(points, panel.named || isTruth(values)) }));
  }
  return cut;
}

/** What the criteria compare the signal with, as lines. */
function drawThresholds(panel, scale, toY, frame) {
  return panel.limits.filter((limit) => limit >= scale.low && limit <= scale.high).flatMap((limit) => {
    const y = Math.round(toY(limit)) + 0.5;
    return [
      svg("line", { class: "threshold", x1: frame.left, x2: frame.right, y1: y, y2: y }),
      svg("text", { class: "threshold-label", x: frame.right + 5, y: y + 3.5 }, limitText(limit)),
    ];
  });
}

function limitText(limit) {
  return String(Number(limit.toPrecision(3)));
}

/** What happened once, such as an impact: a line at its moment. */
function drawEvents(frame, top, base) {
  return frame.events.map((event) => svg("line", { class: "event", x1: frame.toX(event.time), x2: frame.toX(event.time), y1: top, y2: base }));
}

/** What a scenario has of one moment only. */
function eventsOf(scenario) {
  return records(scenario.measurements).filter((one) => text(one.statistic) === "FINAL" && number(one.time) !== null);
}

function drawTimeAxis(picture, frame, bottom) {
  frame.marks.values.forEach((mark, index) => {
    const unit = index === frame.marks.values.length - 1 ? "s" : "";
    const x = Math.min(frame.toX(mark), frame.right - 6);
    picture.append(svg("text", { class: "time", x, y: bottom + 15 }, figure(mark, frame.marks.digits, unit)));
  });
}

/** The frames of the columns beside each other; their right margin has room for the longest limit. */
function framesOf(samples, width) {
  const columns = samples.panels.length > 1 && width >= 2 * PLOT.narrowest + PLOT.between ? 2 : 1;
  const wide = (width - (columns - 1) * PLOT.between) / columns;
  const margin = PLOT.right + 7 * Math.max(0, ...samples.panels.flatMap((panel) => panel.limits).map((limit) => limitText(limit).length));
  return Array.from({ length: columns }, (_, index) => frameOf(samples, index * (wide + PLOT.between) + PLOT.left, index * (wide + PLOT.between) + wide - margin));
}

function frameOf(samples, left, right) {
  const [first, last] = [samples.time[0], samples.time[samples.time.length - 1]];
  const seconds = last > first ? last - first : 1;
  return {
    left,
    right,
    marks: ticks(first, first + seconds, right - left < 420 ? 4 : 8),
    toX: (time) => left + ((time - first) / seconds) * (right - left),
    toTime: (x) => first + ((x - left) / (right - left)) * seconds,
  };
}

/** Draws all panels at a width and returns the picture and how to move its cursors. */
function drawPicture(samples, scenario, width) {
  const events = eventsOf(scenario);
  const frames = framesOf(samples, width).map((frame) => ({ ...frame, events }));
  const picture = svg("svg", { role: "group", "aria-label": "Plots over time" });
  const rows = Math.ceil(samples.panels.length / frames.length);
  const height = PLOT.title + PLOT.height + PLOT.gap;
  const panels = samples.panels.map((panel, index) => drawPanel(panel, samples, PLOT.top + (index % rows) * height, frames[Math.floor(index / rows)]));
  panels.forEach((panel) => picture.append(panel.group));
  const bottom = PLOT.top + rows * height - PLOT.gap;
  const instants = frames.map((frame) => {
    drawTimeAxis(picture, frame, bottom);
    const instant = svg("text", { class: "instant", y: PLOT.top - 4 });
    picture.append(instant);
    return instant;
  });
  picture.setAttribute("viewBox", `0 0 ${width} ${bottom + PLOT.axis}`);
  const move = (index) => {
    frames.forEach((frame, column) => {
      const x = frame.toX(samples.time[index]);
      instants[column].setAttribute("x", Math.max(frame.left + 14, Math.min(frame.right - 14, x)));
      instants[column].textContent = figure(samples.time[index], 2, "s");
    });
    panels.forEach((panel) => panel.update(index));
  };
  return { picture, move, toTime: (x) => (frames.findLast((frame) => x >= frame.left - PLOT.left) ?? frames[0]).toTime(x) };
}

/** The plots of a scenario with their time control; `draw()` fits them to the place they have. */
function plotsOf(scenario) {
  const samples = samplesOf(scenario);
  if (samples.time.length === 0) {
    return { element: html("p", { class: "none plots" }, "No series was recorded."), draw() {} };
  }
  let picture = null;
  let above = null;
  let index = instantOfInterest(samples, scenario);
  const scene = sceneOf(scenario, samples);
  const storyboard = timelineOf(scenario, samples);
  const road = html("div");
  const holder = html("div");
  const range = html("input", {
    type: "range", min: 0, max: samples.time.length - 1, step: 1, value: index, "aria-label": "Time of the readings",
  });
  const show = (next) => {
    index = next;
    range.value = String(index);
    range.setAttribute("aria-valuetext", spokenInstant(samples, index));
    picture?.move(index);
    above?.move(index);
    storyboard.move(index);
  };
  const play = playButton(samples, () => index, show);
  const pick = (next) => {
    play.stop();
    show(next);
  };
  range.addEventListener("input", () => pick(Number(range.value)));
  const draw = () => {
    const width = Math.round(holder.clientWidth) || PLOT.fallback;
    if (picture?.width === width) {
      return;
    }
    picture = { ...drawPicture(samples, scenario, width), width };
    above = scene ? drawScene(scene, samples, width) : null;
    road.replaceChildren(...(above ? [above.picture] : []));
    storyboard.draw(width);
    const follow = (event) => {
      const box = picture.picture.getBoundingClientRect();
      pick(nearest(samples.time, picture.toTime(((event.clientX - box.left) / box.width) * width)));
    };
    picture.picture.addEventListener("pointermove", follow);
    picture.picture.addEventListener("pointerdown", follow);
    holder.replaceChildren(picture.picture);
    show(index);
  };
  new ResizeObserver(() => holder.clientWidth > 0 && draw()).observe(holder);
  const controls = html("div", { class: "controls" }, play.button, range);
  const element = html("figure", { class: "plots" }, road, controls, storyboard.element, holder, captionOf(samples, scenario), steadyList(samples.steady));
  return { element, draw };
}

function spokenInstant(samples, index) {
  const readings = samples.panels.filter((panel) => panel.values[index] !== null)
    .map((panel) => `${panel.name} ${reading(panel, panel.values[index])}`);
  return [figure(samples.time[index], 2, "s"), ...readings].join(", ");
}

function captionOf(samples, scenario) {
  const cut = samples.panels.filter((panel) => panel.ceiling !== null).map((panel) => panel.name);
  const events = eventsOf(scenario).map((event) => `${text(event.name)} ${amount(event.value, event.unit)} after ${figure(event.time, 2, "s")}`);
  return html("figcaption", null,
    events.length > 0 ? `Line: ${events.join(", ")}. ` : "",
    samples.panels.some((panel) => panel.limits.length > 0) ? "Dashed: limits of the criteria. " : "",
    samples.before !== null ? "Grey: the run that this one is compared with. " : "",
    cut.length > 0 ? `Cut off at the top: ${cut.join(", ")}. ` : "",
    "The value above each plot belongs to the time of the cursor.");
}
