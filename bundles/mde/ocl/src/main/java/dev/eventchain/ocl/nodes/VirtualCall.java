package dev.eventchain.ocl.nodes;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiFunction;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;

/** Calls the body in the class of the object, or in its nearest superclass. */
public final class VirtualCall extends GuardedNode {

  /**
   * The body of an operation or a property in a class and its subclasses that do not override it.
   */
  public record Implementation(EClass owner, Lowered definition) {}

  private final Node source;
  private final Node[] arguments;
  private final List<Implementation> implementations;

  /** The fallback for objects without a body. */
  private final BiFunction<Object, Object[], Object> otherwise;

  private final Map<EClass, Optional<Lowered>> targets = new ConcurrentHashMap<>();

  public VirtualCall(
      Node source,
      Node[] arguments,
      List<Implementation> implementations,
      BiFunction<Object, Object[], Object> otherwise) {
    this.source = source;
    this.arguments = arguments;
    this.implementations = implementations;
    this.otherwise = otherwise;
  }

  @Override
  Object compute(Frame frame) {
    Object object = source.evaluate(frame);
    Object[] values = DefinitionNodes.evaluate(arguments, frame);
    if (isUndefined(object)) {
      return INVALID;
    }
    Optional<Lowered> target =
        object instanceof EObject element
            ? targets.computeIfAbsent(element.eClass(), this::select)
            : Optional.empty();
    return target.isPresent()
        ? call(target.get(), object, values, frame)
        : otherwise.apply(object, values);
  }

  private Optional<Lowered> select(EClass type) {
    List<Implementation> fitting =
        implementations.stream().filter(each -> each.owner().isSuperTypeOf(type)).toList();
    return fitting.stream()
        .filter(each -> fitting.stream().noneMatch(other -> isBelow(other, each)))
        .map(Implementation::definition)
        .findFirst();
  }

  private static boolean isBelow(Implementation lower, Implementation upper) {
    return lower.owner() != upper.owner() && upper.owner().isSuperTypeOf(lower.owner());
  }

  private static Object call(Lowered definition, Object object, Object[] values, Frame frame) {
    Frame called = new Frame(frame, definition.size());
    called.slots[0] = object;
    System.arraycopy(values, 0, called.slots, 1, values.length);
    return DefinitionNodes.evaluate(definition, called);
  }
}
