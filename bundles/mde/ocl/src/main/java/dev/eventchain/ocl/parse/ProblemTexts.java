package dev.eventchain.ocl.parse;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.ocl.metamodel.Names;
import dev.eventchain.ocl.metamodel.PackageIndex;
import dev.eventchain.ocl.metamodel.TypeHints;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.ocl.Environment;
import org.eclipse.ocl.ecore.TypeType;
import org.eclipse.ocl.types.CollectionType;
import org.eclipse.ocl.types.InvalidType;
import org.eclipse.ocl.types.PrimitiveType;
import org.eclipse.ocl.types.VoidType;
import org.eclipse.ocl.util.TypeUtil;
import org.eclipse.ocl.utilities.TypedElement;

/** Messages and hints for problems of expressions. */
final class ProblemTexts {

  /** A message and a hint. */
  record Problem(String message, String hint) {}

  /** Literals in other languages. */
  private static final Map<String, String> LITERALS =
      Map.of(
          "true", "true",
          "false", "false",
          "null", "null, or use ->isEmpty()",
          "nil", "null, or use ->isEmpty()",
          "none", "null, or use ->isEmpty()",
          "undefined", "x.oclIsUndefined()");

  private static final Pattern UNKNOWN_LITERAL =
      Pattern.compile("Unknown enumeration literal \\((.*)\\)");
  private static final Pattern UNKNOWN_TYPE = Pattern.compile("Unknown type \\((.*)\\)");
  private static final Pattern ALREADY_THERE =
      Pattern.compile("(?:Property|Operation) \\((.*)\\) already defined in type \\((.*)\\)");
  private static final Pattern SIGNATURE = Pattern.compile(".*?\\((.*)\\)$");

  private final OclEnvironment root;
  private final PackageIndex packages;
  private final CallHints hints;
  private final TypeHints types;

  ProblemTexts(OclEnvironment root, PackageIndex packages) {
    this.root = root;
    this.packages = packages;
    this.hints = new CallHints(root);
    this.types = new TypeHints(packages);
  }

  /** Describes an unknown name without source. */
  Problem unknownName(
      String name, Environment<?, EClassifier, ?, ?, ?, EParameter, ?, ?, ?, ?, ?, ?> environment) {
    Set<String> known = new LinkedHashSet<>();
    environment.getVariables().forEach(variable -> known.add(variable.getName()));
    if (environment.getSelfVariable() != null) {
      known.addAll(featuresOf(environment.getSelfVariable().getType()));
    }
    known.addAll(types.names());
    return new Problem(
        "There is no variable, feature or type '" + name + "' here.", nameHint(name, known));
  }

  private String nameHint(String name, Set<String> known) {
    String literal = LITERALS.get(name.toLowerCase(Locale.ROOT));
    List<String> enumerations = enumerationsWith(name);
    if (literal != null) {
      return "Write " + literal + ".";
    } else if (!enumerations.isEmpty()) {
      return "Write " + enumerations.get(0) + "::" + name + ".";
    }
    String nearest = NearestName.question(name, known);
    boolean maybeType = nearest.isEmpty() && Character.isUpperCase(name.charAt(0));
    return maybeType ? types.metamodels() : nearest;
  }

  private List<String> enumerationsWith(String literal) {
    List<String> found = new ArrayList<>();
    for (EPackage each : packages.all()) {
      for (EClassifier classifier : each.getEClassifiers()) {
        if (classifier instanceof EEnum enumeration
            && enumeration.getEEnumLiteral(literal) != null) {
          found.add(classifier.getName());
        }
      }
    }
    return found;
  }

  /** Describes an unknown name after a dot. */
  Problem unknownFeature(String name, EClassifier sourceType) {
    EClassifier owner = elementType(sourceType).orElse(sourceType);
    if (sourceType instanceof TypeType literal
        && literal.getReferredType() instanceof EEnum enumeration) {
      return new Problem(
          "A literal of " + enumeration.getName() + " is not written with a dot.",
          "Write " + enumeration.getName() + "::" + name + ".");
    }
    Collection<String> features = featuresOf(owner);
    String hint = NearestName.question(name, features);
    if (hint.isEmpty() && operationsOf(owner).contains(name)) {
      hint = "'" + name + "' is an operation: write '" + name + "()'.";
    } else if (hint.isEmpty() && !features.isEmpty() && features.size() <= 12) {
      hint = "It has " + String.join(", ", features) + ".";
    }
    return new Problem(Names.of(owner) + " has no feature '" + name + "'.", hint);
  }

  /** Describes an unknown call without source. */
  Problem unknownFunction(String name, String message) {
    Matcher signature = SIGNATURE.matcher(message);
    String call = signature.matches() ? signature.group(1) : name;
    List<String> known = root.libraries().names();
    return new Problem(
        "There is no operation '" + call + "' here.",
        known.contains(name)
            ? "There is a '" + name + "', but for other types or another number of arguments."
            : NearestName.question(name, known));
  }

