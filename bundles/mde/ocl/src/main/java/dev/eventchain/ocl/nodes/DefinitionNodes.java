package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.dialect.Dialect;
import dev.eventchain.ocl.dialect.OperationLibrary;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.values.CollectionOperations;
import dev.eventchain.ocl.values.Halted;
import dev.eventchain.ocl.values.Numbers;
import dev.eventchain.ocl.values.Values;
import java.util.Arrays;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.types.AnyType;
import org.eclipse.ocl.types.CollectionType;

/** Calls of definitions and of libraries. */
public final class DefinitionNodes {

  private DefinitionNodes() {}

  static Object[] evaluate(Node[] nodes, Frame frame) {
    Object[] values = new Object[nodes.length];
    for (int i = 0; i < nodes.length; i++) {
      values[i] = nodes[i].evaluate(frame);
    }
    return values;
  }

  /** Evaluates a node that passes its outermost library calls to a receiver; null or invalid. */
  static Object evaluateCalls(Node root, OperationLibrary.Implementation receiver, Frame frame) {
    if (root instanceof LibraryCall call) {
      return call.give(receiver, frame);
    } else if (root instanceof LoopNodes.Collect loop && loop.body() instanceof LibraryCall call) {
      return loop.give(call, receiver, frame);
    }
    throw new IllegalStateException("the outermost part is not a call of a library's operation");
  }

  /** Calls a definition: an operation, or a property, which has no arguments. */
  public static final class Call extends Node {
    private final Node source;
    private final Node[] arguments;
    private final Lowered definition;

    public Call(Node source, Node[] arguments, Lowered definition) {
      this.source = source;
      this.arguments = arguments;
      this.definition = definition;
    }

    @Override
    Object evaluate(Frame frame) {
      Object object = source.evaluate(frame);
      Frame called = new Frame(frame, definition.size());
      for (int i = 0; i < arguments.length; i++) {
        called.slots[i + 1] = arguments[i].evaluate(frame);
      }
      if (isUndefined(object)) {
        return INVALID;
      }
      called.slots[0] = object;
      return DefinitionNodes.evaluate(definition, called);
    }
  }

  /** Returns the value of a definition, whose object and arguments are in its own frame. */
  static Object evaluate(Lowered definition, Frame called) {
    Run run = called.run;
    run.step();
    run.enterDefinition();
    try {
      return definition.root().evaluate(called);
    } finally {
      run.leaveDefinition();
    }
  }

  /** Calls an operation of a library. */
  public static final class LibraryCall extends GuardedNode {
    private final Object call;
    private final Object type;
    private final boolean givesCollection;
    private final boolean foreign;
    private final OperationLibrary.Implementation implementation;
    private final Node source;
    private final Node[] arguments;

    /**
     * Creates the node.
     *
     * @param call the call in the expression
     * @param type the static type of its result
     */
    public LibraryCall(
        Object call,
        Object type,
        OperationLibrary.Implementation implementation,
        Node source,
        Node[] arguments) {
      this.call = call;
      this.type = type;
      this.givesCollection = type instanceof CollectionType<?, ?>;
      this.foreign =
          type instanceof CollectionType<?, ?> several
              && (several.getElementType() instanceof AnyType<?>
                  || Numbers.isForeign((EClassifier) several.getElementType()));
      this.implementation = implementation;
      this.source = source;
      this.arguments = arguments;
    }

    /** Returns a node for a caller that uses only one end of the result. */
    public Node endOnly(Dialect dialect, boolean first) {
      return dialect
          .endOf(implementation, first)
          .<Node>map(shorter -> new LibraryCall(call, type, shorter, source, arguments))
          .orElse(this);
    }

    /** Passes on all messages of foreign code. */
    @Override
    boolean tells(RuntimeException e) {
      return true;
    }

    @Override
    Object compute(Frame frame) {
      Object result = call(implementation, frame);
      if (result instanceof Invalid invalid) {
        frame.run.fail(invalid.reason(), invalid.cause());
        return INVALID;
      }
      if (!givesCollection) {
        return Numbers.normal(result);
      }
      Object normal = foreign ? Values.normal(result) : result;
      return implementation.keepsKinds() ? normal : CollectionOperations.conform(normal, type);
    }

    /** Calls a receiver instead of the library; returns null or invalid. */
    Object give(OperationLibrary.Implementation receiver, Frame frame) {
      try {
        Object result = call(receiver, frame);
        return result == INVALID || result instanceof Invalid ? INVALID : null;
      } catch (Halted e) {
        throw e;
      } catch (RuntimeException e) {
        return INVALID;
      }
    }

    private Object call(OperationLibrary.Implementation called, Frame frame) {
      Object object = source.evaluate(frame);
      if (object == INVALID) {
        return INVALID;
      }
      Object[] values = new Object[arguments.length];
      for (int i = 0; i < values.length; i++) {
        values[i] = arguments[i].evaluate(frame);
        if (values[i] == INVALID) {
          return INVALID;
        }
      }
      try {
        return called.isRepeatable()
            ? called.call(object, Arrays.asList(values), frame.run)
            : frame.calls().call(call, called, object, values, frame.run);
      } finally {
        // Failures inside evaluations by the library are not the reason of this result.
        frame.run.setOrigin(null);
        frame.run.takeFailure();
      }
    }
  }
}
