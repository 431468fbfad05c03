package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.ResourceText;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import dev.eventchain.pipeline.campaign.plan.Purpose;
import dev.eventchain.pipeline.campaign.result.BoundarySearch;
import dev.eventchain.pipeline.campaign.result.CampaignComparison;
import dev.eventchain.pipeline.campaign.result.CampaignMerge;
import dev.eventchain.pipeline.campaign.result.CampaignPage;
import dev.eventchain.pipeline.campaign.result.CampaignPoints;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.pipeline.campaign.result.CampaignStore;
import dev.eventchain.pipeline.campaign.result.CampaignSummary;
import dev.eventchain.pipeline.campaign.result.CampaignTable;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Campaigns of a project: many cases of a scenario, simulated on all processors. */
public final class Campaigns {

  private static final int TIMED = 10;

  private final RunContext run;
  private final CampaignOptions options;
  private final CampaignPlan plan;
  private final CampaignScene scene;

  private Campaigns(CampaignScene scene, CampaignOptions options) {
    this.run = scene.run();
    this.options = options;
    this.plan = scene.plan();
    this.scene = scene;
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
    return CampaignScene.of(
        project,
        settings,
        options.file(),
        file -> plans(file, options),
        progress,
        scenes -> run(scenes, options));
  }

  private static List<CampaignPlan> plans(Path file, CampaignOptions options) {
    List<CampaignPlan> all = CampaignReader.read(file);
    List<CampaignPlan> chosen = new ChosenCampaigns(options.only(), options.needsOne()).of(all);
    List<Diagnostic> problems = CriteriaOfCases.withoutCase(chosen, all);
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return chosen;
  }

  /** Simulates one campaign after the other, once all are known to be sound. */
  private static CampaignOutcome run(List<CampaignScene> scenes, CampaignOptions options) {
    CampaignScene.requireSound(scenes, Purpose.CAMPAIGN);
    List<CampaignOutcome> each =
        scenes.stream().map(scene -> new Campaigns(scene, options).run()).toList();
    List<CampaignPlan> plans = scenes.stream().map(CampaignScene::plan).toList();
    return each.size() == 1 ? each.get(0) : CampaignOutcome.of(plans, each);
  }

  /** Returns the JSON Schema of campaign files. */
  public static String schema() {
    return ResourceText.of(Campaigns.class, "campaign.schema.json");
  }

  private CampaignOutcome run() {
    long start = System.nanoTime();
    CaseList list = new CaseList(plan);
    Combinations combinations = new Combinations(plan, list.cases());
    // First, since it may be the folder that is written into.
    Optional<CampaignComparison.Earlier> earlier = options.compared().map(CampaignComparison::read);
    Fingerprint inputs = scene.inputs();
    List<CampaignStore.Cases> parts = CampaignMerge.parts(options.merged(), inputs.value());
    CampaignStore.Cases empty =
        scene.cases(parts.stream().findFirst().map(CampaignStore.Cases::platform), options.shard());
    try (CampaignStore store =
        new CampaignStore(
            run.options().output().resolve(CampaignStore.FOLDER), empty, scene::isUnchanged)) {
      List<CampaignCase> own = combinations.of(options.shard());
      if (options.replayed().isPresent()) {
        return new CaseReplay(run, plan, scene.template(), store)
            .replay(options.replayed().getAsInt());
      }
      if (options.dryRun()) {
        return estimate(own, store);
      }
      int known = store.rows().size();
      store.begin();
      parts.forEach(part -> part.rows().forEach(store::add));
      simulate(combinations, list, inputs, store, empty);
      return outcome(store, known, earlier, System.nanoTime() - start);
    }
  }

  /** Simulates what is not known, on a cluster if one is asked for, and the boundary. */
  private void simulate(
      Combinations combinations,
      CaseList list,
      Fingerprint inputs,
      CampaignStore store,
      CampaignStore.Cases empty) {
    options
        .engine()
        .map(engine -> new RayCampaign(run, plan, engine, store, empty))
        .ifPresent(ray -> ray.simulate(combinations, inputs));
    simulate(combinations.of(options.shard()), store);
    plan.boundary().ifPresent(it -> search(new BoundarySearch(it), list, store));
    scene.requireUnchanged(store);
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
      scene
          .simulation()
          .run(
              open.size(),
              number -> scene.template().of(open.get(number)),
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
        String.format(
            Locale.ROOT,
            "%s, %d of them simulated already; the others take about %s.%s%n",
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
    CampaignSummary summary = new CampaignSummary(plan, rows, scene.template().ofCriteria(rows));
    CampaignTable table = new CampaignTable(plan.names(), rows);
    Optional<CampaignPoints> points = CampaignPoints.of(plan, rows);
    store.write(CampaignStore.TABLE, points.map(it -> it.in(table)).orElse(table).csv());
    points.ifPresent(it -> store.write(CampaignStore.POINTS, it.json(plan, rows)));
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
    if (options.shard().coversAll()) { // a part says nothing about the whole
      found.addAll(summary.findings(scene.place()));
    }
    Suppressions.Parted parted = run.options().suppressions().part(found);
    String report = "Report: " + store.path(CampaignStore.PAGE) + "\n";
    return new CampaignOutcome(
        Outcome.of(Coverage.NONE, parted.remaining(), parted.suppressed()).with(summary.trials()),
        summary.text() + comparison.map(CampaignComparison::text).orElse("") + report);
  }
}
