package dev.eventchain.ocl.parse;

import dev.eventchain.ocl.dialect.OperationLibrary;
import dev.eventchain.ocl.dialect.TypeSystem;
import dev.eventchain.ocl.values.CollectionOperations;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.ocl.expressions.CollectionKind;
import org.eclipse.ocl.types.CollectionType;

/**
 * The operations that Eclipse OCL's older standard library lacks: {@code reverse()} of ordered
 * collections (OMG OCL 2.4, 11.7.3 and 11.7.5) and {@code oclType()} of objects (11.3.1); and those
 * of its newer one, in the Pivot dialect: {@code oclContainer()} and {@code oclContents()} of
 * objects, {@code includingAll} and {@code excludingAll} of collections.
 */
final class StandardAdditions implements OperationLibrary {

  private static final String REVERSE = "reverse";
  private static final String TYPE = "oclType";
  private static final String CONTAINER = "oclContainer";
  private static final String CONTENTS = "oclContents";
  private static final String INCLUDING_ALL = "includingAll";
  private static final String EXCLUDING_ALL = "excludingAll";

  @Override
  public Collection<String> names() {
    return List.of(REVERSE, TYPE, CONTAINER, CONTENTS, INCLUDING_ALL, EXCLUDING_ALL);
  }

  @Override
  public Optional<Operation> lookup(
      TypeSystem types, EClassifier source, String name, List<EClassifier> argumentTypes) {
    if (source == null) {
      return Optional.empty();
    }
    return argumentTypes.isEmpty()
        ? withoutArguments(types, source, name)
        : withOthers(types, source, name, argumentTypes);
  }

  @Override
  public List<Signature> signatures(TypeSystem types, EClassifier source) {
    if (source == null) {
      return List.of();
    }
    List<Signature> found = new ArrayList<>();
    for (String name : List.of(REVERSE, TYPE, CONTAINER, CONTENTS)) {
      withoutArguments(types, source, name)
          .ifPresent(each -> found.add(signature(name, List.of(), each.resultType())));
    }
    for (String name : List.of(INCLUDING_ALL, EXCLUDING_ALL)) {
      withOthers(types, source, name, List.of(source))
          .ifPresent(
              each -> {
                String others = "others : " + source.getName();
                found.add(signature(name, List.of(others), each.resultType()));
              });
    }
    return found;
  }

  private static Signature signature(String name, List<String> parameters, EClassifier result) {
    return new Signature(name, parameters, result.getName(), "");
  }

  private static Optional<Operation> withoutArguments(
      TypeSystem types, EClassifier source, String name) {
    Optional<EClassifier> object = Optional.of(source).filter(EClass.class::isInstance);
    return switch (name) {
      case REVERSE ->
          Optional.of(source).filter(StandardAdditions::isOrdered).map(StandardAdditions::reverse);
      case TYPE -> object.map(type -> type());
      case CONTAINER -> object.map(type -> container(types));
      case CONTENTS -> object.map(type -> contents(types));
      default -> Optional.empty();
    };
  }

  /** Returns an operation of a collection with the elements of another one. */
  private static Optional<Operation> withOthers(
      TypeSystem types, EClassifier source, String name, List<EClassifier> argumentTypes) {
    boolean collections =
        argumentTypes.size() == 1
            && source instanceof CollectionType<?, ?>
            && argumentTypes.get(0) instanceof CollectionType<?, ?>;
    return switch (collections ? name : "") {
      case INCLUDING_ALL -> Optional.of(includingAll(types, source, argumentTypes.get(0)));
      case EXCLUDING_ALL -> Optional.of(excludingAll(source));
      default -> Optional.empty();
    };
  }

  private static boolean isOrdered(EClassifier type) {
    return type instanceof CollectionType<?, ?> collection
        && (collection.getKind() == CollectionKind.SEQUENCE_LITERAL
            || collection.getKind() == CollectionKind.ORDERED_SET_LITERAL);
  }

  private static Operation reverse(EClassifier type) {
    CollectionKind kind = ((CollectionType<?, ?>) type).getKind();
    return new Operation(
        REVERSE,
        type,
        (source, arguments, run) -> {
          List<Object> reversed = new ArrayList<>((Collection<?>) given(source));
          Collections.reverse(reversed);
          return CollectionOperations.create(kind, reversed);
        });
  }

  private static Operation type() {
    return new Operation(
        TYPE,
        EcorePackage.Literals.ECLASS,
        (source, arguments, run) -> ((EObject) given(source)).eClass());
  }

  private static Operation container(TypeSystem types) {
    return new Operation(
        CONTAINER,
        types.anyObject(),
        (source, arguments, run) -> ((EObject) given(source)).eContainer());
  }

  private static Operation contents(TypeSystem types) {
    EClassifier set = types.collectionLike(types.type("Set(OclAny)"), types.anyObject());
    return new Operation(
        CONTENTS,
        set,
        (source, arguments, run) ->
            CollectionOperations.create(
                CollectionKind.SET_LITERAL, ((EObject) given(source)).eContents()));
  }

  private static Operation includingAll(TypeSystem types, EClassifier source, EClassifier others) {
    EClassifier result = types.conforms(others, source) ? source : mixed(types, source, others);
    return new Operation(
        INCLUDING_ALL,
        result,
        (collection, arguments, run) -> {
          Collection<Object> own = elements(given(collection));
          Collection<Object> all =
              CollectionOperations.create(CollectionOperations.kindOf(own), own);
          all.addAll(elements(given(arguments.get(0))));
          return all;
        });
  }

  /** Returns the type of the source, with elements of both if those of the other one fit it. */
  private static EClassifier mixed(TypeSystem types, EClassifier source, EClassifier others) {
    EClassifier own = types.elementType(source).orElseThrow();
    EClassifier more = types.elementType(others).orElseThrow();
    return types.conforms(more, own)
        ? source
        : types.collectionLike(source, types.conforms(own, more) ? more : types.any());
  }

  private static Operation excludingAll(EClassifier source) {
    return new Operation(
        EXCLUDING_ALL,
        source,
        (collection, arguments, run) -> {
          Collection<Object> rest = elements(given(collection));
          for (Object other : elements(given(arguments.get(0)))) {
            rest = CollectionOperations.excluding(rest, other);
          }
          return rest;
        });
  }

  @SuppressWarnings("unchecked")
  private static Collection<Object> elements(Object collection) {
    return (Collection<Object>) collection;
  }

  private static Object given(Object source) {
    if (source == null) {
      throw new IllegalArgumentException("it is called on null");
    }
    return source;
  }
}
