package dev.eventchain.m2t;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.Invalid;
import java.util.List;
import java.util.function.Function;
import org.eclipse.emf.ecore.EObject;

/** What a run finds, with the element at work and the calls on the way to it. */
final class RunReport {
  private final Findings findings = new Findings();
  private final CallStack calls;
  private final Function<EObject, SourceLocation> locator;

  RunReport(CallStack calls, Function<EObject, SourceLocation> locator) {
    this.calls = calls;
    this.locator = locator;
  }

  List<Diagnostic> all() {
    return findings.all();
  }

  void add(Diagnostic finding) {
    findings.add(finding);
  }

  /** A warning for the element at work that may be added later. */
  Diagnostic warning(String id, SourceLocation location, String message, String hint) {
    return Diagnostic.warning(id, message, inModel(location)).withHint(withCalls(hint));
  }

  void warn(String id, SourceLocation location, String message, String hint) {
    add(warning(id, location, message, hint));
  }

  void error(String id, SourceLocation location, String message, String hint) {
    add(Diagnostic.error(id, message, inModel(location)).withHint(withCalls(hint)));
  }

  /**
   * Reports that an expression has no value.
   *
   * @param use what it was wanted for
   */
  void undefined(Expression expression, Invalid invalid, Undefined use) {
    boolean placed = invalid.location().line() > 0;
    boolean service = invalid.cause() instanceof ServiceException;
    error(
        service ? "m2t.service" : "m2t.undefined",
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

  /** The path of an element in its file; empty if that is not known. */
  String nameOf(EObject element) {
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
