package dev.eventchain.constraints;

import dev.eventchain.constraints.document.ConstraintRules;
import dev.eventchain.constraints.document.ResolvedClause;
import dev.eventchain.constraints.document.RuleDocument;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.metamodel.Names;
import dev.eventchain.ocl.metamodel.OclAnnotations;
import dev.eventchain.ocl.text.ExpressionRules;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EAnnotation;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EModelElement;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.ETypedElement;

/** Reads the invariants and expressions in the annotations of metamodels. */
final class MetamodelRules {

  /** {@code Tuple{status = ..., message = ...}.status}: the Pivot dialect's form with a message. */
  private static final Pattern STATUS_OF_TUPLE =
      Pattern.compile(
          "\\s*(Tuple\\s*\\{.*\\bmessage\\b.*\\}\\s*\\.\\s*)status\\s*", Pattern.DOTALL);

  private final ExpressionLanguage language;
  private final Function<EObject, SourceLocation> places;
  private final List<Diagnostic> problems;
  private final List<ResolvedClause> invariants = new ArrayList<>();

  private MetamodelRules(
      ExpressionLanguage language,
      Function<EObject, SourceLocation> places,
      List<Diagnostic> problems) {
    this.language = language;
    this.places = places;
    this.problems = problems;
  }

  /**
   * Reads the annotations of all packages of a language. Bodies of operations and derivations of
   * features are parsed even if nothing uses them, to find their errors.
   *
   * @param places returns the location of an element of a metamodel
   */
  static List<ResolvedClause> read(
      ExpressionLanguage language,
      Function<EObject, SourceLocation> places,
      List<Diagnostic> problems) {
    MetamodelRules rules = new MetamodelRules(language, places, problems);
    language.packages().all().forEach(rules::read);
    return rules.invariants;
  }

  private void read(EPackage metamodel) {
    List<OclAnnotations.Text> unchecked = new ArrayList<>();
    for (EClassifier classifier : metamodel.getEClassifiers()) {
      if (classifier instanceof EClass type) {
        members(type).forEach(each -> unchecked.addAll(OclAnnotations.conditions(each)));
        members(type).forEach(this::readMember);
      }
      read(classifier);
    }
    if (!unchecked.isEmpty()) {
      SourceLocation place = places.apply(unchecked.get(0).entry());
      problems.add(RuleParser.unchecked(unchecked.size(), place));
    }
  }

  private static Stream<ETypedElement> members(EClass type) {
    return Stream.concat(type.getEStructuralFeatures().stream(), type.getEOperations().stream());
  }

  private void read(EClassifier type) {
    for (Map.Entry<String, OclAnnotations.Text> each : OclAnnotations.invariants(type).entrySet()) {
      invariants.add(invariant(type, each.getKey(), each.getValue()));
    }
    OclAnnotations.contradictions(type).forEach(text -> report(type, text));
    OclAnnotations.unknown(type).forEach(annotation -> report(type, annotation));
    for (String name : OclAnnotations.constraintsInJava(type)) {
      problems.add(
          Diagnostic.of(
                  ConstraintRules.JAVA_MISSING,
                  "The constraint '%s' of %s is not checked: it is defined only in Java code."
                      .formatted(name, Names.of(type)),
                  places.apply(type))
              .withSeverity(Severity.WARNING)
              .withHint("Write it in OCL to have it checked here."));
    }
  }

  private void report(EClassifier type, EAnnotation unknown) {
    problems.add(
        Diagnostic.of(
                ConstraintRules.UNSUPPORTED,
                "The annotation '%s' of %s is not understood and is ignored."
                    .formatted(unknown.getSource(), Names.of(type)),
                places.apply(unknown))
            .withSeverity(Severity.WARNING)
            .withHint("The source of constraints is http://www.eclipse.org/emf/2002/Ecore/OCL."));
  }

  private void report(EModelElement element, OclAnnotations.Text again) {
    problems.add(
        Diagnostic.of(
                ExpressionRules.DUPLICATE,
                "'%s' of %s is declared twice.".formatted(again.key(), Names.of(element)),
                places.apply(again.entry()))
            .withHint("Give one of them another name, or leave one of them out."));
  }

  private void readMember(ETypedElement element) {
    OclAnnotations.body(element)
        .ifPresent(text -> language.implement(element, null, textOf(text).whole(), problems));
    OclAnnotations.contradictions(element).forEach(text -> report(element, text));
    for (OclAnnotations.Text text : OclAnnotations.misunderstood(element)) {
      problems.add(
          Diagnostic.of(
                  ConstraintRules.UNSUPPORTED,
                  "The annotation '%s' of %s is not understood and is ignored."
                      .formatted(text.key(), Names.of(element)),
                  places.apply(text.entry()))
              .withSeverity(Severity.WARNING)
              .withHint(
                  element instanceof EOperation
                      ? "An operation has 'body', and conditions that begin with 'pre' or 'post'."
                      : "A feature has 'derivation' or 'initial'."));
    }
  }

  private SourceText textOf(OclAnnotations.Text text) {
    return SourceText.within(places.apply(text.entry()), text.value());
  }

  private ResolvedClause invariant(EClassifier type, String name, OclAnnotations.Text text) {
    SourceText source = textOf(text);
    SourceRange nothing = source.range(0, 0);
    RuleDocument.Path context = new RuleDocument.Path(List.of(type.getName()), places.apply(type));
    RuleDocument.Clause clause =
        new RuleDocument.Clause(
            false,
            null,
            context,
            "",
            name,
            places.apply(text.entry()),
            source.whole(),
            message(type, text),
            List.of(nothing),
            nothing);
    return new ResolvedClause(clause, type, type.getEPackage());
  }

  /** Returns the expression for the message; null if there is none. */
  private SourceRange message(EClassifier type, OclAnnotations.Text text) {
    Matcher tuple = STATUS_OF_TUPLE.matcher(text.value());
    if (tuple.matches()) {
      SourceLocation place = places.apply(text.entry());
      return SourceText.within(place, tuple.group(1) + "message").whole();
    }
    return OclAnnotations.message(type, text.key())
        .map(message -> textOf(message).whole())
        .orElse(null);
  }
}
