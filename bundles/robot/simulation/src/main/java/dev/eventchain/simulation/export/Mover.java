package dev.eventchain.simulation.export;

import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.ActorKind;
import dev.eventchain.simulation.world.EgoMotion;
import dev.eventchain.simulation.world.HumanDriver;
import dev.eventchain.simulation.world.LateralProfile;
import dev.eventchain.simulation.world.Motion;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Situation;
import java.util.function.DoubleFunction;

/**
 * The vehicle under test or an actor, with its reference point: of a vehicle the middle of its rear
 * axle, of anything else its middle, on the ground.
 *
 * @param entity the name of its entity
 * @param pointer to its part of the scenario
 * @param gap from the ego's front bumper to the end of it that comes first at the start, in m
 * @param reach from its reference point ahead to the point whose way is scripted, in m
 * @param direction relative to that of the road, in rad
 * @param turns whether it turns while it moves sideways
 * @param place of the reference point after some seconds, as far as times are known
 */
record Mover(
    String entity,
    String pointer,
    Motion motion,
    double gap,
    double reach,
    double direction,
    boolean turns,
    DoubleFunction<Road.Place> place) {

  /** Distance of a vehicle's rear axle from its rear end, as a part of its length; assumed. */
  private static final double REAR = 0.2;

  private static final double EQUAL = 1e-9;

  /** Slope that a vehicle's heading does not exceed while it moves sideways. */
  static final double STEEPEST = 1.0 / 3.0;

  /** Returns how far ahead of the reference point an actor's middle is, in m. */
  static double reach(Actor actor) {
    return isVehicle(actor.kind()) ? (0.5 - REAR) * actor.size().length() : 0.0;
  }

  static boolean isVehicle(ActorKind kind) {
    return switch (kind) {
      case CAR, LORRY, MOTORCYCLE, BICYCLE, PARKED_CAR -> true;
      case PEDESTRIAN, OVERHEAD_SIGN, BRIDGE, GUARD_RAIL, STEEL_PLATE, OBSTACLE -> false;
    };
  }

  /** Returns an actor that follows a script. */
  static Mover of(Actor actor, String entity, String pointer, Road road) {
    double reach = reach(actor);
    return new Mover(
        entity,
        pointer,
        actor.script().orElseThrow(),
        actor.rear(0.0),
        reach,
        actor.direction(),
        actor.turns(),
        seconds -> actor.body(road, seconds).place().ahead(-reach));
  }

  /** Returns the vehicle under test as its driver drives it. */
  static Mover ego(Situation situation) {
    HumanDriver driver = situation.driver();
    Motion motion = driver.motion();
    Road road = situation.road();
    double reach = situation.ego().axleToBumper();
    Road.Place start = new EgoMotion(situation.ego()).front().ahead(-reach);
    boolean steered = driver.scripted() || !road.isStraight();
    return new Mover(
        EntityNames.EGO,
        "/ego",
        motion,
        0.0,
        reach,
        steered ? 0.0 : start.heading(),
        true,
        seconds -> seconds == 0.0 ? start : driven(road, motion, seconds).ahead(-reach));
  }

  private static Road.Place driven(Road road, Motion motion, double seconds) {
    LateralProfile line = motion.line();
    Road.Place place = road.place(motion.speed().way(seconds), line.offset(seconds));
    double rate = line.rate(seconds);
    double forwards = Math.max(motion.speed().speed(seconds), Math.abs(rate) / STEEPEST);
    double turned = rate == 0.0 ? 0.0 : StrictMath.atan(rate / forwards);
    return new Road.Place(place.x(), place.y(), place.heading() + turned);
  }

  /** Returns whether it follows the road, in its direction or against it. */
  boolean followsTheRoad() {
    return direction == 0.0 || isOncoming();
  }

  private boolean isOncoming() {
    return sign(direction) < 0.0;
  }

  /** Returns 1 for a direction along the road, -1 for one against it, else 0. */
  static double sign(double direction) {
    return direction == 0.0 ? 1.0 : Math.abs(Math.abs(direction) - Math.PI) < EQUAL ? -1.0 : 0.0;
  }

  /** Returns whether it ever moves. */
  boolean moves() {
    return motion.fastest() > 0.0 || !motion.line().moves().isEmpty() || motion.waits();
  }
}
