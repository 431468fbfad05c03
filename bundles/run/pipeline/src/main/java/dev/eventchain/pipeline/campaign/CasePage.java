package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Suppressions.Parted;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.pipeline.report.EarlierRun;
import dev.eventchain.pipeline.report.ReportData;
import dev.eventchain.pipeline.report.ReportPage;
import dev.eventchain.pipeline.results.Simulated;
import dev.eventchain.pipeline.results.StageReport;
import dev.eventchain.pipeline.run.Progress.Status;
import dev.eventchain.pipeline.run.RunResult.Verdict;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.simulate.SimulateStage;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageOutcome;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The report of one case of a campaign, with what a run reports of a scenario. */
final class CasePage {

  private final RunContext run;
  private final SimulationResult result;

  CasePage(RunContext run, SimulationResult result) {
    this.run = run;
    this.result = result;
  }

  /**
   * Returns the page.
   *
   * @param label the case's in the table
   * @param summary the line below the heading
   */
  byte[] render(Scenario scenario, Label label, String summary) {
    EventChain measured = result.measuredModel(run.chain().chain());
    List<Diagnostic> found = new ArrayList<>(result.diagnostics());
    result.verdicts().forEach(verdict -> found.addAll(verdict.diagnostics()));
    Simulated simulated = SimulateStage.report(run, List.of(scenario), result, measured, found);
    Parted parted = run.options().suppressions().part(found);
    Map<Stage, StageOutcome> outcomes = new EnumMap<>(Stage.class);
    for (Stage stage : Stage.values()) {
      outcomes.put(stage, outcome(stage, Status.NOT_RUN, "", List.of(), Optional.empty()));
    }
    String details = result.verdicts().size() + " scenario";
    outcomes.put(
        Stage.SIMULATE,
        outcome(Stage.SIMULATE, Status.DONE, details, parted.remaining(), Optional.of(simulated)));
    ReportData data = new ReportData(run, outcomes, EarlierRun.read(Optional.empty()));
    Verdict verdict = verdict(label, parted.remaining());
    return ReportPage.render(
        measured,
        data.heading(verdict, summary),
        data.collect(verdict, summary, parted.remaining()));
  }

  private static StageOutcome outcome(
      Stage stage,
      Status status,
      String details,
      List<Diagnostic> found,
      Optional<StageReport> report) {
    Parted parted = new Parted(found, List.of());
    return new StageOutcome(stage, status, Duration.ZERO, details, parted, Coverage.NONE, report);
  }

  /** Returns the verdict, which is no pass where something was not tested, unlike a case's. */
  private static Verdict verdict(Label label, List<Diagnostic> found) {
    return switch (label) {
      case PASSED -> Diagnostic.anyError(found) ? Verdict.INCOMPLETE : Verdict.PASSED;
      case UNTESTED -> Verdict.INCOMPLETE;
      case FAILED, ERROR -> Verdict.FAILED;
    };
  }
}
