// The plots of a scenario: one picture with a panel for each series over one time axis.

const TIME_TO_COLLISION_CEILING = 6;
const PLOT = { left: 40, right: 26, top: 16, title: 20, gap: 12, axis: 20, fallback: 680 };

/** `floor` is the smallest top of the scale, `ceiling` a fixed one; `scale` converts to the shown unit. */
const PANELS = [
  { key: "egoSpeed", name: "Speed", unit: "km/h", scale: 3.6, digits: 1, floor: 10, height: 70 },
  { key: "gap", name: "Gap", unit: "m", scale: 1, digits: 1, floor: 5, height: 70, absent: "no vehicle in the path" },
  { key: "timeToCollision", name: "Time to collision", unit: "s", scale: 1, digits: 2,
    ceiling: TIME_TO_COLLISION_CEILING, height: 96, thresholds: [1, 2], absent: "nothing is approached" },
  { key: "brake", name: "Brake command", unit: "", scale: 1, digits: 2, ceiling: 1, height: 56, step: true },
  { key: "deceleration", name: "Deceleration", unit: "m/s\u00b2", scale: 1, digits: 1, floor: 2, height: 70 },
];

/** The samples with a time, each series as long as the time and null where it has no number. */
function samplesOf(series) {
  const numbers = (key) => (Array.isArray(record(series)[key]) ? series[key].map(number) : []);
  const times = numbers("time");
  const kept = times.map((time, index) => index).filter((index) => times[index] !== null);
  const samples = { time: kept.map((index) => times[index]) };
  for (const panel of PANELS) {
    const values = numbers(panel.key);
    samples[panel.key] = kept.map((index) => (number(values[index]) === null ? null : values[index] * panel.scale));
  }
  return samples;
}

