package dev.eventchain.check;

import dev.eventchain.constraints.ConstraintProof;
import dev.eventchain.constraints.OclConstraint;
import dev.eventchain.constraints.OclResult;
import dev.eventchain.constraints.OclRules;
import dev.eventchain.constraints.OclValidator;
import dev.eventchain.constraints.document.ConstraintRules;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.eclipse.emf.ecore.EObject;

/** Constraints of a project: standard, written by users, and generated. */
public final class Constraints {

  private static final String CONSTANT =
      "'%s' reads nothing of the model and holds whatever the model is";
  private static final String UNVIOLATED =
      "No model was found that violates '%s': changed values, references and contained objects of"
          + " the model made no difference";

  private final OclRules rules;
  private final Duration timeLimit;

  /** The standard constraints alone: parsed once, since most projects have no others. */
  private static final class Standard {
    private static final SourceText DOCUMENT = EventChainMetamodel.constraints();
    private static final OclRules RULES = parse(List.of(DOCUMENT));
  }

  /** True if a run has generated constraints, which may not match the current design rules. */
  private final boolean generated;

  private Constraints(OclRules rules, Duration timeLimit, boolean generated) {
    this.rules = rules;
    this.timeLimit = timeLimit;
    this.generated = generated;
  }

  /**
   * Returns all constraints of a project.
   *
   * @param output the folder of the project's results, which may hold generated constraints
   * @param timeLimit the processor time limit of each constraint
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if a file cannot be read
   */
  public static Constraints of(ProjectFolder folder, Path output, Duration timeLimit) {
    List<SourceText> documents = written(folder);
    Optional<Path> generated = folder.generated(output);
    generated.map(SourceText::read).ifPresent(documents::add);
    return new Constraints(rules(documents), timeLimit, generated.isPresent());
  }

  /** Returns the standard constraints and those written by users. */
  public static Constraints withoutGenerated(ProjectFolder folder, Duration timeLimit) {
    return new Constraints(rules(written(folder)), timeLimit, false);
  }

  /** Returns the standard constraints alone, for chains outside any project. */
  static Constraints standard(Duration timeLimit) {
    return new Constraints(Standard.RULES, timeLimit, false);
  }

  private static List<SourceText> written(ProjectFolder folder) {
    List<SourceText> documents = new ArrayList<>();
    documents.add(Standard.DOCUMENT);
    folder.ownConstraints().forEach(file -> documents.add(SourceText.read(file)));
    return documents;
  }

  private static OclRules rules(List<SourceText> documents) {
    return documents.equals(List.of(Standard.DOCUMENT)) ? Standard.RULES : parse(documents);
  }

  /** Returns the constraints of documents about event chains. */
  public static OclRules parse(List<SourceText> documents) {
    return OclRules.parse(documents, List.of(EventchainPackage.eINSTANCE));
  }

  /** Returns the processor time limit of each constraint. */
  Duration timeLimit() {
    return timeLimit;
  }

  /** Evaluates the constraints on a model. */
  public OclResult check(EObject root, Function<EObject, SourceLocation> locator) {
    return OclValidator.of(rules).withTimeLimit(timeLimit).validate(List.of(root), locator);
  }

  /**
   * Returns the constraints that implement a requirement or design rule according to their
   * comments. One that holds for anything implements none.
   */
  public List<OclConstraint> standingFor(String rule) {
    return rules.constraints().stream()
        .filter(constraint -> !constraint.named(List.of(rule)).isEmpty())
        .filter(constraint -> !constraint.holdsForAnything())
        .toList();
  }

  /**
   * Returns a finding for each constraint that nothing violates: an error if its comment names a
   * requirement, which it would prove, else a warning. Only those that name one are tried on
   * changes of the model.
   *
   * @param ids of the written requirements
   * @param root of the model; not modified
   */
  List<Diagnostic> vacuous(Collection<String> ids, EObject root) {
    List<Diagnostic> found = new ArrayList<>(constant(rules, ids));
    rules.constraints().stream()
        .filter(each -> !each.named(ids).isEmpty() && !each.holdsForAnything())
        .filter(each -> ConstraintProof.neverFails(each, List.of(root), timeLimit))
        .map(each -> unproving(each, UNVIOLATED.formatted(each.name()), each.named(ids)))
        .forEach(found::add);
    return found;
  }

  /** Returns a finding for each constraint that reads nothing of the model and holds. */
  static List<Diagnostic> constant(OclRules rules, Collection<String> ids) {
    return rules.constraints().stream()
        .filter(OclConstraint::holdsForAnything)
        .map(each -> unproving(each, CONSTANT.formatted(each.name()), each.named(ids)))
        .toList();
  }

  private static Diagnostic unproving(OclConstraint constraint, String text, Set<String> named) {
    Severity severity = named.isEmpty() ? Severity.WARNING : Severity.ERROR;
    String proves =
        named.isEmpty() ? "." : ", so it cannot prove " + String.join(" and ", named) + ".";
    return Diagnostic.of(CheckRules.OCL_VACUOUS, text + proves, constraint.location())
        .withSeverity(severity)
        .withRule(constraint.qualifiedName())
        .withHint("State what the requirement demands of the features of self.");
  }

  /**
   * Returns a finding for each design rule that no constraint implements. Without it, a generated
   * document that was emptied would pass for one without violations.
   *
   * @param items the design rules
   * @param command returns the command that runs the project with the given arguments
   */
  List<Diagnostic> uncovered(List<WrittenRequirement> items, UnaryOperator<String> command) {
    return items.stream()
        .filter(item -> standingFor(item.id()).isEmpty())
        .map(
            item ->
                Diagnostic.of(
                        CheckRules.PROJECT_RULE_UNCOVERED,
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

  /** Returns the coverage of a validation. */
  public static Coverage coverage(List<String> files, OclResult result) {
    List<Coverage.Check> checks =
        result.checks().stream()
            .map(
                check ->
                    new Coverage.Check(
                        Coverage.Kind.CONSTRAINT,
                        ConstraintRules.VIOLATED.id(),
                        check.constraint().qualifiedName(),
                        check.constraint().severity(),
                        check.constraint().location(),
                        check.constraint().hint(),
                        check.evaluations()))
            .toList();
    return new Coverage(files, result.elements(), checks);
  }

  /** Returns a summary of a validation in words. */
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
