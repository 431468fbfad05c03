package dev.eventchain.m2t.compile;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.generation.GenerationRules;
import dev.eventchain.m2t.library.ServiceLibrary;
import dev.eventchain.m2t.syntax.Problems;
import dev.eventchain.m2t.syntax.SyntaxRules;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.Scope;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Optional;
import java.util.function.Predicate;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.impl.BasicEObjectImpl;
import org.eclipse.ocl.types.AnyType;
import org.eclipse.ocl.types.TupleType;

/** Parser and checker of the expressions and types of one module. */
record ExpressionCompiler(
    ExpressionLanguage language, Problems problems, Usage usage, ExpressionListener listener) {

  /** Test for instances of a class. */
  private static final class Instances implements Predicate<Object> {
    private record Refused(EClass type, Class<?> javaClass) {}

    private final EClass type;

    /**
     * Cache of the latest refused class, because a negative test in Java searches all interfaces. A
     * race between threads is harmless.
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

  /** Parses an expression; empty, after a report, if it is invalid. */
  Optional<Expression> parse(SourceRange span, Scope scope) {
    SourceRange inside = span.strip();
    listener.expression(inside, scope);
    if (inside.isEmpty()) {
      problems.syntax(span.start(), "An expression is missing here.", "");
      return Optional.empty();
    }
    try {
      Optional<Expression> parsed = language.parse(inside, scope, problems.found());
      parsed.ifPresent(expression -> note(expression, inside.start()));
      return parsed;
    } catch (StackOverflowError e) {
      problems.add(
          SyntaxRules.NESTING,
          inside.start(),
          "The expression is nested too deeply.",
          "Use [let].");
      return Optional.empty();
    }
  }

  /** Returns the expression {@code null}. */
  Expression nothing() {
    return language
        .parse(SourceText.of("", "null").whole(), language.root(), new ArrayList<>())
        .orElseThrow();
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
      problems.add(
          GenerationRules.SERVICE,
          start,
          "The template calls a Java service, and no services were given.",
          "Name them: --services JAR or --services FOLDER.");
    }
  }

  /** Parses an expression that must be Boolean. */
  Optional<Expression> condition(SourceRange span, Scope scope) {
    Optional<Expression> parsed = parse(span, scope);
    if (parsed.isPresent()
        && !language.conforms(parsed.get().type(), language.type("Boolean"))
        && !(parsed.get().type() instanceof AnyType)) {
      problems.add(
          GenerationRules.CONDITION,
          span.strip().start(),
          "The condition is of type '" + parsed.get().type().getName() + "', not 'Boolean'.",
          "Compare it with something, or use ->notEmpty().");
      return Optional.empty();
    }
    return parsed;
  }

  /** Parses a type; empty, after a report, if it is unknown. */
  Optional<EClassifier> type(SourceRange span) {
    listener.type(span);
    return language.type(span, problems.found());
  }

  /** Returns the test for instances of a type. */
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
   * Returns the test for values of a type; for collections, of its elements. Large numbers are
   * Integers, too.
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
