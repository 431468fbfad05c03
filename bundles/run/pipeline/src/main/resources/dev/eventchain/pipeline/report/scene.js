// The road from above at the time of the cursor: the ego, all others, and what the lidar saw last.

/** What is shown around the ego's front, in m; the ego looks to the right. */
const VIEW = { behind: 18, ahead: 62, aside: 11, step: 4, dash: 6 };

const LINES_ASIDE = [-1.5, -0.5, 0.5, 1.5];

/** The scene of a scenario with the samples that its plots have; null where none was recorded. */
function sceneOf(scenario, samples) {
  const scene = record(scenario.scene);
  const ego = moverOf(record(scene.ego));
  return ego.x.length === 0 || samples.time.length === 0 ? null : {
    ego,
    others: records(scene.others).map(moverOf),
    scans: records(scene.scans).map((scan) => ({ time: number(scan.time) ?? 0, x: list(scan.x).map(number), y: list(scan.y).map(number) })),
    curvature: number(scene.curvature) ?? 0,
    lane: number(scene.lane_width) ?? 3.75,
    wall: number(scene.wall_distance) ?? 8,
    lines: records(scene.lines).map((line) => ({ broken: line.broken === true, x: list(line.x).map(number), y: list(line.y).map(number) })),
  };
}

function moverOf(mover) {
  const column = (values) => (Array.isArray(values) ? values.map(number) : []);
  return {
    name: text(mover.name), length: number(mover.length) ?? 0, width: number(mover.width) ?? 0,
    x: column(mover.x), y: column(mover.y), heading: column(mover.heading),
  };
}

/** Where a mover is at a sample; null if it is gone. */
function placeAt(mover, index) {
  const at = (values) => (values.length === 1 ? values[0] : values[index] ?? null);
  const place = { x: at(mover.x), y: at(mover.y), heading: at(mover.heading) };
  return place.x === null || place.y === null || place.heading === null ? null : place;
}

/** The same place in a frame whose origin and direction are those of another. */
function seenFrom(origin, place) {
  const [dx, dy] = [place.x - origin.x, place.y - origin.y];
  const [cos, sin] = [Math.cos(origin.heading), Math.sin(origin.heading)];
  return { x: dx * cos + dy * sin, y: dy * cos - dx * sin, heading: (place.heading ?? 0) - origin.heading };
}

/** The place of a station of the road, as the world has it. */
function roadPlace(scene, along, across) {
  if (scene.curvature === 0) {
    return { x: along, y: across };
  }
  const radius = 1 / scene.curvature;
  return { x: (radius - across) * Math.sin(along / radius), y: radius - (radius - across) * Math.cos(along / radius) };
}

/** How far along the road a place is. */
function stationOf(scene, place) {
  return scene.curvature === 0 ? place.x : place.heading / scene.curvature;
}

/** The middle of the view: the ego's front, in the direction of the road where it is straight. */
function viewpointOf(scene, ego) {
  const half = scene.ego.length / 2;
  return {
    x: ego.x + half * Math.cos(ego.heading), y: ego.y + half * Math.sin(ego.heading), heading: scene.curvature === 0 && scene.wall > 0 ? 0 : ego.heading,
  };
}

function pathThrough(points) {
  return points.map((point, index) => `${index === 0 ? "M" : "L"}${point.x.toFixed(1)} ${point.y.toFixed(1)}`).join("");
}

/** Draws the view at a width and returns the picture and how to move it to a sample. */
function drawScene(scene, samples, width) {
  const scale = width / (VIEW.behind + VIEW.ahead);
  const height = Math.round(2 * VIEW.aside * scale);
  const onScreen = (seen) => ({ x: (seen.x + VIEW.behind) * scale, y: (VIEW.aside - seen.y) * scale });
  const layers = { road: svg("g"), scan: svg("path", { class: "echo" }), others: svg("g"), ego: svg("g") };
  const picture = svg("svg", { class: "above", role: "img", viewBox: `0 0 ${width} ${height}` },
    svg("rect", { class: "ground", width, height }), layers.road, layers.scan, layers.others, layers.ego);
  const outline = (mover, seen) => {
    const corners = [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([ahead, left]) => {
      const [along, across] = [(ahead * mover.length) / 2, (left * mover.width) / 2];
      const [cos, sin] = [Math.cos(seen.heading), Math.sin(seen.heading)];
      return onScreen({ x: seen.x + along * cos - across * sin, y: seen.y + along * sin + across * cos });
    });
    return pathThrough(corners) + "Z";
  };
  const move = (index) => {
    const ego = placeAt(scene.ego, index);
    if (ego === null) {
      return;
    }
    const origin = viewpointOf(scene, ego);
    layers.road.replaceChildren(...drawRoad(scene, origin, stationOf(scene, origin), onScreen, scale));
    layers.scan.setAttribute("d", echoesAt(scene, samples.time[index], origin, onScreen));
    layers.others.replaceChildren(...scene.others.flatMap((other) => drawOther(other, placeAt(other, index), origin, outline, onScreen)));
    layers.ego.replaceChildren(svg("path", { class: "ego", d: outline(scene.ego, seenFrom(origin, ego)) }));
    picture.setAttribute("aria-label", `From above after ${figure(samples.time[index], 2, "s")}: ${spokenScene(scene, index)}`);
  };
  return { picture, move };
}

