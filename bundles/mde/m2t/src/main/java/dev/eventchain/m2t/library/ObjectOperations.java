package dev.eventchain.m2t.library;

import static dev.eventchain.m2t.library.OperationTable.Kind.ANY;
import static dev.eventchain.m2t.library.OperationTable.Kind.COLLECTION;
import static dev.eventchain.m2t.library.OperationTable.Kind.INTEGER;
import static dev.eventchain.m2t.library.OperationTable.Kind.TEXT;
import static dev.eventchain.m2t.library.OperationTable.Kind.TYPE;

import dev.eventchain.m2t.library.OperationTable.Call;
import dev.eventchain.m2t.library.OperationTable.Kind;
import dev.eventchain.m2t.library.OperationTable.Row;
import dev.eventchain.m2t.library.OperationTable.Types;
import dev.eventchain.m2t.run.GenerationRun;
import dev.eventchain.m2t.run.ObjectQueries;
import dev.eventchain.m2t.text.Texts;
import java.text.MessageFormat;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/** Operations on model elements and on values of any type. */
final class ObjectOperations {
  private ObjectOperations() {}

  static List<Row> rows() {
    List<Row> rows = new ArrayList<>();
    addWalk(rows, "eAllContents", (object, call) -> ObjectQueries.allContents(object));
    addWalk(rows, "eContents", (object, call) -> object.eContents());
    addWalk(rows, "ancestors", (object, call) -> ObjectQueries.ancestors(object));
    addWalk(rows, "siblings", (object, call) -> siblings(object));
    addWalk(rows, "precedingSiblings", (object, call) -> preceding(object));
    addWalk(rows, "followingSiblings", (object, call) -> following(object));
    addWalk(rows, "eInverse", (object, call) -> call.run().objects().referrers(object));
    rows.add(
        new Row(
            "eContainer",
            ANY,
            List.of(TYPE),
            Types::named,
            (s, a, c) ->
                ObjectQueries.ancestors(object(s)).stream()
                    .filter(each -> c.isInstance(each, a.get(0)))
                    .findFirst()
                    .orElse(null)));
    rows.add(
        new Row(
            "eGet",
            ANY,
            List.of(TEXT),
            types -> types.language().any(),
            (s, a, c) -> object(s).eGet(feature(object(s), (String) a.get(0)))));
    addContext(rows);
    return rows;
  }

  private static void addContext(List<Row> rows) {
    rows.add(new Row("lineSeparator", ANY, List.of(), Types::text, true, (s, a, c) -> "\n"));
    addProperties(rows);
    addSelves(rows);
  }

  /**
   * Adds lookups of properties, in one file or all, with values for {@code {0}}, {@code {1}} in
   * their texts.
   */
  private static void addProperties(List<Row> rows) {
    addProperty(rows, (a, run) -> run.property((String) a.get(0)), TEXT);
    addProperty(rows, (a, run) -> run.property((String) a.get(0), (String) a.get(1)), TEXT, TEXT);
  }

  private static void addProperty(
      List<Row> rows,
      BiFunction<List<Object>, GenerationRun, Optional<String>> value,
      Kind... arguments) {
    List<Kind> withValues = new ArrayList<>(List.of(arguments));
    withValues.add(COLLECTION);
    rows.add(
        new Row(
            "getProperty",
            ANY,
            List.of(arguments),
            Types::text,
            true,
            (s, a, c) -> value.apply(given(a), c.run()).orElse(null)));
    rows.add(
        new Row(
            "getProperty",
            ANY,
            withValues,
            Types::text,
            true,
            (s, a, c) ->
                value
                    .apply(given(a), c.run())
                    .map(text -> filled(text, (Collection<?>) a.get(a.size() - 1)))
                    .orElse(null)));
  }

  private static List<Object> given(List<Object> arguments) {
    if (arguments.contains(null)) {
      throw new IllegalArgumentException("an argument is null");
    }
    return arguments;
  }

  private static String filled(String text, Collection<?> values) {
    return new MessageFormat(text, Locale.ROOT).format(values.stream().map(Texts::of).toArray());
  }

  /** Adds access to the values of self around an expression. */
  private static void addSelves(List<Row> rows) {
    rows.add(
        new Row(
            "current",
            ANY,
            List.of(TYPE),
            Types::named,
            true,
            (s, a, c) ->
                c.run().calls().selves().stream()
                    .filter(each -> c.isInstance(each, a.get(0)))
                    .findFirst()
                    .orElse(null)));
    rows.add(
        new Row(
            "current",
            ANY,
            List.of(INTEGER),
            types -> types.language().any(),
            true,
            (s, a, c) -> c.run().calls().selves().get(((Number) a.get(0)).intValue())));
  }

  /** Adds a navigation from an object to others: to all of them, or those of a type. */
  private static void addWalk(
      List<Row> rows, String name, BiFunction<EObject, Call, Collection<EObject>> walk) {
    rows.add(
        new Row(
            name,
            ANY,
            List.of(),
            Types::sequenceOfObjects,
            (s, a, c) -> new ArrayList<>(walk.apply(object(s), c))));
    rows.add(
        new Row(
            name,
            ANY,
            List.of(TYPE),
            Types::sequenceOfNamed,
            (s, a, c) ->
                walk.apply(object(s), c).stream()
                    .filter(each -> c.isInstance(each, a.get(0)))
                    .toList()));
  }

  private static EObject object(Object value) {
    if (value instanceof EObject object) {
      return object;
    }
    throw new IllegalArgumentException("'" + value + "' is not a model element");
  }

  private static EStructuralFeature feature(EObject object, String name) {
    EStructuralFeature feature = object.eClass().getEStructuralFeature(name);
    if (feature == null) {
      throw new IllegalArgumentException(
          object.eClass().getName() + " has no feature '" + name + "'");
    }
    return feature;
  }

  private static List<EObject> siblings(EObject object) {
    return part(object, row -> row.stream().filter(each -> each != object).toList());
  }

  private static List<EObject> preceding(EObject object) {
    return part(object, row -> row.subList(0, row.indexOf(object)));
  }

  private static List<EObject> following(EObject object) {
    return part(object, row -> row.subList(row.indexOf(object) + 1, row.size()));
  }

  private static List<EObject> part(EObject object, Function<List<EObject>, List<EObject>> part) {
    return part.apply(ObjectQueries.row(object));
  }
}
