package dev.eventchain.pipeline.export;

import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.XmlElement;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Plays what exported files say of one entity, from the words of the standards and without the
 * simulation: initial actions, and speeds, lane changes and trajectories at fixed times.
 */
final class FilePlayer {

  private static final double STEP = 0.001;
  private static final Rule XML = Rule.error("player.xml");

  /** A pose in the plane. */
  record Pose(double x, double y, double heading) {

    Pose ahead(double distance) {
      return new Pose(x + distance * Math.cos(heading), y + distance * Math.sin(heading), heading);
    }
  }

  private final XmlElement scenario;
  private final Map<String, Double> parameters = new HashMap<>();
  private final double curvature;
  private final Pose start;
  private final double laneWidth;

  FilePlayer(String xosc, String xodr) {
    scenario = XmlElement.parse(SourceText.of("s.xosc", xosc), XML);
    for (XmlElement each : first(scenario, "ParameterDeclarations").children()) {
      parameters.put(text(each, "name"), Double.valueOf(text(each, "value")));
    }
    XmlElement road = XmlElement.parse(SourceText.of("s.xodr", xodr), XML);
    XmlElement geometry = first(road, "geometry");
    start = new Pose(number(geometry, "x"), number(geometry, "y"), number(geometry, "hdg"));
    curvature = find(geometry, "arc").map(it -> number(it, "curvature")).orElse(0.0);
    XmlElement lane =
        all(road, "lane").filter(it -> text(it, "id").equals("-1")).findFirst().orElseThrow();
    laneWidth = number(first(lane, "width"), "a");
  }

  static Stream<XmlElement> all(XmlElement root, String name) {
    Stream<XmlElement> below = root.children().stream().flatMap(each -> all(each, name));
    return root.name().equals(name) ? Stream.concat(Stream.of(root), below) : below;
  }

  private static Optional<XmlElement> find(XmlElement root, String name) {
    return all(root, name).findFirst();
  }

  private static XmlElement first(XmlElement root, String name) {
    return find(root, name).orElseThrow();
  }

  private static String text(XmlElement element, String attribute) {
    return element.attribute(attribute).orElseThrow();
  }

  /** Returns a number, or the value of a parameter, or that of "${$name * number + number}". */
  private double number(XmlElement element, String attribute) {
    String value = text(element, attribute);
    if (!value.startsWith("$")) {
      return Double.parseDouble(value);
    }
    String[] words = value.replaceAll("[${}]", "").split(" ", -1);
    double result = parameters.get(words[0]);
    for (int i = 1; i < words.length; i += 2) {
      double operand = Double.parseDouble(words[i + 1]);
      result = words[i].equals("*") ? result * operand : result + operand;
    }
    return result;
  }

  /** Returns the names of the entities, in their order. */
  List<String> entities() {
    return all(scenario, "ScenarioObject").map(it -> text(it, "name")).toList();
  }

  /** Returns how far the middle of an entity's box is ahead of its reference point. */
  double middle(String entity) {
    return number(first(object(entity), "Center"), "x");
  }

  private XmlElement object(String entity) {
    return all(scenario, "ScenarioObject")
        .filter(it -> text(it, "name").equals(entity))
        .findFirst()
        .orElseThrow();
  }

  private record Event(double time, XmlElement action) {}

  private List<Event> events(String entity) {
    List<Event> events = new ArrayList<>();
    all(scenario, "ManeuverGroup")
        .filter(it -> text(first(it, "EntityRef"), "entityRef").equals(entity))
        .flatMap(group -> all(group, "Event"))
        .forEach(
            event ->
                events.add(
                    new Event(
                        number(first(event, "SimulationTimeCondition"), "value"),
                        first(event, "PrivateAction"))));
    return events;
  }

  /** Returns the poses of an entity's reference point at each hundredth of a second. */
  List<Pose> poses(String entity, double duration) {
    XmlElement init =
        all(scenario, "Private")
            .filter(it -> text(it, "entityRef").equals(entity))
            .findFirst()
            .orElseThrow();
    State state = new State(first(init, "LanePosition"));
    all(init, "PrivateAction").forEach(action -> state.begin(action, 0.0));
    List<Event> left = new ArrayList<>(events(entity));
    List<Pose> poses = new ArrayList<>();
    int steps = (int) Math.round(duration / STEP);
    for (int i = 0; i <= steps; i++) {
      double now = i * STEP;
      for (Event each : List.copyOf(left)) {
        if (each.time() <= now + 1e-9) {
          left.remove(each);
          state.begin(each.action(), each.time());
        }
      }
      state.at(now);
      if (i % 10 == 0) {
        poses.add(state.pose(now));
      }
      state.advance();
    }
    return poses;
  }

  /** An entity that keeps its lane, or follows a trajectory. */
  private final class State {
    private double s;
    private double offset;
    private final double turned;
    private double speed;
    private double rate;
    private double target;
    private double sideways;
    private Optional<Side> side = Optional.empty();
    private Optional<Way> way = Optional.empty();

    private record Side(double time, double from, double to, double duration) {}

    private record Way(double time, boolean timed, List<Double> times, List<Pose> vertices) {}

