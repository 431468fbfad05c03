package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.description.ChainNames;
import dev.eventchain.messages.QosSettings;
import java.time.Duration;
import java.util.Optional;

/**
 * Quality of service as the reader of sources writes it: a profile and the policies it changes,
 * under the names of chain descriptions.
 */
final class SourceQos {

  private SourceQos() {}

  /** Returns the settings; empty if there is no such profile or policy. */
  static Optional<QosSettings> read(JsonNode json) {
    try {
      return QosSettings.named(json.path(ChainNames.PROFILE).asText("default"))
          .map(settings -> changed(settings, json));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  private static QosSettings changed(QosSettings profile, JsonNode json) {
    QosSettings settings = profile;
    if (json.has(ChainNames.RELIABILITY)) {
      settings =
          settings.withReliability(
              policy(QosSettings.Reliability.class, json, ChainNames.RELIABILITY));
    }
    if (json.has(ChainNames.DURABILITY)) {
      settings =
          settings.withDurability(
              policy(QosSettings.Durability.class, json, ChainNames.DURABILITY));
    }
    if (json.has(ChainNames.HISTORY)) {
      settings = settings.withHistory(policy(QosSettings.History.class, json, ChainNames.HISTORY));
    }
    if (json.has(ChainNames.LIVELINESS)) {
      settings =
          settings.withLiveliness(
              policy(QosSettings.Liveliness.class, json, ChainNames.LIVELINESS));
    }
    if (json.has(ChainNames.DEPTH)) {
      settings = settings.withDepth(json.path(ChainNames.DEPTH).asInt());
    }
    if (json.has(ChainNames.DEADLINE)) {
      settings = settings.withDeadline(time(json, ChainNames.DEADLINE));
    }
    return json.has(ChainNames.LEASE_DURATION)
        ? settings.withLease(time(json, ChainNames.LEASE_DURATION))
        : settings;
  }

  private static <E extends Enum<E>> E policy(Class<E> type, JsonNode json, String name) {
    return Enum.valueOf(type, json.path(name).asText());
  }

  private static Duration time(JsonNode json, String name) {
    return Duration.ofNanos(Math.round(json.path(name).asDouble() * 1e6));
  }
}
