// The picture of the event chain: nodes as boxes, topics as names on the lines between them, in layers.

const CHAIN = { between: 28, apart: 18, nodeLetter: 7.3, topicLetter: 6.7, line: 14, terminal: 14, wraps: [24, 20, 17, 14, 12], lines: 5, smallest: 0.88 };

/** A name in lines of at most `limit` letters, broken before a slash, else after another separator, else before a capital letter, else anywhere. */
function wrap(name, limit) {
  const lines = [""];
  const add = (part, cuts) => {
    const last = lines.length - 1;
    if (lines[last].length + part.length <= limit) {
      lines[last] += part;
    } else if (part.length > limit && cuts.length > 0) {
      part.split(cuts[0]).forEach((piece, index) => {
        if (index === 0 && lines[last] !== "") {
          lines.push("");
        }
        add(piece, cuts.slice(1));
      });
    } else {
      lines.push(part);
    }
  };
  add(name, [/(?=\/)/, /(?<=[_\-. ])/, /(?<=[a-z0-9])(?=[A-Z])/, new RegExp(`(?<=^(?:.{${limit}})+)`, "s")]);
  lines.splice(0, lines[0] === "" ? 1 : 0);
  return lines.length <= CHAIN.lines ? lines : [...lines.slice(0, CHAIN.lines - 1), "\u2026"];
}

/** The vertices, boxes before topics, and the links between them; from the data's edges. */
function graphOf(chain) {
  const vertices = new Map();
  const vertex = (kind, name) => {
    const key = kind + " " + name;
    if (!vertices.has(key)) {
      vertices.set(key, { kind, name, node: {}, provided: false, consumed: false, next: [], previous: [] });
    }
    return vertices.get(key);
  };
  const nodes = records(record(chain).nodes);
  nodes.forEach((node) => (vertex("node", text(node.name)).node = node));
  const edges = records(record(chain).edges);
  edges.forEach((edge) => [edge.from, edge.to].map(text).filter(Boolean).forEach((name) => vertex("node", name)));
  const links = new Map();
  const link = (from, to) => links.set([from.kind, from.name, to.name].join("\n"), { from, to, reversed: false });
  for (const edge of edges) {
    const topic = vertex("topic", text(edge.topic));
    topic.provided ||= text(edge.from) === "";
    topic.consumed ||= text(edge.to) === "";
    topic.external ||= edge.external === true;
    if (text(edge.from) !== "") {
      link(vertex("node", text(edge.from)), topic);
    }
    if (text(edge.to) !== "") {
      link(topic, vertex("node", text(edge.to)));
    }
  }
  return { vertices: [...vertices.values()], links: [...links.values()] };
}

/** Turns links round that would close a cycle, so that all layers have an order. */
function breakCycles(vertices, links) {
  const state = new Map();
  const outgoing = new Map(vertices.map((vertex) => [vertex, []]));
  links.forEach((link) => outgoing.get(link.from).push(link));
  for (const start of vertices) {
    const stack = state.has(start) ? [] : [{ vertex: start, at: 0 }];
    state.set(start, state.get(start) ?? "open");
    while (stack.length > 0) {
      const top = stack[stack.length - 1];
      const link = outgoing.get(top.vertex)[top.at++];
      if (!link) {
        state.set(top.vertex, "closed");
        stack.pop();
      } else if (state.get(link.to) === "open") {
        link.reversed = true;
      } else if (!state.has(link.to)) {
        state.set(link.to, "open");
        stack.push({ vertex: link.to, at: 0 });
      }
    }
  }
}

const upstream = (link) => (link.reversed ? link.to : link.from);
const downstream = (link) => (link.reversed ? link.from : link.to);

/** The layer of each vertex: behind all it follows; what follows nothing stands right before its first reader. */
function assignLayers(vertices, links) {
  vertices.forEach((vertex) => (vertex.layer = 0));
  for (let changed = true; changed;) {
    changed = false;
    for (const link of links) {
      if (downstream(link).layer <= upstream(link).layer) {
        downstream(link).layer = upstream(link).layer + 1;
        changed = true;
      }
    }
  }
  for (const vertex of vertices) {
    const readers = links.filter((link) => upstream(link) === vertex).map((link) => downstream(link).layer);
    if (readers.length > 0 && !links.some((link) => downstream(link) === vertex)) {
      vertex.layer = Math.min(...readers) - 1;
    }
  }
}

/** The layers with their vertices; a link over several layers gets a bend in each between. */
function layersOf(vertices, links) {
  const layers = Array.from({ length: Math.max(...vertices.map((vertex) => vertex.layer)) + 1 }, () => []);
  vertices.forEach((vertex) => layers[vertex.layer].push(vertex));
  for (const link of links) {
    link.route = [upstream(link)];
    for (let layer = upstream(link).layer + 1; layer < downstream(link).layer; layer++) {
      const bend = { kind: "bend", layer, next: [], previous: [] };
      layers[layer].push(bend);
      link.route.push(bend);
    }
    link.route.push(downstream(link));
    for (let index = 1; index < link.route.length; index++) {
      link.route[index - 1].next.push(link.route[index]);
      link.route[index].previous.push(link.route[index - 1]);
    }
  }
  return layers;
}

