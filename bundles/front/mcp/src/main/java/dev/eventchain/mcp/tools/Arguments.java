package dev.eventchain.mcp.tools;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.mcp.project.McpRules;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The arguments of a call, after they were checked. */
final class Arguments {

  private final Map<String, Object> values;

  private Arguments(Map<String, Object> values) {
    this.values = values;
  }

  /**
   * Checks the arguments of a call.
   *
   * @throws DiagnosticException if they are not as the parameters say
   */
  static Arguments of(Map<String, Object> given, List<Parameter> parameters) {
    Map<String, Object> values = given == null ? Map.of() : given;
    List<String> names = parameters.stream().map(Parameter::name).toList();
    for (String name : values.keySet()) {
      if (!names.contains(name)) {
        String near =
            NearestName.of(name, names)
                .map(it -> "Did you mean '" + it + "'?")
                .orElse("It takes: " + String.join(", ", names) + ".");
        throw wrong("The tool has no argument '" + name + "'.", near);
      }
    }
    for (Parameter parameter : parameters) {
      Object value = values.get(parameter.name());
      if (value == null && parameter.required()) {
        throw wrong("The argument '" + parameter.name() + "' is missing.", expected(parameter));
      }
      if (value != null && !parameter.accepts(value)) {
        throw wrong(
            "The argument '" + parameter.name() + "' has a wrong value.", expected(parameter));
      }
    }
    return new Arguments(values);
  }

  private static String expected(Parameter parameter) {
    return "It is " + parameter.expected() + ".";
  }

  /** Returns a finding about arguments. */
  static DiagnosticException wrong(String message, String hint) {
    return McpRules.refusal(McpRules.ARGUMENT, "", message, hint);
  }

  Optional<String> text(String name) {
    return Optional.ofNullable((String) values.get(name));
  }

  String text(String name, String otherwise) {
    return text(name).orElse(otherwise);
  }

  Optional<Double> number(String name) {
    return Optional.ofNullable((Number) values.get(name)).map(Number::doubleValue);
  }

  Optional<Integer> whole(String name) {
    return Optional.ofNullable((Integer) values.get(name));
  }

  boolean flag(String name) {
    return Boolean.TRUE.equals(values.get(name));
  }

  /** Returns a list of texts. */
  List<String> texts(String name) {
    return list(name).stream().map(String.class::cast).toList();
  }

  /** Returns a list of objects or texts. */
  List<?> list(String name) {
    return values.get(name) instanceof List<?> list ? list : List.of();
  }
}
