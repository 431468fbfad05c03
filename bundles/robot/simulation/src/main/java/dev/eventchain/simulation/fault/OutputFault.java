package dev.eventchain.simulation.fault;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.zip.CRC32;

/**
 * A standard fault of an output, from the start of a scenario to its end. Such faults measure
 * whether the criteria of a scenario notice a component that does not work; those of a user's file
 * are {@link Fault}s.
 *
 * @param node the component whose messages it changes
 * @param topic the full name of the topic
 * @param type the full message type
 * @param field the path of the changed field; empty for a fault of whole messages
 * @param change the kind of change
 * @param amount ms, a number of messages, a value, a factor or a shift; 0 if the kind has none
 * @param unit the unit of a value or shift; may be empty
 * @param range the range of the field's type
 */
public record OutputFault(
    String node,
    String topic,
    String type,
    String field,
    Change change,
    double amount,
    String unit,
    Range range) {

  /** Kinds of changes. */
  public enum Change {
    /** The first content is repeated. */
    FIRST,
    /** No message is sent. */
    DROPPED,
    /** Messages arrive later. */
    DELAYED,
    /** Only every n-th message has new content. */
    HELD,
    /** The field has one value. */
    STUCK,
    /** A Boolean is negated. */
    NEGATED,
    /** A number has the other sign. */
    INVERTED,
    /** A number is multiplied. */
    SCALED,
    /** A constant is added to a number. */
    SHIFTED,
    /** A random number is added, between the amount and its negative. */
    NOISY
  }

  /** Range of a type, inclusive. */
  public record Range(double least, double most) {}

  /** Returns whether a component with this fault does nothing, or always the same. */
  public boolean isOmission() {
    return field.isEmpty() && (change == Change.FIRST || change == Change.DROPPED);
  }

  /** Returns the part of the configuration for the process of the nodes. */
  public ObjectNode toJson(long scenarioSeed) {
    ObjectNode json = JsonNodeFactory.instance.objectNode().put("kind", "output");
    json.put("target", node).put("topic", topic).put("type", type).put("field", field);
    json.put("change", change.name().toLowerCase(Locale.ROOT)).put("amount", amount);
    ArrayNode limits = json.putArray("range");
    limits.add(range.least()).add(range.most());
    return json.put("seed", seed(scenarioSeed));
  }

  /** Returns the seed of the noise, which depends only on the scenario's seed and the fault. */
  private long seed(long scenarioSeed) {
    CRC32 digest = new CRC32();
    digest.update(words().getBytes(StandardCharsets.UTF_8));
    return scenarioSeed ^ (digest.getValue() << 20);
  }

  /** Returns a description for users, such as {@code /brake.data of Brake scaled by 0.5}. */
  public String words() {
    String output = field.isEmpty() ? topic : topic + "." + field;
    return output + " of " + node + " " + happens();
  }

  private String happens() {
    return switch (change) {
      case FIRST -> "stuck at its first value";
      case DROPPED -> "never sent";
      case DELAYED -> "delayed by " + number(amount) + " ms";
      case HELD -> "renewed by every " + number(amount) + "th message only";
      case STUCK -> "stuck at " + number(amount) + ofUnit();
      case NEGATED -> "negated";
      case INVERTED -> "with the other sign";
      case SCALED -> "scaled by " + number(amount);
      case SHIFTED -> "shifted by " + number(amount) + ofUnit();
      case NOISY -> "with noise of " + number(amount) + ofUnit();
    };
  }

  private String ofUnit() {
    return unit.isEmpty() || unit.equals("1") ? "" : " " + unit;
  }

  private static String number(double value) {
    return Double.isFinite(value)
        ? new BigDecimal(value).round(new MathContext(4)).stripTrailingZeros().toPlainString()
        : String.format(Locale.ROOT, "%f", value);
  }
}
