package dev.eventchain.lsp.text;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.MissingNode;
import com.fasterxml.jackson.databind.node.TextNode;

/** Reader of JSON, and of values for which the protocol has no type. */
public final class ProtocolJson {

  private static final JsonMapper MAPPER = new JsonMapper();

  private ProtocolJson() {}

  /**
   * Reads a text.
   *
   * @throws JsonProcessingException if it is not JSON
   */
  public static JsonNode read(String text) throws JsonProcessingException {
    return MAPPER.readTree(text);
  }

  /**
   * Returns a value that an editor has sent; a missing node for none. The protocol's library hands
   * on trees of its own reader, whose text is JSON.
   */
  public static JsonNode of(Object sent) {
    if (sent == null) {
      return MissingNode.getInstance();
    }
    if (sent instanceof String text) {
      return new TextNode(text);
    }
    try {
      return read(sent.toString());
    } catch (JsonProcessingException e) {
      throw new IllegalArgumentException(e);
    }
  }
}
