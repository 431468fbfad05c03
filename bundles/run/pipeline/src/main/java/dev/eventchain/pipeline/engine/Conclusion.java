package dev.eventchain.pipeline.engine;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.Suppressions.Suppressed;
import dev.eventchain.diagnostics.Trial;
import dev.eventchain.llm.chat.AnswerRules;
import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.report.EarlierRun;
import dev.eventchain.pipeline.report.ReportData;
import dev.eventchain.pipeline.report.ReportPage;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.Simulated;
import dev.eventchain.pipeline.results.SimulatedFault;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.Progress.Status;
import dev.eventchain.pipeline.run.RunResult;
import dev.eventchain.pipeline.run.RunResult.FaultLine;
import dev.eventchain.pipeline.run.RunResult.RequirementLine;
import dev.eventchain.pipeline.run.RunResult.ScenarioLine;
import dev.eventchain.pipeline.run.RunResult.Verdict;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.simulate.RequirementOutcomes;
import dev.eventchain.pipeline.simulate.RequirementStrength;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageOutcome;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/** The conclusion of a run: the verdict and the report. */
final class Conclusion {

  private final RunContext run;
  private final Map<Stage, StageOutcome> outcomes;
  private final Optional<Reason> failure;
  private final Progress progress;
  private final EarlierRun before;
  private final boolean reportStays;

  /**
   * Concludes a run whose stages have ended.
   *
   * @param failure the reason why it could not continue, if it could not
   * @param before the earlier run that the report compares with
   * @param reportStays true if the standing report is about a verdict that has to stay visible
   */
  Conclusion(
      RunContext run,
      Map<Stage, StageOutcome> outcomes,
      Optional<Reason> failure,
      Progress progress,
      EarlierRun before,
      boolean reportStays) {
    this.run = run;
    this.outcomes = outcomes;
    this.failure = failure;
    this.progress = progress;
    this.before = before;
    this.reportStays = reportStays;
  }

  RunResult conclude() {
    List<Diagnostic> found = found();
    List<Suppressed> suppressed =
        List.copyOf(new LinkedHashSet<>(all(outcome -> outcome.found().suppressed())));
    Coverage coverage =
        outcomes.values().stream().map(StageOutcome::coverage).reduce(Coverage.NONE, Coverage::and);
    found.addAll(aboutSuppressions(found, suppressed, coverage));
    List<ScenarioLine> scenarios = scenarioLines();
    Verdict verdict = verdict(found);
    requireReason(verdict, scenarios, suppressed);
    String summary = summary(verdict, scenarios, found) + suppressedText(suppressed) + attached();
    Optional<Path> report = report(verdict, summary, found);
    Evidence evidence = evidence(found, suppressed, verdict + ": " + summary);
    return new RunResult(
        verdict,
        summary,
        scenarios,
        found,
        suppressed,
        coverage,
        report,
        failure,
        List.of(),
        faultLines(),
        trials(verdict, found, suppressed, evidence),
        requirementLines(),
        evidence);
  }

  private Evidence evidence(List<Diagnostic> found, List<Suppressed> suppressed, String summary) {
    List<Diagnostic> accepted = suppressed.stream().map(Suppressed::finding).toList();
    return CollectedEvidence.of(
        run, simulated(), found, accepted, outcome(Stage.IMPLEMENT), summary);
  }

  private List<Trial> trials(
      Verdict verdict, List<Diagnostic> found, List<Suppressed> suppressed, Evidence evidence) {
    boolean simulates = run.options().runs(Stage.SIMULATE);
    boolean passed = verdict == Verdict.PASSED;
    return RunTrials.of(simulated(), found, suppressed, passed, evidence, simulates);
  }

  /**
   * Returns all findings without repetitions: stages that need a valid model report those of the
   * validation, too.
   */
  private List<Diagnostic> found() {
    List<Diagnostic> all = all(StageOutcome::diagnostics);
    all.addAll(run.takeFindings());
    return new ArrayList<>(new LinkedHashSet<>(all));
  }

  private <T> List<T> all(Function<StageOutcome, List<T>> part) {
    return outcomes.values().stream()
        .flatMap(outcome -> part.apply(outcome).stream())
        .collect(Collectors.toCollection(ArrayList::new));
  }

