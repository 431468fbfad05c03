package dev.eventchain.project.requirements;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.ObjectReader;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads the items of a document of Doorstop: a folder with a file of settings and one per item. */
final class DoorstopReader {

  /** The file of settings, which makes a folder a document. */
  static final String SETTINGS = ".doorstop.yml";

  private static final Pattern ATTRIBUTES =
      Pattern.compile("(?s)---[ \\t]*\\R.*?^(---[ \\t]*(\\R|\\z))", Pattern.MULTILINE);

  /** The line that ends the attributes, and a header of the first level that comes first. */
  private static final Pattern BEFORE_TEXT =
      Pattern.compile("---[ \\t]*(\\R\\s*(# .*(\\R\\s*)?)?)?");

  private final String prefix;
  private final boolean markdown;
  private final Reading reading;

  private DoorstopReader(String prefix, boolean markdown, Reading reading) {
    this.prefix = prefix;
    this.markdown = markdown;
    this.reading = reading;
  }

  /**
   * Reads a document.
   *
   * @param files the files in its folder; items are those with the ending of its format
   */
  static void read(Path settings, List<Path> files, Reading reading) {
    Optional<ObjectReader> read =
        Reading.file(
            settings, reading, text -> document(text, reading).object("", reading.findings::add));
    Optional<ObjectReader> known = read.flatMap(each -> each.object("settings"));
    if (known.isEmpty()) {
      reading.unread(
          "The file has no 'settings' of a document.",
          SourceLocation.of(settings),
          "Doorstop writes it: doorstop create PREFIX FOLDER");
      return;
    }
    String format = known.get().text("itemformat").orElse("yaml");
    boolean markdown = format.equals("markdown");
    if (!markdown && !format.equals("yaml")) {
      reading.unread(
          "Items in the format '" + format + "' are not read.",
          known.get().at("itemformat"),
          "Let Doorstop keep them as YAML or Markdown: itemformat: yaml");
      return;
    }
    DoorstopReader reader =
        new DoorstopReader(known.get().requiredText("prefix"), markdown, reading);
    files.stream()
        .filter(file -> SourceFiles.has(file, ".md") == markdown)
        .forEach(file -> Reading.file(file, reading, text -> reader.item(text, file)));
  }

  private static Document document(SourceText text, Reading reading) {
    return Document.parse(text, DocumentFormat.YAML, JsonItems.RULES, reading.findings::add);
  }

  private Optional<Item> item(SourceText source, Path file) {
    String id = file.getFileName().toString().replaceFirst("\\.(ya?ml|md)$", "");
    Optional<Integer> end =
        markdown ? endOfAttributes(source) : Optional.of(source.text().length());
    if (end.isEmpty()) {
      return Optional.empty();
    }
    Document document =
        document(SourceText.of(source.name(), source.text().substring(0, end.get())), reading);
    Optional<ObjectReader> read = document.object("", reading.findings::add);
    if (!id.toLowerCase(Locale.ROOT).startsWith(prefix.toLowerCase(Locale.ROOT))) {
      reading.unread(
          "The name does not begin with '" + prefix + "', as those of the document's items do.",
          source.at(0),
          "Move the file out of the folder, of which Doorstop takes every such file for an item.");
      return Optional.empty();
    }
    Item item = described(id, source, end.get(), document, read);
    reading.items.add(item);
    return Optional.of(item);
  }

  /** Returns an item with what its attributes and, in Markdown, the text behind them say. */
  private Item described(
      String id, SourceText source, int end, Document document, Optional<ObjectReader> read) {
    RequirementSource.Fields names = reading.fields;
    int start = textStart(source, end);
    Item item =
        new Item(
            names.id().flatMap(name -> read.flatMap(it -> plain(it, name))).orElse(id),
            read.flatMap(it -> plain(it, names.text().orElse("text")))
                .orElse(source.text().substring(start)),
            markdown && names.text().isEmpty()
                ? source.at(start)
                : document.atKey("/" + names.text().orElse("text")).withElement(""));
    item.type = Optional.of(prefix);
    item.status = read.flatMap(it -> plain(it, names.status().orElse("status")));
    item.tags = read.map(it -> tags(it, names.tags().orElse("tags"))).orElse(List.of());
    item.excluded = read.flatMap(DoorstopReader::excluded);
    for (String links : names.parents().isEmpty() ? List.of("links") : names.parents()) {
      read.flatMap(it -> it.value(links)).ifPresent(it -> link(item, it, links, document));
    }
    return item;
  }

  /** Returns where the attributes above a Markdown text end; without them, it is a finding. */
  private Optional<Integer> endOfAttributes(SourceText source) {
    Matcher attributes = ATTRIBUTES.matcher(source.text());
    if (!attributes.lookingAt()) {
      reading.unread(
          "The item has no attributes between two lines '---'.",
          source.at(0),
          "Doorstop writes them; move other Markdown out of the folder of the document.");
      return Optional.empty();
    }
    return Optional.of(attributes.start(1));
  }

  /** Returns where the text of an item begins: behind its attributes and its header, if any. */
  private static int textStart(SourceText source, int end) {
    Matcher header = BEFORE_TEXT.matcher(source.text()).region(end, source.text().length());
    return header.lookingAt() ? header.end() : source.text().length();
  }

  private static Optional<String> excluded(ObjectReader item) {
    if (item.value("active").filter(value -> !value.asBoolean(true)).isPresent()) {
      return Optional.of("not active");
    }
    return item.value("normative").filter(value -> !value.asBoolean(true)).isPresent()
        ? Optional.of("not normative")
        : Optional.empty();
  }

  private static Optional<String> plain(ObjectReader item, String name) {
    return item.value(name)
        .filter(JsonNode::isValueNode)
        .map(JsonNode::asText)
        .filter(text -> !text.isBlank());
  }

  private static List<String> tags(ObjectReader item, String name) {
    boolean several = item.value(name).filter(JsonNode::isArray).isPresent();
    return several ? item.texts(name) : plain(item, name).map(Reading::parts).orElse(List.of());
  }

  /** Adds links, each an id alone or with the fingerprint of the parent's text. */
  private static void link(Item item, JsonNode links, String name, Document document) {
    for (int i = 0; i < links.size(); i++) {
      SourceLocation place = document.at("/" + name + "/" + i).withElement("");
      if (links.get(i).isObject()) {
        links.get(i).fieldNames().forEachRemaining(id -> item.addParent(id, place));
      } else {
        item.addParent(links.get(i).asText(), place);
      }
    }
  }
}
