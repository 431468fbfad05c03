package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.engine.PipelineRun;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.RunResult;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.simulate.SimulateStage;
import dev.eventchain.pipeline.simulate.SimulationChecks;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.simulation.CaseSimulation;
import dev.eventchain.simulation.scenario.Scenario;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Campaigns of a project: many cases of a scenario, simulated on all processors. */
public final class Campaigns {

  private static final int TIMED = 10;

  private final RunContext run;
  private final CampaignOptions options;
  private final CampaignPlan plan;
  private final Scenario scenario;
  private final ScenarioTemplate template;
  private Optional<CaseSimulation> simulation = Optional.empty();

  private Campaigns(RunContext run, CampaignOptions options, CampaignPlan plan) {
    this.run = run;
    this.options = options;
    this.plan = plan;
    List<Scenario> scenarios =
        Scenario.readFolder(run.project().scenarios(), run.chain().bench(), run::find);
    this.scenario = ScenarioTemplate.find(scenarios, plan);
    this.template = new ScenarioTemplate(run, plan, Path.of(scenario.location().file()));
  }

  /**
   * Generates the nodes of a project, as far as something has changed, and simulates the cases of a
   * campaign that are not known yet.
   *
   * @param settings options of the run up to the generation, in lock-step
   * @throws DiagnosticException for failures caused by the project, the campaign file or this
   *     machine
   */
  public static CampaignOutcome run(
      Project project, RunOptions settings, CampaignOptions options, Progress progress) {
    CampaignPlan plan = CampaignReader.read(options.file());
    RunResult generated = PipelineRun.run(project, settings, progress, Optional.empty()).result();
    if (generated.failure().isPresent() || Diagnostic.anyError(generated.diagnostics())) {
      return new CampaignOutcome(Outcome.of(generated), "");
    }
    try (OutputFolder output = OutputFolder.open(settings.output())) {
      RunContext run = new RunContext(project, settings, output, progress, Optional.empty());
      generated.diagnostics().forEach(run::find);
      return new Campaigns(run, options, plan).run();
    }
  }

