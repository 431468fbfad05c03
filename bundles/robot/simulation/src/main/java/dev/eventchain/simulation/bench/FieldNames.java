package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.messages.FieldConstants;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.model.Signal.Values;
import dev.eventchain.simulation.formula.NamedValues;
import dev.eventchain.simulation.sensor.Listed;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;

/**
 * The names of the values of fields: those of the catalogue or, if it has none, constants of the
 * message with the type of the field. Constants that begin with the name of a field are those of
 * this field only, as {@code POWER_SUPPLY_STATUS_FULL} is of {@code power_supply_status}.
 */
final class FieldNames {

  private final DeclaredSignals declared;
  private final MessageCatalog catalog;

  FieldNames(DeclaredSignals declared, MessageCatalog catalog) {
    this.declared = declared;
    this.catalog = catalog;
  }

  /** Returns the names of a field of a topic; none if nobody states any. */
  NamedValues of(String topic, String type, String path) {
    return of(declared, topic, () -> catalog.find(type), path);
  }

  /**
   * Returns the names of a field likewise.
   *
   * @param message the type of the topic's messages, if known; asked for if there is no catalogue
   */
  static NamedValues of(
      DeclaredSignals declared,
      String topic,
      Supplier<Optional<MessageType>> message,
      String path) {
    Values values =
        declared
            .find(topic)
            .flatMap(signal -> signal.field(path))
            .map(dev.eventchain.model.Signal.Field::values)
            .orElse(Values.ANY);
    if (!values.texts().isEmpty()) {
      return NamedValues.ofTexts(values.texts());
    }
    List<NamedValues.Value> names =
        values.names().stream().map(it -> new NamedValues.Value(it.name(), it.number())).toList();
    return names.isEmpty()
        ? constants(message.get(), path, it -> unit(declared, topic, it))
        : NamedValues.ofNumbers(names);
  }

  /** Returns the unit that is stated for a field, if it is described. */
  private static Optional<String> unit(DeclaredSignals declared, String topic, String path) {
    return declared
        .find(topic)
        .flatMap(signal -> signal.field(path))
        .map(dev.eventchain.model.Signal.Field::unit);
  }

  /** Returns the names of a field of the messages in a list: constants of these, of any unit. */
  static NamedValues ofListed(Optional<MessageType> message, String path) {
    Listed listed = Listed.of(path);
    return constants(message.flatMap(listed::messages), listed.inner(), field -> Optional.empty());
  }

  /** Returns a value that is the name of one number as that number, and others as they are. */
  static Object numbered(Object value, NamedValues names) {
    if (names.isText()) {
      return value;
    }
    List<Double> numbers =
        names.values().stream()
            .filter(it -> it.name().equals(value))
            .map(NamedValues.Value::number)
            .distinct()
            .toList();
    if (numbers.size() != 1) {
      return value;
    }
    double number = numbers.get(0);
    boolean isWhole = number == Math.rint(number) && Math.abs(number) < 1L << 53;
    return isWhole ? (Object) (long) number : (Object) number;
  }

  /** Adds a hint to a finding about a value that is no name, or that of several numbers. */
  static Diagnostic hinted(Diagnostic finding, Object value, NamedValues names) {
    if (!(value instanceof String text) || names.isEmpty()) {
      return finding;
    }
    return finding.withHint(
        names.names().contains(text)
            ? "Several numbers have this name: write one of them."
            : NearestName.hint(text, names.names()));
  }

  /** Returns the constants of a message that name values of a field. */
  private static NamedValues constants(
      Optional<MessageType> message, String path, Function<String, Optional<String>> units) {
    List<MessageType.Constant> found =
        message.map(it -> FieldConstants.of(it, path, units)).orElse(List.of());
    boolean isText = found.stream().anyMatch(it -> it.type().kind() == FieldType.Kind.STRING);
    return isText
        ? NamedValues.ofTexts(found.stream().map(it -> it.value().toString()).toList())
        : NamedValues.ofNumbers(
            found.stream()
                .map(it -> new NamedValues.Value(it.name(), ((Number) it.value()).doubleValue()))
                .toList());
  }
}