/** The lines of a map, or the walls and the lines of three lanes; the dashes stay where they are on the road. */
function drawRoad(scene, origin, station, onScreen, scale) {
  if (scene.wall === 0) {
    return scene.lines.map((line) => {
      const points = line.x.map((x, index) => onScreen(seenFrom(origin, { x, y: line.y[index] })));
      return svg("path", { class: "lane", d: pathThrough(points), "stroke-dasharray": line.broken ? VIEW.dash * scale : null });
    });
  }
  const start = Math.floor((station - VIEW.behind - 8) / (2 * VIEW.dash)) * 2 * VIEW.dash;
  const line = (across, className, dashes) => {
    const points = [];
    for (let along = start; along <= station + VIEW.ahead + 12; along += VIEW.step) {
      points.push(onScreen(seenFrom(origin, roadPlace(scene, along, across))));
    }
    return svg("path", { class: className, d: pathThrough(points), "stroke-dasharray": dashes ? VIEW.dash * scale : null });
  };
  return [
    ...[-scene.wall, scene.wall].map((across) => line(across, "wall", false)),
    ...LINES_ASIDE.map((lanes) => line(lanes * scene.lane, "lane", Math.abs(lanes) < 1)),
  ];
}

/** The echoes of the last scan before a time, as dots. */
function echoesAt(scene, time, origin, onScreen) {
  const scan = scene.scans.filter((each) => each.time <= time + 1e-6).pop();
  return !scan || time - scan.time > 1 ? "" : scan.x.map((x, index) => {
    const at = onScreen(seenFrom(origin, { x, y: scan.y[index], heading: 0 }));
    return `M${at.x.toFixed(1)} ${at.y.toFixed(1)}h0`;
  }).join("");
}

/** A box with its name, if it is in sight. */
function drawOther(other, place, origin, outline, onScreen) {
  if (place === null) {
    return [];
  }
  const seen = seenFrom(origin, place);
  const reach = other.length;
  if (seen.x < -VIEW.behind - reach || seen.x > VIEW.ahead + reach || Math.abs(seen.y) > VIEW.aside + reach) {
    return [];
  }
  const label = onScreen({ x: seen.x, y: Math.min(seen.y + Math.max(other.width, Math.abs(Math.sin(seen.heading)) * other.length) / 2 + 0.6, VIEW.aside - 1.5) });
  return [svg("path", { class: "other", d: outline(other, seen) }), svg("text", { class: "who", x: label.x, y: label.y }, other.name)];
}

/** Who is near the ego and where, in words. */
function spokenScene(scene, index) {
  const ego = placeAt(scene.ego, index);
  const origin = viewpointOf(scene, ego);
  const near = scene.others.flatMap((other) => {
    const place = placeAt(other, index);
    const seen = place === null ? null : seenFrom(origin, place);
    return seen === null || seen.x < -VIEW.behind || seen.x > VIEW.ahead || Math.abs(seen.y) > VIEW.aside ? [] : [{ other, seen }];
  });
  const words = near.sort((one, two) => Math.abs(one.seen.x) - Math.abs(two.seen.x)).slice(0, 3).map(({ other, seen }) => {
    const aside = Math.abs(seen.y) < 0.5 ? "" : `, ${figure(Math.abs(seen.y), 1, "m")} to the ${seen.y > 0 ? "left" : "right"}`;
    return `${other.name} ${figure(Math.abs(seen.x), 0, "m")} ${seen.x >= 0 ? "ahead" : "behind"}${aside}`;
  });
  return words.length > 0 ? words.join("; ") : "nobody near the ego";
}

/** A button that moves the cursor through the scenario as fast as it happened. */
function playButton(samples, current, show) {
  const button = html("button", { type: "button", class: "play", "aria-pressed": "false" }, "Play");
  let frame = 0;
  const stop = () => {
    cancelAnimationFrame(frame);
    frame = 0;
    button.textContent = "Play";
    button.setAttribute("aria-pressed", "false");
  };
  const start = () => {
    const last = samples.time.length - 1;
    const from = current() >= last ? 0 : current();
    const begun = performance.now() / 1000 - samples.time[from];
    button.textContent = "Pause";
    button.setAttribute("aria-pressed", "true");
    const step = () => {
      const index = nearest(samples.time, performance.now() / 1000 - begun);
      show(index);
      if (index >= last || !button.isConnected || button.closest("[hidden]")) {
        stop();
      } else {
        frame = requestAnimationFrame(step);
      }
    };
    step();
  };
  button.addEventListener("click", () => (frame ? stop() : start()));
  return { button, stop };
}
