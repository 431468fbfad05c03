package dev.eventchain.m2t.library;

import dev.eventchain.m2t.run.GenerationRun;
import dev.eventchain.ocl.dialect.OperationLibrary;
import dev.eventchain.ocl.dialect.TypeSystem;
import dev.eventchain.ocl.evaluation.Evaluation;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.types.AnyType;
import org.eclipse.ocl.types.OrderedSetType;
import org.eclipse.ocl.types.SequenceType;
import org.eclipse.ocl.types.VoidType;

/**
 * Table of the non-standard operations of Acceleo templates: the kinds of source and arguments, the
 * type of the result, and the implementation. The classes {@link TextOperations}, {@link
 * ObjectOperations} and {@link CollectionOperations} contain the rows.
 */
public final class OperationTable implements OperationLibrary {

  /** Kind of a source or an argument. */
  enum Kind {
    TEXT,
    /** A text, excluding the type of null, which conforms to every type. */
    SURELY_TEXT,
    INTEGER,
    REAL,
    COLLECTION,
    /** A sequence or an ordered set. */
    ORDERED,
    /** A type literal. */
    TYPE,
    /** Anything but a collection or a type literal. */
    ANY
  }

  /** Types of a call, which determine the type of its result. */
  record Types(TypeSystem language, EClassifier source, List<EClassifier> arguments) {
    EClassifier text() {
      return language.type("String");
    }

    EClassifier integer() {
      return language.type("Integer");
    }

    EClassifier truth() {
      return language.type("Boolean");
    }

    EClassifier sequenceOfObjects() {
      return language.sequenceOf(language.anyObject());
    }

    /** Returns the type that the first argument names. */
    EClassifier named() {
      return language.referredType(arguments.get(0)).orElse(language.any());
    }

    EClassifier sequenceOfNamed() {
      return language.sequenceOf(named());
    }
  }

  /** Function for the type of a result. */
  @FunctionalInterface
  interface ResultType {
    EClassifier of(Types types);
  }

  /**
   * Implementation of an operation; source and arguments are not null unless the row accepts null.
   */
  @FunctionalInterface
  interface Body {
    Object call(Object source, List<Object> arguments, Call call);
  }

  /** Environment of an operation besides its source and arguments. */
  record Call(TypeSystem language, Evaluation evaluation) {
    GenerationRun run() {
      return evaluation.attachment(GenerationRun.class);
    }

    boolean isInstance(Object value, Object type) {
      return language.isInstance(value, (EClassifier) type);
    }

    /** As {@link #isInstance}, but an Integer is no Real, and no value is of OclAny itself. */
    boolean isOfType(Object value, Object type) {
      if (Reals.isReal((EClassifier) type)) {
        return Reals.isRealNumber(value);
      }
      return !(type instanceof AnyType<?>) && isInstance(value, type);
    }
  }

  /** A row of the table. */
  record Row(
      String name,
      Kind source,
      List<Kind> arguments,
      ResultType result,
      boolean takesNull,
      Body body) {
    Row(String name, Kind source, List<Kind> arguments, ResultType result, Body body) {
      this(name, source, arguments, result, false, body);
    }
  }

  /**
   * Stateful operations: the tokenizer, which continues across calls, and the access to current
   * elements.
   */
  private static final Set<String> STATEFUL = Set.of("strtok", "current");

  /** Rows by name, in the order of first occurrence. */
  private static final Map<String, List<Row>> ROWS =
      Stream.of(TextOperations.rows(), ObjectOperations.rows(), CollectionOperations.rows())
          .flatMap(List::stream)
          .collect(Collectors.groupingBy(Row::name, LinkedHashMap::new, Collectors.toList()));

  @Override
  public Optional<Operation> lookup(
      TypeSystem language, EClassifier source, String name, List<EClassifier> argumentTypes) {
    if (source == null) {
      return Optional.empty();
    }
    for (Row row : ROWS.getOrDefault(name, List.of())) {
      if (suits(row, source, argumentTypes, language)) {
        EClassifier result = row.result().of(new Types(language, source, argumentTypes));
        return Optional.of(
            new Operation(name, result, new RowCall(row, language, !STATEFUL.contains(name))));
      }
    }
    return Optional.empty();
  }

