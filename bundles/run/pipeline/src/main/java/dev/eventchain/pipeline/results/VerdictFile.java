package dev.eventchain.pipeline.results;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * The content of {@code verdict.json}.
 *
 * @param stoppedIn the stage that is running or was stopped, if there is no verdict
 * @param driver the driver of nodes that were started elsewhere, if they were
 * @param suppressed the number of suppressed findings, if there are any
 * @param violated the rules that errors name
 * @param strength why the strength of requirements was not measured, or the size of its sample;
 *     empty if all faults were driven
 * @param unshown what no scenario shows of signals; absent if that was not recorded, or unless
 *     every scenario passed
 * @param requirements the outcome of each requirement; empty if there is no verdict
 */
public record VerdictFile(
    String chain,
    boolean passed,
    Optional<String> stoppedIn,
    Optional<String> driver,
    OptionalLong suppressed,
    @JsonInclude(JsonInclude.Include.NON_EMPTY) List<String> violated,
    Optional<String> strength,
    Optional<List<RequirementOutcome>> requirements,
    Optional<List<Unshown>> unshown,
    List<Scenario> scenarios,
    @JsonInclude(JsonInclude.Include.NON_EMPTY) List<SimulatedFault> faults) {

  /** The outcome of a scenario. */
  public record Scenario(
      String name,
      boolean tested,
      boolean passed,
      List<String> requirements,
      List<Criterion> criteria) {}

  /**
   * Something that no scenario shows of a signal.
   *
   * @param signal as formulas have it
   * @param gap its kind
   * @param words after "no scenario shows"
   */
  public record Unshown(String signal, String gap, String words) {}

  /** Copies the lists, of which JSON omits some where they are empty. */
  public VerdictFile {
    unshown = unshown == null ? Optional.empty() : unshown.map(List::copyOf);
    violated = violated == null ? List.of() : List.copyOf(violated);
    scenarios = List.copyOf(scenarios);
    faults = faults == null ? List.of() : List.copyOf(faults);
  }

  /**
   * Returns the content without a verdict.
   *
   * @param stage the stage that is running or was stopped; empty if the run could not begin
   */
  public static VerdictFile without(String chain, Optional<String> stage) {
    return new VerdictFile(
        chain,
        false,
        stage,
        Optional.empty(),
        OptionalLong.empty(),
        List.of(),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        List.of(),
        List.of());
  }
}
