package dev.eventchain.ocl.values;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.eclipse.ocl.expressions.CollectionKind;
import org.eclipse.ocl.types.BagType;
import org.eclipse.ocl.types.CollectionType;
import org.eclipse.ocl.types.SequenceType;
import org.eclipse.ocl.types.SetType;
import org.eclipse.ocl.util.Bag;

/**
 * The collection operations of Eclipse OCL that make sets or bags, with its results (see its {@code
 * CollectionUtil}), except that sets and bags keep the order of insertion, so that no output
 * depends on hash codes.
 */
public final class CollectionOperations {

  private static final int FEW = 8;

  private CollectionOperations() {}

  public static Collection<Object> create(CollectionKind kind) {
    return switch (kind) {
      case SET_LITERAL -> new InsertionOrderedSet<>();
      case ORDERED_SET_LITERAL -> new ValueSet<>();
      case BAG_LITERAL -> new InsertionOrderedBag<>();
      case SEQUENCE_LITERAL, COLLECTION_LITERAL -> new ArrayList<>();
    };
  }

  /** Returns a new collection of a kind with these elements. */
  public static Collection<Object> create(CollectionKind kind, Collection<?> elements) {
    return switch (kind) {
      case SET_LITERAL -> new InsertionOrderedSet<>(elements);
      case ORDERED_SET_LITERAL -> new ValueSet<>(elements);
      case BAG_LITERAL -> new InsertionOrderedBag<>(elements);
      case SEQUENCE_LITERAL, COLLECTION_LITERAL -> new ArrayList<>(elements);
    };
  }

  /** Converts a Java value to a collection of a kind: with its elements, or with it alone. */
  public static Object asCollection(CollectionKind kind, Object value) {
    if (value instanceof Iterator<?>) {
      return value; // EMF's tree iterators are lists, too, but not for reading
    } else if (value instanceof Collection<?> elements) {
      return create(kind, elements);
    }
    Collection<Object> single = create(kind);
    single.add(value);
    return single;
  }

  /** Returns a result of Eclipse OCL; removes values from ordered sets that are equal in OCL. */
  public static Object distinct(Object made) {
    return made instanceof LinkedHashSet<?> set && !(made instanceof ValueSet<?>)
        ? new ValueSet<>(set)
        : made;
  }

  /** Returns the kind of the result of {@code select} and {@code reject} by static source type. */
  public static CollectionKind kindOfSelection(Object sourceType) {
    if (sourceType instanceof SetType<?, ?>) {
      return CollectionKind.SET_LITERAL;
    } else if (sourceType instanceof BagType<?, ?>) {
      return CollectionKind.BAG_LITERAL;
    } else if (sourceType instanceof SequenceType<?, ?>) {
      return CollectionKind.SEQUENCE_LITERAL;
    }
    return CollectionKind.ORDERED_SET_LITERAL;
  }

  /** Returns the kind of the result of {@code collect} by static source type. */
  public static CollectionKind kindOfCollection(Object sourceType) {
    boolean unordered = sourceType instanceof SetType<?, ?> || sourceType instanceof BagType<?, ?>;
    return unordered ? CollectionKind.BAG_LITERAL : CollectionKind.SEQUENCE_LITERAL;
  }

  /** Converts a value from Java code to OCL's representation of a collection type. */
  public static Object conform(Object value, Object type) {
    if (!(type instanceof CollectionType<?, ?> collectionType)
        || !(value instanceof Collection<?> elements)) {
      return value;
    }
    CollectionKind kind = collectionType.getKind();
    boolean conforms =
        switch (kind) {
          case SET_LITERAL -> elements instanceof InsertionOrderedSet<?>;
          case ORDERED_SET_LITERAL -> elements instanceof ValueSet<?>;
          case BAG_LITERAL -> elements instanceof InsertionOrderedBag<?>;
          case SEQUENCE_LITERAL -> elements instanceof List<?>;
          case COLLECTION_LITERAL -> true;
        };
    return conforms ? value : create(kind, elements);
  }

  static Collection<Object> union(Collection<?> first, Collection<?> second) {
    return union(first, kindOf(first), second, kindOf(second));
  }

