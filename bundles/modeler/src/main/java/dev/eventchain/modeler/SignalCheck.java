package dev.eventchain.modeler;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;

/** Whether {@code signals.json} is as it should be: the paper's form, and a direction. */
final class SignalCheck {

  private static final List<String> DIRECTIONS = List.of("provided", "consumed", "internal");

  private final JsonText text;
  private final List<Diagnostic> findings;
  private final Set<String> topics = new HashSet<>();

  SignalCheck(JsonText text, List<Diagnostic> findings) {
    this.text = text;
    this.findings = findings;
  }

  void check() {
    if (!text.root().isArray()) {
      findings.add(
          Diagnostic.error(
              "modeler.value.type",
              "The file must hold an array, not " + JsonObjectReader.kind(text.root()) + ".",
              text.at("")));
      return;
    }
    for (int i = 0; i < text.root().size(); i++) {
      JsonObjectReader.at(text, "/" + i, findings::add).ifPresent(this::checkSignal);
    }
  }

  private void checkSignal(JsonObjectReader json) {
    String topic = legal(json, "Topic Name", Names::isTopic, "modeler.topic.illegal");
    if (!topic.isEmpty() && !topics.add(topic)) {
      json.find(
          "modeler.name.duplicate",
          "There is a signal '" + topic + "' already.",
          json.at("Topic Name"));
    }
    legal(json, "Message Type", Names::isMessageType, "modeler.type.illegal");
    new QosReader(text, findings::add).read(json);
    json.text("direction").ifPresent(direction -> checkDirection(json, direction));
    for (String pointer : json.elements("Message Definition")) {
      JsonObjectReader.at(text, pointer, findings::add).ifPresent(this::checkField);
    }
    json.refuseOthers();
  }

  private void checkDirection(JsonObjectReader json, String direction) {
    if (!DIRECTIONS.contains(direction)) {
      findings.add(
          Diagnostic.error(
                  "modeler.signal.direction",
                  "'" + direction + "' is no direction.",
                  json.at("direction"))
              .withHint(NearestName.hint(direction, DIRECTIONS)));
    }
  }

  private void checkField(JsonObjectReader json) {
    legal(json, "Field", Names::isFieldPath, "modeler.field.illegal");
    json.requiredText("Type");
    json.text("Description");
    json.text("Unit");
    json.refuseOthers();
  }

  private static String legal(
      JsonObjectReader json, String property, Predicate<String> legal, String id) {
    String value = json.requiredText(property);
    if (!value.isBlank() && !legal.test(value)) {
      json.find(id, "'" + value + "' is no legal " + property + ".", json.at(property));
    }
    return value;
  }
}
