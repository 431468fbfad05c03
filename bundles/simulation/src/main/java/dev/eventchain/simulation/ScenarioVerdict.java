package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * How the software did in a scenario.
 *
 * @param scenario the scenario's name
 * @param title the scenario's title
 * @param requirements ids of the requirements that it tests
 * @param tested whether every component worked and every criterion could be judged, or one fails
 * @param passed whether it was tested and every criterion holds
 * @param criteria each criterion with what was measured
 * @param minimalGap smallest distance to a vehicle in the own lane, in m; empty without one
 * @param impactSpeed relative speed at the impact, in m/s; empty without an impact
 * @param timeToCollisionAtFirstBraking in s; empty without braking, or if nothing was approached
 * @param firstBraking time of the first brake command, in s; empty without braking
 * @param latency from a point cloud to the first brake command that is based on it, in ms; empty if
 *     no command is based on one
 * @param latencies what was measured of each latency constraint of the chain, in its order
 * @param series what happened, every 50 ms
 */
public record ScenarioVerdict(
    String scenario,
    String title,
    List<String> requirements,
    boolean tested,
    boolean passed,
    List<CriterionResult> criteria,
    OptionalDouble minimalGap,
    OptionalDouble impactSpeed,
    OptionalDouble timeToCollisionAtFirstBraking,
    OptionalDouble firstBraking,
    Optional<Measurements.Statistics> latency,
    List<Optional<Measurements.Statistics>> latencies,
    List<Moment> series) {

  /** Copies the lists. */
  public ScenarioVerdict {
    requirements = List.copyOf(requirements);
    criteria = List.copyOf(criteria);
    latencies = List.copyOf(latencies);
    series = List.copyOf(series);
  }

  /**
   * A criterion and its outcome.
   *
   * @param text what must hold, in words
   * @param tested whether what it is about ever came up
   * @param passed whether it was tested and holds
   * @param measured the figures that say so, in words
   * @param location where the scenario asks for it
   */
  public record CriterionResult(
      String text, boolean tested, boolean passed, String measured, SourceLocation location) {}

  /**
   * A moment, in simulated time and SI units.
   *
   * @param time since the start, in s
   * @param egoSpeed in m/s
   * @param gap to the nearest vehicle in the own lane, in m; infinite without one
   * @param timeToCollision from the true gap and closing speed, in s; infinite if nothing is
   *     approached
   * @param brake the brake command in force, 0 to 1
   * @param deceleration of the ego, in m/s2
   */
  public record Moment(
      double time,
      double egoSpeed,
      double gap,
      double timeToCollision,
      double brake,
      double deceleration) {}

  /**
   * A finding {@code simulation.criterion.failed} for each criterion that does not hold, and {@code
   * simulation.criterion.untested} for each whose premise never came true; none if not all
   * components worked, so that no criterion was judged.
   */
  public List<Diagnostic> diagnostics() {
    if (criteria.stream().noneMatch(CriterionResult::tested)) {
      return List.of();
    }
    return criteria.stream()
        .filter(criterion -> !criterion.passed())
        .map(criterion -> criterion.tested() ? failed(criterion) : untested(criterion))
        .toList();
  }

  private Diagnostic failed(CriterionResult criterion) {
    return Diagnostic.error(
        "simulation.criterion.failed",
        String.format(
            "Scenario %s: expected %s, but found: %s.",
            scenario, criterion.text(), criterion.measured()),
        criterion.location());
  }

  private Diagnostic untested(CriterionResult criterion) {
    return Diagnostic.error(
            "simulation.criterion.untested",
            String.format(
                "Scenario %s: '%s' was not tested: %s.",
                scenario, criterion.text(), criterion.measured()),
            criterion.location())
        .withHint("Change the scenario so that it comes up, or leave the criterion out.");
  }
}