    State(XmlElement position) {
      s = number(position, "s");
      offset = number(position, "offset");
      turned = number(first(position, "Orientation"), "h");
    }

    void begin(XmlElement action, double time) {
      find(action, "SpeedAction").ifPresent(it -> speed(it));
      find(action, "LaneChangeAction")
          .ifPresent(
              it ->
                  side =
                      Optional.of(
                          new Side(
                              time,
                              offset,
                              number(it, "targetLaneOffset"),
                              number(first(it, "LaneChangeActionDynamics"), "value"))));
      find(action, "Polyline").ifPresent(it -> way(it, find(action, "Timing").isPresent(), time));
    }

    private void speed(XmlElement action) {
      XmlElement dynamics = first(action, "SpeedActionDynamics");
      target = number(first(action, "AbsoluteTargetSpeed"), "value");
      rate = number(dynamics, "value");
      if (text(dynamics, "dynamicsShape").equals("step")) {
        speed = target;
      }
    }

    private void way(XmlElement line, boolean timed, double time) {
      List<Double> times = new ArrayList<>();
      List<Pose> vertices = new ArrayList<>();
      for (XmlElement vertex : line.children()) {
        XmlElement place = first(vertex, "WorldPosition");
        vertices.add(new Pose(number(place, "x"), number(place, "y"), number(place, "h")));
        Pose last = vertices.get(vertices.size() - 1);
        Pose before = vertices.get(Math.max(0, vertices.size() - 2));
        double until = times.isEmpty() ? 0.0 : times.get(times.size() - 1);
        times.add(
            timed
                ? number(vertex, "time")
                : until + Math.hypot(last.x() - before.x(), last.y() - before.y()));
      }
      way = Optional.of(new Way(time, timed, times, vertices));
      driven = 0.0;
    }

    private double driven;

    /** Settles what is over. */
    void at(double now) {
      if (way.filter(Way::timed).isPresent()) {
        Way last = way.get();
        int end = last.times().size() - 1;
        if (now >= last.time() + last.times().get(end) - 1e-9) {
          onRoad(last.vertices().get(end));
          way = Optional.empty();
        }
      }
      sideways = 0.0;
      if (side.isPresent()) {
        Side move = side.get();
        double part = Math.min(1.0, (now - move.time()) / move.duration());
        offset = move.from() + (move.to() - move.from()) * (1 - Math.cos(Math.PI * part)) / 2;
        sideways =
            (move.to() - move.from()) / move.duration() * Math.PI / 2 * Math.sin(Math.PI * part);
        side = part < 1.0 ? side : Optional.empty();
      }
    }

    private void onRoad(Pose pose) {
      if (curvature == 0.0) {
        s = pose.x() - start.x();
        offset = pose.y() - start.y() + laneWidth / 2;
        return;
      }
      double radius = 1.0 / curvature;
      double cx = start.x() - radius * Math.sin(start.heading());
      double cy = start.y() + radius * Math.cos(start.heading());
      double angle = Math.atan2((pose.x() - cx) * curvature, -(pose.y() - cy) * curvature);
      double full = 2 * Math.PI * Math.abs(radius);
      double near = (angle - start.heading()) * radius;
      s = near + Math.rint((s - near) / full) * full;
      double away = Math.hypot(pose.x() - cx, pose.y() - cy);
      offset = radius - Math.signum(radius) * away + laneWidth / 2;
    }

    Pose pose(double now) {
      if (way.isPresent()) {
        Way line = way.get();
        return between(line, line.timed() ? now - line.time() : driven);
      }
      double t = offset - laneWidth / 2;
      double heading = start.heading() + s * curvature;
      Pose lane = lane(s, heading);
      double turn = sideways == 0.0 ? 0.0 : Math.atan2(sideways, speed);
      return new Pose(
          lane.x() - t * Math.sin(heading),
          lane.y() + t * Math.cos(heading),
          heading + turned + turn);
    }

    private Pose lane(double at, double heading) {
      if (curvature == 0.0) {
        return start.ahead(at);
      }
      return new Pose(
          start.x() + (Math.sin(heading) - Math.sin(start.heading())) / curvature,
          start.y() + (Math.cos(start.heading()) - Math.cos(heading)) / curvature,
          heading);
    }

    private static Pose between(Way way, double at) {
      int i = 0;
      while (i < way.times().size() - 2 && way.times().get(i + 1) <= at) {
        i++;
      }
      double from = way.times().get(i);
      double part = Math.min(1.0, (at - from) / (way.times().get(i + 1) - from));
      Pose one = way.vertices().get(i);
      Pose other = way.vertices().get(i + 1);
      return new Pose(
          one.x() + (other.x() - one.x()) * part,
          one.y() + (other.y() - one.y()) * part,
          one.heading() + (other.heading() - one.heading()) * part);
    }

    void advance() {
      double before = speed;
      double most = rate * STEP;
      speed += Math.max(-most, Math.min(most, target - speed));
      double distance = (before + speed) / 2 * STEP;
      driven += distance;
      double along = Math.cos(turned) < 0.0 ? -1.0 : 1.0;
      s += along * distance / (1.0 - curvature * (offset - laneWidth / 2));
    }
  }
}
