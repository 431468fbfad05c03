package dev.eventchain.simulation.export;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** An element of an XML file in the making. */
final class Markup {

  private static final int DECIMALS = 6;

  private final String name;
  private final Map<String, String> attributes = new LinkedHashMap<>();
  private final List<Markup> children = new ArrayList<>();

  Markup(String name) {
    this.name = name;
  }

  /** Adds an attribute. */
  Markup with(String attribute, String value) {
    attributes.put(attribute, value);
    return this;
  }

  /** Adds an attribute with a number, to a millionth. */
  Markup with(String attribute, double value) {
    return with(attribute, number(value));
  }

  /** Adds children. */
  Markup add(Markup... others) {
    children.addAll(List.of(others));
    return this;
  }

  /** Adds children. */
  Markup add(List<Markup> others) {
    children.addAll(others);
    return this;
  }

  /** Returns a number to a millionth, without an exponent. */
  static String number(double value) {
    BigDecimal rounded = BigDecimal.valueOf(value).setScale(DECIMALS, RoundingMode.HALF_EVEN);
    return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
  }

  /** Returns a whole file. */
  byte[] file() {
    StringBuilder text = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    write(text, "");
    return text.toString().getBytes(StandardCharsets.UTF_8);
  }

  private void write(StringBuilder text, String indent) {
    text.append(indent).append('<').append(name);
    attributes.forEach(
        (key, value) ->
            text.append(' ').append(key).append("=\"").append(escaped(value)).append('"'));
    if (children.isEmpty()) {
      text.append("/>\n");
      return;
    }
    text.append(">\n");
    children.forEach(child -> child.write(text, indent + "  "));
    text.append(indent).append("</").append(name).append(">\n");
  }

  private static String escaped(String value) {
    return value
        .replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;")
        .replace("\t", "&#9;")
        .replace("\n", "&#10;")
        .replace("\r", "&#13;");
  }
}
