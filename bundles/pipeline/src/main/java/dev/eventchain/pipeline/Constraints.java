package dev.eventchain.pipeline;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.metamodel.XmiStore;
import dev.eventchain.metamodel.eventchain.EventchainPackage;
import dev.eventchain.modeler.Requirements;
import dev.eventchain.ocl.OclConstraint;
import dev.eventchain.ocl.OclResult;
import dev.eventchain.ocl.OclRules;
import dev.eventchain.ocl.OclValidator;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import org.eclipse.emf.ecore.EObject;

/** The constraints of a project: the standard ones, those people wrote, and the generated ones. */
final class Constraints {

  static final String GENERATED = "generated.ocl";

  private final OclRules rules;
  private final Duration timeLimit;

  private Constraints(OclRules rules, Duration timeLimit) {
    this.rules = rules;
    this.timeLimit = timeLimit;
  }

  /** All constraints that there are. */
  static Constraints of(RunContext run) {
    return run.snapshots()
        .of(
            "constraints",
            paths(run),
            () -> new Constraints(parse(all(run)), run.options().timeLimit()));
  }

  private static List<SourceText> all(RunContext run) {
    List<SourceText> documents = written(run);
    generated(run).map(SourceText::read).ifPresent(documents::add);
    return documents;
  }

  private static Optional<Path> generated(RunContext run) {
    return Optional.of(run.file(GENERATED)).filter(file -> !Project.isAbsent(file));
  }

  /** The files that hold the constraints, but for the standard ones. */
  static List<Path> paths(RunContext run) {
    List<Path> files = new ArrayList<>(run.project().ownConstraints());
    generated(run).ifPresent(files::add);
    return files;
  }

  /** The standard constraints and those that people wrote, before any are generated. */
  static Constraints withoutGenerated(RunContext run) {
    return new Constraints(parse(written(run)), run.options().timeLimit());
  }

  private static List<SourceText> written(RunContext run) {
    List<SourceText> documents = new ArrayList<>();
    documents.add(XmiStore.standardConstraints());
    run.project().ownConstraints().forEach(file -> documents.add(SourceText.read(file)));
    return documents;
  }

  static OclRules parse(List<SourceText> documents) {
    return OclRules.parse(documents, List.of(EventchainPackage.eINSTANCE));
  }

  OclResult check(EObject root, Function<EObject, SourceLocation> locator) {
    return OclValidator.of(rules).withTimeLimit(timeLimit).validate(List.of(root), locator);
  }

  /** As {@link #paths}, for people. */
  static List<String> files(RunContext run) {
    return paths(run).stream().map(file -> SourceLocation.of(file).file()).toList();
  }

  /** The constraints that stand for a design rule, as their comments say. */
  List<OclConstraint> standingFor(String rule) {
    return rules.constraints().stream()
        .filter(constraint -> !constraint.named(List.of(rule)).isEmpty())
        .toList();
  }

  /**
   * A finding for each design rule that no constraint stands for: a document that was emptied since
   * it was generated must not pass for one that nothing violates.
   */
  List<Diagnostic> uncovered(RunContext run) {
    List<Requirements.Item> items = run.designRules().map(Requirements::items).orElse(List.of());
    return items.stream()
        .filter(item -> standingFor(item.id()).isEmpty())
        .map(
            item ->
                Diagnostic.error(
                        "project.rule.uncovered",
                        "No constraint stands for the design rule " + item.id() + ".",
                        item.location())
                    .withRule(item.id())
                    .withHint(
                        "Run '"
                            + run.command("--from constrain --overwrite")
                            + "', or write an invariant under '-- "
                            + item.id()
                            + ": ...' into constraints.ocl."))
        .toList();
  }

  /** What a validation checked. */
  static Coverage coverage(List<String> files, OclResult result) {
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

  /** What a validation did, for the report. */
  static ObjectNode report(String model, OclResult result) {
    ObjectNode report = JsonNodeFactory.instance.objectNode();
    report
        .put("model", model)
        .put("constraints", result.constraints())
        .put("elements", result.elements())
        .put("evaluations", result.evaluations())
        .put(
            "violations",
            result.diagnostics().stream().filter(d -> d.id().startsWith("ocl.")).count());
    ArrayNode violated = report.putArray("violated");
    Set<String> names = new TreeSet<>();
    result.diagnostics().stream().map(Diagnostic::rule).forEach(names::add);
    names.forEach(violated::add);
    ArrayNode evaluated = report.putArray("evaluated");
    result.checks().stream()
        .filter(check -> check.evaluations() > 0)
        .map(check -> check.constraint().qualifiedName())
        .forEach(evaluated::add);
    return report;
  }
}
