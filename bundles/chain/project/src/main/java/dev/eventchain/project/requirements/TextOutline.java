package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * Items of a text in its order: a heading with an id is followed by its text, up to the next one; a
 * line with an id goes on in what is indented below it.
 */
final class TextOutline {

  /** Headings of what is no text of a requirement, whose own heading is the text then. */
  private static final Set<String> BESIDES =
      Set.of(
          "rationale",
          "motivation",
          "justification",
          "background",
          "discussion",
          "note",
          "notes",
          "comment",
          "comments",
          "remarks",
          "source",
          "history",
          "references",
          "example",
          "examples",
          "verification",
          "validation",
          "tests");

  private final Reading reading;
  private final TextKinds kinds;
  private SourceText source;
  private final List<Open> all = new ArrayList<>();
  private final Deque<Around> around = new ArrayDeque<>();
  private Open heading;
  private Open entry;

  /** Items whose texts go on behind a term and its definition; null for none. */
  private record Around(Open heading, Open entry) {}

  /** An item whose text may go on. */
  private static final class Open {
    final String id;
    final String title;
    final SourceLocation place;
    final int depth; // level of a heading, or indent of a line
    final StringBuilder text = new StringBuilder();
    final List<TextIds.Named> facts = new ArrayList<>();
    Item done;

    Open(String id, String title, SourceLocation place, int depth) {
      this.id = id;
      this.title = title;
      this.place = place;
      this.depth = depth;
    }
  }

  TextOutline(SourceText source, TextKinds kinds, Reading reading) {
    this.source = source;
    this.kinds = kinds;
    this.reading = reading;
  }

  SourceText source() {
    return source;
  }

  /** Goes on in another file, or back in the one that takes it in. */
  void goTo(SourceText file) {
    source = file;
  }

  /** Adds an item that is complete. */
  void add(Item item) {
    Open open = new Open(item.id, "", item.location, 0);
    open.done = item;
    all.add(open);
    entry = null;
  }

  void add(TextBlock block) {
    if (block instanceof TextBlock.Heading found) {
      heading(found);
    } else if (block instanceof TextBlock.Lines found) {
      lines(found);
    } else if (block instanceof TextBlock.Table found) {
      goOn(heading, String.join(" | ", found.header()));
      found.rows().forEach(row -> goOn(heading, "; " + String.join(" | ", row.cells())));
    } else if (block instanceof TextBlock.Directive found) {
      directive(found);
    }
  }

  private void heading(TextBlock.Heading found) {
    if (found.level() >= RstBlocks.TERM) {
      term(found);
      return;
    }
    Optional<TextIds.Named> named = named(found);
    boolean continues =
        heading != null
            && heading.text.isEmpty()
            && found.level() > heading.depth
            && (heading.title.isBlank() || !isBeside(found));
    entry = null;
    if (named.isPresent()) {
      open(found, named.get());
    } else if (!continues) {
      heading = null;
    }
  }

  /** Begins a definition or ends it, behind which the texts around it go on. */
  private void term(TextBlock.Heading found) {
    if (found.text().isEmpty()) {
      Around outside = around.pop();
      heading = outside.heading();
      entry = outside.entry();
      return;
    }
    if (entry != null && found.level() - RstBlocks.TERM <= entry.depth) {
      entry = null;
    }
    around.push(new Around(heading, entry));
    Optional<TextIds.Named> named = named(found);
    if (named.isPresent()) {
      open(found, named.get());
    } else {
      goOn(entry == null ? heading : entry, found.text());
    }
  }

  private Optional<TextIds.Named> named(TextBlock.Heading found) {
    return TextIds.ofHeading(found.text())
        .filter(it -> isItem(it, kinds.isHeading(it), found.line()));
  }

  private void open(TextBlock.Heading found, TextIds.Named named) {
    if (TextIds.isAnother(named)) {
      reading.unread(
          "This heading names several ids, and whose text follows is not known.",
          source.at(found.line(), 1),
          "Write a heading for each.");
    }
    String title = named.text().replaceFirst("^\\s*[-:.|–—]*\\s*", "");
    heading = new Open(named.id(), title, source.at(found.line(), 1), found.level());
    entry = null;
    all.add(heading);
  }

