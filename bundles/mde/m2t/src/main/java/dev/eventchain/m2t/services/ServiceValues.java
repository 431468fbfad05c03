package dev.eventchain.m2t.services;

import dev.eventchain.m2t.text.Texts;
import java.lang.reflect.Array;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.common.util.Enumerator;
import org.eclipse.emf.ecore.EObject;

/** Conversion of OCL values to arguments of Java methods, and of their results to OCL values. */
public final class ServiceValues {
  private ServiceValues() {}

  /** Argument, which may be null. */
  record Argument(Object value) {}

  /** Returns the argument for a parameter of a type; empty if the value does not fit. */
  static Optional<Argument> toJava(Object value, Class<?> type) {
    if (value == null) {
      return type.isPrimitive() ? Optional.empty() : Optional.of(new Argument(null));
    }
    if (value instanceof Number number) {
      return number(number, type);
    }
    if (value instanceof Collection<?> elements) {
      return collection(elements, type);
    }
    boolean takes = type.isInstance(value) || (type == boolean.class && value instanceof Boolean);
    return takes ? Optional.of(new Argument(value)) : Optional.empty();
  }

  private static Optional<Argument> number(Number number, Class<?> type) {
    boolean whole = number instanceof Integer || number instanceof Long;
    Object value = null;
    if (type == double.class || type == Double.class) {
      value = number.doubleValue();
    } else if (type == float.class || type == Float.class) {
      value = number.floatValue();
    } else if (whole && (type == long.class || type == Long.class)) {
      value = number.longValue();
    } else if (number instanceof Integer && (type == int.class || type == Integer.class)) {
      value = number;
    } else if (type.isInstance(number)) {
      value = number;
    }
    return Optional.ofNullable(value).map(Argument::new);
  }

  private static Optional<Argument> collection(Collection<?> elements, Class<?> type) {
    if (type.isAssignableFrom(ArrayList.class)) {
      return Optional.of(new Argument(new ArrayList<>(elements)));
    }
    return type.isAssignableFrom(LinkedHashSet.class)
        ? Optional.of(new Argument(new LinkedHashSet<>(elements)))
        : Optional.empty();
  }

  /**
   * Returns the result of a method as an OCL value. Numbers, characters, collections and arrays are
   * converted; an {@link Optional} gives its content or null; any other object gives its text.
   *
   * @param shown the name of the method, for the start of a message
   * @throws ServiceException if an object has no text, or one that differs between runs
   */
  static Object toOcl(Object value, String shown) {
    if (isOcl(value)) {
      return value;
    } else if (value instanceof Long number) {
      return number == number.intValue() ? (Object) number.intValue() : number;
    } else if (value instanceof Short || value instanceof Byte) {
      return ((Number) value).intValue();
    } else if (value instanceof Float number) {
      return number.doubleValue();
    } else if (value instanceof Collection<?> elements) {
      List<Object> copy = new ArrayList<>();
      elements.forEach(each -> copy.add(toOcl(each, shown)));
      return copy;
    } else if (value instanceof Optional<?> held) {
      return toOcl(held.orElse(null), shown);
    } else if (value.getClass().isArray()) {
      List<Object> copy = new ArrayList<>();
      for (int i = 0; i < Array.getLength(value); i++) {
        copy.add(toOcl(Array.get(value, i), shown));
      }
      return copy;
    }
    return text(value, shown);
  }

  private static boolean isOcl(Object value) {
    return value == null
        || value instanceof String
        || value instanceof Boolean
        || value instanceof Integer
        || value instanceof Double
        || value instanceof BigInteger
        || value instanceof BigDecimal
        || value instanceof EObject
        || value instanceof Enumerator;
  }

  private static String text(Object value, String shown) {
    String text = hasText(value.getClass()) ? value.toString() : null;
    if (text == null) {
      throw new ServiceException(
          shown + "gives a " + value.getClass().getTypeName() + ", which has no text");
    }
    return text;
  }

  /**
   * Returns whether the objects of a class have a text of their own, not the default with a hash
   * code.
   */
  private static boolean hasText(Class<?> type) {
    try {
      return type.getMethod("toString").getDeclaringClass() != Object.class;
    } catch (NoSuchMethodException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Returns a value for a message. */
  public static String shown(Object value) {
    if (value == null) {
      return "null";
    } else if (value instanceof EObject object) {
      return Texts.label(object);
    } else if (value instanceof Collection<?>) {
      return "a collection";
    }
    return "'" + value + "'";
  }
}
