package dev.eventchain.agents.component;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DecimalNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.agents.prompt.MessageText;
import dev.eventchain.sandbox.ComponentCall;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Syntax of input values in tests. A number may be one of the texts {@code inf}, {@code -inf} and
 * {@code nan}, with or without the dot of YAML; {@code {from: A, step: B}} is A in the first call
 * of a step and B more in each that follows; {@code {count: N, of: V, at: {I: W}}} is an array of N
 * times V with W at index I. A message is an object with its fields.
 */
final class TestValues {
  private static final int LONGEST = 1_000_000;

  private TestValues() {}

  /**
   * Returns the value in a call.
   *
   * @param type the field type in the syntax of message definitions
   * @throws Unfit if the text is not a value of the type
   */
  static Object of(JsonNode written, String type) throws Unfit {
    int bracket = type.indexOf('[');
    return bracket < 0
        ? scalar(written, type)
        : packed(elements(written, type.substring(0, bracket)), type.substring(0, bracket));
  }

  /** Returns whether values of a type are single numbers. */
  static boolean isNumber(String type) {
    return type.indexOf('[') < 0
        && !MessageText.isMessage(type)
        && !Set.of("bool", "boolean", "string").contains(type);
  }

  /**
   * Requires a type of single numbers.
   *
   * @throws Unfit if it is another one
   */
  static void requireNumber(String type) throws Unfit {
    if (!isNumber(type)) {
      throw new Unfit(
          type.indexOf('[') >= 0
              ? "an array"
              : type.equals("string") ? "a string" : "true or false");
    }
  }

  /**
   * Requires a value of a type, without the forms that only inputs have.
   *
   * @throws Unfit if the text is not such a value
   */
  static void requireConstant(JsonNode written, String type) throws Unfit {
    if (isNumber(type) && literal(written).isEmpty()) {
      throw new Unfit("a number");
    }
    of(written, type);
  }

  /** Returns an array of the form {@code {count, of, at}} with all its elements. */
  static JsonNode expanded(JsonNode written) {
    int count = written.path("count").asInt(-1);
    if (count < 0 || count > LONGEST || !written.has("of") || !hasIndicesBelow(written, count)) {
      return written;
    }
    ArrayNode elements = JsonNodeFactory.instance.arrayNode(count);
    for (int i = 0; i < count; i++) {
      JsonNode here = written.path("at").path(Integer.toString(i));
      elements.add(here.isMissingNode() ? written.get("of") : here);
    }
    return elements;
  }

  /** Returns the value in a call of a step, with values per call resolved. */
  static JsonNode inCall(JsonNode written, int call) {
    if (written.isArray()) {
      ArrayNode elements = JsonNodeFactory.instance.arrayNode();
      written.forEach(element -> elements.add(inCall(element, call)));
      return elements;
    }
    if (!written.isObject()) {
      return written;
    }
    if (written.size() == 2 && isFinite(written.path("from")) && isFinite(written.path("step"))) {
      BigDecimal moved = decimal(written.get("step")).multiply(BigDecimal.valueOf(call));
      return DecimalNode.valueOf(decimal(written.get("from")).add(moved));
    }
    ObjectNode array = JsonNodeFactory.instance.objectNode();
    written.properties().forEach(e -> array.set(e.getKey(), inCall(e.getValue(), call)));
    return array;
  }

  private static boolean isFinite(JsonNode number) {
    return number.isNumber() && Double.isFinite(number.asDouble());
  }

  /** Returns a number with the digits of a double: sums of exact numbers may have millions. */
  private static BigDecimal decimal(JsonNode number) {
    return BigDecimal.valueOf(number.asDouble());
  }

  /** An invalid value in a test. */
  static final class Unfit extends Exception {
    private static final long serialVersionUID = 1;

    Unfit(String wanted) {
      super(wanted);
    }
  }

  private static Object scalar(JsonNode written, String type) throws Unfit {
    if (MessageText.isMessage(type)) {
      return message(written, type);
    }
    return switch (type) {
      case "bool", "boolean" -> required(written.isBoolean(), written.asBoolean(), "true or false");
      case "string" -> required(written.isTextual(), written.asText(), "a string");
      case "float32", "float64", "float", "double" -> number(written);
      default -> wholeNumber(written);
    };
  }

