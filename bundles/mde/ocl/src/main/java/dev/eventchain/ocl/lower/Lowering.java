package dev.eventchain.ocl.lower;

import dev.eventchain.ocl.model.ModelAccess;
import dev.eventchain.ocl.nodes.Lowered;
import dev.eventchain.ocl.nodes.Node;
import dev.eventchain.ocl.nodes.VirtualCall;
import dev.eventchain.ocl.parse.OclEnvironment;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.ETypedElement;
import org.eclipse.ocl.expressions.OCLExpression;

/**
 * Compiles the expressions of a language into trees of {@link Node}s, whose variables are slots of
 * an array. An expression is compiled once, when it is first evaluated, together with the
 * definitions it calls.
 */
public final class Lowering {

  private final OclEnvironment environment;
  private final ModelAccess model;
  private final Overriding overriding;
  private final boolean tracing;

  /** By body. All are complete, except while one is being lowered. */
  private final Map<OCLExpression<EClassifier>, Lowered> definitions = new HashMap<>();

  /** The definitions that the current expression has added. */
  private final List<OCLExpression<EClassifier>> added = new ArrayList<>();

  /** True if the current expression calls a recursive definition. */
  private boolean recursive;

  /**
   * Creates the compiler.
   *
   * @param tracing true if the nodes record why a value is invalid
   */
  public Lowering(OclEnvironment environment, ModelAccess model, boolean tracing) {
    this.environment = environment;
    this.model = model;
    this.tracing = tracing;
    this.overriding = new Overriding(environment);
  }

  /** Lowers an expression. */
  public synchronized Lowered lower(OCLExpression<EClassifier> expression) {
    added.clear();
    recursive = false;
    boolean done = false;
    try {
      Lowered result = new Lowered();
      new BodyLowering(this, null).lower(expression, result);
      done = true;
      return result;
    } finally {
      if (!done) {
        definitions.keySet().removeAll(added);
      }
    }
  }

  /** Returns the lowered body of an operation or a property; null if it has none. */
  Lowered definition(ETypedElement member) {
    OCLExpression<EClassifier> body = member == null ? null : environment.bodyOf(member);
    if (body == null) {
      return null;
    }
    List<String> variables = new ArrayList<>();
    variables.add("self");
    if (member instanceof EOperation operation) {
      operation.getEParameters().forEach(parameter -> variables.add(parameter.getName()));
    }
    return definition(body, variables);
  }

  /** Returns the bodies of an operation or a property in subclasses of the static source type. */
  List<VirtualCall.Implementation> overrides(EClassifier source, ETypedElement member) {
    List<VirtualCall.Implementation> found = new ArrayList<>();
    if (source instanceof EClass type && member != null) {
      for (EClass below : environment.packages().classesBelow(type)) {
        for (ETypedElement other : overriding.in(below, member)) {
          found.add(new VirtualCall.Implementation(below, definition(other)));
        }
      }
    }
    return found;
  }

  private Lowered definition(OCLExpression<EClassifier> body, List<String> parameters) {
    Lowered known = definitions.get(body);
    if (known == null) {
      known = new Lowered();
      definitions.put(body, known);
      added.add(body);
      new BodyLowering(this, parameters).lower(body, known);
    }
    recursive |= known.isRecursive();
    return known;
  }

  boolean isRecursive() {
    return recursive;
  }

  boolean isTracing() {
    return tracing;
  }

  /** Returns the environment in which the expressions were parsed. */
  OclEnvironment environment() {
    return environment;
  }

  /** Returns the access to models, which does not depend on a run. */
  ModelAccess model() {
    return model;
  }
}
