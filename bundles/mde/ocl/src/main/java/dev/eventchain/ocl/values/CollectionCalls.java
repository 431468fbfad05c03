package dev.eventchain.ocl.values;

import java.util.Collection;
import org.eclipse.ocl.utilities.PredefinedType;

/** The results of standard library operations on collections. */
public final class CollectionCalls {

  private CollectionCalls() {}

  public static Collection<?> unary(int code, Collection<?> source) {
    return switch (code) {
      case PredefinedType.AS_SET ->
          source instanceof InsertionOrderedSet<?> ? source : new InsertionOrderedSet<>(source);
      case PredefinedType.AS_BAG ->
          source instanceof InsertionOrderedBag<?> ? source : new InsertionOrderedBag<>(source);
      case PredefinedType.FLATTEN -> CollectionOperations.flatten(source);
      default -> throw new IllegalArgumentException("operation " + code);
    };
  }

  public static Collection<Object> binary(int code, Collection<?> source, Collection<?> argument) {
    return switch (code) {
      case PredefinedType.UNION -> CollectionOperations.union(source, argument);
      case PredefinedType.INTERSECTION -> CollectionOperations.intersection(source, argument);
      case PredefinedType.MINUS -> CollectionOperations.minus(source, argument);
      case PredefinedType.SYMMETRIC_DIFFERENCE ->
          CollectionOperations.symmetricDifference(source, argument);
      default -> throw new IllegalArgumentException("operation " + code);
    };
  }
}
