package dev.eventchain.workspace;

import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.Unit;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Units that the comments of message definitions name: in brackets, or as the whole comment up to
 * its first comma, beside a field or in the line above.
 */
final class FieldUnits {

  private static final Pattern FIELD =
      Pattern.compile("[a-zA-Z][^\\s#]*\\s+([a-z][a-z0-9_]*)\\b.*");
  private static final Pattern BRACKETS = Pattern.compile("[\\[(]([^\\])]+)[\\])]");

  private final MessageCatalog messages;
  private final Map<String, Map<String, String>> known = new HashMap<>();

  FieldUnits(MessageCatalog messages) {
    this.messages = messages;
  }

  /** Returns the unit of a field of a type; empty if no comment names one. */
  Optional<String> of(MessageType type, String field) {
    return Optional.ofNullable(
        known.computeIfAbsent(type.name(), name -> read(messages.text(type))).get(field));
  }

  private static Map<String, String> read(String text) {
    Map<String, String> units = new HashMap<>();
    String above = "";
    for (String line : text.lines().takeWhile(each -> !each.startsWith("====")).toList()) {
      int hash = line.indexOf('#');
      String comment = hash < 0 ? "" : line.substring(hash + 1).strip();
      Matcher field = FIELD.matcher(hash < 0 ? line.strip() : line.substring(0, hash).strip());
      String last = above;
      if (field.matches()) {
        unit(comment).or(() -> unit(last)).ifPresent(unit -> units.put(field.group(1), unit));
      }
      above = field.matches() ? "" : comment;
    }
    return units;
  }

  private static Optional<String> unit(String comment) {
    Matcher brackets = BRACKETS.matcher(comment);
    String named = brackets.find() ? brackets.group(1) : comment.split("[,;]", 2)[0];
    return Optional.of(named.strip())
        .filter(text -> !text.isEmpty() && !text.matches("[0-9].*"))
        .filter(text -> Unit.parse(text).isPresent());
  }
}
