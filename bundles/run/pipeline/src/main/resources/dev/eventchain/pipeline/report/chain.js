// The picture of the event chain: boxes, texts and lines where the program has laid them out.

/** Smallest scale at which texts can be read; a wider picture is scrolled. */
const READABLE = 0.6;

/** "x y" of a point, which has two numbers. */
const place = (point) => list(point).map((length) => number(length) ?? 0).join(" ");

function drawLine(line) {
  const points = list(line.points).map((point) => list(point).map((length) => number(length) ?? 0)).filter((point) => point.length === 2);
  if (points.length < 2) {
    return null;
  }
  let path = `M${place(points[0])}`;
  for (let index = 1; index < points.length; index++) {
    const [from, to] = [points[index - 1], points[index]];
    const middle = (from[1] + to[1]) / 2;
    path += from[0] === to[0] ? `L${place(to)}` : `C${from[0]} ${middle} ${to[0]} ${middle} ${place(to)}`;
  }
  const [before, end] = points.slice(-2);
  return svg("g", null,
    svg("path", { class: "edge", d: path, "stroke-dasharray": line.dashed === true ? "5 3" : null }),
    svg("path", { class: "arrow", d: `M${place(end)}l-4 ${end[1] > before[1] ? -8 : 8}h8z` }));
}

function rectangle(area, attributes) {
  return svg("rect", { x: number(area.x), y: number(area.y), width: number(area.width), height: number(area.height), ...attributes });
}

/** What kind of box it is, for the style sheet. */
function classOf(box) {
  const origin = box.generated === true ? "generated" : "existing";
  return text(box.kind) === "COMPONENT" ? "node " + origin : "topic" + (box.external === true ? " external" : "");
}

function drawBox(box) {
  const kind = classOf(box);
  const facts = text(box.facts);
  return svg("g", null, svg("title", null, facts ? `${text(box.name)} (${facts})` : text(box.name)),
    kind.startsWith("node") ? rectangle(box, { class: kind, rx: 10 }) : svg("polygon", { class: kind, points: list(box.corners).map(place).join(", ") }),
    records(box.bars).map((bar) => rectangle(bar, { class: "bar" })),
    records(box.stems).map((stem) => svg("path", { class: "edge", d: `M${place([stem.x, stem.from])}L${place([stem.x, stem.to])}` })),
    records(box.texts).map((line, index) => svg("text", {
      class: (line.title === true ? "node-name " : index > 0 ? "node-fact " : "") + kind.replace(/^node /, ""),
      x: number(line.x), y: number(line.y), "font-size": number(line.size), textLength: number(line.width), lengthAdjust: "spacingAndGlyphs",
    }, line.text)));
}

function spokenChain(chain) {
  const boxes = records(chain.boxes);
  const name = (index) => text(record(boxes[number(index) ?? -1]).name);
  return "Event chain: " + records(chain.lines).map((line) => `${name(line.from)} to ${name(line.to)}`).join("; ");
}

/** Fills a holder with the picture. */
function drawChain(chain, holder) {
  const [width, height] = [number(chain.width) ?? 0, number(chain.height) ?? 0];
  const picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": spokenChain(chain) },
    records(chain.lines).map(drawLine), records(chain.boxes).map(drawBox));
  picture.style.width = "100%";
  picture.style.maxWidth = `${width}px`;
  picture.style.minWidth = `${Math.round(width * READABLE)}px`;
  holder.replaceChildren(picture);
}
