package dev.eventchain.llm.chat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.TextNode;
import dev.eventchain.diagnostics.Sha256;
import java.math.BigDecimal;
import java.util.Map;

/**
 * The identity of a request: SHA-256 of its canonical JSON, which holds provider, model, messages,
 * schema and sampling, and nothing that may change without changing the answer (address, key, time
 * limit).
 *
 * @param value 64 lower-case hexadecimal digits
 */
public record RequestKey(String value) {
  private static final int SHORT = 12;

  /** The key of a request in the form that {@link RequestJson} gives. */
  public static RequestKey of(JsonNode request) {
    StringBuilder canonical = new StringBuilder();
    append(canonical, request);
    return new RequestKey(Sha256.of(canonical.toString()).hex());
  }

  /** The part of the key that is in file names. */
  public String abbreviated() {
    return value.substring(0, SHORT);
  }

  // Property order is kept: inside a schema it steers what a model writes, elsewhere RequestJson
  // fixes it.
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
      // 1, 1.0 and 1e0 are one number.
      out.append(new BigDecimal(node.asText()).stripTrailingZeros());
    } else {
      out.append(node);
    }
  }
}
