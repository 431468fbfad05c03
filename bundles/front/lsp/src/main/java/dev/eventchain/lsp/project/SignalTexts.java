package dev.eventchain.lsp.project;

import dev.eventchain.model.Signal;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;

/** Descriptions of the topics of a project, in Markdown. */
final class SignalTexts {

  /** Most fields that a description lists. */
  private static final int MOST = 12;

  private SignalTexts() {}

  /** Returns the type of a topic, who sends it, and its fields. */
  static String about(Signal signal) {
    String fields =
        signal.fields().stream()
            .limit(MOST)
            .map(each -> "\n- `" + each.path() + "` " + typed(each))
            .collect(Collectors.joining());
    int more = signal.fields().size() - MOST;
    return "`"
        + signal.messageType()
        + "`, "
        + role(signal)
        + (fields.isEmpty() ? "" : "\n" + fields)
        + (more > 0 ? "\n- and " + more + " more" : "");
  }

  /** Returns the fields of a topic as formulas name them. */
  static Map<String, String> fields(Signal signal) {
    Map<String, String> found = new LinkedHashMap<>();
    for (Signal.Field each : signal.fields()) {
      String about = typed(each) + ", of `" + signal.messageType() + "`, " + role(signal);
      found.put(signal.topic() + "." + each.path(), about.strip());
    }
    return found;
  }

  /** Returns the fields of a topic by their paths, with their types and units. */
  static Map<String, String> fieldsOf(Signal signal) {
    Map<String, String> found = new LinkedHashMap<>();
    signal.fields().forEach(each -> found.put(each.path(), typed(each)));
    return found;
  }

  private static String typed(Signal.Field field) {
    return field.type() + (field.unit().isEmpty() ? "" : " in " + field.unit());
  }

  private static String role(Signal signal) {
    return switch (signal.direction()) {
      case PROVIDED -> "provided by the vehicle";
      case CONSUMED -> "taken by the vehicle";
      case INTERNAL -> "inside the software";
    };
  }
}
