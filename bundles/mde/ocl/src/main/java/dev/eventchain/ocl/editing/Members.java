package dev.eventchain.ocl.editing;

import dev.eventchain.editing.ElementKind;
import dev.eventchain.ocl.dialect.OperationLibrary;
import dev.eventchain.ocl.metamodel.Names;
import dev.eventchain.ocl.parse.OclEnvironment;
import dev.eventchain.ocl.text.Keywords;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.ETypedElement;
import org.eclipse.ocl.ecore.TypeType;
import org.eclipse.ocl.expressions.CollectionKind;
import org.eclipse.ocl.types.CollectionType;
import org.eclipse.ocl.util.TypeUtil;

/** Finds what a type offers: its features and operations, those of the library included. */
public final class Members {

  private static final String BODY = "each | expression";

  /** Operations of the standard library for which there is nothing here. */
  private static final Set<String> OF_RUNNING_PROGRAMS = Set.of("oclIsNew", "oclIsInState");

  private static final Set<String> TESTS = Set.of("forAll", "exists", "one", "isUnique");

  private static final Set<String> SELECTIONS = Set.of("select", "reject");

  private final OclEnvironment environment;
  private final Map<String, Member> found = new LinkedHashMap<>();

  private Members(OclEnvironment environment) {
    this.environment = environment;
  }

  /** Returns what can follow a dot; for a collection, the members of its elements. */
  public static List<Member> afterDot(OclEnvironment environment, EClassifier type) {
    EClassifier single = type;
    while (single instanceof CollectionType<?, ?> collection) {
      single = (EClassifier) collection.getElementType();
    }
    Members members = new Members(environment);
    members.addFeatures(single);
    members.addLibrary(single);
    members.addOperations(single);
    return members.sorted();
  }

  /** Returns what can follow an arrow; a single value counts as a collection of one. */
  public static List<Member> afterArrow(OclEnvironment environment, EClassifier type) {
    EClassifier collection =
        type instanceof CollectionType<?, ?>
            ? type
            : (EClassifier)
                environment
                    .getTypeResolver()
                    .resolveCollectionType(CollectionKind.SET_LITERAL, type);
    Members members = new Members(environment);
    members.addIterators((CollectionType<?, ?>) collection);
    members.addLibrary(collection);
    members.addOperations(collection);
    return members.sorted();
  }

  /** Returns what can be called without a source. */
  public static List<Member> functions(OclEnvironment environment) {
    Members members = new Members(environment);
    members.addLibrary(null);
    return List.copyOf(members.found.values());
  }

  /** Returns all, those that every value has last. */
  private List<Member> sorted() {
    return found.values().stream().sorted(Comparator.comparingInt(Members::rank)).toList();
  }

  private static int rank(Member member) {
    return switch (member.kind()) {
      case ATTRIBUTE, REFERENCE -> 0;
      case DEFINITION, TEMPLATE, QUERY -> 1;
      case ITERATOR -> 2;
      default -> member.name().startsWith("ocl") || member.origin().equals("EObject") ? 4 : 3;
    };
  }

  private void addFeatures(EClassifier type) {
    for (EStructuralFeature feature : TypeUtil.getAttributes(environment, type)) {
      EClassifier value = environment.getUMLReflection().getOCLType(feature);
      ElementKind kind =
          environment.getDefinition(feature) != null
              ? ElementKind.DEFINITION
              : feature instanceof EAttribute ? ElementKind.ATTRIBUTE : ElementKind.REFERENCE;
      add(new Member(feature.getName(), kind, null, name(value), owner(feature), feature, value));
    }
  }

  private void addOperations(EClassifier type) {
    for (EOperation operation : TypeUtil.getOperations(environment, type)) {
      ElementKind kind =
          environment.getDefinition(operation) != null
              ? ElementKind.DEFINITION
              : ElementKind.OPERATION;
      EClassifier value = resultOf(operation, type);
      add(
          new Member(
              operation.getName(),
              kind,
              parameters(operation, type),
              generic(name(value), type),
              owner(operation),
              operation,
              value));
    }
  }

  private EClassifier resultOf(EOperation operation, EClassifier type) {
    try {
      return operation.getEParameters().isEmpty() || !(type instanceof CollectionType<?, ?>)
          ? TypeUtil.getResultType(null, environment, type, operation, List.of())
          : operation.getEType();
    } catch (RuntimeException e) { // Some results depend on arguments, which are not there.
      return operation.getEType();
    }
  }

  private void addIterators(CollectionType<?, ?> type) {
    for (Object each : type.oclIterators()) {
      String name = Names.of(each);
      String element = name((EClassifier) type.getElementType());
      String result =
          TESTS.contains(name)
              ? "Boolean"
              : SELECTIONS.contains(name)
                  ? name((EClassifier) type)
                  : name.equals("any") ? element : "";
      String initial = name.equals("iterate") ? "each; result : Type = initial | expression" : BODY;
      add(new Member(name, ElementKind.ITERATOR, List.of(initial), result, "", null, null));
    }
  }

  private void addLibrary(EClassifier type) {
    for (OperationLibrary.Signature each : environment.libraries().signatures(type)) {
      ElementKind kind =
          switch (each.origin()) {
            case "template" -> ElementKind.TEMPLATE;
            case "query" -> ElementKind.QUERY;
            default -> ElementKind.OPERATION;
          };
      add(
          new Member(
              each.name(), kind, each.parameters(), each.result(), each.origin(), null, null));
    }
  }

  /** Adds a member, unless one that hides it has been added. */
  private void add(Member member) {
    boolean word = Character.isJavaIdentifierStart(member.name().charAt(0));
    if (word
        && !Keywords.ALL.contains(member.name())
        && !OF_RUNNING_PROGRAMS.contains(member.name())) {
      List<String> types =
          member.parameters() == null
              ? null
              : member.parameters().stream().map(each -> each.replaceFirst("^.* : ", "")).toList();
      found.putIfAbsent(member.name() + (types == null ? "" : types), member);
    }
  }

  /** Returns the name of a type with that of the elements in place of the parameter T. */
  private static String generic(String name, EClassifier source) {
    String element =
        source instanceof CollectionType<?, ?> collection
            ? name((EClassifier) collection.getElementType())
            : name(source);
    return name.matches(".*\\bT2\\b.*")
        ? ""
        : name.replaceAll("\\bT\\b", Matcher.quoteReplacement(element));
  }

  private static List<String> parameters(EOperation operation, EClassifier source) {
    List<String> parameters = new ArrayList<>();
    for (EParameter parameter : operation.getEParameters()) {
      String type =
          parameter.getEType() instanceof TypeType
              ? "Type"
              : generic(name(parameter.getEType()), source);
      boolean named = parameter.getName() != null && !parameter.getName().isEmpty();
      parameters.add(named ? parameter.getName() + " : " + type : type);
    }
    return parameters;
  }

  private static String owner(ETypedElement element) {
    String owner = element.eContainer() instanceof EClass type ? type.getName() : null;
    return owner == null || owner.endsWith("_Class") ? "" : owner; // a class of the library
  }

  /** Returns the name of a type for people. */
  public static String name(EClassifier type) {
    if (type == null || type.getName() == null) {
      return "";
    }
    return type instanceof TypeType literal && literal.getReferredType() != null
        ? "Class(" + name(literal.getReferredType()) + ")"
        : type.getName();
  }
}
