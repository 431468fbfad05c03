package dev.eventchain.simulation.bench;

import dev.eventchain.messages.FieldConstants;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.model.Signal.Values;
import dev.eventchain.simulation.formula.NamedValues;
import java.util.List;
import java.util.Optional;

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
    return names.isEmpty() ? constants(type, path) : NamedValues.ofNumbers(names);
  }

  private NamedValues constants(String type, String path) {
    Optional<MessageType> message = catalog.find(type);
    List<MessageType.Constant> found =
        message.map(it -> FieldConstants.of(it, path)).orElse(List.of());
    boolean isText = found.stream().anyMatch(it -> it.type().kind() == FieldType.Kind.STRING);
    return isText
        ? NamedValues.ofTexts(found.stream().map(it -> it.value().toString()).toList())
        : NamedValues.ofNumbers(
            found.stream()
                .map(it -> new NamedValues.Value(it.name(), ((Number) it.value()).doubleValue()))
                .toList());
  }
}
