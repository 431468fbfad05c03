package dev.eventchain.pipeline.results;

import com.fasterxml.jackson.annotation.JsonInclude;
import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The result of a scenario, with the curves and the scene that the report draws. Lists of numbers
 * hold null where a quantity has no value; such lists are not copied.
 *
 * @param text the result in a sentence
 * @param requirements the identifiers of the requirements that it tests
 * @param observed what is only reported, as it counts for no verdict
 * @param measurements the measured figures
 * @param latency the latency of the chain, in ms; empty if it was not measured
 * @param happened what a storyboard let happen
 */
public record SimulatedScenario(
    String name,
    String title,
    boolean tested,
    boolean passed,
    String text,
    List<String> requirements,
    List<Criterion> criteria,
    @JsonInclude(JsonInclude.Include.NON_EMPTY) List<Criterion> observed,
    List<Figure> measurements,
    Optional<Statistics> latency,
    Series series,
    Scene scene,
    @JsonInclude(JsonInclude.Include.NON_EMPTY) List<Happened> happened) {

  /** Copies the lists. */
  public SimulatedScenario {
    requirements = List.copyOf(requirements);
    criteria = List.copyOf(criteria);
    observed = observed == null ? List.of() : List.copyOf(observed);
    measurements = List.copyOf(measurements);
    happened = happened == null ? List.of() : List.copyOf(happened);
  }

  /**
   * Something that happened, in s since the start.
   *
   * @param kind {@code event}, {@code takeover} or {@code end}
   */
  public record Happened(String name, String kind, double start, OptionalDouble end) {}

  /**
   * A measured number.
   *
   * @param time first time of the value, in s since the start
   */
  public record Figure(String name, String unit, String statistic, double value, double time) {}

  /**
   * Curves over time.
   *
   * @param time since the start, in s
   */
  public record Series(List<Double> time, List<Signal> signals) {}

  /**
   * A quantity over time.
   *
   * @param absent why it has no values, if it has none
   * @param values one for each time
   * @param names the names of values, if they have any
   */
  public record Signal(
      String name,
      String unit,
      Optional<String> absent,
      List<Double> values,
      @JsonInclude(JsonInclude.Include.NON_EMPTY) List<Name> names) {

    /** Copies the list of names. */
    public Signal {
      names = names == null ? List.of() : List.copyOf(names);
    }
  }

  /** A value with a name. */
  public record Name(double value, String name) {}

  /** The road from above, in m and rad; lines are those of a map. */
  public record Scene(
      double curvature,
      @JsonProperty("lane_width") double laneWidth,
      @JsonProperty("wall_distance") double wallDistance,
      List<Line> lines,
      Mover ego,
      List<Mover> others,
      List<Scan> scans) {}

  /** A line on the ground, in m. */
  public record Line(boolean broken, List<Double> x, List<Double> y) {}

  /** The positions of a box, one for each time of the series, or one for all. */
  public record Mover(
      String name,
      double length,
      double width,
      List<Double> x,
      List<Double> y,
      List<Double> heading) {}

  /**
   * The echoes of a scan.
   *
   * @param time since the start, in s
   */
  public record Scan(double time, List<Double> x, List<Double> y) {}
}
