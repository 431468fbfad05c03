package dev.eventchain.project;

import dev.eventchain.description.DescriptionRules;
import dev.eventchain.description.QosReader;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.QosProfile;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/** Reader of {@code signals.json}, the paper's form with a direction. */
final class SignalReader {

  private static final List<String> DIRECTIONS = List.of("provided", "consumed", "internal");

  private final Document text;
  private final List<Diagnostic> findings;
  private final Set<String> topics = new HashSet<>();

  SignalReader(Document text, List<Diagnostic> findings) {
    this.text = text;
    this.findings = findings;
  }

  /** Returns the signals in the order of the file; invalid content is a finding. */
  List<Signal> read() {
    List<Signal> signals = new ArrayList<>();
    text.objects(findings::add).forEach(json -> signals.add(readSignal(json)));
    return signals;
  }

  private Signal readSignal(ObjectReader json) {
    String topic = legal(json, "Topic Name", SignalReader::isTopic, DescriptionRules.TOPIC_ILLEGAL);
    if (!topic.isEmpty() && !topics.add(RosNames.resolve(topic, ""))) {
      json.find(
          DescriptionRules.NAME_DUPLICATE,
          "There is already a signal '" + topic + "'.",
          json.at("Topic Name"));
    }
    String type =
        legal(json, "Message Type", RosNames::isMessageType, DescriptionRules.TYPE_ILLEGAL);
    Optional<QosProfile> qos = QosReader.read(json);
    Signal.Direction direction = direction(json);
    List<Signal.Field> fields = new ArrayList<>();
    json.objects("Message Definition").forEach(field -> fields.add(readField(field)));
    json.refuseOthers();
    return new Signal(topic, type, direction, qos, fields, json.location());
  }

  /** Returns whether a topic name is valid. Signals belong to no node, so private names are not. */
  private static boolean isTopic(String name) {
    return RosNames.isTopic(name) && !RosNames.isPrivate(name);
  }

  private Signal.Direction direction(ObjectReader json) {
    String direction = json.text("direction").orElse("internal");
    if (!DIRECTIONS.contains(direction)) {
      findings.add(
          Diagnostic.of(
                  ProjectRules.MODELER_SIGNAL_DIRECTION,
                  "'" + direction + "' is not a direction.",
                  json.at("direction"))
              .withHint(NearestName.hint(direction, DIRECTIONS)));
    }
    return switch (direction) {
      case "provided" -> Signal.Direction.PROVIDED;
      case "consumed" -> Signal.Direction.CONSUMED;
      default -> Signal.Direction.INTERNAL;
    };
  }

  private Signal.Field readField(ObjectReader json) {
    String path = legal(json, "Field", RosNames::isFieldPath, DescriptionRules.FIELD_ILLEGAL);
    String type = json.requiredText("Type");
    json.text("Description");
    String unit = json.text("Unit").orElse("");
    json.refuseOthers();
    return new Signal.Field(path, type, unit, json.location());
  }

  private static String legal(
      ObjectReader json, String property, Predicate<String> legal, Rule rule) {
    String value = json.requiredText(property);
    if (!value.isBlank() && !legal.test(value)) {
      json.find(rule, "'" + value + "' is not a legal " + property + ".", json.at(property));
    }
    return value;
  }
}
