package dev.eventchain.modeler;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonPointer;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.exc.StreamConstraintsException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.cfg.JsonNodeFeature;
import com.fasterxml.jackson.databind.json.JsonMapper;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;

/** A JSON document that knows the place of each of its values. Immutable. */
public final class JsonText {

  /** How deep a document may be nested. */
  public static final int DEEPEST = 200;

  private static final int LONGEST = 16 * 1024 * 1024;

  private static final JsonMapper MAPPER =
      JsonMapper.builder(
              JsonFactory.builder()
                  .streamReadConstraints(
                      StreamReadConstraints.builder().maxNestingDepth(DEEPEST).build())
                  .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
                  .build())
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          // Numbers are shown again as they were written.
          .enable(DeserializationFeature.USE_BIG_DECIMAL_FOR_FLOATS)
          .configure(JsonNodeFeature.STRIP_TRAILING_BIGDECIMAL_ZEROES, false)
          .build();

  private final SourceText source;
  private final JsonNode root;
  private final Map<JsonPointer, Integer> offsets;

  private JsonText(SourceText source, JsonNode root, Map<JsonPointer, Integer> offsets) {
    this.source = source;
    this.root = root;
    this.offsets = offsets;
  }

  /**
   * Reads a document: strict JSON, no property twice, nothing after its end, at most 200 levels and
   * 16 Mi characters.
   *
   * @throws DiagnosticException INPUT, {@code modeler.json.syntax}, if it is not such a document
   */
  public static JsonText parse(SourceText source) {
    if (source.text().length() > LONGEST) {
      throw syntax("The file is longer than " + LONGEST + " characters.", source.at(0));
    }
    try {
      JsonNode root = MAPPER.readTree(source.text());
      if (root == null || root.isMissingNode()) {
        throw syntax("The file is empty.", source.at(0));
      }
      return new JsonText(source, root, offsets(source));
    } catch (JsonProcessingException e) {
      var place = e.getLocation();
      SourceLocation location =
          place == null ? source.at(0) : source.at(place.getLineNr(), place.getColumnNr());
      throw syntax("This is not JSON: " + reason(e), location);
    } catch (IOException e) {
      throw new IllegalStateException("reading from memory", e);
    }
  }

  /** What the parser says, without the names of its settings. */
  private static String reason(JsonProcessingException e) {
    if (e instanceof StreamConstraintsException) {
      return "it is nested deeper than " + DEEPEST + " levels, or a name or number is too long.";
    }
    String said = e.getOriginalMessage().lines().findFirst().orElse("");
    String plain = said.replaceFirst("( \\((start marker|not recognized)|: enable `).*$", "");
    return plain.endsWith("?") ? plain : plain + ".";
  }

  private static DiagnosticException syntax(String message, SourceLocation location) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.error("modeler.json.syntax", message, location));
  }

  private static Map<JsonPointer, Integer> offsets(SourceText source) throws IOException {
    Map<JsonPointer, Integer> offsets = new HashMap<>();
    try (JsonParser parser = MAPPER.createParser(source.text())) {
      for (JsonToken token = parser.nextToken(); token != null; token = parser.nextToken()) {
        if (token != JsonToken.FIELD_NAME && !token.isStructEnd()) {
          int offset = (int) parser.currentTokenLocation().getCharOffset();
          // An array or object is its own context: its pointer names it already.
          offsets.putIfAbsent(parser.getParsingContext().pathAsPointer(), offset);
        }
      }
    }
    return offsets;
  }

  /** The whole document. Not to be changed. */
  public JsonNode root() {
    return root;
  }

  /**
   * The place of a JSON pointer's value; where there is no such value, that of the nearest one
   * around it.
   */
  public SourceLocation at(String pointer) {
    for (JsonPointer known = JsonPointer.compile(pointer); known != null; known = known.head()) {
      Integer offset = offsets.get(known);
      if (offset != null) {
        return source.at(offset).withElement(pointer);
      }
    }
    return source.at(0).withElement(pointer);
  }

  /** The pointer to a property or an element below another one. */
  static String below(String pointer, Object name) {
    return pointer + "/" + name.toString().replace("~", "~0").replace("/", "~1");
  }
}
