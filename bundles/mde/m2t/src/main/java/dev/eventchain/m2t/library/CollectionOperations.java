package dev.eventchain.m2t.library;

import static dev.eventchain.m2t.library.OperationTable.Kind.ANY;
import static dev.eventchain.m2t.library.OperationTable.Kind.COLLECTION;
import static dev.eventchain.m2t.library.OperationTable.Kind.INTEGER;
import static dev.eventchain.m2t.library.OperationTable.Kind.ORDERED;
import static dev.eventchain.m2t.library.OperationTable.Kind.TEXT;
import static dev.eventchain.m2t.library.OperationTable.Kind.TYPE;

import dev.eventchain.m2t.library.OperationTable.Body;
import dev.eventchain.m2t.library.OperationTable.Kind;
import dev.eventchain.m2t.library.OperationTable.ResultType;
import dev.eventchain.m2t.library.OperationTable.Row;
import dev.eventchain.m2t.library.OperationTable.Types;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.util.ObjectUtil;

/** Operations on collections. Positions count from 1; the position of a missing element is -1. */
final class CollectionOperations {
  private static final ResultType SAME = Types::source;

  /** Name of the operation that selects elements of a type. */
  static final String FILTER = "filter";

  private CollectionOperations() {}

  static List<Row> rows() {
    List<Row> rows = new ArrayList<>();
    rows.add(
        row(
            FILTER,
            COLLECTION,
            types -> types.language().collectionLike(types.source(), types.named()),
            (s, a, c) -> list(s).stream().filter(each -> c.isOfType(each, a.get(0))).toList(),
            TYPE));
    addSeparators(rows);
    addOrder(rows);
    rows.add(
        row("addAll", COLLECTION, SAME, (s, a, c) -> joined(list(s), list(a.get(0))), COLLECTION));
    rows.add(row("removeAll", COLLECTION, SAME, (s, a, c) -> without(s, a.get(0)), COLLECTION));
    return rows;
  }

  private static void addSeparators(List<Row> rows) {
    rows.add(
        row(
            "sep",
            COLLECTION,
            CollectionOperations::textsOrAnything,
            (s, a, c) -> separated(list(s), a.get(0)),
            TEXT));
    rows.add(
        row(
            "sep",
            COLLECTION,
            CollectionOperations::textsOrAnything,
            (s, a, c) -> {
              List<Object> result = separated(list(s), a.get(1));
              result.add(0, a.get(0));
              result.add(a.get(2));
              return result;
            },
            TEXT,
            TEXT,
            TEXT));
  }

  private static void addOrder(List<Row> rows) {
    rows.add(
        row(
            "reverse",
            ORDERED,
            SAME,
            (s, a, c) -> {
              List<Object> result = list(s);
              Collections.reverse(result);
              return result;
            }));
    rows.add(
        row("drop", ORDERED, SAME, (s, a, c) -> list(s).subList(count(s, a), size(s)), INTEGER));
    rows.add(
        row(
            "dropRight",
            ORDERED,
            SAME,
            (s, a, c) -> list(s).subList(0, size(s) - count(s, a)),
            INTEGER));
    rows.add(row("startsWith", ORDERED, Types::truth, (s, a, c) -> starts(s, a.get(0)), ORDERED));
    rows.add(row("endsWith", ORDERED, Types::truth, (s, a, c) -> ends(s, a.get(0)), ORDERED));
    for (Kind kind : List.of(ANY, COLLECTION)) {
      rows.add(
          new Row(
              "lastIndexOf",
              ORDERED,
              List.of(kind),
              Types::integer,
              true,
              (s, a, c) -> index(lastSlice(list(s), Collections.singletonList(a.get(0))))));
    }
    rows.add(
        row(
            "indexOfSlice",
            ORDERED,
            Types::integer,
            (s, a, c) -> index(firstSlice(list(s), list(a.get(0)))),
            ORDERED));
    rows.add(
        row(
            "lastIndexOfSlice",
            ORDERED,
            Types::integer,
            (s, a, c) -> index(lastSlice(list(s), list(a.get(0)))),
            ORDERED));
  }

  private static Row row(
      String name, Kind source, ResultType result, Body body, Kind... arguments) {
    return new Row(name, source, List.of(arguments), result, body);
  }

  /**
   * Returns the result type: a sequence of strings remains one with separators; others can hold
   * anything.
   */
  private static EClassifier textsOrAnything(Types types) {
    EClassifier elements = types.language().elementType(types.source()).orElseThrow();
    boolean texts = types.language().conforms(elements, types.text());
    return types.language().sequenceOf(texts ? types.text() : types.language().any());
  }

  private static List<Object> list(Object collection) {
    return new ArrayList<>((Collection<?>) collection);
  }

  private static int size(Object collection) {
    return ((Collection<?>) collection).size();
  }

  /** Returns the number of elements to drop, limited to the size of the collection. */
  private static int count(Object collection, List<Object> arguments) {
    int wanted = ((Number) arguments.get(0)).intValue();
    return Math.max(0, Math.min(size(collection), wanted));
  }

  private static int index(int fromZero) {
    return fromZero < 0 ? -1 : fromZero + 1;
  }

  private static List<Object> separated(List<Object> elements, Object separator) {
    List<Object> result = new ArrayList<>();
    for (Object element : elements) {
      if (!result.isEmpty()) {
        result.add(separator);
      }
      result.add(element);
    }
    return result;
  }

  private static List<Object> joined(List<Object> first, List<Object> second) {
    first.addAll(second);
    return first;
  }

  private static List<Object> without(Object collection, Object others) {
    Set<Object> removed = new HashSet<>();
    ((Collection<?>) others).forEach(each -> removed.add(key(each)));
    List<Object> result = list(collection);
    result.removeIf(each -> removed.contains(key(each)));
    return result;
  }

  /** Returns a key that is the same for equal values of OCL, such as 1 and 1.0. */
  private static Object key(Object value) {
    return value instanceof Number number ? Double.valueOf(number.doubleValue() + 0.0) : value;
  }

  private static int firstSlice(List<Object> elements, List<Object> slice) {
    for (int i = 0; i + slice.size() <= elements.size(); i++) {
      if (isSlice(elements, slice, i)) {
        return i;
      }
    }
    return -1;
  }

  private static int lastSlice(List<Object> elements, List<Object> slice) {
    for (int i = elements.size() - slice.size(); i >= 0; i--) {
      if (isSlice(elements, slice, i)) {
        return i;
      }
    }
    return -1;
  }

  private static boolean isSlice(List<Object> elements, List<Object> slice, int from) {
    if (from < 0 || from + slice.size() > elements.size()) {
      return false;
    }
    for (int i = 0; i < slice.size(); i++) {
      if (!ObjectUtil.equal(elements.get(from + i), slice.get(i))) {
        return false;
      }
    }
    return true;
  }

  private static boolean starts(Object collection, Object part) {
    return isSlice(list(collection), list(part), 0);
  }

  private static boolean ends(Object collection, Object part) {
    return isSlice(list(collection), list(part), size(collection) - size(part));
  }
}
