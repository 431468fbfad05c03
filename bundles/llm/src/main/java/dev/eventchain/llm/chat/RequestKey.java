package dev.eventchain.llm.chat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.TextNode;
import dev.eventchain.diagnostics.Sha256;
import java.math.BigDecimal;
import java.util.Map;

/**
 * The identity of a request: SHA-256 of its canonical JSON, which holds provider, model, messages,
 * schema and sampling, but no settings without effect on the answer (address, key, time limit).
 *
 * @param value 64 lower-case hexadecimal digits
 */
public record RequestKey(String value) {
  private static final int SHORT = 12;

  /** Returns the key of a request in the form of {@link RequestJson}. */
  public static RequestKey of(JsonNode request) {
    StringBuilder canonical = new StringBuilder();
    append(canonical, request);
    return new RequestKey(Sha256.of(canonical.toString()).hex());
  }

  /** Returns the part of the key for file names. */
  public String abbreviated() {
    return value.substring(0, SHORT);
  }

  // Property order is kept: inside a schema it affects the answer, elsewhere RequestJson fixes it.
  private static void append(StringBuilder out, JsonNode node) {
    if (node.isObject()) {
      out.append('{');
      String separator = "";
      for (Map.Entry<String, JsonNode> property : node.properties()) {
        out.append(separator).append(TextNode.valueOf(property.getKey())).append(':');
        append(out, property.getValue());
        separator = ",";
      }
      out.append('}');
    } else if (node.isArray()) {
      out.append('[');
      String separator = "";
      for (JsonNode item : node) {
        out.append(separator);
        append(out, item);
        separator = ",";
      }
      out.append(']');
    } else if (node.isNumber()) {
      // 1, 1.0 and 1e0 are equal numbers.
      out.append(new BigDecimal(node.asText()).stripTrailingZeros());
    } else {
      out.append(node);
    }
  }
}
