package dev.eventchain.project;

import dev.eventchain.messages.FieldConstants;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType.Constant;
import dev.eventchain.model.Signal;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The names of values with which formulas compare the fields of a project's signals. */
public final class ValueNames {

  private final List<Signal> signals;
  private final MessageCatalog messages;

  private ValueNames(List<Signal> signals, MessageCatalog messages) {
    this.signals = signals;
    this.messages = messages;
  }

  /** Reads the signals and messages of a project. */
  public static ValueNames of(ProjectFolder project) {
    return new ValueNames(
        project.readSoftwareBase().signals().orElse(List.of()), project.readMessages());
  }

  /** Returns the names of a field, each once: those of a catalogue, or constants of its message. */
  public List<String> of(String topic, String path) {
    Optional<Signal> signal = signals.stream().filter(it -> it.topic().equals(topic)).findFirst();
    List<String> stated =
        signal
            .flatMap(it -> it.field(path))
            .map(Signal.Field::values)
            .map(
                it ->
                    Stream.concat(
                            it.texts().stream(), it.names().stream().map(Signal.NamedNumber::name))
                        .distinct()
                        .toList())
            .orElse(List.of());
    return stated.isEmpty() ? signal.map(it -> constants(it, path)).orElse(List.of()) : stated;
  }

  private List<String> constants(Signal signal, String path) {
    return messages
        .find(signal.messageType())
        .map(
            it -> FieldConstants.of(it, path, field -> signal.field(field).map(Signal.Field::unit)))
        .orElse(List.of())
        .stream()
        .map(ValueNames::name)
        .toList();
  }

  private static String name(Constant constant) {
    return constant.type().kind() == FieldType.Kind.STRING
        ? constant.value().toString()
        : constant.name();
  }
}
