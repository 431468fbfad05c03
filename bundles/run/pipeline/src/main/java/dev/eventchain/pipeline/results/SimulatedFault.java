package dev.eventchain.pipeline.results;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The result of a fault, for the report and {@code verdict.json}.
 *
 * @param injected the fault, in words
 * @param effect its effect, in words
 * @param judged true if the plan states an expectation
 * @param detected true if anything detected it
 * @param text the result in a sentence
 * @param vehicle the behaviour of the vehicle with the fault
 * @param without its behaviour without the fault
 * @param criteria the criteria of the scenario
 * @param expected the criteria of the fault
 * @param ended why the run was ended, if it was
 * @param line its line in the plan of faults
 */
public record SimulatedFault(
    String name,
    String scenario,
    String injected,
    String effect,
    boolean effective,
    boolean judged,
    boolean tested,
    boolean passed,
    boolean detected,
    String text,
    Vehicle vehicle,
    Vehicle without,
    Deviation deviation,
    List<Criterion> criteria,
    List<Criterion> expected,
    List<Detection> detections,
    Optional<String> ended,
    int line) {

  /** Copies the lists. */
  public SimulatedFault {
    criteria = List.copyOf(criteria);
    expected = List.copyOf(expected);
    detections = List.copyOf(detections);
  }

  /**
   * The behaviour of a vehicle, in m, m/s, and s since the start.
   *
   * @param did in words
   * @param impactSpeed its speed at an impact; empty without one
   * @param impact what it hit, if anything
   * @param stopped the time at which it stopped; empty if it did not
   * @param minimalGap the smallest gap to another one; empty if there is none
   * @param speed its speed at the end
   * @param end the end
   */
  public record Vehicle(
      String did,
      @JsonProperty("impact_speed") OptionalDouble impactSpeed,
      Optional<String> impact,
      OptionalDouble stopped,
      @JsonProperty("minimal_gap") OptionalDouble minimalGap,
      double speed,
      double end) {}

  /** The largest distance in m between the vehicle with and without the fault, and its time. */
  public record Deviation(double distance, double time) {}

  /**
   * A detection of the fault.
   *
   * @param by the means
   * @param id the identifier of the finding
   * @param time in s since the start; empty if unknown
   */
  public record Detection(String by, String id, String element, String text, OptionalDouble time) {}
}
