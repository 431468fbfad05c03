package dev.eventchain.openscenario.storyboard.check;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.world.StoryboardRules;
import java.util.Map;
import java.util.Set;

/** Looks for values with which something cannot be done. */
final class ValueCheck {

  /** Attributes that may not be negative, of any element. */
  private static final Set<String> NOT_NEGATIVE =
      Set.of(
          "delay",
          "duration",
          "tolerance",
          "angleTolerance",
          "targetTolerance",
          "targetToleranceMaster",
          "distance",
          "timeGap",
          "distanceForward",
          "distanceBackward",
          "maxSpeed",
          "maxAcceleration",
          "maxDeceleration",
          "initialDistanceOffset");

  /** Attributes that have to be greater than 0, by their elements. */
  private static final Map<String, Set<String>> POSITIVE =
      Map.of(
          "Timing", Set.of("scale"),
          "LaneOffsetActionDynamics", Set.of("maxLateralAcc"),
          "Clothoid", Set.of("length"),
          "ClothoidSplineSegment", Set.of("length"),
          "ControlPoint", Set.of("weight"),
          "Event", Set.of("maximumExecutionCount"),
          "ManeuverGroup", Set.of("maximumExecutionCount"));

  private final Findings findings;

  ValueCheck(Findings findings) {
    this.findings = findings;
  }

  void check(ScenarioElement element) {
    Findings.within(element).forEach(this::checkOne);
  }

  private void checkOne(ScenarioElement element) {
    Set<String> positive = POSITIVE.getOrDefault(element.name(), Set.of());
    for (String attribute : element.values().keySet().stream().sorted().toList()) {
      if (positive.contains(attribute) && !(element.number(attribute) > 0)) {
        wrong(element, attribute, "has to be greater than 0");
      } else if (NOT_NEGATIVE.contains(attribute) && !(element.number(attribute) >= 0)) {
        wrong(element, attribute, "may not be negative");
      }
    }
    switch (element.name()) {
      case "SpeedActionDynamics", "LaneChangeActionDynamics" -> checkDynamics(element);
      case "LongitudinalDistanceAction" -> checkGap(element);
      case "FollowTrajectoryAction" -> checkTiming(element);
      default -> {}
    }
  }

  private void checkDynamics(ScenarioElement dynamics) {
    boolean step = dynamics.text("dynamicsShape").equals("step");
    boolean rate = dynamics.text("dynamicsDimension").equals("rate");
    double value = dynamics.number("value");
    if (rate && !step && !(value > 0)) {
      wrong(dynamics, "value", "is a rate, which has to be greater than 0");
    } else if (!(value >= 0)) {
      wrong(dynamics, "value", "may not be negative");
    }
  }

  private void checkGap(ScenarioElement action) {
    if (action.has("distance") == action.has("timeGap")) {
      findings.add(
          StoryboardRules.VALUE,
          action.location(),
          "LongitudinalDistanceAction needs either a distance or a timeGap.",
          "Give one of them.");
    }
  }

  private void checkTiming(ScenarioElement action) {
    boolean timed = action.child("TimeReference").flatMap(each -> each.child("Timing")).isPresent();
    if (timed && action.number("initialDistanceOffset", 0) > 0) {
      wrong(action, "initialDistanceOffset", "contradicts the times of the trajectory");
    }
  }

  private void wrong(ScenarioElement element, String attribute, String problem) {
    findings.add(
        StoryboardRules.VALUE,
        element.location(attribute),
        attribute + " of " + element.name() + " " + problem + ": " + element.text(attribute) + ".",
        "Correct the value, or the parameter that it comes from.");
  }
}
