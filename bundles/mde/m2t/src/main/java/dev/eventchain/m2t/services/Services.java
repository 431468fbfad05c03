package dev.eventchain.m2t.services;

import dev.eventchain.diagnostics.Coverage;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Java methods that templates may call: the public ones of the classes that one class loader
 * defines itself. Classes of its parents, such as the Java library, cannot be called or
 * initialised, and methods inherited from them cannot be called.
 */
public final class Services {
  private final Optional<ClassLoader> loader;

  public Services(Optional<ClassLoader> loader) {
    this.loader = loader;
  }

  /** Returns whether there are any services. */
  public boolean exist() {
    return loader.isPresent();
  }

  /**
   * Calls a method.
   *
   * @param signature the signature {@code name(types)}; packages of the types are optional
   * @param arguments the arguments; null, as in Acceleo, for a static method without parameters
   * @param instances the instances of classes with non-static methods; created on demand
   * @return the result of the method as an OCL value
   * @throws ServiceException with the reason if there is no such method, it does not take these
   *     arguments, or it threw an exception
   */
  public Object call(
      String className,
      String signature,
      Collection<?> arguments,
      Map<Class<?>, Object> instances) {
    String shown = "the Java service '" + className + "." + signature + "' ";
    try {
      Class<?> type = find(className, shown);
      Method method = method(type, signature, shown);
      Object[] values = values(method, arguments, shown);
      Object target =
          Modifier.isStatic(method.getModifiers()) ? null : instance(type, instances, shown);
      return ServiceValues.toOcl(method.invoke(target, values), shown);
    } catch (ServiceException e) {
      throw e;
    } catch (InvocationTargetException e) {
      throw failed(className, shown, e.getCause());
    } catch (IllegalAccessException e) {
      throw new ServiceException(shown + "is not accessible: its class is not public", e);
    } catch (RuntimeException | LinkageError | StackOverflowError e) {
      // For example, a library of the class is missing, or the text of a value cannot be computed.
      throw failed(className, shown, e);
    }
  }

  private Class<?> find(String className, String shown) {
    boolean isName =
        className.chars().allMatch(each -> each == '.' || Character.isJavaIdentifierPart(each));
    boolean isForeign = false;
    try {
      // No class is initialised before its class loader is known.
      Class<?> type = isName ? Class.forName(className, false, loader.orElseThrow()) : null;
      if (type != null && type.getClassLoader() == loader.get()) {
        return type;
      }
      isForeign = type != null;
    } catch (ClassNotFoundException e) {
      // Treated like a class of another class loader.
    }
    throw new ServiceException(
        shown
            + (isForeign
                ? "is not a service: templates call the classes of their services only, not those"
                    + " of Java, EMF or this program"
                : "is missing: the services have no such class"));
  }

  private Method method(Class<?> type, String signature, String shown) {
    String bare = withoutGenerics(signature);
    int open = bare.indexOf('(');
    String name = open < 0 ? bare : bare.substring(0, open);
    String inside = open < 0 ? "" : bare.substring(open + 1).replaceFirst("\\)$", "");
    List<String> types = inside.isEmpty() ? List.of() : List.of(inside.split(",", -1));
    List<Method> named =
        Arrays.stream(type.getMethods())
            .filter(each -> each.getName().equals(name))
            .filter(each -> each.getDeclaringClass().getClassLoader() == loader.orElseThrow())
            .sorted(Comparator.comparing(Method::isBridge))
            .toList();
    Method found =
        named.stream()
            .filter(each -> takes(each, types))
            .findFirst()
            .orElseThrow(() -> new ServiceException(shown + "is absent: " + known(named)));
    if (found.isVarArgs()) {
      throw new ServiceException(
          shown
              + "takes any number of arguments, which templates cannot pass: make it take a List");
    }
    return found;
  }

  /**
   * Returns a signature without white space and type arguments; unchanged if its brackets do not
   * match.
   */
  private static String withoutGenerics(String signature) {
    StringBuilder bare = new StringBuilder();
    int depth = 0;
    for (int i = 0; i < signature.length(); i++) {
      char each = signature.charAt(i);
      if (each == '<') {
        depth++;
      } else if (each == '>') {
        depth--;
      } else if (depth == 0 && !Character.isWhitespace(each)) {
        bare.append(each);
      }
      if (depth < 0) {
        return signature;
      }
    }
    return depth == 0 ? bare.toString() : signature;
  }

