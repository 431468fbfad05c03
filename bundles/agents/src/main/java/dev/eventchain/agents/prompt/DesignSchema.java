package dev.eventchain.agents.prompt;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.description.EventChainSchema;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.jsonmodels.JsonDocument;
import dev.eventchain.llm.chat.AnswerSchema;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.Signal;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.project.Requirements;
import dev.eventchain.project.SoftwareBase;
import java.util.Iterator;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/** The schema of a designed chain, and the conversion of such answers to the array of the paper. */
public final class DesignSchema {

  private DesignSchema() {}

  /**
   * Returns the schema.
   *
   * @param base the existing software; the types that it uses are allowed even if undefined, which
   *     the checks report
   */
  public static AnswerSchema of(
      Requirements requirements, SoftwareBase base, MessageCatalog messages) {
    List<String> ids = requirements.items().stream().map(WrittenRequirement::id).toList();
    Set<String> types = new TreeSet<>(messages.names());
    Stream.concat(
            base.messageTypes().stream(),
            base.signals().orElse(List.of()).stream().map(Signal::messageType))
        .filter(RosNames::isMessageType)
        .map(RosNames::fullMessageType)
        .forEach(types::add);
    EventChainSchema schema = EventChainSchema.of(ids, types);
    return new AnswerSchema(schema.nested(), schema.flat(), schema.array());
  }

  /**
   * Converts an answer in the shape of the schema to a chain description: the array, without nulls.
   * Any other answer stays unchanged.
   */
  public static SourceText asArray(SourceText answer) {
    JsonNode json = JsonDocument.parse(answer).root();
    JsonNode components = EventChainSchema.components(json);
    boolean isWrapped = json.isObject() && json.size() == 1 && components.isArray();
    if (!isWrapped) {
      return answer;
    }
    JsonNode array = components.deepCopy();
    removeNulls(array);
    return SourceText.of(answer.name(), JsonLayout.of(array) + "\n");
  }

  private static void removeNulls(JsonNode node) {
    if (node instanceof ObjectNode object) {
      for (Iterator<JsonNode> values = object.elements(); values.hasNext(); ) {
        if (values.next().isNull()) {
          values.remove();
        }
      }
    }
    node.forEach(DesignSchema::removeNulls);
  }
}
