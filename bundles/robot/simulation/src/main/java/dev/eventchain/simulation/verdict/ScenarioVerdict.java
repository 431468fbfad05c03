package dev.eventchain.simulation.verdict;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;

/**
 * Verdict on the software in a scenario.
 *
 * @param scenario the scenario's name
 * @param title the scenario's title
 * @param requirements ids of all requirements that the scenario or one of its criteria names,
 *     without those whose criteria the run did not ask
 * @param worked true if every component worked; if not, no criterion was judged
 * @param tested true if every component worked and every criterion could be judged, or one fails
 * @param passed true if it was tested and every criterion holds
 * @param criteria the results of the criteria
 * @param observed what was only observed: it counts for no verdict
 * @param figures measurements of the world and of the chain's commands
 * @param latency from a stimulus of the chain's first node to the first command that is based on
 *     it, in ms; empty if no command is based on it
 * @param latencies measurements of each latency constraint of the chain, in its order
 * @param flow the message flow
 * @param series the curves over time
 * @param samples what the nodes read and wrote, where it was kept
 * @param happened what a storyboard let happen, and how the run went on by it, in the order of
 *     time; empty without one
 */
public record ScenarioVerdict(
    String scenario,
    String title,
    List<String> requirements,
    boolean worked,
    boolean tested,
    boolean passed,
    List<CriterionResult> criteria,
    List<CriterionResult> observed,
    List<Figure> figures,
    Optional<Measurements.Statistics> latency,
    List<Optional<Latency>> latencies,
    MessageFlow flow,
    Series series,
    List<FieldSamples> samples,
    List<Happened> happened) {

  /** Copies the lists. */
  public ScenarioVerdict {
    requirements = List.copyOf(requirements);
    criteria = List.copyOf(criteria);
    observed = List.copyOf(observed);
    latencies = List.copyOf(latencies);
    figures = List.copyOf(figures);
    samples = List.copyOf(samples);
    happened = List.copyOf(happened);
  }

  /** Returns a copy with other latencies of the constraints. */
  public ScenarioVerdict withLatencies(List<Optional<Latency>> others) {
    return new ScenarioVerdict(
        scenario,
        title,
        requirements,
        worked,
        tested,
        passed,
        criteria,
        observed,
        figures,
        latency,
        others,
        flow,
        series,
        samples,
        happened);
  }

  /**
   * Words of a requirement that a criterion judges.
   *
   * @param requirement its id
   * @param words as the scenario quotes them
   */
  public record Judged(String requirement, String words) {}

  /**
   * A criterion and its outcome.
   *
   * @param text the requirement, in words
   * @param tested true if its premise came true
   * @param passed true if it was tested and holds
   * @param measured the measured figures, in words
   * @param margin the distance from the opposite verdict; empty if it has no size
   * @param decided the time of what decides it, in s since the start; empty if no single moment
   *     does
   * @param otherwise the times next to it at which what decides it is the other way round, in s
   * @param judges the words of requirements that it judges; may be empty
   * @param limits the numbers that signals are compared with
   * @param location its location in the scenario
   * @param requirements ids of the requirements that it tests
   * @param cause the finding about an impact that its own finding is a consequence of; empty if it
   *     stands for itself
   */
  public record CriterionResult(
      String text,
      boolean tested,
      boolean passed,
      String measured,
      Optional<Margin> margin,
      OptionalDouble decided,
      List<Double> otherwise,
      List<Judged> judges,
      List<Limit> limits,
      SourceLocation location,
      List<String> requirements,
      Optional<Diagnostic.Cause> cause) {

    private static final String FIRST = "See first to what ended the run.";

    /** Copies the lists. */
    public CriterionResult {
      otherwise = List.copyOf(otherwise);
      judges = List.copyOf(judges);
      limits = List.copyOf(limits);
      requirements = List.copyOf(requirements);
    }

    /** Returns a copy that is a consequence of an impact, or of none. */
    public CriterionResult withCause(Optional<Diagnostic.Cause> impact) {
      return new CriterionResult(
          text,
          tested,
          passed,
          measured,
          margin,
          decided,
          otherwise,
          judges,
          limits,
          location,
          requirements,
          impact);
    }

    /** Returns its finding, which names the cause if it is a consequence. */
    Diagnostic asConsequence(Diagnostic finding) {
      return cause
          .map(it -> finding.withCause(it).withHint((FIRST + " " + finding.hint()).strip()))
          .orElse(finding);
    }

    /**
     * Returns the part of its margin in another run that is left in this one; infinite if it does
     * not hold in both, or its margin has no size.
     */
    public double leftOf(CriterionResult other) {
      if (!passed || margin.isEmpty() || other.margin.isEmpty()) {
        return Double.POSITIVE_INFINITY;
      }
      double before = other.margin.get().value();
      double left = margin.get().value() / before;
      return before > 0 && Double.isFinite(left) ? left : Double.POSITIVE_INFINITY;
    }
  }

  /**
   * Distance of a criterion from the opposite verdict, negative if it does not hold.
   *
   * @param value in the unit
   * @param unit the unit of the compared values; 1 for a ratio
   * @param time the time of the margin, in s since the start
   */
  public record Margin(double value, String unit, double time) {}

  /** A number, in the signal's unit, with which a criterion compares a signal. */
  public record Limit(String signal, double value) {}

  /** Statistic of a quantity over a scenario. */
  public enum Statistic {
    /** The smallest value of the scenario. */
    MINIMUM,
    /** The largest value of the scenario. */
    MAXIMUM,
    /** The value at the end. */
    FINAL
  }

  /**
   * A measured number.
   *
   * @param name of the quantity
   * @param unit of the value; 1 for a ratio
   * @param statistic the statistic of the quantity
   * @param value finite
   * @param time first time of the value, in s since the start
   */
  public record Figure(String name, String unit, Statistic statistic, double value, double time) {}

  /**
   * Measurements of a latency constraint.
   *
   * @param statistics of all its times, in ms
   * @param slowest the parts of the longest of them, in the order of the data; they add up to it
   * @param values the part of each time by which values are later than the messages, in ms: the
   *     value latency of the components
   */
  public record Latency(Measurements.Statistics statistics, List<Part> slowest, double values) {

    /** Copies the list. */
    public Latency {
      slowest = List.copyOf(slowest);
    }

    /** Returns a copy with the value latencies of components on the path, in ms, by their names. */
    public Latency withValues(Map<String, Double> delays) {
      double later = delays.values().stream().mapToDouble(Double::doubleValue).sum();
      List<Part> parts =
          slowest.stream().map(it -> it.later(delays.getOrDefault(it.node(), 0.0))).toList();
      return new Latency(statistics.later(later), parts, values + later);
    }
  }

  /**
   * Part of a component in a latency, in ms of simulated time.
   *
   * @param node the component's name
   * @param waiting age of its input when it started
   * @param execution its execution time, as stated by the model, and its value latency
   */
  public record Part(String node, double waiting, double execution) {

    private Part later(double delay) {
      return new Part(node, waiting, execution + delay);
    }
  }

  /**
   * Curves and scene, every 50 ms.
   *
   * @param time since the start, in s
   * @param curves one for each quantity
   * @param scene the positions of everything
   */
  public record Series(List<Double> time, List<Curve> curves, Scene scene) {

    /** Copies the lists. */
    public Series {
      time = List.copyOf(time);
      curves = List.copyOf(curves);
    }
  }

  /**
   * A line on the ground, in m.
   *
   * @param broken whether it has dashes
   */
  public record Line(boolean broken, List<Double> x, List<Double> y) {

    /** Copies the lists. */
    public Line {
      x = List.copyOf(x);
      y = List.copyOf(y);
    }
  }

  /**
   * The road from above, in m and rad, in the plane in which the road starts along x at the ego's
   * front bumper.
   *
   * @param curvature of the road, in 1/m, to the left is positive
   * @param laneWidth in m
   * @param wallDistance of the walls from the centre of the ego's lane, in m; 0 if there are none
   * @param lines those of a map, in place of the lines of lanes; none of other roads
   * @param ego the vehicle with the software
   * @param others all others, except those above the road
   * @param scans some of the scans of the lidar, if the software has one
   */
  public record Scene(
      double curvature,
      double laneWidth,
      double wallDistance,
      List<Line> lines,
      Mover ego,
      List<Mover> others,
      List<Scan> scans) {

    /** Copies the lists. */
    public Scene {
      lines = List.copyOf(lines);
      others = List.copyOf(others);
      scans = List.copyOf(scans);
    }
  }

  /**
   * Positions of a box.
   *
   * @param name its name
   * @param length in m
   * @param width in m
   * @param x of its middle, one for each time of the series, or one for all; NaN once it is gone
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
   * Nearest echoes of a scan, except those of the road.
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

  /** Returns the results of the criteria that test a requirement, in their order. */
  public Stream<CriterionResult> criteriaOf(String requirement) {
    return criteria.stream().filter(each -> each.requirements().contains(requirement));
  }

  /**
   * Returns a finding {@code simulation.criterion.failed} for each criterion that does not hold,
   * and {@code simulation.criterion.untested} for each whose premise never came true. Returns none
   * if not all components worked, so that no criterion was judged.
   */
  public List<Diagnostic> diagnostics() {
    if (!worked) {
      return List.of(); // The simulation's findings name the silent component.
    }
    return criteria.stream()
        .filter(criterion -> !criterion.passed())
        .map(criterion -> criterion.tested() ? failed(criterion) : untested(criterion))
        .toList();
  }

  private Diagnostic failed(CriterionResult criterion) {
    return criterion.asConsequence(
        Diagnostic.of(
            VerdictRules.CRITERION_FAILED,
            String.format(
                "Scenario %s: expected %s, but found: %s.",
                scenario, criterion.text(), criterion.measured()),
            criterion.location()));
  }

  private Diagnostic untested(CriterionResult criterion) {
    return criterion.asConsequence(
        Diagnostic.of(
                VerdictRules.CRITERION_UNTESTED,
                String.format(
                    "Scenario %s: '%s' was not tested: %s.",
                    scenario, criterion.text(), criterion.measured()),
                criterion.location())
            .withHint(
                "Change the scenario so that the situation occurs, mark the criterion as optional if"
                    + " correct software need not come to it, or leave it out."));
  }
}
