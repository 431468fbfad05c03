package dev.eventchain.pipeline.engine;

import dev.eventchain.diagnostics.ContentHash;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.results.VerdictFile;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.SourceName;
import dev.eventchain.pipeline.stage.StageMemory;
import dev.eventchain.pipeline.stage.StageRecord;
import dev.eventchain.project.ProjectLayout;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;

/**
 * The verdict in the output folder, for those who only read it.
 *
 * @param outcomes the outcomes of requirements; none if there is no verdict
 * @param problem why it says nothing about the current files; empty if it does
 */
public record StandingVerdict(List<RequirementOutcome> outcomes, Optional<String> problem) {

  /** Copies the list. */
  public StandingVerdict {
    outcomes = List.copyOf(outcomes);
  }

  /**
   * Reads the verdict, and compares what it is about with the current files.
   *
   * @param run a run of this project that does nothing
   */
  public static StandingVerdict of(RunContext run) {
    Path file = run.file(ProjectLayout.VERDICT);
    if (!Files.isRegularFile(file)) {
      return without("nothing was run");
    }
    try {
      byte[] bytes = Files.readAllBytes(file);
      VerdictFile verdict = ResultJson.read(bytes, VerdictFile.class);
      return verdict
          .requirements()
          .map(outcomes -> new StandingVerdict(outcomes, problem(run, bytes)))
          .orElseGet(
              () ->
                  without(
                      verdict
                          .stoppedIn()
                          .map(stage -> "the last run was stopped in '" + stage + "'")
                          .orElse("the last run reached no verdict")));
    } catch (IOException e) {
      return without(ProjectLayout.VERDICT + " cannot be read");
    }
  }

  private static StandingVerdict without(String problem) {
    return new StandingVerdict(List.of(), Optional.of(problem));
  }

  private static Optional<String> problem(RunContext run, byte[] verdict) {
    StageMemory memory = new StageMemory(run.output(), run.options().output());
    Optional<StageRecord> record = memory.recall(Stage.SIMULATE);
    if (record.isEmpty()) {
      return Optional.of("there is no record of what " + ProjectLayout.VERDICT + " is about");
    }
    String written = record.get().outputs().get(ProjectLayout.VERDICT);
    if (!ContentHash.hex(verdict).equals(written)) {
      return Optional.of(ProjectLayout.VERDICT + " was edited");
    }
    try {
      new EarlierStages(run, memory, PipelineRun.WORK).require(Stage.SIMULATE);
      Fingerprint now = new Fingerprint(run);
      PipelineRun.WORK.get(Stage.SIMULATE).fingerprint(run, now);
      return changed(record.get().sources(), now.sources(record.get()));
    } catch (DiagnosticException e) {
      return Optional.of(e.diagnostics().get(0).message());
    }
  }

  private static Optional<String> changed(
      Map<String, String> before, SortedMap<String, String> now) {
    return now.keySet().stream()
        .filter(source -> !now.get(source).equals(before.get(source)))
        .findFirst()
        .or(() -> before.keySet().stream().filter(source -> !now.containsKey(source)).findFirst())
        .map(source -> SourceName.words(source) + " has changed since the last run");
  }

  /** Returns the recorded outcome of a requirement. */
  public Optional<RequirementOutcome> of(String requirement) {
    return outcomes.stream().filter(each -> each.id().equals(requirement)).findFirst();
  }
}
