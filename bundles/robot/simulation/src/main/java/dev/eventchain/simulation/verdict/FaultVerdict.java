package dev.eventchain.simulation.verdict;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The effect of a fault: what the vehicle did, compared with what it did without the fault, and
 * what detected the fault.
 *
 * @param name the fault's name
 * @param scenario the name of the scenario
 * @param injected the fault, for people
 * @param effect what it changed, for people
 * @param effective whether it made a difference to anything before the run was over
 * @param judged whether something is expected of the software
 * @param tested whether everything that is expected could be judged, or something fails
 * @param passed whether it was judged and tested, and everything holds
 * @param vehicle what the vehicle did
 * @param without what it did without the fault
 * @param deviation how far it was from where it was without the fault, at most
 * @param own the criteria of the scenario, which are not expected to hold
 * @param expected what is expected in spite of the fault, with its detection
 * @param detections what told of the fault, in the order of time; those without one last
 * @param ended why the run could not go on to its end; empty if it did
 * @param location where the fault is written
 */
public record FaultVerdict(
    String name,
    String scenario,
    String injected,
    String effect,
    boolean effective,
    boolean judged,
    boolean tested,
    boolean passed,
    Vehicle vehicle,
    Vehicle without,
    Deviation deviation,
    List<CriterionResult> own,
    List<CriterionResult> expected,
    List<Detection> detections,
    Optional<Diagnostic> ended,
    SourceLocation location) {

  /** Copies the lists. */
  public FaultVerdict {
    own = List.copyOf(own);
    expected = List.copyOf(expected);
    detections = List.copyOf(detections);
  }

  /**
   * What a vehicle did.
   *
   * @param impactSpeed in m/s; empty if there was no impact
   * @param impact who hit whom; empty if there was no impact
   * @param stopped since when it is stationary at the end, in s; empty if it moves
   * @param minimalGap to a vehicle in its path, in m; empty if there was none
   * @param speed at the end, in m/s
   * @param end when the run ended, in s
   */
  public record Vehicle(
      OptionalDouble impactSpeed,
      String impact,
      OptionalDouble stopped,
      OptionalDouble minimalGap,
      double speed,
      double end) {}

  /**
   * How far a vehicle was from where it was without the fault.
   *
   * @param distance in m
   * @param time when it was largest first, in s
   */
  public record Deviation(double distance, double time) {}

  /** What tells of a fault. */
  public enum Means {
    /** The software itself, by means that it declares: it did not work with what was too old. */
    SOFTWARE,
    /** A check of the simulation or of DDS, of which the software knows nothing. */
    CHECK,
    /** A node ended by its own error. */
    FAILURE
  }

  /**
   * Something that tells of a fault, and did not do so without it.
   *
   * @param id of the finding
   * @param element the node that it is about; may be empty
   * @param words what it says
   * @param time when, in s since the start of the scenario; empty if it is not known
   */
  public record Detection(
      Means means, String id, String element, String words, OptionalDouble time) {}

  /** Whether something told of the fault. */
  public boolean detected() {
    return !detections.isEmpty();
  }

  /**
   * A finding {@code simulation.fault.no-effect} if the fault changed nothing, which says nothing
   * about the software; else {@code simulation.fault.failed} for each expectation that does not
   * hold, and {@code simulation.fault.untested} for each that could not be judged.
   */
  public List<Diagnostic> diagnostics() {
    List<Diagnostic> found = new ArrayList<>();
    if (!effective) {
      found.add(
          Diagnostic.error(
                  "simulation.fault.no-effect",
                  String.format(
                      "The fault '%s' had no effect in scenario %s: %s.", name, scenario, effect),
                  location)
              .withHint("Choose a time and a target at which there is something to disturb."));
      return found;
    }
    for (CriterionResult each : expected) {
      if (!each.passed()) {
        String id = each.tested() ? "simulation.fault.failed" : "simulation.fault.untested";
        String pattern =
            each.tested()
                ? "Scenario %s with fault '%s': expected %s, but found: %s."
                : "Scenario %s with fault '%s': '%s' was not tested: %s.";
        String message = String.format(pattern, scenario, name, each.text(), each.measured());
        found.add(Diagnostic.error(id, message, each.location()));
      }
    }
    return found;
  }
}