  private static void requireReason(
      Verdict verdict, List<ScenarioLine> scenarios, List<Suppressed> suppressed) {
    boolean unproved = scenarios.stream().anyMatch(scenario -> !scenario.passed());
    if (verdict == Verdict.PASSED && unproved && suppressed.isEmpty()) {
      throw new IllegalStateException("a scenario did not pass, and no finding says why");
    }
  }

  /** Returns the report, written now unless the standing one stays; adds findings about it. */
  private Optional<Path> report(Verdict verdict, String summary, List<Diagnostic> found) {
    if (reportStays) {
      return Optional.of(run.file(ReportPage.FILE)).filter(Files::isRegularFile);
    }
    boolean reportable = !run.options().isPartial() && !failure.equals(Optional.of(Reason.WAITING));
    if (!run.options().runs(Stage.REPORT) || !reportable) {
      return Optional.empty();
    }
    Optional<Path> report = writeReport(verdict, summary, found);
    found.addAll(run.takeFindings());
    return report;
  }

  /**
   * Returns findings about suppressions that have expired or match nothing: about all of them in a
   * run of all stages, else about those for the model if it was checked.
   */
  private List<Diagnostic> aboutSuppressions(
      List<Diagnostic> found, List<Suppressed> suppressed, Coverage coverage) {
    boolean everything =
        failure.isEmpty()
            && !run.options().isPartial()
            && outcomes.values().stream().noneMatch(o -> o.status() == Status.NOT_RUN);
    List<Diagnostic> all = new ArrayList<>(found);
    suppressed.forEach(each -> all.add(each.finding()));
    return run.options().suppressions().warnings(all, coverage, everything);
  }

  private Verdict verdict(List<Diagnostic> found) {
    if (failure.isPresent() && failure.get() != Reason.FINDINGS) {
      return Verdict.INCOMPLETE;
    }
    if (failure.isPresent() || Diagnostic.anyError(found)) {
      boolean tests = run.options().runs(Stage.SIMULATE);
      return tests && onlyUntested(found) ? Verdict.INCOMPLETE : Verdict.FAILED;
    }
    boolean judged =
        outcome(Stage.SIMULATE).status() != Status.NOT_RUN && !run.options().isPartial();
    return judged ? Verdict.PASSED : Verdict.INCOMPLETE;
  }

  /** Returns whether all findings are about missing tests. */
  private static boolean onlyUntested(List<Diagnostic> found) {
    return Diagnostic.anyError(found)
        && found.stream()
            .filter(each -> each.severity() == Severity.ERROR)
            .allMatch(each -> each.kind().has(CommonTrait.UNTESTED));
  }

  private String summary(Verdict verdict, List<ScenarioLine> scenarios, List<Diagnostic> found) {
    long passed = scenarios.stream().filter(ScenarioLine::passed).count();
    String scenarioText = passed + " of " + scenarios.size() + " scenarios passed";
    long errors = found.stream().filter(finding -> finding.severity() == Severity.ERROR).count();
    String errorText = Coverage.counted(errors, "error");
    String requirements =
        simulated().map(it -> RequirementOutcomes.counted(it.requirements())).orElse("");
    String counted = faultText() + (requirements.isEmpty() ? "" : requirements + ", ");
    return switch (verdict) {
      case PASSED ->
          requirements.isEmpty() && faultText().isEmpty()
              ? scenarioText
              : (scenarioText + ", " + counted).replaceFirst(", $", "");
      case FAILED -> scenarios.isEmpty() ? errorText : scenarioText + ", " + counted + errorText;
      case INCOMPLETE ->
          onlyUntested(found)
              ? untested(scenarios, scenarioText) + ": " + counted + errorText
              : failure.isPresent() ? stopped() : unjudged(scenarios, scenarioText);
    };
  }

  /** Returns the requirements whose strength was measured in this run. */
  private List<RequirementLine> requirementLines() {
    List<RequirementLine> lines = new ArrayList<>();
    for (RequirementOutcome each : simulated().map(Simulated::requirements).orElse(List.of())) {
      each.strength()
          .map(RequirementStrength::words)
          .ifPresent(it -> lines.add(new RequirementLine(each.id(), each.outcome().words(), it)));
    }
    return lines;
  }

