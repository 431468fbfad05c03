package dev.eventchain.ocl.parse;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.ocl.metamodel.Names;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.ocl.ecore.TypeType;
import org.eclipse.ocl.expressions.CollectionKind;
import org.eclipse.ocl.types.CollectionType;
import org.eclipse.ocl.types.VoidType;
import org.eclipse.ocl.util.TypeUtil;

/** Suggestions for calls that fit no operation. */
final class CallHints {

  private static final Set<String> COMPARISONS = Set.of("=", "<>", "<", ">", "<=", ">=");
  private static final Set<String> LOGICAL = Set.of("and", "or", "xor", "implies", "not");
  private static final Set<String> ARITHMETIC = Set.of("+", "-", "*", "/");

  private static final Set<String> TYPE_TESTS = Set.of("oclIsKindOf", "oclIsTypeOf");

  /** Names of operations in other languages. */
  private static final Map<String, List<String>> SYNONYMS =
      Map.of(
          "length", List.of("size"),
          "count", List.of("size"),
          "contains", List.of("includes"),
          "add", List.of("including"),
          "remove", List.of("excluding"),
          "get", List.of("at"),
          "filter", List.of("select"),
          "isNull", List.of("oclIsUndefined"),
          "isInstanceOf", List.of("oclIsKindOf"),
          "toUpperCase", List.of("toUpper"));

  private final OclEnvironment root;

  CallHints(OclEnvironment root) {
    this.root = root;
  }

  /**
   * Returns a hint about a call.
   *
   * @param owner the type of the source
   * @param features the names of the owner's features
   */
  String of(
      EClassifier owner, String name, List<EClassifier> arguments, Collection<String> features) {
    Optional<EClassifier> element = elementType(owner);
    boolean argumentIsCollection =
        arguments.stream().anyMatch(each -> elementType(each).isPresent());
    if (LOGICAL.contains(name)) {
      return "'"
          + name
          + "' combines Booleans"
          + (name.equals("not") ? "" : " on both sides")
          + ": compare first, or use ->notEmpty() or ->forAll(...).";
    } else if (COMPARISONS.contains(name) || ARITHMETIC.contains(name)) {
      return hintForOperator(name, element.isPresent(), argumentIsCollection, owner);
    } else if (element.isPresent()) {
      return hintForArrow(owner, element.get(), name);
    } else if (operations(owner).contains(name)) {
      return "It takes " + signatures(owner, name) + ".";
    } else if (operations(anyCollection(owner)).contains(name) || isIterator(name)) {
      return "'" + name + "' applies to a collection: write ->" + name + "(...).";
    } else if (features.contains(name)) {
      return "'" + name + "' is a feature: leave the parentheses out.";
    }
    return nearest(owner, name);
  }

  private String hintForOperator(
      String name, boolean collection, boolean argumentIsCollection, EClassifier owner) {
    if (collection && argumentIsCollection) {
      return "Compare their sizes, or test one of them with ->forAll(...) or ->includesAll(...).";
    } else if (collection) {
      return "This is a collection. Test its elements with ->forAll(each | each "
          + name
          + " ...) or ->exists(...), or compare its ->size().";
    } else if (argumentIsCollection) {
      return "The argument is a collection. Test its elements with ->forAll(...) or ->exists(...),"
          + " or compare its ->size().";
    }
    String signatures = signatures(owner, name);
    return signatures.isEmpty() ? "" : "It takes " + signatures + ".";
  }

  /** Returns a hint for a call with an arrow on a collection, or on a single value as one. */
  private String hintForArrow(EClassifier owner, EClassifier element, String name) {
    if (operations(owner).contains(name)) {
      return "It takes " + signatures(owner, name) + ".";
    } else if (TYPE_TESTS.contains(name)) {
      return ("'%s' applies to each value: write a dot instead of the arrow, or ->forAll(each"
              + " | each.%s(...)) for all.")
          .formatted(name, name);
    } else if (name.equals("oclAsType")) {
      return "'oclAsType' applies to each value: write a dot instead of the arrow, or"
          + " ->selectByKind(...) for the elements of that type.";
    } else if (operations(element).contains(name) || name.equals("allInstances")) {
      // Also for a dot after a collection of collections.
      return "'"
          + name
          + "' applies to each value, not to a collection: write a dot instead of the arrow, or"
          + " ->flatten() before the dot.";
    }
    return nearest(owner, name);
  }

  private String nearest(EClassifier owner, String name) {
    Set<String> known = operations(owner);
    List<String> ofLibraries = root.libraries().names();
    if (ofLibraries.contains(name)) {
      return "There is a '" + name + "', but for other types or another number of arguments.";
    }
    known.addAll(ofLibraries);
    known.removeIf(each -> !Character.isJavaIdentifierStart(each.charAt(0))); // operators
    return SYNONYMS.getOrDefault(name, List.of()).stream()
        .filter(known::contains)
        .findFirst()
        .map(meant -> "Did you mean `" + meant + "`?")
        .orElseGet(() -> NearestName.question(name, known));
  }

  private static boolean isIterator(String name) {
    return FrequentMistakes.ITERATORS.contains(name);
  }

  private EClassifier anyCollection(EClassifier element) {
    boolean error = element instanceof VoidType<?>;
    return (EClassifier)
        root.getTypeResolver()
            .resolveCollectionType(
                CollectionKind.SEQUENCE_LITERAL,
                error ? root.getOCLStandardLibrary().getOclAny() : element);
  }

  private String signatures(EClassifier owner, String name) {
    return TypeUtil.getOperations(root, owner).stream()
        .filter(operation -> name.equals(operation.getName()))
        .map(CallHints::parameters)
        .distinct()
        .limit(4)
        .collect(Collectors.joining(" or "));
  }

  private static String parameters(EOperation operation) {
    return operation.getEParameters().stream()
        .map(parameter -> nameOf(parameter.getEType()))
        .collect(Collectors.joining(", ", "(", ")"));
  }

  private static String nameOf(EClassifier type) {
    return type instanceof TypeType ? "a type" : Names.of(type);
  }

  private Set<String> operations(EClassifier type) {
    return TypeUtil.getOperations(root, type).stream()
        .map(EOperation::getName)
        .collect(Collectors.toCollection(java.util.LinkedHashSet::new));
  }

  private static Optional<EClassifier> elementType(EClassifier type) {
    return type instanceof CollectionType<?, ?> collection
        ? Optional.of((EClassifier) collection.getElementType())
        : Optional.empty();
  }
}
