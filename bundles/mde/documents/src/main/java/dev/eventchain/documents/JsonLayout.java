package dev.eventchain.documents;

import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.core.util.Separators;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.TextNode;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Iterator;

/** Layout of JSON for users, language models and files. */
public final class JsonLayout {
  private static final JsonMapper MAPPER = new JsonMapper();

  private JsonLayout() {}

  /**
   * Returns the text with line breaks, and an indentation of one blank, only before values that are
   * more than plain values and lists of these: about half as long as {@link #of}, and still
   * readable.
   */
  public static String compact(JsonNode node) {
    StringBuilder text = new StringBuilder();
    append(text, node, "\n");
    return text.toString();
  }

  private static void append(StringBuilder text, JsonNode node, String line) {
    if (!node.isContainerNode()) {
      text.append(node);
      return;
    }
    text.append(node.isObject() ? '{' : '[');
    Iterator<String> names = node.fieldNames();
    String separator = "";
    boolean broken = false;
    for (JsonNode child : node) {
      boolean plain = isPlain(child);
      broken |= !plain;
      text.append(separator).append(broken ? line + " " : separator.isEmpty() ? "" : " ");
      if (node.isObject()) {
        text.append(TextNode.valueOf(names.next())).append(": ");
      }
      append(text, child, line + " ");
      separator = ",";
    }
    text.append(node.isObject() ? '}' : ']');
  }

  /** Returns whether a value is no container, or a list of such values. */
  private static boolean isPlain(JsonNode node) {
    return !node.isContainerNode() || (node.isArray() && areScalars(node));
  }

  private static boolean areScalars(JsonNode array) {
    for (JsonNode each : array) {
      if (each.isContainerNode()) {
        return false;
      }
    }
    return true;
  }

  /** Returns the text, indented by two blanks, without a line break at its end. */
  public static String of(JsonNode node) {
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
