package dev.eventchain.agents;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonPointer;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.core.util.Separators;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.cfg.JsonNodeFeature;
import com.fasterxml.jackson.databind.json.JsonMapper;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.Map;

/** A JSON text with the place of each of its values. */
final class JsonText {
  private static final JsonMapper MAPPER =
      JsonMapper.builder()
          .enable(DeserializationFeature.USE_BIG_DECIMAL_FOR_FLOATS)
          .configure(JsonNodeFeature.STRIP_TRAILING_BIGDECIMAL_ZEROES, false)
          .build();

  private final SourceText source;
  private final JsonNode root;
  private final Map<JsonPointer, SourceLocation> places = new HashMap<>();

  private JsonText(SourceText source, JsonNode root) {
    this.source = source;
    this.root = root;
  }

  /** Reads a text that is known to be JSON. */
  static JsonText of(SourceText source) {
    try (JsonParser parser = MAPPER.createParser(source.text())) {
      JsonText text = new JsonText(source, MAPPER.readTree(source.text()));
      for (JsonToken token = parser.nextToken(); token != null; token = parser.nextToken()) {
        if (token == JsonToken.FIELD_NAME || token.isStructEnd()) {
          continue;
        }
        var place = parser.currentTokenLocation();
        JsonPointer pointer = parser.getParsingContext().pathAsPointer();
        // An array or object is its own context: its pointer names it already.
        text.places.putIfAbsent(
            pointer,
            source.at(place.getLineNr(), place.getColumnNr()).withElement(pointer.toString()));
      }
      return text;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  JsonNode root() {
    return root;
  }

  /** The place of a value; that of the value around it when there is none. */
  SourceLocation locate(String pointer) {
    JsonPointer wanted = JsonPointer.compile(pointer);
    for (JsonPointer known = wanted; known != null; known = known.head()) {
      SourceLocation place = places.get(known);
      if (place != null) {
        return place.withElement(pointer);
      }
    }
    return source.at(0).withElement(pointer);
  }

  /** The layout in which JSON is shown to models and written to files. */
  static String layout(JsonNode node) {
    DefaultIndenter indenter = new DefaultIndenter("  ", "\n");
    DefaultPrettyPrinter printer =
        new DefaultPrettyPrinter(
                Separators.createDefaultInstance()
                    .withObjectFieldValueSpacing(Separators.Spacing.AFTER))
            .withObjectIndenter(indenter)
            .withArrayIndenter(indenter);
    try {
      return MAPPER.writer(printer).writeValueAsString(node);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
