package dev.eventchain.constraints;

import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.ocl.Evaluations;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.evaluation.TimeBudget;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;

/** An invariant that was parsed and checked. Immutable and thread-safe. */
public final class OclConstraint {

  /** What an invariant is for an element. */
  public enum Verdict {
    TRUE,
    FALSE,
    /** Neither: the value is null or invalid. */
    UNDEFINED
  }

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

  /** The name; one that was not given a name has {@code inv} and its number in its class. */
  public String name() {
    return name;
  }

  /** {@code Class::Name}. */
  public String qualifiedName() {
    return context.getName() + "::" + name;
  }

  /** The class whose instances it constrains, or the data type whose values. */
  public EClassifier context() {
    return context;
  }

  /** How bad a violation is. */
  public Severity severity() {
    return comments.severity();
  }

  /** What to do about a violation; empty if the rules do not say. */
  public String hint() {
    return comments.hint();
  }

  /**
   * Which of these ids its comment names, so that a reader can tell what it stands for: the lines
   * and blocks right above it, but for {@code @message} and the other annotations; or, if those
   * name none, the comment right above its context, which then is about all of its invariants.
   * Where it is in several documents, the comments of all of them count.
   *
   * @param ids as of written rules; one is not found inside another
   */
  public Set<String> named(Collection<String> ids) {
    return comments.named(ids);
  }

  /** Where it is. */
  public SourceLocation location() {
    return location;
  }

  /**
   * The features it reads, also by way of definitions, in the order of first mention: what a change
   * of the model must touch to change the verdict.
   */
  public List<Expression.Navigation> navigations() {
    return condition.navigations();
  }

  /**
   * Evaluates it on one element; undefined also if there is not the time for that.
   *
   * @param element an instance of {@link #context}, which is a class; extents cover its whole
   *     resource set
   * @param budget what the time is taken from
   */
  public Verdict evaluate(EObject element, TimeBudget budget) {
    Object value = evaluate(element, Evaluations.over(List.of(element)).withBudget(budget));
    if (value instanceof Boolean holds) {
      return holds ? Verdict.TRUE : Verdict.FALSE;
    }
    return Verdict.UNDEFINED;
  }

  /** Whether evaluating it may need a deep stack. */
  boolean isRecursive() {
    return condition.isRecursive();
  }

  /**
   * The value for an object, or for a value of a data type: a Boolean, null, or an {@link Invalid}.
   */
  Object evaluate(Object subject, Evaluation run) {
    run.bind("self", HeldValue.self(subject));
    try {
      return condition.evaluate(run);
    } finally {
      run.unbind("self");
    }
  }

  /** What to say of an object or a value that violates it. */
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
