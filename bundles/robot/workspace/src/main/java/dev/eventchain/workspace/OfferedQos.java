package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.QosSettings.Durability;
import dev.eventchain.messages.QosSettings.Reliability;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Quality of service as rosbag2 keeps it: a list of profiles in YAML, one for each publisher, with
 * policies by their numbers in rmw, or by name since Jazzy. History is not compared between ends,
 * and often unknown there.
 */
final class OfferedQos {

  private static final List<String> RELIABILITIES =
      List.of("SYSTEM_DEFAULT", "RELIABLE", "BEST_EFFORT");
  private static final List<String> DURABILITIES =
      List.of("SYSTEM_DEFAULT", "TRANSIENT_LOCAL", "VOLATILE");

  /** Seconds from which on a time is what rmw calls infinite. */
  private static final long INFINITE = Integer.MAX_VALUE;

  private OfferedQos() {}

  /** Returns the first profile of a text in YAML; empty if it has none that is known. */
  static Optional<QosSettings> read(String yaml) {
    if (yaml.isBlank()) {
      return Optional.empty();
    }
    try {
      DocumentRules rules = DocumentRules.all(WorkspaceRules.RECORDING);
      return read(
          Document.parse(SourceText.of("qos", yaml), DocumentFormat.YAML, rules, found -> {})
              .root());
    } catch (DiagnosticException e) {
      return Optional.empty();
    }
  }

  /** Returns the first profile of a list. */
  static Optional<QosSettings> read(JsonNode profiles) {
    JsonNode first = profiles.path(0);
    Optional<Reliability> reliability =
        policy(first.path("reliability"), RELIABILITIES).map(Reliability::valueOf);
    Optional<Durability> durability =
        policy(first.path("durability"), DURABILITIES).map(Durability::valueOf);
    if (reliability.isEmpty() || durability.isEmpty()) {
      return Optional.empty();
    }
    QosSettings settings =
        QosSettings.defaults().withReliability(reliability.get()).withDurability(durability.get());
    JsonNode deadline = first.path("deadline");
    long seconds = deadline.path("sec").asLong();
    long all = seconds * 1_000_000_000L + deadline.path("nsec").asLong();
    boolean isTime = seconds >= 0 && seconds < INFINITE && all > 0;
    return Optional.of(isTime ? settings.withDeadline(Duration.ofNanos(all)) : settings);
  }

  private static Optional<String> policy(JsonNode value, List<String> names) {
    String text = value.asText().toUpperCase(Locale.ROOT);
    return value.isIntegralNumber() && value.asInt() >= 0 && value.asInt() < names.size()
        ? Optional.of(names.get(value.asInt()))
        : names.stream().filter(text::equals).findFirst();
  }
}
