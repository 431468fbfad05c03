package dev.eventchain.project.requirements;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The tags of nodes and their fields that a StrictDoc document may use. */
final class SdocGrammar {

  /** Tags of nodes that are never requirements. */
  static final Set<String> STRUCTURE = Set.of("SECTION", "TEXT");

  private static final Set<String> ALWAYS = Set.of("MID", "LEVEL");
  private static final Set<String> OLD_CONTAINERS = Set.of("SECTION", "COMPOSITE_REQUIREMENT");
  private static final Pattern LINE =
      Pattern.compile("\\s*(?:- )?([A-Z_]+):(?: (.*))?", Pattern.DOTALL);

  /** Fields by tag; empty for the grammar of StrictDoc itself, which is not checked. */
  private final Map<String, Set<String>> fields = new HashMap<>();

  private String imported = "";

  /** Returns the file that the grammar of a document is imported from; empty if it has its own. */
  String imported() {
    return imported;
  }

  /**
   * Reads the lines of a grammar.
   *
   * @param tag what ends it
   * @return the index of the first line that does not belong to it
   */
  int read(List<String> lines, int from, Pattern tag) {
    Set<String> current = new HashSet<>();
    boolean inFields = false;
    int next = from;
    for (; next < lines.size() && !tag.matcher(lines.get(next)).matches(); next++) {
      Matcher line = LINE.matcher(lines.get(next));
      if (!line.matches()) {
        continue;
      }
      String value = line.group(2) == null ? "" : line.group(2);
      switch (line.group(1)) {
        case "IMPORT_FROM_FILE" -> imported = value;
        case "TAG" -> current = fields.computeIfAbsent(value, key -> new HashSet<>());
        case "FIELDS" -> inFields = true;
        case "RELATIONS", "PROPERTIES" -> inFields = false;
        case "TITLE" -> {
          if (inFields) {
            current.add(value);
          }
        }
        default -> {} // types of fields, and which are required
      }
    }
    return next;
  }

  /** Returns whether a tag in single brackets has an end, as in older versions. */
  boolean isOldContainer(String tag) {
    return OLD_CONTAINERS.contains(tag) && !fields.containsKey(tag);
  }

  /** Reports a tag or field that the grammar of the document does not have. */
  void check(SdocNode node, Reading reading) {
    Set<String> known = fields.get(node.tag);
    boolean structure = STRUCTURE.contains(node.tag);
    if (fields.isEmpty() || (known == null && structure)) {
      return;
    }
    if (known == null) {
      reading.unread(
          "The grammar of the document has no '" + node.tag + "'.",
          node.place,
          "Add it to the elements of the grammar.");
      return;
    }
    node.places()
        .forEach(
            (field, place) -> {
              if (!known.contains(field) && !ALWAYS.contains(field)) {
                String message = "The grammar of the document gives '%s' no field '%s'.";
                reading.unread(
                    message.formatted(node.tag, field), place, "Add it to the grammar's fields.");
              }
            });
  }
}
