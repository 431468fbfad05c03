package dev.eventchain.simulation.verdict;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Effect of a fault: the motion of the vehicle, compared with that without the fault, and the
 * detections of the fault.
 *
 * @param name the fault's name
 * @param scenario the name of the scenario
 * @param injected the fault, for users
 * @param effect the effect of the fault, for users
 * @param effective true if it had an effect before the end of the run
 * @param judged true if the software must meet a requirement
 * @param tested true if every requirement could be judged, or one fails
 * @param passed true if it was judged and tested, and every requirement holds
 * @param vehicle the motion of the vehicle
 * @param without the motion of the vehicle without the fault
 * @param deviation the largest distance from the position without the fault
 * @param own the criteria of the scenario, which are not expected to hold
 * @param expected the requirements in spite of the fault, including its detection
 * @param detections the detections of the fault, in the order of time; those without one last
 * @param ended why the run ended early; empty if it did not
 * @param location the location of the fault in its file
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
   * Motion of a vehicle.
   *
   * @param impactSpeed in m/s; empty if there was no impact
   * @param impact the parties of the impact, in words; empty if there was none
   * @param stopped start of the standstill at the end, in s; empty if it moves
   * @param minimalGap to a vehicle in its path, in m; empty if there was none
   * @param speed at the end, in m/s
   * @param end time of the end of the run, in s
   */
  public record Vehicle(
      OptionalDouble impactSpeed,
      String impact,
      OptionalDouble stopped,
      OptionalDouble minimalGap,
      double speed,
      double end) {}

  /**
   * Distance of a vehicle from its position without the fault.
   *
   * @param distance in m
   * @param time when it first was largest, in s
   */
  public record Deviation(double distance, double time) {}

  /** Means of detecting a fault. */
  public enum Means {
    /** The software itself, by declared means: it did not work with outdated inputs. */
    SOFTWARE,
    /** A check of the simulation or of DDS, outside the software. */
    CHECK,
    /** A node ended by its own error. */
    FAILURE
  }

  /**
   * A sign of a fault that is absent without the fault.
   *
   * @param kind the kind of the finding
   * @param element the affected node; may be empty
   * @param words the message of the finding
   * @param time in s since the start of the scenario; empty if unknown
   */
  public record Detection(
      Means means, Rule kind, String element, String words, OptionalDouble time) {

    /** Returns the id of the finding. */
    public String id() {
      return kind.id();
    }
  }

  /** Returns whether the fault was detected. */
  public boolean detected() {
    return !detections.isEmpty();
  }

  /**
   * Returns a finding {@code simulation.fault.no-effect} if the fault had no effect, so that the
   * run says nothing about the software. Otherwise returns {@code simulation.fault.failed} for each
   * requirement that does not hold, and {@code simulation.fault.untested} for each that could not
   * be judged.
   */
  public List<Diagnostic> diagnostics() {
    List<Diagnostic> found = new ArrayList<>();
    if (!effective) {
      found.add(
          Diagnostic.of(
                  VerdictRules.FAULT_NO_EFFECT,
                  String.format(
                      "The fault '%s' had no effect in scenario %s: %s.", name, scenario, effect),
                  location)
              .withHint("Choose a time and a target at which there is something to disturb."));
      return found;
    }
    for (CriterionResult each : expected) {
      if (!each.passed()) {
        Rule rule = each.tested() ? VerdictRules.FAULT_FAILED : VerdictRules.FAULT_UNTESTED;
        String pattern =
            each.tested()
                ? "Scenario %s with fault '%s': expected %s, but found: %s."
                : "Scenario %s with fault '%s': '%s' was not tested: %s.";
        String message = String.format(pattern, scenario, name, each.text(), each.measured());
        found.add(each.asConsequence(Diagnostic.of(rule, message, each.location())));
      }
    }
    return found;
  }
}
