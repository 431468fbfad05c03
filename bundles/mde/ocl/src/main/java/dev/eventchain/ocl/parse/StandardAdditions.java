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
 * The operations of the standard library that Eclipse OCL's older one lacks: {@code reverse()} of
 * ordered collections (OMG OCL 2.4, 11.7.3 and 11.7.5) and {@code oclType()} of objects (11.3.1).
 */
final class StandardAdditions implements OperationLibrary {

  private static final String REVERSE = "reverse";
  private static final String TYPE = "oclType";

  @Override
  public Collection<String> names() {
    return List.of(REVERSE, TYPE);
  }

  @Override
  public Optional<Operation> lookup(
      TypeSystem types, EClassifier source, String name, List<EClassifier> argumentTypes) {
    if (source == null || !argumentTypes.isEmpty()) {
      return Optional.empty();
    }
    return switch (name) {
      case REVERSE ->
          Optional.of(source).filter(StandardAdditions::isOrdered).map(StandardAdditions::reverse);
      case TYPE -> Optional.of(source).filter(EClass.class::isInstance).map(type -> type());
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

  private static Object given(Object source) {
    if (source == null) {
      throw new IllegalArgumentException("it is called on null");
    }
    return source;
  }
}
