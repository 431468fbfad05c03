package dev.eventchain.pipeline.engine;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.report.ReportPage;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.simulate.SimulateStage;
import dev.eventchain.pipeline.simulate.SimulationReport;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageMemory;
import dev.eventchain.pipeline.stage.StageRecord;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * The results of an earlier simulation, and the report, while a run works. They are withdrawn
 * before anything is done that may lead to other results, so that no unfounded verdict remains,
 * even if the run is killed; and put back if it turns out that they still hold.
 */
public final class StandingResults {

  /** What states a verdict, or belongs to one, besides the verdict itself. */
  private static final List<String> OTHERS =
      List.of(
          SimulateStage.MEASUREMENTS,
          SimulateStage.MEASUREMENTS_TABLE,
          SimulateStage.MEASURED_MODEL,
          ReportPage.FILE);

  private final RunContext run;
  private final StageMemory memory;
  private final Map<String, byte[]> contents = new TreeMap<>();
  private Optional<StageRecord> record = Optional.empty();
  private boolean withdrawn;

  StandingResults(RunContext run, StageMemory memory) {
    this.run = run;
    this.memory = memory;
  }

  /**
   * Withdraws the results; the verdict says in which stage the run is, and stays so if it ends
   * there. A run that is not to reach a verdict makes none where there is none.
   */
  void withdraw(Stage stage) {
    boolean reachesVerdict = run.options().runs(Stage.SIMULATE) && !run.options().isPartial();
    boolean nothingStands = run.output().read(SimulateStage.VERDICT).isEmpty();
    if (run.options().readsOnly() || (nothingStands && !reachesVerdict)) {
      return;
    }
    if (!withdrawn) {
      remember();
      // First of all: a verdict without record is never taken for a result again.
      memory.forget(Stage.SIMULATE);
      withdrawn = true;
    }
    String chain = run.project().configuration().name();
    run.writeResult(SimulateStage.VERDICT, SimulationReport.noVerdict(chain, Optional.of(stage)));
    OTHERS.forEach(run::remove);
  }

  /**
   * Withdraws the verdict in an output folder, for a run that could not even be begun. Nothing
   * happens where there is not a verdict, or another run is at work.
   */
  public static void withdrawVerdict(Path output) {
    if (!Files.isRegularFile(output.resolve(SimulateStage.VERDICT))) {
      return;
    }
    try (OutputFolder folder = OutputFolder.open(output)) {
      withdraw(folder);
    } catch (DiagnosticException e) {
      // What keeps the run from beginning is said by the one who asked for it.
      return;
    }
  }

  /** Withdraws the verdict of a project that cannot be opened. */
  private static void withdraw(OutputFolder output) {
    byte[] standing = output.read(SimulateStage.VERDICT).orElseThrow();
    output.write(
        SimulateStage.VERDICT,
        SimulationReport.noVerdict(SimulationReport.chainOf(standing), Optional.empty()),
        OutputFolder.OnEdit.OVERWRITE);
    OTHERS.forEach(output::remove);
  }

  private void remember() {
    record = memory.recall(Stage.SIMULATE).filter(this::isAsWritten);
    record.ifPresent(
        found -> {
          found.outputs().keySet().forEach(this::keep);
          keep(ReportPage.FILE);
        });
  }

  private void keep(String name) {
    run.output().read(name).ifPresent(content -> contents.put(name, content));
  }

  private boolean isAsWritten(StageRecord found) {
    return found.outputs().entrySet().stream()
        .allMatch(
            each ->
                run.output().read(each.getKey()).isPresent()
                    && !run.output().isEdited(each.getKey())
                    && run.output().written(each.getKey()).equals(each.getValue()));
  }

  /** What is remembered of the simulation, with its results in place, if its key is this one. */
  Optional<StageRecord> recall(String key) {
    if (!withdrawn) {
      return memory.recall(Stage.SIMULATE, key).filter(this::isAsWritten);
    }
    Optional<StageRecord> same = record.filter(found -> found.key().equals(key));
    same.ifPresent(
        found -> {
          found.outputs().keySet().forEach(this::putBack);
          memory.remember(Stage.SIMULATE, found);
        });
    return same;
  }

  private void putBack(String name) {
    run.writeResult(name, contents.get(name));
  }

  /** For a run that makes no report: the one of before, if the same came to the same verdict. */
  void putReportBack() {
    boolean same =
        record.isPresent()
            && contents.containsKey(ReportPage.FILE)
            && memory
                .recall(Stage.SIMULATE)
                .filter(found -> found.key().equals(record.get().key()))
                .isPresent()
            && run.output()
                .read(SimulateStage.VERDICT)
                .filter(verdict -> Arrays.equals(verdict, contents.get(SimulateStage.VERDICT)))
                .isPresent();
    if (same && withdrawn) {
      putBack(ReportPage.FILE);
    }
  }
}
