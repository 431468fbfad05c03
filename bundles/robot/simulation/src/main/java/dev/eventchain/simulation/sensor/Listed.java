package dev.eventchain.simulation.sensor;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A field that is filled for each object of a list: a sequence or an array of values ({@code
 * distance}), or a field of each message in one ({@code objects[].pose.position.x}).
 *
 * @param list the sequence or array
 * @param inner the field of its messages; empty if it holds the values themselves
 */
public record Listed(String list, String inner) {

  private static final String EACH = "[].";

  /** Returns the field that a path of a bench means. */
  public static Listed of(String path) {
    int each = path.indexOf(EACH);
    return each < 0
        ? new Listed(path, "")
        : new Listed(path.substring(0, each), path.substring(each + EACH.length()));
  }

  /** Returns whether it is a field of messages. */
  public boolean ofMessages() {
    return !inner.isEmpty();
  }

  /** Returns the type of the messages in the list; empty if it holds none. */
  public Optional<MessageType> messages(MessageType type) {
    return type.resolve(list)
        .type()
        .filter(it -> it.shape() != FieldType.Shape.SINGLE)
        .flatMap(FieldType::message);
  }

  /** Returns how many objects the list can hold. */
  int capacity(MessageType type) {
    int size = type.resolve(list).type().orElseThrow().size();
    return size == 0 ? Integer.MAX_VALUE : size;
  }

  private boolean isArray(MessageType type) {
    return type.resolve(list).type().orElseThrow().shape() == FieldType.Shape.ARRAY;
  }

  /** Makes room for a number of objects, all with the default values. */
  void make(MessageValue message, int count) {
    MessageType element = messages(message.type()).orElseThrow();
    int size = isArray(message.type()) ? capacity(message.type()) : count;
    List<MessageValue> elements = new ArrayList<>();
    for (int i = 0; i < size; i++) {
      elements.add(MessageValue.of(element));
    }
    message.set(list, elements);
  }

  /**
   * Writes a value for each object; what follows in an array is 0 or empty.
   *
   * @param values at most as many as the list can hold
   */
  void write(MessageValue message, List<Object> values) {
    if (ofMessages()) {
      List<?> elements = (List<?>) message.get(list);
      for (int i = 0; i < values.size(); i++) {
        ((MessageValue) elements.get(i)).set(inner, values.get(i));
      }
      return;
    }
    List<Object> all = new ArrayList<>(values);
    boolean texts =
        message.type().resolve(list).type().orElseThrow().kind() == FieldType.Kind.STRING;
    while (isArray(message.type()) && all.size() < capacity(message.type())) {
      all.add(texts ? "" : (Object) 0);
    }
    message.set(list, all);
  }
}
