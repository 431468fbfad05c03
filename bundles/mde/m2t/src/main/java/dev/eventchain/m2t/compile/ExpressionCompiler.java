package dev.eventchain.m2t.compile;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.m2t.library.ServiceLibrary;
import dev.eventchain.m2t.syntax.Problems;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.Scope;
import java.util.Collection;
import java.util.Optional;
import java.util.function.Predicate;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.impl.BasicEObjectImpl;
import org.eclipse.ocl.types.AnyType;
import org.eclipse.ocl.types.TupleType;

/** Parses and checks the expressions and types of one module. */
record ExpressionCompiler(ExpressionLanguage language, Problems problems, Usage usage) {

  /** The instances of a class. */
  private static final class Instances implements Predicate<Object> {
    private record Refused(EClass type, Class<?> javaClass) {}

    private final EClass type;

    /**
     * The latest that was refused, for which Java looks through all interfaces; threads may
     * overwrite each other's.
     */
    private Refused latest = new Refused(null, null);

    Instances(EClass type) {
      this.type = type;
    }

    @Override
    public boolean test(Object value) {
      if (!(value instanceof BasicEObjectImpl object)) {
        return value instanceof EObject && type.isInstance(value);
      }
      EClass actual = object.eClass();
      if (actual == type) {
        return true;
      }
      Refused refused = latest;
      if (refused.type() == actual && refused.javaClass() == value.getClass()) {
        return false;
      }
      boolean accepted = type.isInstance(value);
      if (!accepted) {
        latest = new Refused(actual, value.getClass());
      }
      return accepted;
    }
  }

  /** An expression; empty if it is wrong, which has been reported. */
  Optional<Expression> parse(SourceRange span, Scope scope) {
    SourceRange inside = span.strip();
    if (inside.isEmpty()) {
      problems.syntax(span.start(), "An expression is missing here.", "");
      return Optional.empty();
    }
    try {
      Optional<Expression> parsed = language.parse(inside, scope, problems.found());
      parsed.ifPresent(expression -> note(expression, inside.start()));
      return parsed;
    } catch (StackOverflowError e) {
      problems.error(
          "m2t.nesting", inside.start(), "The expression is nested too deeply.", "Use [let].");
      return Optional.empty();
    }
  }

  private void note(Expression expression, int start) {
    usage.add(expression);
    Lints.separators(expression, problems, start);
    Lints.computedInJava(expression, problems, start);
    boolean withoutServices =
        expression.libraryCalls().stream()
            .anyMatch(
                call ->
                    call.implementation() instanceof ServiceLibrary.Call service
                        && !service.services().exist());
    if (withoutServices) {
      problems.error(
          "m2t.service",
          start,
          "The template calls a Java service, and no services were given.",
          "Name them: --services JAR or --services FOLDER.");
    }
  }

  /** An expression that can be true or false. */
  Optional<Expression> condition(SourceRange span, Scope scope) {
    Optional<Expression> parsed = parse(span, scope);
    if (parsed.isPresent()
        && !language.conforms(parsed.get().type(), language.type("Boolean"))
        && !(parsed.get().type() instanceof AnyType)) {
      problems.error(
          "m2t.condition",
          span.strip().start(),
          "The condition is of type '" + parsed.get().type().getName() + "', not 'Boolean'.",
          "Compare it with something, or use ->notEmpty().");
      return Optional.empty();
    }
    return parsed;
  }

  /** A type; empty if there is none of this name, which has been reported. */
  Optional<EClassifier> type(SourceRange span) {
    return language.type(span, problems.found());
  }

  /** The test of whether a value is an instance of a type. */
  Predicate<Object> instancesOf(EClassifier type) {
    if (type instanceof AnyType) {
      return value -> true;
    }
    if (language.elementType(type).isPresent()) {
      return value -> value instanceof Collection<?>;
    }
    boolean isTuple = type instanceof TupleType<?, ?>;
    if (!isTuple && type instanceof EClass eClass && language.type(type) == type) {
      return new Instances(eClass);
    }
    Class<?> usual = language.conforms(type, language.type("String")) ? String.class : Void.class;
    return value -> usual.isInstance(value) || language.isInstance(value, type);
  }

  /**
   * The test of whether a value is of a type; of a collection, whether its elements are. A large
   * number is an Integer, too.
   */
  Predicate<Object> valuesOf(EClassifier type) {
    Optional<EClassifier> elementType = language.elementType(type);
    if (elementType.isEmpty()) {
      boolean takesIntegers = language.conforms(language.type("Integer"), type);
      Predicate<Object> instances = instancesOf(type);
      return value -> instances.test(value) || (takesIntegers && value instanceof Long);
    }
    Predicate<Object> element = valuesOf(elementType.get());
    return value ->
        value instanceof Collection<?> elements
            && elements.stream().allMatch(each -> each == null || element.test(each));
  }
}