  /** Returns the union of collections that may have other Java classes than their kinds. */
  public static Collection<Object> union(
      Collection<?> first, CollectionKind kindOfFirst, Collection<?> second, CollectionKind other) {
    Limits.requireElements((long) first.size() + second.size());
    CollectionKind kind;
    if (kindOfFirst == CollectionKind.BAG_LITERAL || other == CollectionKind.BAG_LITERAL) {
      kind = CollectionKind.BAG_LITERAL;
    } else if (first.isEmpty()) {
      kind = other;
    } else if (second.isEmpty()) {
      kind = kindOfFirst;
    } else if (isList(kindOfFirst) || isList(other)) {
      kind = CollectionKind.SEQUENCE_LITERAL;
    } else {
      kind = CollectionKind.SET_LITERAL;
    }
    if (kind == CollectionKind.SET_LITERAL && first.size() + second.size() <= FEW) {
      return unionOfFew(first, second);
    }
    Collection<Object> result = create(kind, first);
    result.addAll(second);
    return result;
  }

  private static boolean isList(CollectionKind kind) {
    return kind == CollectionKind.SEQUENCE_LITERAL || kind == CollectionKind.COLLECTION_LITERAL;
  }

  /** Returns the union of a few elements, for which comparing is faster than hashing. */
  private static Collection<Object> unionOfFew(Collection<?> first, Collection<?> second) {
    List<Object> all = new ArrayList<>(first.size() + second.size());
    addNew(first, all);
    addNew(second, all);
    return InsertionOrderedSet.ofDistinct(all);
  }

  private static void addNew(Collection<?> elements, List<Object> all) {
    // EMF copies its lists faster than it iterates over them.
    for (Object element : elements.toArray()) {
      if (!Values.contains(all, element)) {
        all.add(element);
      }
    }
  }

  static Collection<Object> intersection(Collection<?> first, Collection<?> second) {
    boolean set = first instanceof Set<?> || second instanceof Set<?>;
    Collection<Object> result =
        create(set ? CollectionKind.SET_LITERAL : CollectionKind.BAG_LITERAL);
    boolean firstIsLarger = first.size() > second.size();
    Collection<?> larger = firstIsLarger ? first : second;
    for (Object element : firstIsLarger ? second : first) {
      if (Values.contains(larger, element)) {
        result.add(element);
      }
    }
    return result;
  }

  static Collection<Object> minus(Collection<?> first, Collection<?> second) {
    Collection<Object> result = new InsertionOrderedSet<>();
    for (Object element : first) {
      if (!Values.contains(second, element)) {
        result.add(element);
      }
    }
    return result;
  }

  static Collection<Object> symmetricDifference(Collection<?> first, Collection<?> second) {
    Collection<Object> result = minus(first, second);
    result.addAll(minus(second, first));
    return result;
  }

  public static Collection<Object> including(Collection<?> source, Object element) {
    Collection<Object> result = create(kindOf(source), source);
    result.add(element);
    return result;
  }

  public static Collection<Object> excluding(Collection<?> source, Object element) {
    Collection<Object> result = create(kindOf(source), source);
    if (result instanceof List<?>) {
      result.removeIf(each -> Values.equal(each, element));
    } else {
      result.remove(element);
    }
    return result;
  }

  /** Flattens while the first element is a collection, as Eclipse OCL does. */
  public static Collection<?> flatten(Collection<?> source) {
    Collection<?> result = source;
    while (!result.isEmpty() && result.iterator().next() instanceof Collection<?>) {
      CollectionKind kind = kindOf(result);
      Collection<Object> flatter =
          create(kind == CollectionKind.ORDERED_SET_LITERAL ? CollectionKind.SET_LITERAL : kind);
      for (Object element : result) {
        flatter.addAll((Collection<?>) element);
        Limits.requireElements(flatter.size());
      }
      result = flatter;
    }
    return result;
  }

  public static CollectionKind kindOf(Collection<?> collection) {
    if (collection instanceof Bag<?>) {
      return CollectionKind.BAG_LITERAL;
    } else if (collection instanceof LinkedHashSet<?>) {
      return CollectionKind.ORDERED_SET_LITERAL;
    } else if (collection instanceof Set<?>) {
      return CollectionKind.SET_LITERAL;
    }
    return CollectionKind.SEQUENCE_LITERAL;
  }
}
