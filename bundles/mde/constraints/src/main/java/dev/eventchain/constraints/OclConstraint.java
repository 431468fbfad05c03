package dev.eventchain.constraints;

import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.ocl.Evaluations;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.evaluation.TimeBudget;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;

/** A parsed and checked invariant. Immutable and thread-safe. */
public final class OclConstraint {

  /** The result of an invariant for an element. */
  public enum Verdict {
    TRUE,
    FALSE,
    /** Neither: the value is null or invalid. */
    UNDEFINED
  }

  /** Limit of processor time for the value of a condition that reads no model. */
  private static final Duration CONSTANT_TIME = Duration.ofMillis(200);

  private final String name;
  private final EClassifier context;
  private final Expression condition;
  private final RuleComments comments;
  private final MessageTemplate message;
  private final SourceLocation location;

  OclConstraint(
      String name,
      EClassifier context,
      Expression condition,
      RuleComments comments,
      MessageTemplate message,
      SourceLocation location) {
    this.name = name;
    this.context = context;
    this.condition = condition;
    this.comments = comments;
    this.message = message;
    this.location = location;
  }

  /** Returns the name; an unnamed invariant has {@code inv} and its number in its class. */
  public String name() {
    return name;
  }

  /** {@code Class::Name}. */
  public String qualifiedName() {
    return context.getName() + "::" + name;
  }

  /** Returns the class or data type whose instances or values it constrains. */
  public EClassifier context() {
    return context;
  }

  /** Returns the severity of violations. */
  public Severity severity() {
    return comments.severity();
  }

  /** Returns the hint for violations; empty if the rules have none. */
  public String hint() {
    return comments.hint();
  }

  /**
   * Returns those ids that its comment names, to trace it to written rules. The comment is that
   * right above it, without {@code @message} and the other annotations. If that names none, the
   * comment right above its context counts, for all invariants of the context. If several documents
   * contain the invariant, the comments in all of them count.
   *
   * @param ids such as ids of written rules; matched as whole words
   */
  public Set<String> named(Collection<String> ids) {
    return comments.named(ids);
  }

  /** Returns its location. */
  public SourceLocation location() {
    return location;
  }

  /**
   * Returns the features it reads, also through definitions, in the order of first mention. Only a
   * change of these can change the verdict.
   */
  public List<Expression.Navigation> navigations() {
    return condition.navigations();
  }

  /** Returns whether a part of it may not matter, such as the conclusion of a false premise. */
  boolean isConditional() {
    return condition.isConditional();
  }

  /** Returns the texts and numbers in it and in the definitions that it uses. */
  Set<Object> literals() {
    return condition.literals();
  }

  /**
   * Evaluates it on one element; undefined also if the time runs out.
   *
   * @param element an instance of {@link #context}, which is a class; extents cover its whole
   *     resource set
   * @param budget the time budget
   */
  public Verdict evaluate(EObject element, TimeBudget budget) {
    Object value = evaluate(element, Evaluations.over(List.of(element)).withBudget(budget));
    if (value instanceof Boolean holds) {
      return holds ? Verdict.TRUE : Verdict.FALSE;
    }
    return Verdict.UNDEFINED;
  }

  /**
   * Returns whether it is true by itself, such as {@code 1 = 1}: no model can violate it, so it
   * shows nothing about any. One whose value takes long is not known to be.
   */
  public boolean holdsForAnything() {
    return condition.isConstant()
        && Boolean.TRUE.equals(
            condition.evaluate(
                Evaluations.over(List.of()).withBudget(TimeBudget.of(CONSTANT_TIME))));
  }

  /** Returns whether evaluating it may need a deep stack. */
  boolean isRecursive() {
    return condition.isRecursive();
  }

  /**
   * Returns the value for an object or a data type value: a Boolean, null, or an {@link Invalid}.
   */
  Object evaluate(Object subject, Evaluation run) {
    run.bind("self", HeldValue.self(subject));
    try {
      return condition.evaluate(run);
    } finally {
      run.unbind("self");
    }
  }

  /** Returns the message for an object or a value that violates it. */
  String messageFor(Object subject, Evaluation run) {
    run.bind("self", HeldValue.self(subject));
    try {
      if (message != null) {
        return message.render(run);
      }
      String why = condition.whyFalse(run);
      String what = HeldValue.label(subject) + " violates '" + name + "'";
      return why.isEmpty() ? what + "." : what + ": " + why + ".";
    } finally {
      run.unbind("self");
    }
  }

  @Override
  public String toString() {
    return qualifiedName();
  }
}
