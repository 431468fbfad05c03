package dev.eventchain.documents;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.exc.StreamConstraintsException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DecimalNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.MissingNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;

/** Builder of the tree of a JSON text. */
final class JsonTree {

  private static final JsonFactory FACTORY = new JsonFactory();
  private static final JsonNodeFactory JSON = JsonNodeFactory.instance;

  private final JsonParser parser;
  private final TreeNotes notes;
  private int depth;

  private JsonTree(JsonParser parser, TreeNotes notes) {
    this.parser = parser;
    this.notes = notes;
  }

  /** Returns the tree; a missing node if the text is empty. */
  static JsonNode read(String text, TreeNotes notes) throws MalformedException {
    try (JsonParser parser = FACTORY.createParser(text)) {
      return new JsonTree(parser, notes).root();
    } catch (JsonProcessingException e) {
      JsonLocation place = e.getLocation();
      throw new MalformedException(
          "This is not valid JSON: " + reason(e), place == null ? 0 : (int) place.getCharOffset());
    } catch (IOException e) {
      throw new IllegalStateException("reading from memory", e);
    }
  }

  /** Returns the message of the parser without the names of its settings and its own location. */
  private static String reason(JsonProcessingException e) {
    if (e instanceof StreamConstraintsException) {
      return "a name or a number is too long.";
    }
    String said = e.getOriginalMessage().lines().findFirst().orElse("");
    String plain =
        said.replaceFirst(
            "( \\((start marker|not recognized|for \\w+ starting)|: enable `).*$", "");
    return plain.endsWith("?") ? plain : plain + ".";
  }

  private JsonNode root() throws IOException, MalformedException {
    if (parser.nextToken() == null) {
      return MissingNode.getInstance();
    }
    JsonNode root = value("");
    if (parser.nextToken() != null) {
      throw new MalformedException(
          "This is not valid JSON: something follows after its end.", offset());
    }
    return root;
  }

  private int offset() {
    return (int) parser.currentTokenLocation().getCharOffset();
  }

  private JsonNode value(String pointer) throws IOException, MalformedException {
    int offset = offset();
    notes.noteValue(pointer, offset);
    return switch (parser.currentToken()) {
      case START_OBJECT -> object(pointer);
      case START_ARRAY -> array(pointer);
      case VALUE_STRING -> JSON.textNode(notes.check(parser.getText(), pointer, offset));
      case VALUE_NUMBER_INT -> integer();
      // Keeps the notation: trailing zeros are shown again.
      case VALUE_NUMBER_FLOAT -> DecimalNode.valueOf(parser.getDecimalValue());
      case VALUE_TRUE -> JSON.booleanNode(true);
      case VALUE_FALSE -> JSON.booleanNode(false);
      default -> JSON.nullNode();
    };
  }

  private JsonNode integer() throws IOException {
    return switch (parser.getNumberType()) {
      case INT -> JSON.numberNode(parser.getIntValue());
      case LONG -> JSON.numberNode(parser.getLongValue());
      default -> JSON.numberNode(parser.getBigIntegerValue());
    };
  }

  private JsonNode object(String pointer) throws IOException, MalformedException {
    enter();
    ObjectNode object = JSON.objectNode();
    while (parser.nextToken() != JsonToken.END_OBJECT) {
      String name = parser.currentName();
      String below = notes.noteKey(object, pointer, name, offset());
      parser.nextToken();
      TreeNotes.put(object, below, name, value(below));
    }
    depth--;
    return object;
  }

  private JsonNode array(String pointer) throws IOException, MalformedException {
    enter();
    ArrayNode array = JSON.arrayNode();
    while (parser.nextToken() != JsonToken.END_ARRAY) {
      array.add(value(TreeNotes.below(pointer, array.size())));
    }
    depth--;
    return array;
  }

  private void enter() throws MalformedException {
    depth++;
    if (depth > Document.DEEPEST) {
      throw new MalformedException(Document.TOO_DEEP, offset());
    }
  }
}
