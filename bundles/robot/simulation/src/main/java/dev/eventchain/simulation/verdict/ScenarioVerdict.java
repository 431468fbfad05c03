package dev.eventchain.simulation.verdict;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;
import java.util.Optional;

/**
 * How the software did in a scenario.
 *
 * @param scenario the scenario's name
 * @param title the scenario's title
 * @param requirements ids of the requirements that it tests
 * @param worked whether every component did; if not, no criterion was judged
 * @param tested whether every component worked and every criterion could be judged, or one fails
 * @param passed whether it was tested and every criterion holds
 * @param criteria each criterion with what was measured
 * @param figures what was measured of the world and of what the chain commands
 * @param latency from what the chain's first node senses to the first command that is based on it,
 *     in ms; empty if no command is based on it
 * @param latencies what was measured of each latency constraint of the chain, in its order
 * @param flow how messages went
 * @param series what happened over time
 */
public record ScenarioVerdict(
    String scenario,
    String title,
    List<String> requirements,
    boolean worked,
    boolean tested,
    boolean passed,
    List<CriterionResult> criteria,
    List<Figure> figures,
    Optional<Measurements.Statistics> latency,
    List<Optional<Latency>> latencies,
    MessageFlow flow,
    Series series) {

  /** Copies the lists. */
  public ScenarioVerdict {
    requirements = List.copyOf(requirements);
    criteria = List.copyOf(criteria);
    latencies = List.copyOf(latencies);
    figures = List.copyOf(figures);
  }

  /**
   * A criterion and its outcome.
   *
   * @param text what must hold, in words
   * @param tested whether what it is about ever came up
   * @param passed whether it was tested and holds
   * @param measured the figures that say so, in words
   * @param margin how far what decides is from the other verdict; empty where it has no size
   * @param limits the numbers that signals are compared with
   * @param location where the scenario asks for it
   */
  public record CriterionResult(
      String text,
      boolean tested,
      boolean passed,
      String measured,
      Optional<Margin> margin,
      List<Limit> limits,
      SourceLocation location) {

    /** Copies the list. */
    public CriterionResult {
      limits = List.copyOf(limits);
    }
  }

  /**
   * How far a criterion is from the other verdict, below zero if it does not hold.
   *
   * @param value in the unit
   * @param unit that of what is compared; 1 for a ratio
   * @param time when it is so, in s since the start
   */
  public record Margin(double value, String unit, double time) {}

  /** A number, in the signal's unit, that a criterion compares a signal with. */
  public record Limit(String signal, double value) {}

  /** What one number of a scenario is. */
  public enum Statistic {
    /** The smallest value of the scenario. */
    MINIMUM,
    /** The largest value of the scenario. */
    MAXIMUM,
    /** The value at the end. */
    FINAL
  }

  /**
   * A number that was measured.
   *
   * @param name of the quantity
   * @param unit of the value; 1 for a ratio
   * @param statistic which of its values it is
   * @param value finite
   * @param time when it was so first, in s since the start
   */
  public record Figure(String name, String unit, Statistic statistic, double value, double time) {}

  /**
   * What was measured of a latency constraint.
   *
   * @param statistics of all its times, in ms
   * @param slowest what the longest of them consists of, in the order of the data; sums up to it
   */
  public record Latency(Measurements.Statistics statistics, List<Part> slowest) {

    /** Copies the list. */
    public Latency {
      slowest = List.copyOf(slowest);
    }
  }

  /**
   * What a component contributes to a latency, in ms of simulated time.
   *
   * @param node the component's name
   * @param waiting how long what it works on had been there when it started
   * @param execution how long it executed: the model's number
   */
  public record Part(String node, double waiting, double execution) {}

  /**
   * What happened, every 50 ms.
   *
   * @param time since the start, in s
   * @param curves one for each quantity
   * @param scene where everything was
   */
  public record Series(List<Double> time, List<Curve> curves, Scene scene) {

    /** Copies the lists. */
    public Series {
      time = List.copyOf(time);
      curves = List.copyOf(curves);
    }
  }

  /**
   * The road from above, in m and rad, in the plane in which the road starts along x at the ego's
   * front bumper.
   *
   * @param curvature of the road, in 1/m, to the left is positive
   * @param laneWidth in m
   * @param wallDistance of the walls from the centre of the ego's lane, in m
   * @param ego the vehicle with the software
   * @param others all others, but for what is above the road
   * @param scans what the lidar saw, if the software has one; not each of its scans
   */
  public record Scene(
      double curvature,
      double laneWidth,
      double wallDistance,
      Mover ego,
      List<Mover> others,
      List<Scan> scans) {

    /** Copies the lists. */
    public Scene {
      others = List.copyOf(others);
      scans = List.copyOf(scans);
    }
  }

  /**
   * Where a box was.
   *
   * @param name who it is
   * @param length in m
   * @param width in m
   * @param x of its middle, one for each time of the series, or one for all; not a number where it
   *     is gone
   * @param y as x
   * @param heading as x
   */
  public record Mover(
      String name,
      double length,
      double width,
      List<Double> x,
      List<Double> y,
      List<Double> heading) {

    /** Copies the lists. */
    public Mover {
      x = List.copyOf(x);
      y = List.copyOf(y);
      heading = List.copyOf(heading);
    }
  }

  /**
   * The nearest echoes of a scan, but for those of the road.
   *
   * @param time since the start, in s
   */
  public record Scan(double time, List<Double> x, List<Double> y) {

    /** Copies the lists. */
    public Scan {
      x = List.copyOf(x);
      y = List.copyOf(y);
    }
  }

  /**
   * A quantity over time.
   *
   * @param name of the quantity
   * @param unit of the values; 1 for a ratio
   * @param absence why it says nothing; empty if it says something
   * @param values one for each time of the series, infinite or not a number where there is none
   */
  public record Curve(String name, String unit, String absence, List<Double> values) {

    /** Copies the list. */
    public Curve {
      values = List.copyOf(values);
    }
  }

  /**
   * A finding {@code simulation.criterion.failed} for each criterion that does not hold, and {@code
   * simulation.criterion.untested} for each whose premise never came true; none if not all
   * components worked, so that no criterion was judged.
   */
  public List<Diagnostic> diagnostics() {
    if (!worked) {
      return List.of(); // The simulation's own findings say which component did not, and why.
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
        .withHint("Change the scenario so that the situation occurs, or leave the criterion out.");
  }
}