/** Two to five round values from bottom to top. */
function ticks(bottom, top, atMost) {
  const rough = (top - bottom) / atMost;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((factor) => factor * power >= rough * 0.999);
  const result = [];
  for (let value = Math.ceil(bottom / step - 1e-9) * step; value <= top + step * 1e-6; value += step) {
    result.push(Math.abs(value) < step * 1e-9 ? 0 : value);
  }
  return { values: result, digits: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
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

/** The scale of a panel: from 0, or below if values are, to a round value. */
function domain(panel, range) {
  if (panel.ceiling) {
    return { low: 0, high: panel.ceiling };
  }
  const high = Math.max(panel.floor, range.high * 1.05);
  const step = ticks(Math.min(0, range.low), high, 3).values;
  const unit = step.length > 1 ? step[1] - step[0] : high;
  return { low: range.low < -0.05 * high ? Math.floor(range.low / unit) * unit : 0, high: Math.ceil(high / unit - 1e-9) * unit };
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

function pathOf(points, step) {
  const at = (value) => value.toFixed(1);
  return points.map((point, index) => {
    if (index === 0) {
      return `M${at(point.x)} ${at(point.y)}`;
    }
    return step ? `H${at(point.x)}V${at(point.y)}` : `L${at(point.x)} ${at(point.y)}`;
  }).join("") + (points.length === 1 ? "h0.5" : "");
}

/** From when to when the brake is commanded. */
function brakingTimes(samples) {
  const result = [];
  samples.time.forEach((time, index) => {
    if (samples.brake[index] > 0) {
      const next = samples.time[Math.min(index + 1, samples.time.length - 1)];
      const last = result[result.length - 1];
      if (last && last.until >= time) {
        last.until = next;
      } else {
        result.push({ from: time, until: next });
      }
    }
  });
  return result;
}

/** Where the cursor stands at first: the first brake command, else the smallest gap, else the end. */
function instantOfInterest(samples) {
  const braking = samples.brake.findIndex((value) => value > 0);
  if (braking >= 0) {
    return braking;
  }
  const range = extent(samples.gap);
  return range ? samples.gap.indexOf(range.low) : samples.time.length - 1;
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
  return value === null ? "\u2013" : figure(value, panel.digits, panel.unit);
}

function spokenSeries(panel, values, range) {
  if (!range) {
    return `${panel.name}: ${panel.absent ?? "no values"}`;
  }
  const known = values.filter((value) => value !== null);
  const first = reading(panel, known[0]);
  const last = reading(panel, known[known.length - 1]);
  return `${panel.name} over time: starts at ${first}, ends at ${last}, `
    + `smallest ${reading(panel, range.low)}, largest ${reading(panel, range.high)}`;
}

/** One panel: its group, the text that holds the cursor's value, and the point on the curve. */
function drawPanel(panel, samples, top, frame) {
  const values = samples[panel.key];
  const range = extent(values);
  const value = svg("text", { class: "value", x: frame.right, y: top + 13 });
  const group = svg("g", { role: "img", "aria-label": spokenSeries(panel, values, range) },
    svg("text", { class: "title", x: frame.left, y: top + 13 }, panel.name + (panel.unit ? `, ${panel.unit}` : "")), value);
  if (!range) {
    value.setAttribute("class", "absent");
    value.append(panel.absent ?? "no values");
    return { group, height: PLOT.title, update() {} };
  }
  const scale = domain(panel, range);
  const base = top + PLOT.title + panel.height;
  const toY = (amount) => base - ((Math.min(amount, scale.high * 20) - scale.low) / (scale.high - scale.low)) * panel.height;
  drawScale(group, panel, scale, toY, frame, top);
  const point = svg("circle", { class: "point", r: 3.5 });
  const cursor = svg("line", { class: "cursor", y1: top + PLOT.title, y2: base });
  group.append(drawCurve(panel, samples, values, toY, frame, top), ...drawThresholds(panel, range, toY, frame),
    ...drawImpact(panel, frame, top + PLOT.title, base), cursor, point);
  return {
    group,
    height: PLOT.title + panel.height,
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
  for (const band of frame.braking) {
    const [from, until] = [frame.toX(band.from), frame.toX(band.until)];
    group.append(svg("rect", { class: "band", x: from, y: top + PLOT.title, width: Math.max(1, until - from), height: panel.height }));
  }
  for (const mark of frame.marks.values) {
    const x = frame.toX(mark);
    group.append(svg("line", { class: "grid", x1: x, x2: x, y1: top + PLOT.title, y2: top + PLOT.title + panel.height }));
  }
  const marks = ticks(scale.low, scale.high, panel.ceiling === 1 ? 2 : 3);
  for (const mark of marks.values) {
    const y = Math.round(toY(mark)) + 0.5;
    group.append(
      svg("line", { class: mark === 0 ? "axis" : "grid", x1: frame.left, x2: frame.right, y1: y, y2: y }),
      svg("text", { class: "tick", x: frame.left - 6, y: y + 3.5 }, figure(mark, marks.digits)));
  }
}

/** The curve, cut off at the edges of its panel. */
function drawCurve(panel, samples, values, toY, frame, top) {
  const [x, y, width, height] = [frame.left, top + PLOT.title - 1, frame.right - frame.left, panel.height + 2];
  const cut = svg("svg", { x, y, width, height, viewBox: `${x} ${y} ${width} ${height}`, overflow: "hidden" });
  for (const points of stretches(samples.time, values, frame.toX, toY)) {
    const path = pathOf(points, panel.step);
    if (panel.step) {
      const last = points[points.length - 1].x.toFixed(1);
      cut.append(svg("path", { class: "area", d: `${path}L${last} ${toY(0).toFixed(1)}H${points[0].x.toFixed(1)}Z` }));
    }
    cut.append(svg("path", { class: "curve", d: path }));
  }
  return cut;
}

/** The limits that the values go below, as lines. */
function drawThresholds(panel, range, toY, frame) {
  return (panel.thresholds ?? []).filter((limit) => range.low < limit && range.high >= limit).flatMap((limit) => {
    const y = Math.round(toY(limit)) + 0.5;
    return [
      svg("line", { class: "threshold", x1: frame.left, x2: frame.right, y1: y, y2: y }),
      svg("text", { class: "threshold-label", x: frame.right + 5, y: y + 3.5 }, `${limit} s`),
    ];
  });
}

/** An impact ends a scenario: a line at the last moment, with the speed beside it in the plot of the gap. */
function drawImpact(panel, frame, top, base) {
  if (frame.impact === null) {
    return [];
  }
  const line = svg("line", { class: "impact", x1: frame.last, x2: frame.last, y1: top, y2: base });
  const label = svg("text", { class: "impact-label", x: frame.last - 8, y: top + 14 }, `impact, ${figure(frame.impact * 3.6, 1, "km/h")}`);
  return panel.key === "gap" ? [line, label] : [line];
}

function drawTimeAxis(picture, frame, bottom) {
  frame.marks.values.forEach((mark, index) => {
    const unit = index === frame.marks.values.length - 1 ? "s" : "";
    const x = Math.min(frame.toX(mark), frame.right - 6);
    picture.append(svg("text", { class: "time", x, y: bottom + 15 }, figure(mark, frame.marks.digits, unit)));
  });
}

function frameOf(samples, width) {
  const [first, last] = [samples.time[0], samples.time[samples.time.length - 1]];
  const [left, right] = [PLOT.left, width - PLOT.right];
  const seconds = last > first ? last - first : 1;
  return {
    left,
    right,
    braking: brakingTimes(samples),
    last: seconds === last - first ? right : left,
    marks: ticks(first, first + seconds, right - left < 420 ? 4 : 8),
    toX: (time) => left + ((time - first) / seconds) * (right - left),
    toTime: (x) => first + ((x - left) / (right - left)) * seconds,
  };
}

/** Draws all panels at a width and returns the picture and how to move its cursor. */
function drawPicture(samples, scenario, width) {
  const frame = { ...frameOf(samples, width), impact: number(scenario.impactSpeed) };
  const picture = svg("svg", { role: "group", "aria-label": "Plots over time" });
  const panels = [];
  let top = PLOT.top;
  for (const panel of PANELS.filter((one) => one.key !== "deceleration" || extent(samples.deceleration))) {
    const drawn = drawPanel(panel, samples, top, frame);
    panels.push(drawn);
    picture.append(drawn.group);
    top += drawn.height + PLOT.gap;
  }
  const bottom = top - PLOT.gap;
  drawTimeAxis(picture, frame, bottom);
  const instant = svg("text", { class: "instant", y: PLOT.top - 4 });
  picture.append(instant);
  picture.setAttribute("viewBox", `0 0 ${width} ${bottom + PLOT.axis}`);
  const move = (index) => {
    const x = frame.toX(samples.time[index]);
    instant.setAttribute("x", Math.max(frame.left + 14, Math.min(frame.right - 14, x)));
    instant.textContent = figure(samples.time[index], 2, "s");
    panels.forEach((panel) => panel.update(index));
  };
  return { picture, move, toTime: (x) => frame.toTime(x) };
}

/** The plots of a scenario with their time control; `draw()` fits them to the place they have. */
function plotsOf(scenario) {
  const samples = samplesOf(scenario.series);
  if (samples.time.length === 0) {
    return { element: html("p", { class: "none plots" }, "No series was recorded."), draw() {} };
  }
  let picture = null;
  let index = instantOfInterest(samples);
  const holder = html("div");
  const range = html("input", {
    type: "range", min: 0, max: samples.time.length - 1, step: 1, value: index, "aria-label": "Time of the readings",
  });
  const show = (next) => {
    index = next;
    range.value = String(index);
    range.setAttribute("aria-valuetext", spokenInstant(samples, index));
    picture?.move(index);
  };
  range.addEventListener("input", () => show(Number(range.value)));
  const draw = () => {
    const width = Math.round(holder.clientWidth) || PLOT.fallback;
    if (picture?.width === width) {
      return;
    }
    picture = { ...drawPicture(samples, scenario, width), width };
    const follow = (event) => {
      const box = picture.picture.getBoundingClientRect();
      show(nearest(samples.time, picture.toTime(((event.clientX - box.left) / box.width) * width)));
    };
    picture.picture.addEventListener("pointermove", follow);
    picture.picture.addEventListener("pointerdown", follow);
    holder.replaceChildren(picture.picture);
    show(index);
  };
  new ResizeObserver(() => holder.clientWidth > 0 && draw()).observe(holder);
  const element = html("figure", { class: "plots" }, holder, range, captionOf(samples));
  return { element, draw };
}

function spokenInstant(samples, index) {
  const readings = PANELS.filter((panel) => samples[panel.key][index] !== null)
    .map((panel) => `${panel.name} ${reading(panel, samples[panel.key][index])}`);
  return [figure(samples.time[index], 2, "s"), ...readings].join(", ");
}

function captionOf(samples) {
  const braking = samples.brake.some((value) => value > 0);
  const clipped = samples.timeToCollision.some((value) => value > TIME_TO_COLLISION_CEILING);
  const known = samples.brake.some((value) => value !== null);
  return html("figcaption", null,
    braking ? [html("span", { class: "key", "aria-hidden": "true" }), " Brake commanded. "] : known ? "The brake is never commanded. " : "",
    clipped ? `Time to collision is cut off at ${TIME_TO_COLLISION_CEILING} s. ` : "",
    "The value above each plot belongs to the time of the cursor.");
}
