package dev.eventchain.constraints;

import dev.eventchain.constraints.document.ConstraintRules;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import org.eclipse.emf.ecore.EObject;

/** Builds the findings of the evaluation of invariants. */
final class Findings {

  private static final Invalid IS_NULL =
      new Invalid("it is null", SourceLocation.NONE, Invalid.Kind.NULL);

  private final Function<EObject, SourceLocation> locator;

  /**
   * Makes findings about a model.
   *
   * @param locator returns the location of an element; only called for findings
   */
  Findings(Function<EObject, SourceLocation> locator) {
    this.locator = locator;
  }

  /** Serializes calls of the locator, which need not be thread-safe. */
  private SourceLocation locate(Object subject) {
    synchronized (locator) {
      return locator.apply(HeldValue.element(subject));
    }
  }

  /** Returns the finding for an element for which an invariant is false. */
  Diagnostic violated(OclConstraint constraint, Object subject, Evaluation evaluation) {
    return new Diagnostic(
        ConstraintRules.VIOLATED,
        constraint.severity(),
        constraint.messageFor(subject, evaluation),
        locate(subject),
        constraint.hint(),
        constraint.qualifiedName(),
        List.of(constraint.location()));
  }

  /**
   * Returns the finding for an element for which an invariant is neither true nor false: an error
   * whatever the severity, since nothing was checked.
   */
  Diagnostic undefined(OclConstraint constraint, Object subject, Object value) {
    Invalid invalid = value instanceof Invalid reason ? reason : IS_NULL;
    boolean placed = !SourceLocation.NONE.equals(invalid.location());
    return new Diagnostic(
        ConstraintRules.UNDEFINED,
        Severity.ERROR,
        "'"
            + constraint.name()
            + "' is neither true nor false for "
            + HeldValue.label(subject)
            + ": "
            + invalid.reason()
            + ".",
        locate(subject),
        guard(invalid.kind()),
        constraint.qualifiedName(),
        List.of(placed ? invalid.location() : constraint.location()));
  }

  private static String guard(Invalid.Kind kind) {
    return switch (kind) {
      case NULL -> "Guard it: x <> null implies ...";
      case EMPTY -> "Guard it: x->notEmpty() implies ...";
      default -> "Say what holds in that case: if ... then ... else ... endif.";
    };
  }

  /**
   * Returns the finding for an invariant that was abandoned at an element.
   *
   * @param index index of the element; those before it were checked
   * @param limit the limit that was exceeded
   */
  Diagnostic limit(OclConstraint constraint, List<?> elements, int index, Invalid limit) {
    return new Diagnostic(
        Invalid.ABANDONED,
        Severity.ERROR,
        String.format(
            Locale.ROOT,
            "'%s' was abandoned at %s: %s. It left %d of %s unchecked.",
            constraint.name(),
            HeldValue.label(elements.get(index)),
            limit.reason(),
            elements.size() - index,
            Coverage.counted(elements.size(), "element")),
        constraint.location(),
        limit.kind() == Invalid.Kind.RECURSION
            ? "Fix the recursion: closure() follows references and terminates."
            : "Make it cheaper, or allow more: --time-limit SECONDS, EVENTCHAIN_MEMORY=4g.",
        constraint.qualifiedName(),
        List.of(locate(elements.get(index))));
  }

  /** Returns the finding if no invariant was evaluated on any element. */
  static Diagnostic nothingEvaluated(OclRules rules, int elements) {
    List<String> documents = rules.documents();
    int constraints = rules.constraints().size();
    boolean wrong = Diagnostic.anyError(rules.diagnostics());
    return Diagnostic.of(
            ConstraintRules.NOTHING_EVALUATED,
            constraints == 0
                ? "Nothing was checked: there is no constraint"
                    + (wrong ? " without errors" : "")
                    + (documents.isEmpty() ? "." : " in " + String.join(", ", documents) + ".")
                : "Nothing was checked: none of "
                    + Coverage.counted(constraints, "constraint")
                    + " applies to the class of any of "
                    + Coverage.counted(elements, "element")
                    + ".",
            documents.size() == 1 && constraints == 0
                ? SourceLocation.of(documents.get(0))
                : SourceLocation.NONE)
        .withHint(
            constraints == 0
                ? "Write invariants: context Class inv Name: ..."
                : "Give rules for the classes of this model.");
  }
}
