package dev.eventchain.m2t;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.WeakHashMap;
import java.util.stream.Collectors;

/**
 * The Java methods that templates may call: the public ones of the classes that one class loader
 * has itself. What its parents have, such as the Java library, cannot be called.
 */
final class Services {
  /** How the reasons of all failures start. */
  static final String REASON = "the Java service ";

  private final Optional<ClassLoader> loader;

  /** The instances of services whose methods are not static: one of a class in each run. */
  private final Map<GenerationRun, Map<Class<?>, Object>> instances = new WeakHashMap<>();

  Services(Optional<ClassLoader> loader) {
    this.loader = loader;
  }

  /** Whether anything can be called at all. */
  boolean exist() {
    return loader.isPresent();
  }

  /**
   * Calls a method.
   *
   * @param signature {@code name(types)}, the types with or without their packages
   * @return what the method gave, as a value of OCL
   * @throws IllegalArgumentException with the reason if there is no such method, it does not take
   *     these arguments, or it threw an exception
   */
  Object call(String className, String signature, Collection<?> arguments, GenerationRun run) {
    String shown = REASON + "'" + className + "." + signature + "' ";
    Class<?> type = find(className, shown);
    Method method = method(type, signature, shown);
    Object[] values = values(method, arguments, shown);
    try {
      Object target = Modifier.isStatic(method.getModifiers()) ? null : instance(type, run, shown);
      return ServiceValues.toOcl(method.invoke(target, values));
    } catch (InvocationTargetException e) {
      throw failed(shown, e.getCause());
    } catch (IllegalAccessException e) {
      throw new IllegalArgumentException(shown + "is not accessible: its class is not public", e);
    }
  }

  private Class<?> find(String className, String shown) {
    try {
      Class<?> type = Class.forName(className, true, loader.orElseThrow());
      if (type.getClassLoader() == loader.get()) {
        return type;
      }
    } catch (ClassNotFoundException e) {
      // The same as a class that belongs to somebody else.
    } catch (LinkageError e) {
      throw failed(shown, e);
    }
    throw new IllegalArgumentException(shown + "is absent: the services have no such class");
  }

  private static Method method(Class<?> type, String signature, String shown) {
    String bare = signature.replaceAll("<[^()]*>", "").replaceAll("\\s", "");
    int open = bare.indexOf('(');
    String name = open < 0 ? bare : bare.substring(0, open);
    String inside = open < 0 ? "" : bare.substring(open + 1).replaceFirst("\\)$", "");
    List<String> types = inside.isEmpty() ? List.of() : List.of(inside.split(",", -1));
    List<Method> named =
        Arrays.stream(type.getMethods()).filter(each -> each.getName().equals(name)).toList();
    return named.stream()
        .filter(each -> !each.isBridge() && takes(each, types))
        .findFirst()
        .orElseThrow(
            () -> new IllegalArgumentException(shown + "is absent: " + known(type, named)));
  }

  private static String known(Class<?> type, List<Method> named) {
    if (named.isEmpty()) {
      return "its class has no such public method";
    }
    return "there is only "
        + named.stream()
            .map(
                each ->
                    each.getName()
                        + Arrays.stream(each.getParameterTypes())
                            .map(Class::getName)
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
      String wanted = types.get(i);
      Class<?> parameter = parameters[i];
      if (!wanted.equals(parameter.getName())
          && !wanted.equals(parameter.getCanonicalName())
          && !wanted.equals(parameter.getSimpleName())) {
        return false;
      }
    }
    return true;
  }

  private static Object[] values(Method method, Collection<?> arguments, String shown) {
    Class<?>[] parameters = method.getParameterTypes();
    if (arguments.size() != parameters.length) {
      throw new IllegalArgumentException(
          shown + "takes " + parameters.length + " arguments and is given " + arguments.size());
    }
    List<Object> given = new ArrayList<>(arguments);
    Object[] values = new Object[parameters.length];
    for (int i = 0; i < values.length; i++) {
      Object argument = given.get(i);
      int position = i + 1;
      Class<?> parameter = parameters[i];
      values[i] =
          ServiceValues.toJava(argument, parameter)
              .orElseThrow(
                  () ->
                      new IllegalArgumentException(
                          shown
                              + "takes a "
                              + parameter.getName()
                              + " as argument "
                              + position
                              + " and is given "
                              + ServiceValues.shown(argument)))
              .value();
    }
    return values;
  }

  private Object instance(Class<?> type, GenerationRun run, String shown)
      throws IllegalAccessException, InvocationTargetException {
    synchronized (instances) {
      Map<Class<?>, Object> known = instances.computeIfAbsent(run, each -> new HashMap<>());
      Object instance = known.get(type);
      if (instance == null) {
        try {
          instance = type.getConstructor().newInstance();
        } catch (NoSuchMethodException | InstantiationException e) {
          throw new IllegalArgumentException(
              shown + "needs a class with a public constructor without parameters", e);
        }
        known.put(type, instance);
      }
      return instance;
    }
  }

  private static IllegalArgumentException failed(String shown, Throwable cause) {
    String message = cause.getMessage() == null ? "" : ": " + cause.getMessage();
    return new IllegalArgumentException(
        shown + "threw " + cause.getClass().getName() + message, cause);
  }
}
