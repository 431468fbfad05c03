package dev.eventchain.pipeline.stage;

import dev.eventchain.check.ChainChecks;
import dev.eventchain.check.ChainModel;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.Requirements;
import dev.eventchain.simulation.bench.Bench;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.emf.ecore.EObject;

/**
 * The chain of a project according to its files: its model, the locations of elements, and the
 * results of checks. Each is computed once per state of its files. Immutable by convention.
 */
public final class ChainSnapshot {

  private final RunContext run;
  private final List<Path> files;
  private final ChainModel model;

  private ChainSnapshot(RunContext run, List<Path> files) {
    this.run = run;
    this.files = files;
    ChainModel loaded = run.loadChain(run.model());
    Path description = run.file(ProjectFolder.DESCRIPTION);
    this.model =
        run.project().editedModel().isPresent()
            ? loaded
            // For the locations of elements only, on which no result depends.
            : loaded.describedBy(
                description, () -> FileReads.unrecorded(() -> direct(run, description)));
  }

  static ChainSnapshot of(RunContext run) {
    List<Path> files = originFiles(run);
    files.add(run.model());
    return run.snapshots().of("chain", files, () -> new ChainSnapshot(run, files));
  }

  /** Returns the files that determine the locations of elements, besides the model. */
  private static List<Path> originFiles(RunContext run) {
    List<Path> files = new ArrayList<>(run.project().softwareBaseFiles());
    files.addAll(run.project().requirementFiles());
    files.add(run.file(ProjectFolder.DESCRIPTION));
    return files;
  }

  /**
   * Returns the model converted directly from a description. It must not be changed.
   *
   * @throws DiagnosticException INPUT if it cannot be read
   */
  public static Modeled<EventChain> direct(RunContext run, Path description) {
    return run.snapshots().of("description", originFiles(run), () -> read(run, description));
  }

  private static Modeled<EventChain> read(RunContext run, Path description) {
    run.progress().read(description);
    Requirements requirements = run.requirements();
    return ChainModel.ofDescription(
        description, run.project().configuration().settings(), requirements, run.softwareBase());
  }

  public EventChain chain() {
    return model.chain();
  }

  /** Returns the project's bench, whose formulas can read outputs of the chain by requirement. */
  public Bench bench() {
    return run.bench().withOutputsOf(chain());
  }

  /** Returns the location of an element: in the description of the chain or in the model. */
  public SourceLocation locate(EObject element) {
    return model.locate(element);
  }

  /** Returns the result of the project's constraints and contracts. */
  public ChainChecks.Outcome checks() {
    List<Path> all = new ArrayList<>(files);
    all.addAll(ProjectChecks.files(run));
    return run.snapshots().of("checks", all, () -> ProjectChecks.of(run).check(model));
  }
}
