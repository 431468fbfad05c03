package dev.eventchain.simulation.scenario;

import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.formula.Range;
import dev.eventchain.simulation.world.Actuator;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Script;
import dev.eventchain.simulation.world.Situation;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The values that signals can have in a scenario, whatever the software does: those of the world
 * follow from the vehicle's abilities and the duration, those of inputs from their scripts, and
 * those of fields from the types of messages.
 */
final class SignalRanges implements Range.Source {

  private static final Set<Actuator> BACKWARDS =
      Set.of(Actuator.REVERSE, Actuator.GEAR, Actuator.SPEED);
  private static final Set<Actuator> WHEELS =
      Set.of(Actuator.STEERING, Actuator.STEERING_ANGLE, Actuator.YAW_RATE);

  private final Situation situation;
  private final Map<String, Script> inputs;
  private final Bench bench;
  private final double duration;

  SignalRanges(Situation situation, Map<String, Script> inputs, Bench bench, double duration) {
    this.situation = situation;
    this.inputs = inputs;
    this.bench = bench;
    this.duration = duration;
  }

  @Override
  public Range apply(String signal) {
    if (signal.startsWith("/")) {
      return bench.signals().rangeOf(signal);
    }
    double wall = Road.WALL_DISTANCE;
    double half = situation.road().laneWidth(0.0) / 2;
    double curvature = situation.road().curvature(0.0);
    return switch (signal) {
      case "ego.speed" -> new Range(drives(BACKWARDS) ? -gained() : 0.0, fastest());
      case "ego.acceleration" -> accelerations();
      case "ego.position" -> new Range(staysAhead() ? 0.0 : -way(), way());
      case "ego.offset" -> Range.within(wall);
      case "ego.x", "ego.y" -> Range.within(way() + wall);
      case "ego.latitude" -> Range.within(90.0);
      case "ego.longitude" -> Range.within(180.0);
      case "ego.yaw" -> Range.within(Math.PI);
      case "ego.yaw_rate" -> Range.within(fastest() * situation.ego().chassis().tightest());
      case "ego.orientation.z", "ego.orientation.w", "steering" -> Range.within(1.0);
      case "lane.left", "lane.right" -> new Range(half - wall, half + wall);
      case "lane.width" -> new Range(2 * half, 2 * half);
      case "lane.curvature" -> new Range(curvature, curvature);
      case "gap", "ttc" -> Range.upTo(Double.POSITIVE_INFINITY);
      case "lead.speed" -> Range.within(fastestOther());
      case "brake", "throttle" -> Range.upTo(1.0);
      default -> inputs.containsKey(signal) ? scripted(inputs.get(signal)) : Range.ALL;
    };
  }

  private static Range scripted(Script script) {
    List<Double> values = script.steps().stream().map(Script.Step::value).toList();
    return new Range(
        values.stream().min(Double::compare).orElseThrow(),
        values.stream().max(Double::compare).orElseThrow());
  }

  private boolean drives(Set<Actuator> actuators) {
    return bench.consumed().values().stream()
        .flatMap(topic -> topic.fields().stream())
        .flatMap(field -> field.actuator().stream())
        .anyMatch(actuators::contains);
  }

  /** Returns whether it can neither drive backwards nor turn round. */
  private boolean staysAhead() {
    return !drives(BACKWARDS) && !drives(WHEELS) && situation.ego().chassis().heading() == 0.0;
  }

  /** Returns the largest gain of speed, in m/s. */
  private double gained() {
    return situation.ego().maximalAcceleration() * (duration + situation.ego().speedStep());
  }

  private double fastest() {
    return situation.ego().speed() + gained();
  }

  /** Returns a bound of the distance, in m; in a bend, the lane's centre may be the longer way. */
  private double way() {
    double curvature = Math.abs(situation.road().curvature(0.0));
    double inside = 1.0 - curvature * Road.WALL_DISTANCE;
    return inside <= 0.0 ? Double.POSITIVE_INFINITY : fastest() * duration / inside;
  }

  private Range accelerations() {
    EgoVehicle ego = situation.ego();
    double drag = ego.chassis().drag() * fastest() * fastest();
    double braking =
        Math.max(
                Math.max(ego.maximalDeceleration(), ego.coastingDeceleration()),
                ego.chassis().handBrakeDeceleration())
            + drag;
    double driving = ego.maximalAcceleration();
    return drives(BACKWARDS)
        ? Range.within(Math.max(braking, driving))
        : new Range(-braking, driving);
  }

  private double fastestOther() {
    return situation.actors().stream().mapToDouble(each -> each.fastest()).max().orElse(0.0);
  }
}
