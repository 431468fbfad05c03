package dev.eventchain.m2t.report;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.generation.GenerationRules;
import dev.eventchain.m2t.services.ServiceException;
import dev.eventchain.m2t.text.Texts;
import dev.eventchain.m2t.text.Undefined;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.evaluation.Invalid;
import java.util.List;
import java.util.function.Function;
import org.eclipse.emf.ecore.EObject;

/** Report of a run: findings with the current element and the active calls. */
public final class RunReport {
  private final Findings findings = new Findings();
  private final CallStack calls;
  private final Function<EObject, SourceLocation> locator;

  public RunReport(CallStack calls, Function<EObject, SourceLocation> locator) {
    this.calls = calls;
    this.locator = locator;
  }

  public List<Diagnostic> all() {
    return findings.all();
  }

  public void add(Diagnostic finding) {
    findings.add(finding);
  }

  /** Returns a finding about the current element, which may be added later. */
  public Diagnostic finding(Rule rule, SourceLocation location, String message, String hint) {
    return Diagnostic.of(rule, message, inModel(location)).withHint(withCalls(hint));
  }

  /** Adds a finding as a warning, although others of its rule are errors. */
  public void warn(Rule rule, SourceLocation location, String message, String hint) {
    add(finding(rule, location, message, hint).withSeverity(Severity.WARNING));
  }

  /** Adds a finding about the current element. */
  public void find(Rule rule, SourceLocation location, String message, String hint) {
    add(finding(rule, location, message, hint));
  }

  /**
   * Reports that an expression has no value.
   *
   * @param use the use of the value
   */
  public void undefined(Expression expression, Invalid invalid, Undefined use) {
    boolean placed = invalid.location().line() > 0;
    boolean service = invalid.cause() instanceof ServiceException;
    find(
        service ? GenerationRules.SERVICE : GenerationRules.UNDEFINED,
        placed ? invalid.location() : expression.location(),
        "The value is undefined" + element() + ": " + invalid.reason() + ". " + use.consequence(),
        service
            ? "Fix the service, or its arguments."
            : "Guard the expression with [if], or fix the model.");
  }

  private String element() {
    EObject element = calls.element();
    if (element == null) {
      return "";
    }
    SourceLocation place = locator.apply(element);
    String shown = place.toString().isEmpty() ? place.element() : place.toString();
    return " for " + Texts.label(element) + (shown.isEmpty() ? "" : " (" + shown + ")");
  }

  /** Returns the path of an element in its file; empty if unknown. */
  public String nameOf(EObject element) {
    return locator.apply(element).element();
  }

  private SourceLocation inModel(SourceLocation location) {
    EObject element = calls.element();
    return element == null ? location : location.withElement(nameOf(element));
  }

  private String withCalls(String hint) {
    return (hint + " " + calls.shown()).strip();
  }
}
