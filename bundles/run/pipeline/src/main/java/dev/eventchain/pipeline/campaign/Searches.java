package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.pipeline.campaign.plan.Purpose;
import dev.eventchain.pipeline.campaign.plan.SearchSettings;
import dev.eventchain.pipeline.campaign.plan.Shard;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.pipeline.campaign.result.CampaignStore;
import dev.eventchain.pipeline.campaign.result.CampaignSummary;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.simulation.verdict.CaseResult;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.stream.IntStream;

/** Searches for cases of a scenario that fail: they minimise the margins of its criteria. */
public final class Searches {

  static final String FOLDER = "searches";

  private final CampaignScene scene;
  private final CampaignPlan plan;
  private final SearchSettings settings;
  private final boolean keeps;

  /**
   * Options of a search.
   *
   * @param file the campaign file
   * @param only the campaign of a file of several
   * @param keeps true to make the finds scenarios of the project
   */
  public record Options(Path file, Optional<String> only, boolean keeps) {}

  /** Results of a search and of the making of simple finds. */
  private record Results(
      SearchWork.Result search, List<SearchFinds.Find> finds, List<CampaignCase> asked) {}

  private Searches(CampaignScene scene, boolean keeps) {
    this.scene = scene;
    this.plan = scene.plan();
    this.settings = plan.search();
    this.keeps = keeps;
  }

  /**
   * Generates the nodes of a project, as far as something has changed, and searches for cases of a
   * campaign file that fail.
   *
   * @param settings options of the run up to the generation, in lock-step
   * @throws DiagnosticException for failures caused by the project, the campaign file or this
   *     machine
   */
  public static CampaignOutcome run(
      Project project, RunOptions settings, Options options, Progress progress) {
    return CampaignScene.of(
        project,
        settings,
        options.file(),
        path -> List.of(plan(path, options.only())),
        progress,
        scenes -> new Searches(scenes.get(0), options.keeps()).run());
  }

  private static CampaignPlan plan(Path file, Optional<String> only) {
    List<CampaignPlan> all = CampaignReader.readForSearch(file);
    return new ChosenCampaigns(only, true).of(all).get(0).ofSearch();
  }

  private CampaignOutcome run() {
    long start = System.nanoTime();
    CampaignScene.requireSound(List.of(scene), Purpose.SEARCH);
    requireCriterion();
    SearchSpace space = new SearchSpace(plan);
    CampaignStore.Cases empty = scene.cases(Optional.empty(), Shard.ALL);
    Path folder = scene.run().options().output().resolve(FOLDER);
    try (CampaignStore store = new CampaignStore(folder, empty, scene::isUnchanged)) {
      int known = store.rows().size();
      store.begin(FoundScenarios.FOLDER);
      Results results = simulate(space, store);
      scene.requireUnchanged(store);
      boolean isNew = store.rows().size() > known;
      CampaignOutcome outcome = outcome(space, results, store);
      scene
          .run()
          .progress()
          .ended(
              Stage.SIMULATE,
              isNew ? Progress.Status.DONE : Progress.Status.UNCHANGED,
              Duration.ofNanos(System.nanoTime() - start),
              Coverage.counted(results.search().runs().size(), "run")
                  + " in "
                  + store.path(CampaignStore.TABLE));
      return outcome;
    }
  }

  /** Requires that the criterion that is minimised is the one of a case that begins so. */
  private void requireCriterion() {
    if (settings.criterion().isEmpty()) {
      return;
    }
    NamedCriterion.problem(
            CampaignRules.SEARCH_CRITERION,
            settings.criterion().get(),
            plan.scenario(),
            scene.template().criteriaOfSearch())
        .ifPresent(
            found -> {
              throw new DiagnosticException(DiagnosticException.Reason.INPUT, found);
            });
  }

  /** Searches on a thread of its own, while this one simulates what is asked for. */
  private Results simulate(SearchSpace space, CampaignStore store) {
    CaseQueue queue = new CaseQueue(store::find);
    SearchWork work = new SearchWork(space, settings, plan.seed(), queue::ask);
    CompletableFuture<Results> results = new CompletableFuture<>();
    Thread director = new Thread(() -> direct(work, space, queue, results), "search");
    director.start();
    try {
      scene
          .simulation()
          .run(
              queue,
              number -> scene.template().of(queue.get(number)),
              (number, result) -> done(queue, number, result, store));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("nobody interrupts a search", e);
    } finally {
      queue.stop();
      store.save();
    }
    return join(results);
  }

  private void direct(
      SearchWork work, SearchSpace space, CaseQueue queue, CompletableFuture<Results> results) {
    try {
      SearchWork.Result search = work.run();
      SearchFinds finds = new SearchFinds(space, scene.template().usual(), queue::ask);
      List<SearchFinds.Find> found = finds.of(search.runs());
      results.complete(new Results(search, found, List.copyOf(finds.asked())));
    } catch (RuntimeException | Error e) { // thrown by the thread that waits for the results
      results.completeExceptionally(e);
    } finally {
      queue.stop();
    }
  }

  private static Results join(CompletableFuture<Results> results) {
    try {
      return results.join();
    } catch (CompletionException e) {
      if (e.getCause() instanceof DiagnosticException known) {
        throw known;
      }
      throw e;
    } catch (CancellationException e) {
      throw new IllegalStateException("the simulation ended before the search", e);
    }
  }

  private void done(CaseQueue queue, int number, CaseResult result, CampaignStore store) {
    store.add(new CampaignRow(queue.get(number), result));
    queue.done(number, result);
    scene
        .run()
        .progress()
        .step(
            Stage.SIMULATE,
            String.format(Locale.ROOT, "run %d, %d planned", number + 1, settings.runs()));
  }

  private CampaignOutcome outcome(SearchSpace space, Results results, CampaignStore store) {
    List<CampaignRow> rows = results.search().rows();
    requireAny(rows);
    SearchReport report = new SearchReport(plan, space, results.search(), results.finds());
    FoundScenarios found = new FoundScenarios(scene, results.finds());
    found.write(store);
    store.write(CampaignStore.TABLE, report.table());
    Set<CampaignCase> lasting = new TreeSet<>(CampaignCase.ORDER);
    rows.forEach(row -> lasting.add(row.id()));
    int searched = lasting.size();
    lasting.addAll(results.asked());
    store.retain(lasting);
    store.complete();
    List<String> files =
        IntStream.rangeClosed(1, results.finds().size())
            .mapToObj(number -> store.path(found.file(number)).toString())
            .toList();
    String kept = keeps ? found.keep() : "";
    String text = kept + report.text(files, lasting.size() - searched);
    return new CampaignOutcome(outcome(rows, report.findings(files)), text);
  }

  private void requireAny(List<CampaignRow> rows) {
    if (rows.isEmpty()) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  CampaignRules.EMPTY,
                  "The conditions keep none of the combinations that were drawn at first.",
                  SourceLocation.of(plan.file()))
              .withHint(
                  "Loosen a condition under 'where', or narrow the factors to what it keeps."));
    }
  }

  private Outcome outcome(List<CampaignRow> rows, List<Diagnostic> found) {
    CampaignSummary summary = new CampaignSummary(plan, rows, scene.template().ofCriteria(rows));
    List<Diagnostic> all = new ArrayList<>(scene.run().takeFindings());
    all.addAll(found);
    all.addAll(summary.findings(scene.place(), false));
    Suppressions.Parted parted = scene.run().options().suppressions().part(all);
    return Outcome.of(Coverage.NONE, parted.remaining(), parted.suppressed())
        .with(new CampaignSummary(plan, rows.stream().distinct().toList()).trials());
  }
}
