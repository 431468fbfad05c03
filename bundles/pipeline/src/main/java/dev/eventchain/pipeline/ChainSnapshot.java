package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.metamodel.eventchain.EventChain;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.emf.ecore.EObject;

/**
 * The chain of a project as its files say it: its model, where the elements come from, and what the
 * checks find. Each is had once for each state of the files that it depends on. Nobody changes it.
 */
final class ChainSnapshot {

  private final RunContext run;
  private final List<Path> files;
  private final RunContext.LoadedChain model;
  private final ChainOrigins origins;

  private ChainSnapshot(RunContext run, List<Path> files) {
    this.run = run;
    this.files = files;
    this.model = run.loadChain(run.model());
    this.origins = ChainOrigins.of(run, model);
  }

  static ChainSnapshot of(RunContext run) {
    List<Path> files = new ArrayList<>(ChainOrigins.files(run));
    files.add(run.model());
    return run.snapshots().of("chain", files, () -> new ChainSnapshot(run, files));
  }

  EventChain chain() {
    return model.chain();
  }

  /** Where an element stands: in the description that the chain was made from, or in the model. */
  SourceLocation locate(EObject element) {
    return origins.locate(element);
  }

  /** What the project's constraints and contracts say of it. */
  ChainChecks.Outcome checks() {
    List<Path> all = new ArrayList<>(files);
    all.addAll(ChainChecks.files(run));
    return run.snapshots().of("checks", all, () -> ChainChecks.of(run).check(model, origins));
  }
}
