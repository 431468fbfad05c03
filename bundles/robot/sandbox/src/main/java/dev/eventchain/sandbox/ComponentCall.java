package dev.eventchain.sandbox;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * One call of {@code execute}.
 *
 * @param name name of the call in findings, such as {@code stopped vehicle ahead}
 * @param arguments the inputs by name: {@link Boolean}, {@link Number}, {@link String}, lists and
 *     string-keyed maps of these; {@code byte[]}, {@code int[]}, {@code float[]} and {@code
 *     double[]} become the arrays that fields of ROS messages hold, and {@link Message} an object
 *     whose fields are attributes
 */
public record ComponentCall(String name, Map<String, Object> arguments) {

  /**
   * A message inside of an argument.
   *
   * @param type its type
   * @param fields the values of its fields, as arguments are
   */
  public record Message(String type, Map<String, Object> fields) {

    /** Copies the fields. */
    public Message {
      fields = Collections.unmodifiableMap(new LinkedHashMap<>(fields));
    }
  }

  /** Copies the arguments. */
  public ComponentCall {
    arguments = Collections.unmodifiableMap(new LinkedHashMap<>(arguments));
  }
}