  private static String known(List<Method> named) {
    if (named.isEmpty()) {
      return "its class has no such public method";
    }
    return "there is only "
        + named.stream()
            .map(
                each ->
                    each.getName()
                        + Arrays.stream(each.getParameterTypes())
                            .map(Class::getTypeName)
                            .collect(Collectors.joining(", ", "(", ")")))
            .sorted()
            .distinct()
            .collect(Collectors.joining(" or "));
  }

  private static boolean takes(Method method, List<String> types) {
    Class<?>[] parameters = method.getParameterTypes();
    if (parameters.length != types.size()) {
      return false;
    }
    for (int i = 0; i < parameters.length; i++) {
      String wanted = types.get(i).replaceFirst("\\.\\.\\.$", "[]");
      Class<?> parameter = parameters[i];
      if (!wanted.equals(parameter.getName())
          && !wanted.equals(parameter.getCanonicalName())
          && !wanted.equals(parameter.getSimpleName())) {
        return false;
      }
    }
    return true;
  }

  /** Returns the arguments if there are as many as the method takes. */
  private static List<Object> given(Method method, Collection<?> arguments, String shown) {
    int count = method.getParameterCount();
    boolean mayBeNull = count == 0 && Modifier.isStatic(method.getModifiers());
    if (arguments == null && !mayBeNull) {
      throw new ServiceException(
          shown + "is given null in place of its arguments: write Sequence{...}");
    }
    List<Object> given = arguments == null ? List.of() : new ArrayList<>(arguments);
    if (given.size() != count) {
      throw new ServiceException(
          shown
              + ("takes " + Coverage.counted(count, "argument"))
              + (" and is given " + given.size()));
    }
    return given;
  }

  private static Object[] values(Method method, Collection<?> arguments, String shown) {
    Class<?>[] parameters = method.getParameterTypes();
    List<Object> given = given(method, arguments, shown);
    Object[] values = new Object[parameters.length];
    for (int i = 0; i < values.length; i++) {
      Object argument = given.get(i);
      int position = i + 1;
      Class<?> parameter = parameters[i];
      values[i] =
          ServiceValues.toJava(argument, parameter)
              .orElseThrow(
                  () ->
                      new ServiceException(
                          shown
                              + "takes a "
                              + parameter.getTypeName()
                              + " as argument "
                              + position
                              + " and is given "
                              + ServiceValues.shown(argument)))
              .value();
    }
    return values;
  }

  private Object instance(Class<?> type, Map<Class<?>, Object> known, String shown)
      throws IllegalAccessException, InvocationTargetException {
    Object instance = known.get(type);
    if (instance == null) {
      try {
        instance = type.getConstructor().newInstance();
      } catch (NoSuchMethodException e) {
        throw new ServiceException(
            shown + "needs a class with a public constructor without parameters", e);
      } catch (InstantiationException e) {
        throw new ServiceException(
            shown + "needs an instance of its class, which is abstract: make the method static", e);
      }
      known.put(type, instance);
    }
    return instance;
  }

  private static ServiceException failed(String className, String shown, Throwable thrown) {
    boolean wraps = thrown instanceof ExceptionInInitializerError && thrown.getCause() != null;
    Throwable cause = wraps ? thrown.getCause() : thrown;
    String message = message(cause);
    if (cause instanceof UnsupportedClassVersionError) {
      return new ServiceException(
          shown + "is compiled for a newer Java than " + Runtime.version().feature(), cause);
    } else if (cause instanceof NoClassDefFoundError && !message.contains(" initialize ")) {
      String missing = message.replace('/', '.');
      return new ServiceException(
          shown + "needs the class '" + missing + "', which could not be loaded", cause);
    }
    return new ServiceException(
        shown
            + "threw "
            + cause.getClass().getName()
            + (message.isEmpty() ? "" : ": " + message)
            + line(className, cause),
        cause);
  }

  /** Returns the line of the service in the stack trace of an exception, if known. */
  private static String line(String className, Throwable cause) {
    return Arrays.stream(cause.getStackTrace())
        .filter(each -> each.getClassName().replaceFirst("\\$.*", "").equals(className))
        .filter(each -> each.getFileName() != null && each.getLineNumber() > 0)
        .map(each -> " (" + each.getFileName() + ":" + each.getLineNumber() + ")")
        .findFirst()
        .orElse("");
  }

  /** Returns the message of an exception, whose class may be foreign code. */
  private static String message(Throwable cause) {
    try {
      return Optional.ofNullable(cause.getMessage()).orElse("");
    } catch (RuntimeException | LinkageError | StackOverflowError e) {
      return "";
    }
  }
}