  private static Object message(JsonNode written, String type) throws Unfit {
    if (!written.isObject() || written.isEmpty()) {
      throw new Unfit("an object with the fields of " + type);
    }
    Map<String, Object> fields = new LinkedHashMap<>();
    for (var field : written.properties()) {
      fields.put(field.getKey(), ofField(field.getValue(), type));
    }
    return new ComponentCall.Message(type, fields);
  }

  /** Returns the value of a field of a message, whose type the text shows. */
  private static Object ofField(JsonNode written, String type) throws Unfit {
    if (written.isArray()) {
      List<Object> elements = new ArrayList<>();
      for (JsonNode element : written) {
        elements.add(ofField(element, type));
      }
      return elements;
    }
    if (written.isObject()) {
      return message(written, type);
    }
    if (written.isIntegralNumber()) {
      return wholeNumber(written);
    }
    Optional<Double> number = literal(written);
    return number.isPresent()
        ? number.get()
        : written.isBoolean() ? (Object) written.asBoolean() : written.asText();
  }

  private static Object required(boolean fits, Object value, String wanted) throws Unfit {
    if (!fits) {
      throw new Unfit(wanted);
    }
    return value;
  }

  private static long wholeNumber(JsonNode written) throws Unfit {
    double number = number(written);
    if (number != Math.rint(number) || Math.abs(number) > 1L << 53) {
      throw new Unfit("a whole number");
    }
    return (long) number;
  }

  private static double number(JsonNode written) throws Unfit {
    return literal(written)
        .orElseThrow(() -> new Unfit("a number, 'inf', '-inf', 'nan' or {from, step}"));
  }

  /** Returns the value of a literal number. */
  static Optional<Double> literal(JsonNode written) {
    if (written.isNumber()) {
      return Optional.of(written.asDouble());
    }
    return switch (written.isTextual() ? written.asText().replaceFirst("^(-?)\\.", "$1") : "") {
      case "inf" -> Optional.of(Double.POSITIVE_INFINITY);
      case "-inf" -> Optional.of(Double.NEGATIVE_INFINITY);
      case "nan" -> Optional.of(Double.NaN);
      default -> Optional.empty();
    };
  }

  private static List<Object> elements(JsonNode written, String type) throws Unfit {
    List<Object> elements = new ArrayList<>();
    if (written.isArray()) {
      for (JsonNode element : written) {
        elements.add(scalar(element, type));
      }
      return elements;
    }
    int count = written.path("count").asInt(-1);
    if (!written.isObject() || count < 0 || count > LONGEST || !written.has("of")) {
      throw new Unfit("an array, or {count, of, at}");
    }
    Object usual = scalar(written.path("of"), type);
    for (int i = 0; i < count; i++) {
      JsonNode here = written.path("at").path(Integer.toString(i));
      elements.add(here.isMissingNode() ? usual : scalar(here, type));
    }
    if (!hasIndicesBelow(written, count)) {
      throw new Unfit("an array whose 'at' names indices below its 'count'");
    }
    return elements;
  }

  private static boolean hasIndicesBelow(JsonNode written, int count) {
    for (var names = written.path("at").fieldNames(); names.hasNext(); ) {
      String index = names.next();
      if (!index.matches("\\d{1,7}") || Integer.parseInt(index) >= count) {
        return false;
      }
    }
    return true;
  }

  /** Returns the elements as fields of messages hold them. */
  private static Object packed(List<Object> elements, String type) {
    return switch (type) {
      case "uint8", "byte", "octet", "char" -> bytes(elements);
      case "float32", "float" -> floats(elements);
      case "float64", "double" ->
          elements.stream().mapToDouble(each -> ((Number) each).doubleValue()).toArray();
      default -> elements;
    };
  }

  private static byte[] bytes(List<Object> elements) {
    byte[] bytes = new byte[elements.size()];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = ((Number) elements.get(i)).byteValue();
    }
    return bytes;
  }

  private static float[] floats(List<Object> elements) {
    float[] floats = new float[elements.size()];
    for (int i = 0; i < floats.length; i++) {
      floats[i] = ((Number) elements.get(i)).floatValue();
    }
    return floats;
  }
}