  @Override
  public List<Signature> signatures(TypeSystem language, EClassifier source) {
    return source == null
        ? List.of()
        : ROWS.values().stream()
            .flatMap(List::stream)
            .filter(row -> Character.isLetter(row.name().charAt(0)))
            .filter(row -> is(row.source(), source, language))
            .map(row -> signature(row, source, language))
            .toList();
  }

  private static Signature signature(Row row, EClassifier source, TypeSystem language) {
    List<String> parameters = new ArrayList<>();
    for (Kind each : row.arguments()) {
      parameters.add(nameOf(each));
    }
    // What such an operation gives is of the type that a call names.
    boolean named = row.arguments().contains(Kind.TYPE);
    List<EClassifier> types = row.arguments().stream().map(each -> typeOf(each, language)).toList();
    String result = named ? "" : row.result().of(new Types(language, source, types)).getName();
    return new Signature(row.name(), parameters, result, "");
  }

  private static EClassifier typeOf(Kind kind, TypeSystem language) {
    return switch (kind) {
      case TEXT, SURELY_TEXT -> language.type("String");
      case INTEGER -> language.type("Integer");
      case REAL -> language.type("Real");
      case COLLECTION, ORDERED -> language.sequenceOf(language.any());
      case TYPE, ANY -> language.any();
    };
  }

  private static String nameOf(Kind kind) {
    return switch (kind) {
      case TEXT, SURELY_TEXT -> "text : String";
      case INTEGER -> "number : Integer";
      case REAL -> "number : Real";
      case COLLECTION -> "values : Collection";
      case ORDERED -> "values : Sequence";
      case TYPE -> "type : Type";
      case ANY -> "value : OclAny";
    };
  }

  /** Returns the names that are identifiers. */
  @Override
  public Collection<String> names() {
    return ROWS.keySet().stream().filter(name -> Character.isLetter(name.charAt(0))).toList();
  }

  /** A call of an operation. */
  public record RowCall(Row row, TypeSystem language, boolean isRepeatable)
      implements Implementation {
    public String name() {
      return row.name();
    }

    @Override
    public boolean isSelection() {
      return row.name().equals(CollectionOperations.FILTER);
    }

    /** Returns an implementation as {@code endOf} of the dialect does. */
    public Optional<Implementation> endOnly(boolean first) {
      return TextOperations.endOnly(row.name(), row.arguments().size(), first)
          .map(
              body ->
                  new RowCall(
                      new Row(row.name(), row.source(), row.arguments(), row.result(), body),
                      language,
                      isRepeatable));
    }

    @Override
    public Object call(Object source, List<Object> arguments, Evaluation run) {
      if (!row.takesNull()) {
        if (source == null) {
          throw new IllegalArgumentException("it is applied to null");
        }
        for (int i = 0; i < arguments.size(); i++) {
          if (arguments.get(i) == null) {
            throw new IllegalArgumentException("an argument is null");
          }
        }
      }
      return row.body().call(source, arguments, new Call(language, run));
    }
  }

  private static boolean suits(
      Row row, EClassifier source, List<EClassifier> argumentTypes, TypeSystem language) {
    if (row.arguments().size() != argumentTypes.size() || !is(row.source(), source, language)) {
      return false;
    }
    for (int i = 0; i < argumentTypes.size(); i++) {
      if (!is(row.arguments().get(i), argumentTypes.get(i), language)) {
        return false;
      }
    }
    return true;
  }

  private static boolean is(Kind kind, EClassifier type, TypeSystem language) {
    boolean collection = language.elementType(type).isPresent();
    boolean literal = language.referredType(type).isPresent();
    return switch (kind) {
      case TEXT -> !collection && !literal && language.conforms(type, language.type("String"));
      case SURELY_TEXT -> is(Kind.TEXT, type, language) && !(type instanceof VoidType<?>);
      case INTEGER -> !collection && !literal && language.conforms(type, language.type("Integer"));
      case REAL -> !collection && !literal && language.conforms(type, language.type("Real"));
      case COLLECTION -> collection;
      case ORDERED -> collection && isOrdered(type);
      case TYPE -> literal;
      case ANY -> !collection && !literal;
    };
  }

  private static boolean isOrdered(EClassifier type) {
    return type instanceof SequenceType<?, ?> || type instanceof OrderedSetType<?, ?>;
  }
}
