package dev.eventchain.llm.chat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * A request as JSON, in a fixed property order. This form is hashed, and (with texts as lines)
 * recorded.
 */
public final class RequestJson {
  private static final JsonNodeFactory JSON = JsonNodeFactory.instance;

  private RequestJson() {}

  public static ObjectNode of(ModelName model, ChatRequest request) {
    ObjectNode json = JSON.objectNode();
    json.put("provider", model.provider());
    json.put("model", model.name());
    ArrayNode messages = json.putArray("messages");
    for (ChatMessage message : request.messages()) {
      messages
          .addObject()
          .put("role", message.role().name().toLowerCase(Locale.ROOT))
          .put("content", message.content());
    }
    json.set("schema", request.schema().map(AnswerSchema::chosen).orElse(JSON.nullNode()));
    json.set("sampling", sampling(request.sampling()));
    return json;
  }

  private static ObjectNode sampling(Sampling sampling) {
    ObjectNode json = JSON.objectNode();
    sampling.temperature().ifPresent(value -> json.put("temperature", value));
    sampling.maximumTokens().ifPresent(value -> json.put("maximumTokens", value));
    sampling.seed().ifPresent(value -> json.put("seed", value));
    return json;
  }

  /** Returns the request with the text of each message as an array of lines, for review. */
  public static ObjectNode withLines(ObjectNode request) {
    ObjectNode copy = request.deepCopy();
    copy.withArray("messages")
        .forEach(
            message ->
                ((ObjectNode) message).set("content", lines(message.get("content").asText())));
    return copy;
  }

  /** Reverts {@link #withLines}. */
  public static ObjectNode withTexts(ObjectNode request) {
    ObjectNode copy = request.deepCopy();
    copy.withArray("messages")
        .forEach(message -> ((ObjectNode) message).put("content", text(message.get("content"))));
    return copy;
  }

  public static ArrayNode lines(String text) {
    ArrayNode lines = JSON.arrayNode();
    for (String line : text.split("\n", -1)) {
      lines.add(line);
    }
    return lines;
  }

  public static String text(JsonNode textOrLines) {
    if (textOrLines.isTextual()) {
      return textOrLines.asText();
    }
    List<String> lines = new ArrayList<>();
    textOrLines.forEach(line -> lines.add(line.asText()));
    return String.join("\n", lines);
  }

  /** Returns all lines of the conversation, for comparing two requests. */
  public static List<String> promptLines(ObjectNode request) {
    List<String> lines = new ArrayList<>();
    request
        .withArray("messages")
        .forEach(message -> lines.addAll(List.of(message.get("content").asText().split("\n", -1))));
    return lines;
  }
}