  /** Describes an unknown call on a source of a type. */
  Problem unknownOperation(
      EClassifier owner, String name, List<? extends TypedElement<EClassifier>> arguments) {
    String types =
        arguments == null
            ? ""
            : arguments.stream()
                .map(argument -> Names.of(argument.getType()))
                .collect(Collectors.joining(", "));
    return new Problem(
        Names.of(owner) + " has no operation '" + name + "(" + types + ")'.",
        hints.of(
            owner,
            name,
            arguments == null
                ? List.of()
                : arguments.stream().map(argument -> argument.getType()).toList(),
            featuresOf(owner)));
  }

  /** Describes a comparison with a constant result, which Eclipse OCL accepts. */
  Optional<Problem> senselessComparison(String name, EClassifier left, EClassifier right) {
    if (!name.equals("=") && !name.equals("<>")) {
      return Optional.empty();
    } else if (elementType(left).isPresent() && right instanceof VoidType<?>) {
      return Optional.of(
          new Problem("A collection is never null.", "Use ->isEmpty() or ->notEmpty()."));
    } else if (isPlain(left)
        && isPlain(right)
        && !TypeUtil.compatibleTypeMatch(root, left, right)
        && !TypeUtil.compatibleTypeMatch(root, right, left)) {
      boolean literal = left instanceof EEnum || right instanceof EEnum;
      return Optional.of(
          new Problem(
              "Values of type " + Names.of(left) + " and " + Names.of(right) + " are never equal.",
              literal ? "A literal is written Type::LITERAL." : ""));
    }
    return Optional.empty();
  }

  private static boolean isPlain(EClassifier type) {
    return type instanceof PrimitiveType<?> || type instanceof EEnum;
  }

  /** Returns whether a type stands for a reported error. */
  boolean isError(EClassifier type) {
    EClassifier each = elementType(type).orElse(type);
    return each == null || each instanceof InvalidType<?> || each instanceof VoidType<?>;
  }

  /** Returns whether an argument stands for a reported error. */
  static boolean isAnyError(List<? extends TypedElement<EClassifier>> arguments) {
    return arguments != null
        && arguments.stream().anyMatch(each -> each.getType() instanceof InvalidType<?>);
  }

  /** Describes a definition whose name is taken, if the message is about that. */
  static Optional<Problem> duplicate(String message) {
    Matcher matcher = ALREADY_THERE.matcher(message);
    return matcher.matches()
        ? Optional.of(
            new Problem(
                matcher.group(2) + " has '" + matcher.group(1) + "' already.",
                "Give the definition another name."))
        : Optional.empty();
  }

  /** Returns the message of Eclipse OCL, with a hint if a name is wrong. */
  Problem other(String message) {
    Matcher literal = UNKNOWN_LITERAL.matcher(message);
    if (literal.matches()) {
      return new Problem(
          "There is no enumeration literal '" + literal.group(1) + "'.",
          NearestName.question(literal.group(1), literals()));
    }
    Matcher type = UNKNOWN_TYPE.matcher(message);
    if (type.matches()) {
      List<String> names = List.of(type.group(1).replaceAll("^\\[|]$", "").split(", ", -1));
      String name = String.join("::", names);
      return names.size() == 1
          ? new Problem("There is no type '" + name + "'.", types.of(names))
          : new Problem("There is no type, literal or feature '" + name + "'.", types.of(names));
    }
    if (message.startsWith("Qualifiers do not conform")) {
      return new Problem("Brackets select no element here.", "Write ->at(1) for the first one.");
    }
    return new Problem(message, "");
  }

  private static Optional<EClassifier> elementType(EClassifier type) {
    return type instanceof CollectionType<?, ?> collection
        ? Optional.of((EClassifier) collection.getElementType())
        : Optional.empty();
  }

  private List<String> featuresOf(EClassifier type) {
    List<String> names = new ArrayList<>();
    if (type instanceof EClass eClass) {
      for (EStructuralFeature feature : eClass.getEAllStructuralFeatures()) {
        names.add(feature.getName());
      }
    }
    for (EStructuralFeature feature : root.getAdditionalAttributes(type)) {
      names.add(feature.getName());
    }
    return names;
  }

  private Set<String> operationsOf(EClassifier type) {
    Set<String> names = new LinkedHashSet<>();
    for (EOperation operation : TypeUtil.getOperations(root, type)) {
      names.add(operation.getName());
    }
    return names;
  }

  private Set<String> literals() {
    Set<String> names = new LinkedHashSet<>();
    for (EPackage each : packages.all()) {
      for (EClassifier classifier : each.getEClassifiers()) {
        if (classifier instanceof EEnum enumeration) {
          enumeration.getELiterals().forEach(literal -> names.add(literal.getName()));
        }
      }
    }
    return names;
  }
}
