package dev.eventchain.pipeline;

import dev.eventchain.analysis.AnalysisResult;
import dev.eventchain.analysis.ChainAnalysis;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.metamodel.EcoreChecks;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.modeler.Requirements;
import dev.eventchain.modeler.SoftwareBase;
import dev.eventchain.ocl.OclResult;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * What has to hold for the event chain of a project: its metamodel, its constraints, its contracts
 * on messages, and the use of existing components as they are.
 */
final class ChainChecks {

  private final Constraints constraints;
  private final ChainAnalysis analysis;
  private final SoftwareBase base;
  private final List<Requirements.Item> requirements;
  private final List<Diagnostic> uncovered;

  private ChainChecks(
      Constraints constraints,
      ChainAnalysis analysis,
      SoftwareBase base,
      List<Requirements.Item> requirements,
      List<Diagnostic> uncovered) {
    this.uncovered = uncovered;
    this.requirements = requirements;
    this.constraints = constraints;
    this.analysis = analysis;
    this.base = base;
  }

  /**
   * What was checked and found.
   *
   * @param ecore what the metamodel demands
   * @param constraints the standard constraints, the project's own and the generated ones
   * @param analysis the contracts
   * @param reuse how existing components are used otherwise than they are
   * @param trace how the model's requirements are others than those that are written
   * @param uncovered the design rules that no constraint stands for
   */
  record Outcome(
      EcoreChecks ecore,
      OclResult constraints,
      AnalysisResult analysis,
      List<Diagnostic> reuse,
      List<Diagnostic> trace,
      List<Diagnostic> uncovered) {

    /** All findings. */
    List<Diagnostic> diagnostics() {
      List<Diagnostic> all = new ArrayList<>(ecore.diagnostics());
      all.addAll(constraints.diagnostics());
      all.addAll(analysis.diagnostics());
      all.addAll(reuse);
      all.addAll(trace);
      all.addAll(uncovered);
      return all;
    }

    /**
     * Goes on with a valid model only.
     *
     * @throws DiagnosticException FINDINGS if a finding is an error that is not suppressed
     */
    void refuseErrors(RunContext run) {
      List<Diagnostic> found = run.options().suppressions().part(diagnostics()).remaining();
      if (Diagnostic.anyError(found)) {
        throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, found);
      }
    }

    /** What was done, in words. */
    String words() {
      Coverage all = coverage(List.of());
      return Constraints.words(constraints)
          + ", "
          + Coverage.counted(all.evaluations(Coverage.Kind.CONTRACT), "message contract")
          + ", "
          + Coverage.counted(all.evaluations(Coverage.Kind.METAMODEL), "metamodel check");
    }

    /**
     * What was checked.
     *
     * @param files the files that were
     */
    Coverage coverage(List<String> files) {
      return Constraints.coverage(files, constraints)
          .and(ecore.coverage())
          .and(new Coverage(List.of(), 0, analysis.checks()));
    }
  }

  /** The checks of a project, whose software base knows the vehicle and its messages. */
  static ChainChecks of(RunContext run) {
    Constraints constraints = Constraints.of(run);
    return of(run, constraints, constraints.uncovered(run));
  }

  /** The checks of a project before constraints are generated. */
  static ChainChecks withoutGenerated(RunContext run) {
    return of(run, Constraints.withoutGenerated(run), List.of());
  }

  private static ChainChecks of(
      RunContext run, Constraints constraints, List<Diagnostic> uncovered) {
    SoftwareBase base = run.softwareBase();
    MessageCatalog catalog = run.messages();
    return new ChainChecks(
        constraints,
        ChainAnalysis.of(catalog, base.signals()),
        base,
        ProjectScenarios.requirements(run),
        uncovered);
  }

  /** The files that the checks of a project depend on, besides the chain's. */
  static List<Path> files(RunContext run) {
    List<Path> files = new ArrayList<>(Constraints.paths(run));
    files.add(run.project().designRulesFile());
    files.add(run.project().requirements());
    files.addAll(run.project().softwareBaseFiles());
    files.addAll(run.project().messageFiles());
    return files;
  }

  /**
   * Checks a chain.
   *
   * @param origins tells where its elements stand
   */
  Outcome check(RunContext.LoadedChain model, ChainOrigins origins) {
    EventChain chain = model.chain();
    return new Outcome(
        model.ecore(),
        constraints.check(chain, origins::locate),
        analysis.check(chain, origins::locate),
        base.check(chain, origins::locate),
        RequirementTrace.check(requirements, chain, origins),
        uncovered);
  }
}
