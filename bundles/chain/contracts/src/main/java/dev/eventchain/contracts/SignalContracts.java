package dev.eventchain.contracts;

import dev.eventchain.messages.RosNames;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Checks that the chain uses the vehicle's topics as described. */
final class SignalContracts {

  private static final Pattern STAMP = Pattern.compile("(^|\\.)header\\.stamp(\\.|$)");

  private final TypeContracts types;
  private final Findings findings;

  SignalContracts(TypeContracts types, Findings findings) {
    this.types = types;
    this.findings = findings;
  }

  void check(Topic topic) {
    topic.signal().ifPresent(signal -> check(topic, signal));
  }

  private void check(Topic topic, Signal signal) {
    for (Endpoint publisher : topic.publishers()) {
      findings.checked(ContractRule.SIGNAL_DIRECTION);
      if (signal.direction() == Signal.Direction.PROVIDED) {
        findings.error(
            ContractRule.SIGNAL_DIRECTION,
            findings.at(publisher.first(), Literals.DATA__TOPIC_NAME),
            "%s writes %s, which the vehicle provides.".formatted(publisher.name(), topic.name()),
            "Write another topic, unless the direction of the signal is wrong.",
            signal.location());
      }
    }
    if (!signal.fields().isEmpty()) {
      topic.endpoints().forEach(endpoint -> fields(endpoint, signal));
    }
  }

  /** Checks for fields that exist but are not described; the vehicle may not set or read them. */
  private void fields(Endpoint endpoint, Signal signal) {
    for (Data data : endpoint.data()) {
      if (types.fieldType(data).isEmpty()) {
        continue;
      }
      findings.checked(ContractRule.SIGNAL_FIELD);
      String path = data.getFieldName();
      boolean described =
          signal.fields().stream()
              .map(Signal.Field::path)
              .anyMatch(known -> RosNames.overlap(known, path));
      if (!described) {
        findings.warning(
            ContractRule.SIGNAL_FIELD,
            findings.at(data, Literals.DATA__FIELD_NAME),
            "%s uses the field '%s' of %s, which the description of the signal does not name."
                .formatted(endpoint.name(), path, signal.topic()),
            hint(path, signal),
            signal.location());
      }
    }
  }

  /** Returns what to do: a stamp says when a message was made, which no other field can say. */
  private static String hint(String path, Signal signal) {
    String described =
        signal.fields().stream().map(Signal.Field::path).collect(Collectors.joining(", "));
    return STAMP.matcher(path).find()
        ? "Describe it in the signal if the vehicle sets the stamp, as the simulated one does."
            + " The described fields are %s.".formatted(described)
        : "The described fields are %s. Use one of them.".formatted(described);
  }
}
