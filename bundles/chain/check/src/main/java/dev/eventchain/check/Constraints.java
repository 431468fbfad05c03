package dev.eventchain.check;

import dev.eventchain.constraints.OclConstraint;
import dev.eventchain.constraints.OclResult;
import dev.eventchain.constraints.OclRules;
import dev.eventchain.constraints.OclValidator;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.eclipse.emf.ecore.EObject;

/** The constraints of a project: the standard ones, those people wrote, and the generated ones. */
public final class Constraints {

  private final OclRules rules;
  private final Duration timeLimit;

  /** Whether a run has generated constraints, which may be others than today's rules need. */
  private final boolean generated;

  private Constraints(OclRules rules, Duration timeLimit, boolean generated) {
    this.rules = rules;
    this.timeLimit = timeLimit;
    this.generated = generated;
  }

  /**
   * All constraints that there are.
   *
   * @param output the folder of the project's results, which may hold generated ones
   * @param timeLimit the processor time that each may take
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if a file cannot be read
   */
  public static Constraints of(ProjectFolder folder, Path output, Duration timeLimit) {
    List<SourceText> documents = written(folder);
    Optional<Path> generated = folder.generated(output);
    generated.map(SourceText::read).ifPresent(documents::add);
    return new Constraints(parse(documents), timeLimit, generated.isPresent());
  }

  /** The standard constraints and those that people wrote, before any are generated. */
  public static Constraints withoutGenerated(ProjectFolder folder, Duration timeLimit) {
    return new Constraints(parse(written(folder)), timeLimit, false);
  }

  /** The standard constraints alone, for chains that are in no project. */
  static Constraints standard(Duration timeLimit) {
    return new Constraints(parse(List.of(EventChainMetamodel.constraints())), timeLimit, false);
  }

  private static List<SourceText> written(ProjectFolder folder) {
    List<SourceText> documents = new ArrayList<>();
    documents.add(EventChainMetamodel.constraints());
    folder.ownConstraints().forEach(file -> documents.add(SourceText.read(file)));
    return documents;
  }

  /** The constraints of documents about event chains. */
  public static OclRules parse(List<SourceText> documents) {
    return OclRules.parse(documents, List.of(EventchainPackage.eINSTANCE));
  }

  /** The processor time that each may take. */
  Duration timeLimit() {
    return timeLimit;
  }

  /** Evaluates them on a model. */
  public OclResult check(EObject root, Function<EObject, SourceLocation> locator) {
    return OclValidator.of(rules).withTimeLimit(timeLimit).validate(List.of(root), locator);
  }

  /** The constraints that stand for a design rule, as their comments say. */
  public List<OclConstraint> standingFor(String rule) {
    return rules.constraints().stream()
        .filter(constraint -> !constraint.named(List.of(rule)).isEmpty())
        .toList();
  }

  /**
   * A finding for each design rule that no constraint stands for: a document that was emptied since
   * it was generated must not pass for one that nothing violates.
   *
   * @param items the design rules
   * @param command the command that runs the project, with what follows it
   */
  List<Diagnostic> uncovered(List<WrittenRequirement> items, UnaryOperator<String> command) {
    return items.stream()
        .filter(item -> standingFor(item.id()).isEmpty())
        .map(
            item ->
                Diagnostic.error(
                        "project.rule.uncovered",
                        "No constraint implements the design rule " + item.id() + ".",
                        item.location())
                    .withRule(item.id())
                    .withHint(
                        "Run '"
                            + command.apply(
                                generated ? "--from constrain --overwrite" : "--to constrain")
                            + "', or write an invariant under '-- "
                            + item.id()
                            + ": ...' into constraints.ocl."))
        .toList();
  }

  /** What a validation checked. */
  public static Coverage coverage(List<String> files, OclResult result) {
    List<Coverage.Check> checks =
        result.checks().stream()
            .map(
                check ->
                    new Coverage.Check(
                        Coverage.Kind.CONSTRAINT,
                        "ocl.violated",
                        check.constraint().qualifiedName(),
                        check.constraint().severity(),
                        check.constraint().location(),
                        check.constraint().hint(),
                        check.evaluations()))
            .toList();
    return new Coverage(files, result.elements(), checks);
  }

  /** What a validation did, in words. */
  static String words(OclResult result) {
    String checked =
        Coverage.counted(result.constraints(), "constraint")
            + " evaluated "
            + Coverage.counted(result.evaluations(), "time")
            + " on "
            + Coverage.counted(result.elements(), "element");
    int findings = result.diagnostics().size();
    return findings == 0 ? checked : checked + ", " + Coverage.counted(findings, "finding");
  }
}
