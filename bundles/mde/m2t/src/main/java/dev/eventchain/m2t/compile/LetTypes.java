package dev.eventchain.m2t.compile;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.m2t.library.Reals;
import dev.eventchain.m2t.template.Signatures;
import java.util.Collection;
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
   * @param valueType the static type of the value
   */
  Predicate<Object> accepts(SourceRange declared, EClassifier type, EClassifier valueType) {
    if (type instanceof CollectionType<?, ?> wanted) {
      if (!(valueType instanceof CollectionType<?, ?> given)) {
        return value -> kinds(value).contains(wanted.getKind());
      }
      boolean fits = fits(wanted.getKind(), given.getKind());
      if (!fits) {
        never(declared, type, valueType);
      }
      return value -> fits && value instanceof Collection<?>;
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
