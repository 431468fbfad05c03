package dev.eventchain.workspace;

import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.QosSettings.Durability;
import dev.eventchain.messages.QosSettings.History;
import dev.eventchain.messages.QosSettings.Liveliness;
import dev.eventchain.messages.QosSettings.Reliability;
import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalLong;

/** Quality of service as NoDL has it: policies that are spelt out, and times in ns. */
final class NodlQos {

  private static final NumberRange TIMES = NumberRange.of(0, Long.MAX_VALUE);
  private static final NumberRange DEPTHS = NumberRange.of(1, Integer.MAX_VALUE);

  private NodlQos() {}

  /** Returns the settings; what is wrong is a finding of the reader. */
  static Optional<QosSettings> read(ObjectReader json) {
    Optional<History> history = policy(json, "history", History.class, true);
    Optional<Reliability> reliability = policy(json, "reliability", Reliability.class, true);
    Optional<Durability> durability = policy(json, "durability", Durability.class, false);
    boolean isOpen = json.text("liveliness").filter("SYSTEM_DEFAULT"::equals).isPresent();
    Optional<Liveliness> liveliness =
        isOpen ? Optional.empty() : policy(json, "liveliness", Liveliness.class, false);
    OptionalLong depth =
        history.filter(History.KEEP_LAST::equals).isPresent()
            ? OptionalLong.of(json.requiredWholeNumber("depth", DEPTHS))
            : json.wholeNumber("depth", DEPTHS);
    Optional<Duration> deadline = time(json, "deadline_ns");
    Optional<Duration> lease = time(json, "liveliness_lease_duration_ns");
    json.wholeNumber("lifespan_ns", TIMES);
    json.refuseOthers();
    if (history.isEmpty() || reliability.isEmpty()) {
      return Optional.empty();
    }
    QosSettings settings =
        QosSettings.defaults()
            .withHistory(history.get())
            .withReliability(reliability.get())
            .withDepth((int) depth.orElse(0));
    settings = durability.map(settings::withDurability).orElse(settings);
    settings = liveliness.map(settings::withLiveliness).orElse(settings);
    settings = deadline.map(settings::withDeadline).orElse(settings);
    return Optional.of(lease.map(settings::withLease).orElse(settings));
  }

  /** Returns a question about what a chain cannot say; empty if it can say all. */
  static Optional<String> withoutCounterpart(ObjectReader json) {
    if (time(json, "lifespan_ns").isPresent()) {
      return Optional.of("It has a lifespan, which a chain does not have. Does it matter?");
    }
    return json.text("liveliness")
        .filter("SYSTEM_DEFAULT"::equals)
        .map(policy -> "Which liveliness is the system's default? AUTOMATIC is taken.");
  }

  private static Optional<Duration> time(ObjectReader json, String name) {
    OptionalLong nanoseconds = json.wholeNumber(name, TIMES);
    return nanoseconds.isPresent() && nanoseconds.getAsLong() > 0
        ? Optional.of(Duration.ofNanos(nanoseconds.getAsLong()))
        : Optional.empty();
  }

  private static <E extends Enum<E>> Optional<E> policy(
      ObjectReader json, String name, Class<E> type, boolean isRequired) {
    Optional<String> written = isRequired ? Optional.of(json.requiredText(name)) : json.text(name);
    Optional<E> found =
        written.flatMap(
            text ->
                Arrays.stream(type.getEnumConstants())
                    .filter(each -> each.name().equals(text))
                    .findFirst());
    if (written.filter(text -> !text.isBlank()).isPresent() && found.isEmpty()) {
      json.find(
          WorkspaceRules.NODL, "There is no " + name + " '" + written.get() + "'.", json.at(name));
    }
    return found;
  }
}
