package dev.eventchain.pipeline.stage;

import dev.eventchain.check.ChainChecks;
import dev.eventchain.check.ChainModel;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.Requirements;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.emf.ecore.EObject;

/**
 * The chain of a project as its files say it: its model, where the elements come from, and what the
 * checks find. Each is had once for each state of the files that it depends on. Nobody changes it.
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
            : loaded.describedBy(description, () -> direct(run, description));
  }

  static ChainSnapshot of(RunContext run) {
    List<Path> files = originFiles(run);
    files.add(run.model());
    return run.snapshots().of("chain", files, () -> new ChainSnapshot(run, files));
  }

  /** The files that decide where elements come from, besides the model. */
  private static List<Path> originFiles(RunContext run) {
    List<Path> files = new ArrayList<>(run.project().softwareBaseFiles());
    files.add(run.project().requirements());
    files.add(run.file(ProjectFolder.DESCRIPTION));
    return files;
  }

  /**
   * The model that a description gives without a language model. Nobody changes it.
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

  /** Where an element is: in the description that the chain was made from, or in the model. */
  public SourceLocation locate(EObject element) {
    return model.locate(element);
  }

  /** What the project's constraints and contracts say of it. */
  public ChainChecks.Outcome checks() {
    List<Path> all = new ArrayList<>(files);
    all.addAll(ProjectChecks.files(run));
    return run.snapshots().of("checks", all, () -> ProjectChecks.of(run).check(model));
  }
}