  /** Returns whether what follows a heading is no text of a requirement. */
  static boolean isBeside(TextBlock.Heading heading) {
    return BESIDES.contains(heading.text().toLowerCase(Locale.ROOT));
  }

  private boolean isItem(TextIds.Named named, boolean isItem, int line) {
    if (!isItem) {
      kinds.pass(named, source, line);
    }
    return isItem;
  }

  private void lines(TextBlock.Lines found) {
    boolean below = entry != null && found.indent() > entry.depth;
    int number = 0;
    for (String line : found.lines()) {
      int at = found.line() + number;
      Optional<TextIds.Named> named =
          TextIds.ofLine(line).filter(it -> isItem(it, kinds.isLine(it), at));
      Optional<TextIds.Named> fact = TextIds.ofFact(line).filter(it -> isKnown(it, reading.fields));
      Open owner = below || (number > 0 && entry != null) ? entry : heading;
      if (named.isPresent()) {
        entry = new Open(named.get().id(), "", source.at(at, 1), found.indent());
        entry.text.append(named.get().text());
        all.add(entry);
      } else if (fact.isPresent() && owner != null) {
        owner.facts.add(fact.get());
      } else {
        if (number == 0 && !below) {
          entry = null;
        }
        goOn(owner, (number == 0 && found.isEntry() ? "- " : "") + line);
      }
      number++;
    }
  }

  private static void goOn(Open owner, String text) {
    if (owner != null) {
      owner.text.append(owner.text.isEmpty() ? "" : " ").append(text);
    }
  }

  /** Returns whether a line says the status, the tags, the type or a parent of an item. */
  static boolean isKnown(TextIds.Named fact, RequirementSource.Fields fields) {
    List<String> parents = fields.parents().isEmpty() ? TextIds.PARENTS : fields.parents();
    return is(fact, fields.status().orElse("status"))
        || is(fact, fields.tags().orElse("tags"))
        || is(fact, "type")
        || parents.stream().anyMatch(name -> is(fact, name));
  }

  private static boolean is(TextIds.Named fact, String name) {
    return fact.id().equalsIgnoreCase(name);
  }

  private void directive(TextBlock.Directive found) {
    List<String> links = new ArrayList<>(reading.fields.parents());
    if (links.isEmpty()) {
      links.addAll(List.of("links", RstBlocks.AROUND));
    }
    String id = found.options().get(reading.fields.id().orElse("id"));
    String text =
        reading
            .fields
            .text()
            .map(name -> found.options().getOrDefault(name, ""))
            .orElse(found.content());
    Item item = new Item(id, text.isBlank() ? found.title() : text, source.at(found.line(), 1));
    item.type = Optional.of(found.name());
    item.status =
        Optional.ofNullable(found.options().get(reading.fields.status().orElse("status")));
    item.tags =
        Reading.parts(found.options().getOrDefault(reading.fields.tags().orElse("tags"), ""));
    for (String link : links) {
      Reading.parts(found.options().getOrDefault(link, ""))
          .forEach(each -> item.addParent(each, item.location));
    }
    add(item);
  }

  /** Returns the items. */
  List<Item> items() {
    return all.stream().map(each -> each.done == null ? item(each) : each.done).toList();
  }

  private Item item(Open open) {
    String text = open.text.toString();
    Item item = new Item(open.id, text.isBlank() ? open.title : text, open.place);
    for (TextIds.Named fact : open.facts) {
      if (is(fact, "type")) {
        item.type = Optional.of(fact.text());
      } else if (is(fact, reading.fields.status().orElse("status"))) {
        item.status = Optional.of(fact.text());
      } else if (is(fact, reading.fields.tags().orElse("tags"))) {
        item.tags = Reading.parts(fact.text());
      } else {
        Reading.parts(fact.text())
            .forEach(each -> item.addParent(TextIds.plain(each), item.location));
      }
    }
    return item;
  }
}
