package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads a document of StrictDoc line by line. Nodes of every tag are items, except for texts and
 * sections; those that no field of the grammar describes are findings.
 */
final class SdocReader {

  private static final Pattern TAG = Pattern.compile("(\\[\\[?)(/?)([A-Z][A-Z0-9_]*)(\\]\\]?)");
  private static final Pattern FIELD = Pattern.compile("([A-Z][A-Za-z0-9_-]*):(?: (.*))?");
  private static final Pattern ENTRY = Pattern.compile("(- |  )([A-Z_]+):(?: (.*))?");

  /** Parts of a document that are no nodes. */
  private static final Set<String> HEADS = Set.of("DOCUMENT", "VIEWS");

  private static final Set<String> RELATIONS = Set.of("RELATIONS", "REFS");

  private final SourceText source;
  private final Reading reading;
  private final SdocGrammar grammar = new SdocGrammar();
  private final Neighbours neighbours;
  private final List<String> lines;
  private final Deque<Open> open = new ArrayDeque<>();
  private int next;

  private record Open(String tag, SourceLocation place) {}

  /** The files beside a document, by their names in it. */
  interface Neighbours {

    /** Returns the lines of a file with a grammar; empty if it cannot be read. */
    Optional<List<String>> grammar(String name);

    /** Returns whether another document is read, too. */
    boolean isRead(String name);
  }

  private SdocReader(SourceText source, Neighbours neighbours, Reading reading) {
    this.source = source;
    this.neighbours = neighbours;
    this.reading = reading;
    this.lines = source.text().lines().map(String::stripTrailing).toList();
  }

  /** Reads a document. */
  static void read(SourceText source, Neighbours neighbours, Reading reading) {
    new SdocReader(source, neighbours, reading).read();
  }

  private void read() {
    while (next < lines.size()) {
      String line = lines.get(next);
      Matcher tag = TAG.matcher(line);
      if (line.isBlank()) {
        next++;
      } else if (tag.matches()) {
        next++;
        part(tag);
      } else {
        unread(next, "This line belongs to no node.");
        skipToTag();
      }
    }
    open.forEach(
        each -> reading.unread("[" + each.tag() + "] has no end.", each.place(), "End it."));
  }

  private void part(Matcher tag) {
    String name = tag.group(3);
    int line = next - 1;
    if (!tag.group(2).isEmpty()) {
      end(name, line);
    } else if (name.equals("FREETEXT")) {
      skipTo("[/FREETEXT]", line);
    } else if (name.equals("GRAMMAR")) {
      next = grammar.read(lines, next, TAG);
      if (!grammar.imported().isEmpty()) {
        neighbours.grammar(grammar.imported()).ifPresent(all -> grammar.read(all, 1, TAG));
      }
    } else {
      SdocNode node = new SdocNode(name, source.at(line + 1, 1));
      fields(node);
      node(node, tag.group(1).length() == 2 || grammar.isOldContainer(name), line);
    }
  }

  private void node(SdocNode node, boolean container, int line) {
    if (HEADS.contains(node.tag)) {
      return;
    }
    if (container) {
      open.push(new Open(node.tag, source.at(line + 1, 1)));
    }
    if (node.tag.equals("DOCUMENT_FROM_FILE")) {
      if (!neighbours.isRead(node.text("FILE"))) {
        String message = "The document '%s', which this one includes, is not read from here.";
        reading.unread(
            message.formatted(node.text("FILE")),
            node.place,
            "Name the folder of both as the source; both are read there.");
      }
      return;
    }
    grammar.check(node, reading);
    if (!SdocGrammar.STRUCTURE.contains(node.tag)) {
      node.addTo(reading);
    }
  }

  private void end(String name, int line) {
    if (open.isEmpty() || !open.peek().tag().equals(name)) {
      String wanted = open.isEmpty() ? "Nothing is open." : "[" + open.peek().tag() + "] is open.";
      unread(line, "[" + name + "] ends here, but was not begun. " + wanted);
      return;
    }
    open.pop();
  }

  private void fields(SdocNode node) {
    while (next < lines.size() && !TAG.matcher(lines.get(next)).matches()) {
      String line = lines.get(next);
      Matcher field = FIELD.matcher(line);
      if (line.isBlank()) {
        next++;
      } else if (field.matches() && RELATIONS.contains(field.group(1))) {
        next++;
        relations(node);
      } else if (field.matches()) {
        SourceLocation place = source.at(next + 1, 1);
        next++;
        if (!node.put(field.group(1), place, value(field.group(2), place))) {
          String message = "The field '" + field.group(1) + "' is given twice.";
          reading.unread(message, place, "Leave one of them out.");
        }
      } else if (line.matches("[ -].*") && HEADS.contains(node.tag)) {
        next++; // an option or a view
      } else {
        unread(next, "This line is no field.");
        skipToTag();
      }
    }
  }

  /** Returns a value, which may go on in the following lines. */
  private String value(String first, SourceLocation place) {
    if (first == null || !first.equals(">>>")) {
      return first == null ? "" : first;
    }
    StringBuilder text = new StringBuilder();
    while (next < lines.size() && !lines.get(next).startsWith("<<<")) {
      text.append(lines.get(next++)).append('\n');
    }
    if (next == lines.size()) {
      reading.unread("The text that begins here has no end.", place, "End it with a line '<<<'.");
    }
    next++;
    return text.toString();
  }

  private void relations(SdocNode node) {
    String type = "";
    for (; next < lines.size(); next++) {
      Matcher entry = ENTRY.matcher(lines.get(next));
      if (!entry.matches()) {
        return;
      }
      String value = entry.group(3) == null ? "" : entry.group(3);
      if (entry.group(2).equals("TYPE")) {
        type = value;
      } else if (entry.group(2).equals("VALUE")) {
        node.relate(type, value, source.at(next + 1, entry.start(2) + 1));
      }
    }
  }

  /** Skips what is likely not read either, so that it is one finding. */
  private void skipToTag() {
    while (next < lines.size() && !TAG.matcher(lines.get(next)).matches()) {
      next++;
    }
  }

  private void skipTo(String end, int from) {
    while (next < lines.size() && !lines.get(next).equals(end)) {
      next++;
    }
    if (next == lines.size()) {
      unread(from, "The text that begins here has no end.");
    }
    next++;
  }

  private void unread(int line, String message) {
    reading.unread(
        message,
        source.at(line + 1, 1),
        "Fields are 'NAME: text', or 'NAME: >>>', lines and '<<<'; StrictDoc itself says what it"
            + " refuses.");
  }
}
