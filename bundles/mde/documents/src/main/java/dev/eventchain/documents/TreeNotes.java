package dev.eventchain.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;

/**
 * Locations of the values and keys of a tree, noted while it is built, and its recoverable
 * problems.
 */
final class TreeNotes {

  private final SourceText source;
  private final DocumentFormat format;
  private final DocumentRules rules;
  private final boolean anyText;
  private final Consumer<Diagnostic> findings;
  private final Map<String, Integer> values = new HashMap<>();
  private final Map<String, Integer> keys = new HashMap<>();

  TreeNotes(
      SourceText source,
      DocumentFormat format,
      DocumentRules rules,
      boolean anyText,
      Consumer<Diagnostic> findings) {
    this.source = source;
    this.format = format;
    this.rules = rules;
    this.anyText = anyText;
    this.findings = findings;
  }

  /** Returns the pointer to a property or element below a pointer; null for null. */
  static String below(String pointer, Object name) {
    return pointer == null ? null : Document.below(pointer, name);
  }

  Integer value(String pointer) {
    return values.get(pointer);
  }

  Integer key(String pointer) {
    return keys.get(pointer);
  }

  void noteValue(String pointer, int offset) {
    if (pointer != null) {
      values.put(pointer, offset);
    }
  }

  /**
   * Notes a key and reports a duplicate one.
   *
   * @return the pointer to its value; null if the value is to be ignored
   */
  String noteKey(ObjectNode object, String pointer, String name, int offset) {
    if (pointer == null) {
      return null;
    }
    check(name, pointer, offset);
    if (object.has(name)) {
      String message = "The " + format.key() + " '" + name + "' is duplicated.";
      report(rules.duplicate(), message, TreeNotes.below(pointer, name), offset);
      return null;
    }
    String below = below(pointer, name);
    keys.put(below, offset);
    return below;
  }

  /** Adds a value, unless its key is one that {@link #noteKey} refused. */
  static void put(ObjectNode object, String pointer, String name, JsonNode value) {
    if (pointer != null) {
      object.set(name, value);
    }
  }

  /** Returns a text or a key. Reports it if it contains unprintable characters. */
  String check(String text, String pointer, int offset) {
    int found = anyText || pointer == null ? -1 : unprintable(text);
    if (found >= 0) {
      String message = String.format("This holds %s.", described(text.charAt(found)));
      report(rules.type(), message, pointer, offset);
    }
    return text;
  }

  /** Returns the offset of the first unprintable character; -1 if there is none. */
  static int unprintable(String text) {
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (Character.isHighSurrogate(c)
          && i + 1 < text.length()
          && Character.isLowSurrogate(text.charAt(i + 1))) {
        i++;
      } else if (isControl(c) || Character.isSurrogate(c)) {
        return i;
      }
    }
    return -1;
  }

  private static boolean isControl(char c) {
    return Character.isISOControl(c) && c != '\t' && c != '\n' && c != '\r';
  }

  /** Returns the description of an unprintable character. */
  static String described(char c) {
    String kind = Character.isSurrogate(c) ? "half of a character, U+" : "the control character U+";
    return kind + String.format(Locale.ROOT, "%04X", (int) c);
  }

  void report(Rule rule, String message, String pointer, int offset) {
    findings.accept(Diagnostic.of(rule, message, source.at(offset).withElement(pointer)));
  }

  /** Reports an invalid value, except in an ignored part of the document. */
  void reportType(String message, String pointer, int offset) {
    if (pointer != null) {
      report(rules.type(), message, pointer, offset);
    }
  }
}
