package dev.eventchain.m2t;

import java.lang.reflect.Array;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EObject;

/** Values of OCL as arguments of Java methods, and what these give as values of OCL. */
final class ServiceValues {
  private ServiceValues() {}

  /** An argument, which may be null. */
  record Argument(Object value) {}

  /** The argument for a parameter of a type; empty if the type cannot take the value. */
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

  /** What a method gave, with numbers, characters and arrays as OCL has them. */
  static Object toOcl(Object value) {
    if (value instanceof Short || value instanceof Byte) {
      return ((Number) value).intValue();
    } else if (value instanceof Float number) {
      return number.doubleValue();
    } else if (value instanceof Character) {
      return value.toString();
    } else if (value instanceof Collection<?> elements) {
      List<Object> copy = new ArrayList<>();
      elements.forEach(each -> copy.add(toOcl(each)));
      return copy;
    } else if (value != null && value.getClass().isArray()) {
      List<Object> copy = new ArrayList<>();
      for (int i = 0; i < Array.getLength(value); i++) {
        copy.add(toOcl(Array.get(value, i)));
      }
      return copy;
    }
    return value;
  }

  /** A value for a message. */
  static String shown(Object value) {
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