  /** Returns the simulation of this run; an earlier one proves nothing about it. */
  private Optional<Simulated> simulated() {
    StageOutcome simulated = outcomes.get(Stage.SIMULATE);
    return simulated.status() == Status.NOT_RUN
        ? Optional.empty()
        : simulated.report(Simulated.class);
  }

  private static String untested(List<ScenarioLine> scenarios, String scenarioText) {
    return scenarios.isEmpty()
        ? "nothing was simulated"
        : scenarioText + ", but not all was tested";
  }

  /** Returns the number of suppressed findings as text, which a verdict must not hide. */
  private static String suppressedText(List<Suppressed> suppressed) {
    int count = suppressed.size();
    return count == 0 ? "" : ", " + Coverage.counted(count, "finding") + " suppressed";
  }

  /** Returns a note on nodes that were started elsewhere. */
  private String attached() {
    return simulated().flatMap(Simulated::attached).map(words -> " (" + words + ")").orElse("");
  }

  private String stopped() {
    if (failure.equals(Optional.of(Reason.WAITING))) {
      return "waiting for " + Coverage.counted(awaited(), "answer");
    }
    return outcomes.values().stream()
        .filter(outcome -> outcome.status() == Status.FAILED)
        .map(outcome -> "stopped in the stage '" + outcome.stage().id() + "'")
        .findFirst()
        .orElse("stopped");
  }

  private long awaited() {
    return outcomes.values().stream()
        .flatMap(outcome -> outcome.diagnostics().stream())
        .filter(finding -> finding.is(AnswerRules.HANDOFF_WAITING))
        .count();
  }

  private String unjudged(List<ScenarioLine> scenarios, String scenarioText) {
    return scenarios.isEmpty()
        ? lastDetails()
        : scenarioText + "; no verdict, because the others were not simulated";
  }

  /** Returns the details of the last stage, for a run without a verdict. */
  private String lastDetails() {
    return outcomes.values().stream()
        .filter(outcome -> outcome.status() != Status.NOT_RUN)
        .reduce((earlier, later) -> later)
        .map(StageOutcome::details)
        .orElse("nothing to do");
  }

  private List<ScenarioLine> scenarioLines() {
    return simulated().map(Simulated::scenarios).orElse(List.of()).stream()
        .map(
            it ->
                new ScenarioLine(it.name(), it.tested(), it.passed(), it.text() + before.words(it)))
        .toList();
  }

  /**
   * Returns the number of judged faults that went as expected, and the number of faults not judged.
   */
  private String faultText() {
    List<SimulatedFault> faults = faults();
    long judged = faults.stream().filter(SimulatedFault::judged).count();
    long passed = faults.stream().filter(SimulatedFault::passed).count();
    long observed = faults.size() - judged;
    String text =
        judged == 0 ? "" : passed + " of " + Coverage.counted(judged, "fault") + " as expected, ";
    return observed == 0 ? text : text + Coverage.counted(observed, "fault") + " not judged, ";
  }

  /** Returns the results of the faults in this run. */
  private List<FaultLine> faultLines() {
    return faults().stream()
        .map(it -> new FaultLine(it.name(), it.judged() && it.tested(), it.passed(), it.text()))
        .toList();
  }

  private List<SimulatedFault> faults() {
    return simulated().map(Simulated::faults).orElse(List.of());
  }

  private StageOutcome outcome(Stage stage) {
    return outcomes.get(stage);
  }

  private Optional<Path> writeReport(Verdict verdict, String summary, List<Diagnostic> found) {
    progress.started(Stage.REPORT);
    long start = System.nanoTime();
    try {
      ReportData collected = new ReportData(run, outcomes, before);
      byte[] page =
          ReportPage.render(
              collected.chain(),
              collected.heading(verdict, summary),
              collected.collect(verdict, summary, found));
      run.writeResult(ReportPage.FILE, page);
      ended(Status.DONE, start, run.file(ReportPage.FILE).toString());
      return Optional.of(run.file(ReportPage.FILE));
    } catch (DiagnosticException e) {
      e.diagnostics().forEach(run::find);
      ended(Status.FAILED, start, e.diagnostics().get(0).message());
      return Optional.empty();
    }
  }

  private void ended(Status status, long start, String details) {
    progress.ended(Stage.REPORT, status, Duration.ofNanos(System.nanoTime() - start), details);
  }
}
