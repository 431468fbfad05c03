package dev.eventchain.pipeline.simulate;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.results.VerdictFile;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/** The content of {@code verdict.json}. */
public final class VerdictJson {

  private VerdictJson() {}

  /**
   * Returns the content of {@code verdict.json}: the same bytes for the same nodes and scenarios.
   *
   * @param outcomes the outcome of each requirement
   * @param strength why the strength of requirements was not measured, or the size of its sample;
   *     empty if all faults were driven
   * @param found all findings about scenarios and measurements, suppressed ones apart; each
   *     scenario that did not pass has one
   */
  static byte[] of(
      EventChain chain,
      SimulationResult result,
      List<RequirementOutcome> outcomes,
      Optional<String> strength,
      Suppressions.Parted found) {
    List<Diagnostic> errors =
        found.remaining().stream().filter(each -> each.severity() == Severity.ERROR).toList();
    int suppressed = found.suppressed().size();
    boolean accepted = result.passed() || suppressed > 0;
    List<String> violated =
        errors.stream()
            .filter(each -> !each.kind().has(CommonTrait.UNTESTED))
            .map(Diagnostic::rule)
            .filter(rule -> !rule.isEmpty())
            .distinct()
            .toList();
    return ResultJson.indented(
        new VerdictFile(
            chain.getName(),
            accepted && errors.isEmpty(),
            Optional.empty(),
            SimulationReport.attached(result.host()),
            suppressed > 0 ? OptionalLong.of(suppressed) : OptionalLong.empty(),
            violated,
            strength,
            Optional.of(outcomes),
            UnshownSignals.of(result).listed(),
            result.verdicts().stream().map(VerdictJson::outcome).toList(),
            FaultReport.of(result)));
  }

  private static VerdictFile.Scenario outcome(ScenarioVerdict verdict) {
    return new VerdictFile.Scenario(
        verdict.scenario(),
        verdict.tested(),
        verdict.passed(),
        verdict.requirements(),
        SimulationReport.criteria(verdict));
  }

  /**
   * Returns the content of {@code verdict.json} without a verdict, because a run is in progress or
   * was stopped.
   *
   * @param stage the stage that is running or was stopped; empty if the run could not begin
   */
  public static byte[] without(String chain, Optional<Stage> stage) {
    return ResultJson.indented(VerdictFile.without(chain, stage.map(Stage::id)));
  }

  /** Returns the name of the verdict's chain; empty if it cannot be read. */
  public static String chainOf(byte[] verdict) {
    return ResultJson.ifValid(verdict, VerdictFile.class).map(VerdictFile::chain).orElse("");
  }
}
