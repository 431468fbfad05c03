package dev.eventchain.simulation.run;

import dev.eventchain.messages.MessageValue;
import java.lang.reflect.Array;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;

/** Published values of a scenario: the range of each field that components write. */
public final class OutputRecord {

  /** A large odd number, which spreads the hashes of single values over 64 bits. */
  private static final long PRIME = 0x9E3779B97F4A7C15L;

  private final Map<String, List<String>> fields;
  private final Map<String, Values> values = new TreeMap<>();
  private long digest;

  /**
   * Values of a field. Its numbers are those of a single value or of all elements of an array;
   * Booleans count as 0 and 1.
   */
  public static final class Values {

    private Object first;
    private boolean changed;
    private boolean infinite;
    private double least = Double.POSITIVE_INFINITY;
    private double most = Double.NEGATIVE_INFINITY;

    private void add(Object value) {
      if (first == null) {
        first = value;
      }
      changed |= !Objects.deepEquals(first, value);
      if (value.getClass().isArray()) {
        for (int i = 0; i < Array.getLength(value); i++) {
          addNumber(Array.get(value, i));
        }
      } else {
        addNumber(value);
      }
    }

    private void addNumber(Object value) {
      double number =
          value instanceof Boolean truth
              ? (truth ? 1.0 : 0.0)
              : value instanceof Number some ? some.doubleValue() : Double.NaN;
      if (Double.isFinite(number)) {
        least = Math.min(least, number);
        most = Math.max(most, number);
      } else {
        infinite = true;
      }
    }

    /** Returns whether there was more than one value. */
    public boolean changed() {
      return changed;
    }

    /** Returns whether there were finite numbers. */
    public boolean hasNumbers() {
      return least <= most;
    }

    /** Returns whether the field always had this number. */
    public boolean isAlways(double number) {
      return !infinite && least == number && most == number;
    }

    /** Returns the smallest finite number; infinite if there was none. */
    public double least() {
      return least;
    }

    /** Returns the largest finite number; infinite if there was none. */
    public double most() {
      return most;
    }
  }

  /**
   * Creates an empty record.
   *
   * @param fields the paths of the recorded fields, by topic
   */
  public OutputRecord(Map<String, List<String>> fields) {
    this.fields = fields;
  }

  /** Returns whether messages of a topic are recorded. */
  boolean reads(String topic) {
    return fields.containsKey(topic);
  }

  /** Adds a message. */
  public void add(String topic, MessageValue message) {
    for (String path : fields.getOrDefault(topic, List.of())) {
      Object value = message.get(path);
      values.computeIfAbsent(key(topic, path), key -> new Values()).add(value);
      digest = PRIME * digest + Arrays.deepHashCode(new Object[] {topic, path, value});
    }
  }

  /** Returns a hash of all values in their order: equal for runs with the same outputs. */
  public long digest() {
    return digest;
  }

  /** Returns the values of a field; without numbers and changes if it was never published. */
  public Values of(String topic, String path) {
    return values.getOrDefault(key(topic, path), new Values());
  }

  /** Returns whether a field was published. */
  public boolean has(String topic, String path) {
    return values.containsKey(key(topic, path));
  }

  private static String key(String topic, String path) {
    return topic + " " + path;
  }
}
