package dev.eventchain.check;

import dev.eventchain.constraints.OclResult;
import dev.eventchain.contracts.AnalysisResult;
import dev.eventchain.contracts.ChainAnalysis;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.project.OpenQuestions;
import dev.eventchain.project.ProjectFileNames;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.xmi.EcoreChecks;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * Checks of the event chain of a project: metamodel, constraints, message contracts, and use of
 * existing components. The files of the project are read once; then any number of chains can be
 * checked, by one thread at a time.
 */
public final class ChainChecks {

  private final Constraints constraints;
  private final ChainAnalysis analysis;
  private final SoftwareBase base;
  private final List<WrittenRequirement> requirements;
  private final List<Diagnostic> unchecked;

  private ChainChecks(
      Constraints constraints,
      SoftwareBase base,
      MessageCatalog messages,
      List<WrittenRequirement> requirements,
      List<Diagnostic> unchecked) {
    this.constraints = constraints;
    this.analysis = ChainAnalysis.of(messages, base.signals());
    this.base = base;
    this.requirements = requirements;
    this.unchecked = unchecked;
  }

  /**
   * Checks and findings.
   *
   * @param ecore the checks of the metamodel
   * @param constraints the results of the standard, the project's own and the generated constraints
   * @param analysis the results of the contracts
   * @param reuse the deviations from the descriptions of existing components
   * @param trace the deviations from the written requirements
   * @param unchecked the findings of {@link #unchecked}, and constraints that check nothing
   */
  public record Outcome(
      EcoreChecks ecore,
      OclResult constraints,
      AnalysisResult analysis,
      List<Diagnostic> reuse,
      List<Diagnostic> trace,
      List<Diagnostic> unchecked) {

    /** Returns all findings. */
    public List<Diagnostic> diagnostics() {
      List<Diagnostic> all = new ArrayList<>(ecore.diagnostics());
      all.addAll(constraints.diagnostics());
      all.addAll(analysis.diagnostics());
      all.addAll(reuse);
      all.addAll(trace);
      all.addAll(unchecked);
      return all;
    }

    /** Returns a summary in words. */
    public String words() {
      Coverage all = coverage(List.of());
      return Constraints.words(constraints)
          + ", "
          + Coverage.counted(all.evaluations(Coverage.Kind.CONTRACT), "message contract")
          + ", "
          + Coverage.counted(all.evaluations(Coverage.Kind.METAMODEL), "metamodel check");
    }

    /**
     * Returns the coverage.
     *
     * @param files the checked files
     */
    public Coverage coverage(List<String> files) {
      return Constraints.coverage(files, constraints)
          .and(ecore.coverage())
          .and(new Coverage(List.of(), 0, analysis.checks()));
    }
  }

  /**
   * Returns the checks for the current files of a project.
   *
   * @param output the folder of the project's results, which may hold generated constraints
   * @param timeLimit the processor time that a constraint, or the patterns of a data type, may take
   * @throws DiagnosticException INPUT with the errors of all files
   */
  public static ChainChecks of(ProjectFolder folder, Path output, Duration timeLimit) {
    Attempts attempts = new Attempts();
    Optional<Constraints> constraints =
        attempts.of(() -> Constraints.of(folder, output, timeLimit));
    Optional<List<WrittenRequirement>> rules =
        attempts.of(() -> folder.designRules().map(ChainChecks::items).orElse(List.of()));
    Optional<SoftwareBase> base = attempts.of(folder::readSoftwareBase);
    Optional<MessageCatalog> messages = attempts.of(folder::readMessages);
    Optional<List<WrittenRequirement>> requirements = attempts.of(() -> requirements(folder));
    attempts.refuseProblems();
    return of(
        constraints.orElseThrow(),
        base.orElseThrow(),
        messages.orElseThrow(),
        requirements.orElseThrow(),
        unchecked(folder, constraints.get(), rules.orElseThrow(), output));
  }

  /**
   * Returns the checks for a chain outside any project: standard constraints, contracts inside the
   * chain, and metamodel. The vehicle and existing components are unknown.
   *
   * @param timeLimit as for a project
   */
  public static ChainChecks alone(Duration timeLimit) {
    return of(
        Constraints.standard(timeLimit),
        SoftwareBase.unknown(),
        MessageCatalog.of(List.of()),
        List.of(),
        List.of());
  }

  /**
   * Returns findings about unchecked input: design rules without constraints, documents that are
   * not read, and what is not known of the software base.
   *
   * @param output the folder of the project's results
   */
  public static List<Diagnostic> unchecked(
      ProjectFolder folder, Constraints constraints, List<WrittenRequirement> rules, Path output) {
    List<Diagnostic> found =
        new ArrayList<>(constraints.uncovered(rules, more -> folder.command(output, more)));
    found.addAll(ProjectFileNames.unreadConstraints(folder, output));
    found.addAll(OpenQuestions.read(folder));
    return found;
  }

  private static List<WrittenRequirement> requirements(ProjectFolder folder) {
    return folder.hasRequirements() ? folder.readRequirements().items() : List.of();
  }

  private static List<WrittenRequirement> items(Path file) {
    return ProjectFolder.readRules(file).items();
  }

  /**
   * Returns the checks for a project whose files have been read.
   *
   * @param requirements the written requirements; none if there is no such file
   * @param unchecked the findings of {@link #unchecked}
   */
  public static ChainChecks of(
      Constraints constraints,
      SoftwareBase base,
      MessageCatalog messages,
      List<WrittenRequirement> requirements,
      List<Diagnostic> unchecked) {
    return new ChainChecks(constraints, base, messages, requirements, unchecked);
  }

  /** Checks a chain that was read from a file. */
  public Outcome check(ChainModel model) {
    return check(model.chain(), model.ecore(), model::locate, model::locate);
  }

  /**
   * Checks a chain in memory, with or without a file. It must not be changed meanwhile.
   *
   * @param locator returns the locations of its elements
   * @param featureLocator returns the locations of their features
   */
  public Outcome check(
      EventChain chain,
      Function<EObject, SourceLocation> locator,
      BiFunction<EObject, EStructuralFeature, SourceLocation> featureLocator) {
    EcoreChecks ecore = EcoreChecks.of(chain, locator, constraints.timeLimit());
    return check(chain, ecore, locator, featureLocator);
  }

  private Outcome check(
      EventChain chain,
      EcoreChecks ecore,
      Function<EObject, SourceLocation> locator,
      BiFunction<EObject, EStructuralFeature, SourceLocation> featureLocator) {
    List<Diagnostic> unproving =
        new ArrayList<>(
            constraints.vacuous(requirements.stream().map(WrittenRequirement::id).toList(), chain));
    unproving.addAll(unchecked);
    return new Outcome(
        ecore,
        constraints.check(chain, locator),
        analysis.check(chain, featureLocator),
        base.check(chain, featureLocator),
        RequirementTrace.check(requirements, chain, featureLocator),
        unproving);
  }
}
