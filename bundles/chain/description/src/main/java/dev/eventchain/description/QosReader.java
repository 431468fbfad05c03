package dev.eventchain.description;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.ModelChange;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.model.eventchain.Durability;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.History;
import dev.eventchain.model.eventchain.Liveliness;
import dev.eventchain.model.eventchain.QosProfile;
import dev.eventchain.model.eventchain.Reliability;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.eclipse.emf.common.util.Enumerator;

/**
 * Reader of quality of service: the name of a ROS 2 profile, a depth, a reliability, or an object
 * with the policies.
 */
public final class QosReader {

  private static final String DEFAULT = "default";

  /** Names for the profile {@code default} with that reliability. */
  static final List<String> RELIABILITIES = List.of("reliable", "best_effort");

  private static final List<String> NAMES =
      Stream.concat(QosSettings.names().stream(), RELIABILITIES.stream()).toList();

  private QosReader() {}

  /** Returns the profile of {@code qos_profile}; empty if it is missing or invalid. */
  public static Optional<QosProfile> read(ObjectReader port) {
    Optional<JsonNode> value = port.value(ChainNames.QOS_PROFILE);
    if (value.isEmpty()) {
      return Optional.empty();
    }
    if (value.get().isObject()) {
      return port.object(ChainNames.QOS_PROFILE).map(QosReader::policies);
    }
    if (value.get().isTextual() || value.get().isIntegralNumber()) {
      return named(value.get().asText(), port);
    }
    port.refuseType(ChainNames.QOS_PROFILE, "a profile's name, a depth or an object");
    return Optional.empty();
  }

  /** Returns a profile by its name as written in C++, Python or documentation. */
  private static Optional<QosProfile> named(String written, ObjectReader port) {
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
      port.find(
          Diagnostic.of(
                  DescriptionRules.QOS_UNKNOWN,
                  "There is no quality-of-service profile called '" + written + "'.",
                  port.at(ChainNames.QOS_PROFILE))
              .withHint(
                  "Use "
                      + String.join(", ", QosSettings.names())
                      + ", reliable, best_effort, a depth, or an object with the policies.")
              .withChanges(nearest(port, ChainNames.QOS_PROFILE, written, NAMES)));
      return Optional.empty();
    }
    return Optional.of(qos);
  }

  private static QosProfile policies(ObjectReader object) {
    QosProfile qos = EventchainFactory.eINSTANCE.createQosProfile();
    qos.setName(object.text(ChainNames.PROFILE).orElse(DEFAULT));
    if (QosSettings.named(qos.getName()).isEmpty()) {
      object.find(
          Diagnostic.of(
                  DescriptionRules.QOS_UNKNOWN,
                  "There is no quality-of-service profile called '" + qos.getName() + "'.",
                  object.at(ChainNames.PROFILE))
              .withChanges(
                  nearest(object, ChainNames.PROFILE, qos.getName(), QosSettings.names())));
    }
    policy(object, ChainNames.RELIABILITY, Reliability::getByName, Reliability.VALUES)
        .ifPresent(qos::setReliability);
    policy(object, ChainNames.DURABILITY, Durability::getByName, Durability.VALUES)
        .ifPresent(qos::setDurability);
    policy(object, ChainNames.HISTORY, History::getByName, History.VALUES)
        .ifPresent(qos::setHistory);
    policy(object, ChainNames.LIVELINESS, Liveliness::getByName, Liveliness.VALUES)
        .ifPresent(qos::setLiveliness);
    object
        .wholeNumber(ChainNames.DEPTH, NumberRange.of(0, Integer.MAX_VALUE))
        .ifPresent(depth -> qos.setDepth((int) depth));
    object.number(ChainNames.DEADLINE, NumberRange.atLeast(0)).ifPresent(qos::setDeadline);
    object
        .number(ChainNames.LEASE_DURATION, NumberRange.atLeast(0))
        .ifPresent(qos::setLeaseDuration);
    object.refuseOthers();
    return qos;
  }

  private static <E> Optional<E> policy(
      ObjectReader object,
      String name,
      Function<String, E> literal,
      List<? extends Enumerator> all) {
    Optional<String> value = object.text(name);
    Optional<E> found = value.map(v -> literal.apply(v.strip().toUpperCase(Locale.ROOT)));
    if (value.isPresent() && found.isEmpty()) {
      List<String> names = all.stream().map(Enumerator::getName).toList();
      object.find(
          Diagnostic.of(
                  DescriptionRules.QOS_UNKNOWN,
                  "There is no " + name + " '" + value.get() + "'.",
                  object.at(name))
              .withChanges(nearest(object, name, value.get(), names)));
    }
    return found;
  }

  /**
   * Returns the change of a text to the known one that it may be meant to be. It is no part of the
   * hint, which language models read in their answers' corrections.
   */
  private static List<ModelChange> nearest(
      ObjectReader object, String key, String written, Collection<String> known) {
    return NearestName.of(written, known).stream()
        .map(
            name ->
                new ModelChange(
                    "Change to '" + name + "'", object.at(key), "", key, written, name, true))
        .toList();
  }
}