  /** Returns the JSON Schema of campaign files. */
  public static String schema() {
    try (InputStream input = Campaigns.class.getResourceAsStream("campaign.schema.json")) {
      return new String(input.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private CampaignOutcome run() {
    long start = System.nanoTime();
    requireSound();
    CaseList list = new CaseList(plan);
    List<CampaignCase> all = list.cases();
    // First, since it may be the folder that is written into.
    Optional<CampaignComparison.Earlier> earlier = options.compared().map(CampaignComparison::read);
    CampaignStore.Cases empty =
        new CampaignStore.Cases(plan.name(), inputs(), options.shard(), false, List.of());
    try (CampaignStore store = new CampaignStore(run.options().output(), empty)) {
      List<CampaignCase> own = own(all);
      if (options.replayed().isPresent()) {
        return new CaseReplay(run, plan, template, store).replay(options.replayed().getAsInt());
      }
      if (options.dryRun()) {
        return estimate(own, store);
      }
      int known = store.rows().size();
      store.begin();
      if (!options.merged().isEmpty()) {
        CampaignMerge.rows(options.merged(), empty.inputs()).forEach(store::add);
      }
      simulate(own, store);
      plan.boundary().ifPresent(it -> search(new BoundarySearch(it), list, store));
      requireUnchanged(empty.inputs(), store);
      return outcome(store, known, earlier, System.nanoTime() - start);
    }
  }

  private void requireSound() {
    List<Diagnostic> problems = template.check();
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    SimulationChecks.requireSound(run, List.of(scenario)).forEach(run::find);
  }

  /** Returns a hash of all that a result depends on: what a simulation does, and the campaign. */
  private String inputs() {
    Fingerprint fingerprint = new Fingerprint(run);
    new SimulateStage().fingerprint(run, fingerprint);
    fingerprint.addFile(plan.file());
    plan.factors().forEach(factor -> fingerprint.add(factor.levels()));
    return fingerprint.value();
  }

  /** Drops the results if some of them may be of other files than the others. */
  private void requireUnchanged(String before, CampaignStore store) {
    if (!inputs().equals(before)) {
      store.discard();
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  CampaignRules.INPUTS_CHANGED,
                  "Files of the project or the campaign were changed while it ran.",
                  SourceLocation.of(plan.file()))
              .withHint("Nobody can say which cases are of which state. Run it again."));
    }
  }

  /** Returns the cases of this part: combinations stay together along a boundary. */
  private List<CampaignCase> own(List<CampaignCase> all) {
    Map<CampaignCase, Integer> indices = new LinkedHashMap<>();
    List<CampaignCase> own = new ArrayList<>();
    for (CampaignCase each : all) {
      CampaignCase whole =
          plan.boundary().map(it -> each.with(it.factor(), BigDecimal.ZERO)).orElse(each);
      int index = indices.computeIfAbsent(whole, it -> indices.size());
      if (options.shard().has(index)) {
        own.add(each);
      }
    }
    return own;
  }

  private void search(BoundarySearch search, CaseList list, CampaignStore store) {
    List<CampaignCase> next;
    do {
      next =
          search.next(store.rows()).stream()
              .filter(each -> store.find(each).isEmpty() && list.keeps(each))
              .toList();
      simulate(next, store);
    } while (!next.isEmpty());
  }

  private void simulate(List<CampaignCase> cases, CampaignStore store) {
    List<CampaignCase> open = cases.stream().filter(each -> store.find(each).isEmpty()).toList();
    if (open.isEmpty()) {
      return;
    }
    CampaignProgress progress =
        new CampaignProgress(run.progress(), store.rows().size(), open.size());
    try {
      simulation()
          .run(
              open.size(),
              number -> template.of(open.get(number)),
              (number, result) -> {
                store.add(new CampaignRow(open.get(number), result));
                progress.done(result);
              });
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("nobody interrupts a campaign", e);
    } finally {
      store.save();
    }
  }

  private CaseSimulation simulation() {
    if (simulation.isEmpty()) {
      int processes = Runtime.getRuntime().availableProcessors();
      simulation =
          Optional.of(
              new CaseSimulation(
                  SimulateStage.request(run, List.of(scenario))
                      .with(it -> it.withProcesses(processes)),
                  run.python(Stage.SIMULATE)));
    }
    return simulation.get();
  }

  /** Simulates a few cases, evenly from all, to say how long all take. */
  private CampaignOutcome estimate(List<CampaignCase> own, CampaignStore store) {
    List<CampaignCase> open = own.stream().filter(each -> store.find(each).isEmpty()).toList();
    List<CampaignCase> timed = new ArrayList<>();
    for (int i = 0; i < Math.min(TIMED, open.size()); i++) {
      timed.add(open.get((int) ((long) i * open.size() / Math.min(TIMED, open.size()))));
    }
    long start = System.nanoTime();
    simulate(timed, store);
    double seconds = (System.nanoTime() - start) / 1e9 / Math.max(1, timed.size()) * open.size();
    String text =
        "%s, %d of them simulated already; the others take about %s.%s%n"
            .formatted(
                Coverage.counted(own.size(), "case"),
                own.size() - open.size(),
                CampaignProgress.words(seconds),
                plan.boundary().isPresent() ? " The search for the boundary comes on top." : "");
    return new CampaignOutcome(Outcome.of(Coverage.NONE, run.takeFindings(), List.of()), text);
  }

  private CampaignOutcome outcome(
      CampaignStore store, int known, Optional<CampaignComparison.Earlier> earlier, long nanos) {
    store.complete();
    List<CampaignRow> rows = List.copyOf(store.rows());
    Optional<CampaignComparison> comparison = earlier.map(it -> it.beside(rows));
    CampaignSummary summary = new CampaignSummary(plan, rows);
    CampaignTable table = new CampaignTable(plan.names(), rows);
    store.write(CampaignStore.TABLE, table.csv());
    store.write(
        CampaignStore.PAGE,
        CampaignPage.of(run.project(), plan, options.shard(), rows, comparison)
            .getBytes(StandardCharsets.UTF_8));
    run.progress()
        .ended(
            Stage.SIMULATE,
            known == rows.size() ? Progress.Status.UNCHANGED : Progress.Status.DONE,
            Duration.ofNanos(nanos),
            Coverage.counted(rows.size(), "case") + " in " + store.path(CampaignStore.TABLE));
    List<Diagnostic> found = new ArrayList<>(run.takeFindings());
    if (options.shard().isAll()) { // a part says nothing about the whole
      found.addAll(summary.findings(SourceLocation.of(plan.file())));
    }
    Suppressions.Parted parted = run.options().suppressions().part(found);
    String report = "Report: " + store.path(CampaignStore.PAGE) + "\n";
    return new CampaignOutcome(
        Outcome.of(Coverage.NONE, parted.remaining(), parted.suppressed()).with(summary.trials()),
        summary.text() + comparison.map(CampaignComparison::text).orElse("") + report);
  }
}
