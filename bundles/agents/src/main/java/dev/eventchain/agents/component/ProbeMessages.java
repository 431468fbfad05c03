package dev.eventchain.agents.component;

import dev.eventchain.agents.prompt.MessageText;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.RosNames;
import dev.eventchain.sandbox.ComponentCall;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;

/** Messages to probe an input with, or the elements of one that is an array. */
final class ProbeMessages {
  /** The most values that a number is probed with. */
  private static final int MOST = 10;

  private final Supplier<MessageCatalog> catalog;

  /** Creates probes with the message types of a project, which are asked for only if needed. */
  ProbeMessages(Supplier<MessageCatalog> catalog) {
    this.catalog = catalog;
  }

  /**
   * Returns messages, the usual one first, then those whose fields are all at one of their limits.
   *
   * @param type a type as message definitions write it
   * @return none if it is no known message
   */
  List<ProbeValue> of(String type) {
    return find(type)
        .map(
            message ->
                IntStream.range(0, MOST)
                    .mapToObj(
                        edge ->
                            new ProbeValue(
                                edge == 0 ? "a usual message" : "a message at edge " + edge,
                                message(message, edge)))
                    .toList())
        .orElse(List.of());
  }

  private Optional<MessageType> find(String type) {
    return MessageText.isMessage(type)
        ? catalog.get().find(RosNames.fullMessageType(type))
        : Optional.empty();
  }

  private static ComponentCall.Message message(MessageType type, int edge) {
    Map<String, Object> fields = new LinkedHashMap<>();
    type.fields().forEach(field -> fields.put(field.name(), value(field.type(), edge)));
    return new ComponentCall.Message(type.name(), fields);
  }

  private static Object value(FieldType type, int edge) {
    Optional<MessageType> message = type.message();
    if (message.isPresent()) {
      return type.shape() == FieldType.Shape.SINGLE ? message(message.get(), edge) : List.of();
    }
    List<ProbeValue> values = ProbeValue.of(type.toString());
    return values.get(Math.min(edge, values.size() - 1)).value();
  }
}
