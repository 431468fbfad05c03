package dev.eventchain.pipeline.engine;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.project.Templates;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.ComponentFiles;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.SourceName;
import dev.eventchain.pipeline.stage.StageMemory;
import dev.eventchain.pipeline.stage.StageRecord;
import dev.eventchain.pipeline.stage.StageWork;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * The stages that a run leaves out because it begins later. Their results are reused, so they must
 * be up to date with the current sources: otherwise a verdict would be about something else than
 * the project's files.
 */
final class EarlierStages {

  private static final Rule OUTDATED = EngineRules.STAGE_OUTDATED;

  /** Result files of the stages, apart from those of project templates. */
  private static final Map<Stage, String> RESULTS =
      Map.of(
          Stage.DESIGN, ProjectFolder.DESCRIPTION,
          Stage.IMPLEMENT, ComponentFiles.FOLDER,
          Stage.MODEL, ProjectFolder.MODEL,
          Stage.CONSTRAIN, ProjectFolder.GENERATED);

  private final RunContext run;
  private final StageMemory memory;
  private final Map<Stage, StageWork> works;
  private final List<Diagnostic> outdated = new ArrayList<>();
  private final List<Diagnostic> edited = new ArrayList<>();
  private final List<String> unknown = new ArrayList<>();

  EarlierStages(RunContext run, StageMemory memory, Map<Stage, StageWork> works) {
    this.run = run;
    this.memory = memory;
    this.works = works;
  }

  /**
   * Checks the results of all stages before the first one to run.
   *
   * @return the suppressed findings, and warnings about edited results and results of unknown
   *     sources
   * @throws DiagnosticException INPUT with the first finding about an outdated result that is not
   *     suppressed
   */
  List<Diagnostic> require(Stage next) {
    if (checksEditedChain()) {
      return aboutGeneratedConstraints();
    }
    for (Stage stage : Stage.values()) {
      if (stage.compareTo(next) < 0 && stage.compareTo(Stage.SIMULATE) < 0) {
        look(stage);
      }
    }
    List<Diagnostic> counting = run.options().suppressions().part(outdated).remaining();
    if (!counting.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, counting.get(0));
    }
    List<Diagnostic> found = new ArrayList<>(outdated);
    found.addAll(edited);
    if (!unknown.isEmpty()) {
      found.add(unknown());
    }
    return found;
  }

  /**
   * Returns the findings about generated constraints, the only earlier results that the check of an
   * edited chain uses. They concern the design rules, and therefore apply to the current chain;
   * constraints for other rules are findings next to those about the chain.
   */
  private List<Diagnostic> aboutGeneratedConstraints() {
    if (run.project().generated(run.options().output()).isPresent()) {
      look(Stage.CONSTRAIN);
    }
    List<Diagnostic> found = new ArrayList<>(outdated);
    found.addAll(edited);
    return found;
  }

  private boolean checksEditedChain() {
    return run.options().readsOnly() && run.project().editedModel().isPresent();
  }

  private void look(Stage stage) {
    StageWork work = works.get(stage);
    Optional<StageRecord> record = memory.recall(stage);
    if (memory.isUnfinished(stage)) {
      outdated.add(unfinished(stage));
    } else if (record.isPresent()) {
      outdated(stage, work, record.get())
          .or(() -> noLongerSuppressed(stage, record.get()))
          .ifPresent(outdated::add);
      for (String name : record.get().outputs().keySet()) {
        run.output().accept(name).ifPresent(edited::add);
      }
    } else if (stage == Stage.GENERATE && run.options().runs(Stage.SIMULATE)) {
      unknownPackage().ifPresent(outdated::add);
    } else if (work.skippable() && Files.exists(results(stage))) {
      unknown.add(results(stage).getFileName().toString());
    }
  }

  private Optional<Diagnostic> outdated(Stage stage, StageWork work, StageRecord record) {
    Fingerprint fingerprint = new Fingerprint(run);
    work.fingerprint(run, fingerprint);
    SortedMap<String, String> changed = changes(record.sources(), fingerprint.sources(record));
    if (checksEditedChain()) {
      changed.keySet().retainAll(Set.of(SourceName.of(run.project().designRulesFile(), run)));
    }
    if (!changed.isEmpty()) {
      return Optional.of(changed(stage, changed));
    }
    return record.outputs().keySet().stream()
        .filter(name -> !Files.isRegularFile(run.file(name)))
        .findFirst()
        .map(
            name ->
                error(
                    stage,
                    name + ", which the stage '" + stage.id() + "' has written, is gone.",
                    run.file(name)));
  }

  /** Returns an error if findings of the stage were suppressed when it ran, but no longer are. */
  private Optional<Diagnostic> noLongerSuppressed(Stage stage, StageRecord record) {
    return run.anyErrorCounts(record.diagnostics())
        ? Optional.of(
            error(
                stage,
                "The stage '"
                    + stage.id()
                    + "' has findings that were suppressed when it ran, but no longer are.",
                results(stage)))
        : Optional.empty();
  }

  /** Returns the changed sources, each with its change. */
  private static SortedMap<String, String> changes(
      Map<String, String> before, Map<String, String> now) {
    SortedMap<String, String> changes = new TreeMap<>();
    before.forEach(
        (source, content) -> {
          String current = now.getOrDefault(source, Fingerprint.ABSENT);
          if (!current.equals(content)) {
            changes.put(source, current.equals(Fingerprint.ABSENT) ? "is gone" : "has changed");
          }
        });
    now.forEach(
        (source, content) -> {
          boolean absent =
              before.getOrDefault(source, Fingerprint.ABSENT).equals(Fingerprint.ABSENT);
          if (absent && !content.equals(Fingerprint.ABSENT)) {
            changes.put(source, "is new");
          }
        });
    return changes;
  }

  private Diagnostic changed(Stage stage, SortedMap<String, String> changes) {
    String first = changes.firstKey();
    String more =
        changes.size() == 1
            ? ""
            : " (and "
                + String.join(
                    ", ",
                    changes.keySet().stream().skip(1).limit(3).map(SourceName::words).toList())
                + (changes.size() > 4 ? ", ..." : "")
                + ")";
    return error(
        stage,
        SourceName.words(first)
            + more
            + " "
            + changes.get(first)
            + " since the stage '"
            + stage.id()
            + "' ran, so its results are out of date.",
        SourceName.file(first, run));
  }

  private Diagnostic unfinished(Stage stage) {
    return error(
        stage,
        "The stage '" + stage.id() + "' was started but did not finish: its results are older.",
        results(stage));
  }

  private Optional<Diagnostic> unknownPackage() {
    return Files.exists(results(Stage.GENERATE))
        ? Optional.of(
            error(
                Stage.GENERATE,
                "There is no record of how the package was generated, so it may be out of date.",
                results(Stage.GENERATE)))
        : Optional.empty();
  }

  private Diagnostic unknown() {
    return Diagnostic.of(
            OUTDATED,
            "There is no record of what "
                + String.join(", ", unknown)
                + (unknown.size() == 1 ? " was" : " were")
                + " created from, so it may be out of date.",
            SourceLocation.of(run.options().output()))
        .withSeverity(Severity.WARNING)
        .withHint("Run '" + run.command("") + "' to create everything from the current files.");
  }

  private Diagnostic error(Stage stage, String message, Path place) {
    return Diagnostic.of(OUTDATED, message, SourceLocation.of(place))
        .withHint("Run '" + run.command("--from " + stage.id()) + "'.");
  }

  private Path results(Stage stage) {
    String folder = Templates.folder(run.project());
    return run.file(RESULTS.getOrDefault(stage, folder));
  }
}
