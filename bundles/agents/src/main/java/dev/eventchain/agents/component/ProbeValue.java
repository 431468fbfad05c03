package dev.eventchain.agents.component;

import dev.eventchain.agents.chain.ChainView;
import dev.eventchain.agents.prompt.MessageText;
import dev.eventchain.messages.UnitConversion;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.LongSummaryStatistics;
import java.util.stream.Stream;

/**
 * A value to probe an input with.
 *
 * @param name name of the value in findings
 * @param value a Boolean, a number, a text, or an array as in messages
 */
record ProbeValue(String name, Object value) {
  private static final int ARRAY_LENGTH = 8;
  private static final int LONGEST = 100_000;

  /**
   * Returns values of an input, the usual one first. Those of a converted input are what its field
   * can hold, in the unit of the component.
   *
   * @param limits further values that the field can hold
   * @param messages the values of messages
   */
  static List<ProbeValue> of(ChainView.Value input, List<Object> limits, ProbeMessages messages) {
    if (MessageText.isMessage(input.fieldType())) {
      return ofMessages(input.fieldType(), messages);
    }
    List<ProbeValue> probes = new ArrayList<>(of(input.fieldType()));
    all(limits.toArray()).stream()
        .filter(limit -> probes.stream().noneMatch(limit::isSame))
        .forEach(probes::add);
    if (input.converted().isEmpty()) {
      return probes;
    }
    UnitConversion conversion = input.converted().get().conversion();
    return probes.stream()
        .map(
            probe ->
                probe.value() instanceof Number number
                    ? all(conversion.apply(number.doubleValue())).get(0)
                    : probe)
        .toList();
  }

  /**
   * Returns values of a field type in the syntax of message definitions, the usual one first; an
   * unknown type counts as a number.
   */
  static List<ProbeValue> of(String type) {
    int bracket = type.indexOf('[');
    if (bracket < 0) {
      return scalars(type);
    }
    String element = type.substring(0, bracket);
    String length = type.substring(bracket + 1).replace("]", "");
    boolean fixed = length.matches("[1-9][0-9]{0,8}");
    int count = fixed ? Math.min(Integer.parseInt(length), LONGEST) : ARRAY_LENGTH;
    List<ProbeValue> arrays = new ArrayList<>();
    for (ProbeValue value : scalars(element)) {
      arrays.add(array(element, value, count, count + " times " + value.name()));
    }
    if (!fixed) {
      ProbeValue usual = scalars(element).get(0);
      arrays.add(array(element, usual, 0, "empty"));
      arrays.add(array(element, usual, 1, "a single " + usual.name()));
    }
    return arrays;
  }

  /** Returns messages, or arrays of some or none of them; of unknown ones, empty arrays only. */
  private static List<ProbeValue> ofMessages(String type, ProbeMessages messages) {
    int bracket = type.indexOf('[');
    List<ProbeValue> single = messages.of(bracket < 0 ? type : type.substring(0, bracket));
    if (bracket < 0) {
      return single.isEmpty() ? of(type) : single;
    }
    String length = type.substring(bracket + 1).replace("]", "");
    boolean fixed = length.matches("[1-9][0-9]{0,3}");
    int count = fixed ? Integer.parseInt(length) : ARRAY_LENGTH;
    List<ProbeValue> arrays = new ArrayList<>();
    for (ProbeValue each : single) {
      arrays.add(
          new ProbeValue(
              count + " times " + each.name(), Collections.nCopies(count, each.value())));
    }
    if (!fixed || single.isEmpty()) {
      arrays.add(new ProbeValue("empty", List.of()));
    }
    return arrays;
  }

  private boolean isSame(ProbeValue other) {
    return (value instanceof Number number && other.value instanceof Number another)
        ? number.doubleValue() == another.doubleValue()
        : value.equals(other.value);
  }

  /** Returns whether an integer type has a number. */
  static boolean isInteger(long number, String type) {
    LongSummaryStatistics range =
        scalars(type).stream()
            .mapToLong(probe -> ((Number) probe.value()).longValue())
            .summaryStatistics();
    return range.getMin() <= number && number <= range.getMax();
  }

  private static List<ProbeValue> scalars(String type) {
    return switch (type) {
      case "bool", "boolean" -> all(true, false);
      case "string" -> all("x", "");
      case "uint8", "byte", "octet", "char" -> all(1, 0, 255);
      case "int8" -> all(1, 0, -1, 127, -128);
      case "uint16" -> all(1, 0, 65_535);
      case "int16" -> all(1, 0, -1, 32_767, -32_768);
      case "uint32" -> all(1, 0, 4_294_967_295L);
      case "int32" -> all(1, 0, -1, Integer.MAX_VALUE, Integer.MIN_VALUE);
      case "uint64" -> all(1, 0, Long.MAX_VALUE);
      case "int64" -> all(1, 0, -1, Long.MAX_VALUE, Long.MIN_VALUE);
      case "double", "float64" -> numbers(Double.MAX_VALUE);
      default -> numbers(1.0e38);
    };
  }

  /**
   * Returns numbers whose arithmetic may overflow: twice the largest is infinite, and infinity
   * minus infinity is NaN.
   */
  private static List<ProbeValue> numbers(double largest) {
    return all(
        1.0,
        0.0,
        -1.0,
        1.0e-9,
        1.0e6,
        largest,
        -largest,
        Double.NaN,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY);
  }

  private static List<ProbeValue> all(Object... values) {
    return Stream.of(values).map(value -> new ProbeValue(text(value), value)).toList();
  }

  private static String text(Object value) {
    return value instanceof String text ? "'" + text + "'" : value.toString();
  }

  private static ProbeValue array(String element, ProbeValue value, int count, String name) {
    return new ProbeValue(
        name,
        switch (element) {
          case "uint8", "byte", "octet", "char" -> bytes(value, count);
          case "float32" -> floats(value, count);
          case "float64" -> doubles(value, count);
          default -> Collections.nCopies(count, value.value());
        });
  }

  private static byte[] bytes(ProbeValue value, int count) {
    byte[] bytes = new byte[count];
    Arrays.fill(bytes, ((Number) value.value()).byteValue());
    return bytes;
  }

  private static float[] floats(ProbeValue value, int count) {
    float[] floats = new float[count];
    Arrays.fill(floats, ((Number) value.value()).floatValue());
    return floats;
  }

  private static double[] doubles(ProbeValue value, int count) {
    double[] doubles = new double[count];
    Arrays.fill(doubles, ((Number) value.value()).doubleValue());
    return doubles;
  }
}