function mean(values) {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

/** Orders each layer by the mean place of its neighbours, to and fro. */
function orderLayers(layers) {
  const renumber = () => layers.forEach((layer) => layer.forEach((vertex, index) => (vertex.order = index - (layer.length - 1) / 2)));
  renumber();
  for (let sweep = 0; sweep < 12; sweep++) {
    const forward = sweep % 2 === 0;
    for (const layer of forward ? layers : [...layers].reverse()) {
      for (const vertex of layer) {
        const near = forward ? vertex.previous : vertex.next;
        vertex.wish = near.length > 0 ? mean(near.map((one) => one.order)) : vertex.order;
      }
      layer.sort((one, other) => one.wish - other.wish || one.order - other.order);
      layer.forEach((vertex, index) => (vertex.order = index - (layer.length - 1) / 2));
    }
  }
}

/** Places of a layer as near to the wishes as their distances allow (least squares, pooled neighbours). */
function settle(layer, across) {
  let offset = 0;
  const blocks = [];
  layer.forEach((vertex, index) => {
    if (index > 0) {
      offset += (layer[index - 1][across] + vertex[across]) / 2 + CHAIN.apart;
    }
    blocks.push({ sum: vertex.wish - offset, vertices: [{ vertex, offset }] });
    const size = (block) => block.sum / block.vertices.length;
    while (blocks.length > 1 && size(blocks[blocks.length - 2]) > size(blocks[blocks.length - 1])) {
      const last = blocks.pop();
      const before = blocks[blocks.length - 1];
      before.sum += last.sum;
      before.vertices.push(...last.vertices);
    }
  });
  for (const block of blocks) {
    block.vertices.forEach((entry) => (entry.vertex.across = block.sum / block.vertices.length + entry.offset));
  }
}

/** Gives vertices their places: `along` the flow and `across` it. */
function placeVertices(layers, down) {
  const [along, across] = down ? ["height", "width"] : ["width", "height"];
  let position = 0;
  for (const layer of layers) {
    const size = Math.max(...layer.map((vertex) => vertex[along]));
    layer.forEach((vertex) => Object.assign(vertex, { along: position + size / 2, across: 0, wish: vertex.order * 60 }));
    position += size + CHAIN.between;
    settle(layer, across);
  }
  for (let sweep = 0; sweep < 8; sweep++) {
    const forward = sweep % 2 === 0;
    for (const layer of forward ? layers : [...layers].reverse()) {
      for (const vertex of layer) {
        const near = forward ? vertex.previous : vertex.next;
        vertex.wish = near.length > 0 ? mean(near.map((one) => one.across)) : vertex.across;
      }
      settle(layer, across);
    }
  }
  for (const vertex of layers.flat()) {
    [vertex.x, vertex.y] = down ? [vertex.across, vertex.along] : [vertex.along, vertex.across];
  }
}

function measure(vertex, limit, down) {
  if (vertex.kind === "bend") {
    return Object.assign(vertex, { width: 1, height: 1 });
  }
  const node = vertex.kind === "node";
  vertex.lines = wrap(vertex.name, node && !down ? Math.max(18, limit) : limit);
  const longest = Math.max(...vertex.lines.map((line) => line.length), node ? 14 : 1);
  vertex.width = longest * (node ? CHAIN.nodeLetter : CHAIN.topicLetter) + (node ? 22 : 6);
  vertex.height = vertex.lines.length * CHAIN.line + (node ? CHAIN.line + 18 : 4);
  const terminals = (vertex.provided ? CHAIN.terminal : 0) + (vertex.consumed ? CHAIN.terminal : 0);
  vertex[down ? "height" : "width"] += terminals;
  return vertex;
}

function layOut(chain, limit, down) {
  const graph = graphOf(chain);
  breakCycles(graph.vertices, graph.links);
  assignLayers(graph.vertices, graph.links);
  const layers = layersOf(graph.vertices, graph.links);
  layers.flat().forEach((vertex) => measure(vertex, limit, down));
  orderLayers(layers);
  placeVertices(layers, down);
  const sides = layers.flat().map((vertex) => ({
    left: vertex.x - vertex.width / 2, right: vertex.x + vertex.width / 2, top: vertex.y - vertex.height / 2, bottom: vertex.y + vertex.height / 2,
  }));
  const box = {
    left: Math.min(...sides.map((side) => side.left)) - 4,
    top: Math.min(...sides.map((side) => side.top)) - 4,
    right: Math.max(...sides.map((side) => side.right)) + 4,
    bottom: Math.max(...sides.map((side) => side.bottom)) + 4,
  };
  return { ...graph, down, box, width: box.right - box.left, height: box.bottom - box.top };
}

function drawLink(link, down) {
  const reach = (vertex, side) => {
    const half = (down ? vertex.height : vertex.width) / 2;
    return down ? { x: vertex.x, y: vertex.y + side * half } : { x: vertex.x + side * half, y: vertex.y };
  };
  const at = (point) => `${point.x.toFixed(1)} ${point.y.toFixed(1)}`;
  const arrow = link.to.kind === "node";
  let path = "";
  for (let index = 1; index < link.route.length; index++) {
    const from = reach(link.route[index - 1], 1);
    const to = reach(link.route[index], -1);
    const half = down ? { x: 0, y: (to.y - from.y) / 2 } : { x: (to.x - from.x) / 2, y: 0 };
    path += `${index === 1 ? "M" : "L"}${at(from)}C${at({ x: from.x + half.x, y: from.y + half.y })} `
      + `${at({ x: to.x - half.x, y: to.y - half.y })} ${at(to)}`;
  }
  const tip = reach(link.to, link.reversed ? 1 : -1);
  const way = link.reversed ? -1 : 1;
  const wings = down ? `l-4 ${-7 * way}h8z` : `l${-7 * way} -4v8z`;
  return svg("g", null, svg("path", { class: "edge", d: path }), arrow ? svg("path", { class: "arrow", d: `M${at(tip)}${wings}` }) : null);
}

function drawLines(lines, x, top, className) {
  return lines.map((line, index) => svg("text", { class: className, x, y: top + index * CHAIN.line + 10.5 }, line));
}

function originOf(node) {
  return text(node.origin) === "GENERATED" ? "generated" : text(node.origin) === "EXISTING" ? "existing" : "origin unknown";
}

function drawNode(vertex) {
  const [x, y] = [vertex.x - vertex.width / 2, vertex.y - vertex.height / 2];
  const origin = originOf(vertex.node);
  const frequency = number(vertex.node.frequency);
  const fact = frequency === null ? origin : `${origin} \u00b7 ${figure(frequency, frequency % 1 ? 1 : 0, "Hz")}`;
  return svg("g", null, svg("title", null, vertex.name),
    svg("rect", { class: "node " + origin, x, y, width: vertex.width, height: vertex.height, rx: 3 }),
    drawLines(vertex.lines, vertex.x, y + 9, "node-name"),
    svg("text", { class: "node-fact " + origin, x: vertex.x, y: y + vertex.height - 9.5 }, fact));
}

/** A topic: its name, with a circle on the side where it comes from or goes to the outside. */
function drawTopic(vertex, down) {
  const [before, after] = [vertex.provided ? CHAIN.terminal : 0, vertex.consumed ? CHAIN.terminal : 0];
  const [left, top] = [vertex.x - vertex.width / 2, vertex.y - vertex.height / 2];
  const name = down
    ? { x: vertex.x, top: top + before, height: vertex.height - before - after }
    : { x: left + before + (vertex.width - before - after) / 2, top, height: vertex.height };
  const circle = (along, kind = "") => (down
    ? svg("circle", { class: "terminal" + kind, cx: vertex.x, cy: top + along, r: 4 })
    : svg("circle", { class: "terminal" + kind, cx: left + along, cy: vertex.y, r: 4 }));
  const outside = vertex.provided || vertex.consumed;
  return svg("g", null, svg("title", null, vertex.name),
    vertex.provided ? circle(5) : null, vertex.consumed ? circle((down ? vertex.height : vertex.width) - 5, vertex.external ? " external" : "") : null,
    drawLines(vertex.lines, name.x, name.top + (name.height - vertex.lines.length * CHAIN.line) / 2, "topic-name" + (outside ? " outside" : "")));
}

function spokenChain(chain) {
  return "Event chain: " + records(record(chain).edges)
    .map((edge) => `${text(edge.from) || "outside"} to ${text(edge.to) || "outside"} by ${text(edge.topic)}`).join("; ");
}

/** The widest layout from left to right that has room; else the widest one downwards; else the narrowest of these, made smaller. */
function fitting(chain, room) {
  let drawing = null;
  for (const limit of room < 600 ? [] : CHAIN.wraps) {
    drawing = layOut(chain, limit, false);
    if (drawing.width * CHAIN.smallest <= room) {
      return drawing;
    }
  }
  for (const limit of CHAIN.wraps) {
    drawing = layOut(chain, limit, true);
    if (drawing.width * CHAIN.smallest <= room) {
      break;
    }
  }
  return drawing;
}

/** Fills a holder with the picture. */
function drawChain(chain, holder) {
  const room = holder.clientWidth || 1000;
  const { down, box, width, height, links, vertices } = fitting(chain, room);
  const picture = svg("svg", { viewBox: `${box.left} ${box.top} ${width} ${height}`, role: "img", "aria-label": spokenChain(chain) },
    links.map((link) => drawLink(link, down)),
    vertices.map((vertex) => (vertex.kind === "node" ? drawNode(vertex) : drawTopic(vertex, down))));
  picture.style.width = "100%";
  picture.style.maxWidth = `${width}px`;
  holder.replaceChildren(picture);
}
