package dev.eventchain.pipeline.engine;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.report.ReportPage;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.simulate.SimulateStage;
import dev.eventchain.pipeline.simulate.VerdictJson;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageMemory;
import dev.eventchain.pipeline.stage.StageRecord;
import dev.eventchain.project.ProjectLayout;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * The results of an earlier simulation, and the report, during a run. They are withdrawn before any
 * change, so that no unfounded verdict remains, even if the run is killed; and restored if they
 * turn out to be still valid.
 */
public final class StandingResults {

  /** Files besides the verdict that state it or belong to it. */
  private static final List<String> OTHERS =
      List.of(
          SimulateStage.MEASUREMENTS,
          SimulateStage.MEASUREMENTS_TABLE,
          SimulateStage.LATENCY_BOUNDS,
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
   * Withdraws the results; the verdict names the current stage, and keeps it if the run ends there.
   * A run without a verdict creates none.
   */
  void withdraw(Stage stage) {
    boolean reachesVerdict = run.options().runs(Stage.SIMULATE) && !run.options().isPartial();
    boolean nothingStands = run.output().read(ProjectLayout.VERDICT).isEmpty();
    if (run.options().readsOnly() || (nothingStands && !reachesVerdict)) {
      return;
    }
    if (!withdrawn) {
      remember();
      // First of all: a verdict without a record never counts as a result.
      memory.forget(Stage.SIMULATE);
      withdrawn = true;
    }
    String chain = run.project().configuration().name();
    run.writeResult(ProjectLayout.VERDICT, VerdictJson.without(chain, Optional.of(stage)));
    OTHERS.forEach(run::remove);
  }

  /**
   * Withdraws the verdict in an output folder, for a run that could not begin. Does nothing if
   * there is no verdict or another run is in progress.
   */
  public static void withdrawVerdict(Path output) {
    if (!Files.isRegularFile(output.resolve(ProjectLayout.VERDICT))) {
      return;
    }
    try (OutputFolder folder = OutputFolder.open(output)) {
      withdraw(folder);
    } catch (DiagnosticException e) {
      // The caller reports why the run cannot begin.
      return;
    }
  }

  /** Withdraws the verdict of a project that cannot be opened. */
  private static void withdraw(OutputFolder output) {
    byte[] standing = output.read(ProjectLayout.VERDICT).orElseThrow();
    output.write(
        ProjectLayout.VERDICT,
        VerdictJson.without(VerdictJson.chainOf(standing), Optional.empty()),
        OutputFolder.OnEdit.OVERWRITE);
    OTHERS.forEach(output::remove);
  }

  private void remember() {
    record = memory.recall(Stage.SIMULATE).filter(found -> found.isAsWritten(run.output()));
    record.ifPresent(
        found -> {
          found.outputs().keySet().forEach(this::keep);
          keep(ReportPage.FILE);
        });
  }

  private void keep(String name) {
    run.output().read(name).ifPresent(content -> contents.put(name, content));
  }

  /** Returns the recorded simulation and restores its results, if it had the given inputs. */
  Optional<StageRecord> recall(Fingerprint inputs) {
    if (!withdrawn) {
      return memory.recall(Stage.SIMULATE, inputs).filter(found -> found.isAsWritten(run.output()));
    }
    Optional<StageRecord> same = record.filter(inputs::isOf);
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

  /** Restores the earlier report for a run without one, if the verdict is the same. */
  void putReportBack() {
    boolean same =
        record.isPresent()
            && contents.containsKey(ReportPage.FILE)
            && memory
                .recall(Stage.SIMULATE)
                .filter(found -> found.key().equals(record.get().key()))
                .isPresent()
            && run.output()
                .read(ProjectLayout.VERDICT)
                .filter(verdict -> Arrays.equals(verdict, contents.get(ProjectLayout.VERDICT)))
                .isPresent();
    if (same && withdrawn) {
      putBack(ReportPage.FILE);
    }
  }
}
