package dev.eventchain.modeler;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.metamodel.eventchain.Durability;
import dev.eventchain.metamodel.eventchain.EventchainFactory;
import dev.eventchain.metamodel.eventchain.History;
import dev.eventchain.metamodel.eventchain.Liveliness;
import dev.eventchain.metamodel.eventchain.QosProfile;
import dev.eventchain.metamodel.eventchain.Reliability;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * Reads quality of service: the name of a ROS 2 profile, a depth, a reliability, or an object with
 * the policies.
 */
final class QosReader {

  private static final String DEFAULT = "default";

  private final JsonText text;
  private final Consumer<Diagnostic> findings;

  QosReader(JsonText text, Consumer<Diagnostic> findings) {
    this.text = text;
    this.findings = findings;
  }

  /** The profile of {@code qos_profile}; nothing where it is missing or not understood. */
  Optional<QosProfile> read(JsonObjectReader port) {
    Optional<JsonNode> value = port.value("qos_profile");
    if (value.isEmpty()) {
      return Optional.empty();
    }
    if (value.get().isObject()) {
      return JsonObjectReader.at(text, port.pointerTo("qos_profile"), findings).map(this::policies);
    }
    if (value.get().isTextual() || value.get().isIntegralNumber()) {
      return named(value.get().asText(), port.at("qos_profile"));
    }
    port.find(
        "modeler.value.type",
        "'qos_profile' must be a profile's name, a depth or an object, not "
            + JsonObjectReader.kind(value.get())
            + ".",
        port.at("qos_profile"));
    return Optional.empty();
  }

  /** Accepts the ways in which C++, Python and documentation write the same profiles. */
  private Optional<QosProfile> named(String written, SourceLocation location) {
    QosProfile qos = EventchainFactory.eINSTANCE.createQosProfile();
    String name =
        written.strip().toLowerCase(Locale.ROOT).replaceFirst("^(rmw_)?(qos_profile_)", "");
    qos.setName(DEFAULT);
    if (QosSettings.named(name).isPresent()) {
      qos.setName(name);
    } else if (name.matches("[1-9][0-9]{0,4}")) {
      qos.setDepth(Integer.parseInt(name));
    } else if (name.equals("reliable")) {
      qos.setReliability(Reliability.RELIABLE);
    } else if (name.equals("best_effort")) {
      qos.setReliability(Reliability.BEST_EFFORT);
    } else {
      findings.accept(
          Diagnostic.error(
                  "modeler.qos.unknown",
                  "There is no profile of quality of service called '" + written + "'.",
                  location)
              .withHint(
                  "Use "
                      + String.join(", ", QosSettings.names())
                      + ", reliable, best_effort, a depth, or an object with the policies."));
      return Optional.empty();
    }
    return Optional.of(qos);
  }

  private QosProfile policies(JsonObjectReader object) {
    QosProfile qos = EventchainFactory.eINSTANCE.createQosProfile();
    qos.setName(object.text("profile").orElse(DEFAULT));
    if (QosSettings.named(qos.getName()).isEmpty()) {
      object.find(
          "modeler.qos.unknown",
          "There is no profile of quality of service called '" + qos.getName() + "'.",
          object.at("profile"));
    }
    policy(object, "reliability", Reliability::getByName).ifPresent(qos::setReliability);
    policy(object, "durability", Durability::getByName).ifPresent(qos::setDurability);
    policy(object, "history", History::getByName).ifPresent(qos::setHistory);
    policy(object, "liveliness", Liveliness::getByName).ifPresent(qos::setLiveliness);
    object.number("depth").ifPresent(depth -> setDepth(qos, depth, object));
    object.number("deadline").ifPresent(qos::setDeadline);
    object.refuseOthers();
    return qos;
  }

  private static void setDepth(QosProfile qos, double depth, JsonObjectReader object) {
    if (depth == (int) depth) {
      qos.setDepth((int) depth);
    } else {
      object.find(
          "modeler.value.range", "'depth' must be a whole number of samples.", object.at("depth"));
    }
  }

  private static <E> Optional<E> policy(
      JsonObjectReader object, String name, Function<String, E> literal) {
    Optional<String> value = object.text(name);
    Optional<E> found = value.map(v -> literal.apply(v.strip().toUpperCase(Locale.ROOT)));
    if (value.isPresent() && found.isEmpty()) {
      object.find(
          "modeler.qos.unknown",
          "There is no " + name + " '" + value.get() + "'.",
          object.at(name));
    }
    return found;
  }
}
