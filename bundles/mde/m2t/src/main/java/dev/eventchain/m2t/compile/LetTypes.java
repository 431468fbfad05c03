package dev.eventchain.m2t.compile;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.m2t.library.Reals;
import dev.eventchain.m2t.template.Signatures;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.Scope;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.expressions.CollectionKind;
import org.eclipse.ocl.types.CollectionType;
import org.eclipse.ocl.types.PrimitiveType;
import org.eclipse.ocl.util.Bag;

/**
 * Types of values that {@code [let name : Type = ...]} accepts. As in Acceleo, no value is
 * converted: an ordered set is a set, but no sequence; an Integer is not a Real; and no value is of
 * the type Collection itself.
 */
record LetTypes(ExpressionCompiler expressions) {

  /**
   * Returns the test for values of a declared type. Warns if no value can pass.
   *
   * @param declared the source range of the declared type
   */
  Predicate<Object> accepts(
      SourceRange declared, EClassifier type, Expression expression, Scope scope) {
    EClassifier valueType = expression.type();
    if (type instanceof CollectionType<?, ?> wanted) {
      if (!(valueType instanceof CollectionType<?, ?> given)) {
        return value -> kinds(value).contains(wanted.getKind());
      }
      if (!fits(wanted.getKind(), given.getKind()) && hasItsKind(expression, scope)) {
        never(declared, type, valueType);
      }
      return value ->
          value instanceof Collection<?> elements
              && fits(wanted.getKind(), kind(elements, given.getKind()));
    }
    Predicate<Object> instances = expressions.instancesOf(type);
    if ((Reals.isReal(type) && isInteger(valueType)) || isOther(type, valueType)) {
      never(declared, type, valueType);
    }
    return Reals.isReal(type)
        ? value -> Reals.isRealNumber(value) && instances.test(value)
        : instances;
  }

  /** Returns whether no value is of both types. Two classes may have a common subclass. */
  private boolean isOther(EClassifier type, EClassifier valueType) {
    boolean primitive = type instanceof PrimitiveType<?> || valueType instanceof PrimitiveType<?>;
    return primitive && !new Signatures(expressions.language()).mayFit(valueType, type);
  }

  private static boolean isInteger(EClassifier type) {
    return type instanceof PrimitiveType<?> primitive
        && primitive.getName().equals(PrimitiveType.INTEGER_NAME);
  }

  private static boolean fits(CollectionKind wanted, CollectionKind given) {
    return wanted != CollectionKind.COLLECTION_LITERAL && (wanted == given || isSet(wanted, given));
  }

  private static boolean isSet(CollectionKind wanted, CollectionKind given) {
    return wanted == CollectionKind.SET_LITERAL && given == CollectionKind.ORDERED_SET_LITERAL;
  }

  /**
   * Returns whether a collection certainly is of the kind that its static type says. Queries give
   * collections of other kinds than they declare, and variables hold what queries give.
   */
  static boolean hasItsKind(Expression collection, Scope scope) {
    return collection.libraryCalls().stream().noneMatch(call -> call.implementation().keepsKinds())
        && collection.variableNames().stream()
            .noneMatch(name -> scope.typeOf(name) instanceof CollectionType<?, ?>);
  }

  /**
   * Returns the kind that a collection has at run time; lists of the model leave it to the static
   * type.
   */
  private static CollectionKind kind(Collection<?> elements, CollectionKind declared) {
    if (elements instanceof Bag<?>) {
      return CollectionKind.BAG_LITERAL;
    } else if (elements instanceof LinkedHashSet<?>) {
      return CollectionKind.ORDERED_SET_LITERAL;
    } else if (elements instanceof Set<?>) {
      return CollectionKind.SET_LITERAL;
    }
    return elements instanceof ArrayList<?> ? CollectionKind.SEQUENCE_LITERAL : declared;
  }

  private static Set<CollectionKind> kinds(Object value) {
    if (value instanceof List<?>) {
      return Set.of(CollectionKind.SEQUENCE_LITERAL);
    } else if (value instanceof Bag<?>) {
      return Set.of(CollectionKind.BAG_LITERAL);
    }
    return value instanceof Set<?>
        ? Set.of(CollectionKind.SET_LITERAL, CollectionKind.ORDERED_SET_LITERAL)
        : Set.of();
  }

  private void never(SourceRange declared, EClassifier type, EClassifier valueType) {
    expressions
        .problems()
        .add(
            CompilerRules.LET_NEVER,
            declared.strip().start(),
            "The block is never entered: the value is of type '"
                + valueType.getName()
                + "', which is not '"
                + type.getName()
                + "'.",
            "Declare the type of the value, or convert it.");
  }
}
