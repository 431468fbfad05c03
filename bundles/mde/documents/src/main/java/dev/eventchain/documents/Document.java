package dev.eventchain.documents;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * A JSON or YAML file with the location of each of its values and keys. JSON pointers address its
 * values, also in YAML. Immutable.
 */
public final class Document {

  /** Greatest nesting depth of a document. */
  public static final int DEEPEST = 200;

  static final int LONGEST = 16 * 1024 * 1024;
  static final String TOO_DEEP = "It is nested deeper than " + DEEPEST + " levels.";

  private final SourceText source;
  private final DocumentFormat format;
  private final DocumentRules rules;
  private final TreeNotes notes;
  private final JsonNode root;

  private Document(
      SourceText source,
      DocumentFormat format,
      DocumentRules rules,
      TreeNotes notes,
      JsonNode root) {
    this.source = source;
    this.format = format;
    this.rules = rules;
    this.notes = notes;
    this.root = root;
  }

  /**
   * Reads a document of at most 200 levels and 16 Mi characters without control characters.
   * Duplicate keys, keys that are not text, and control characters are findings, after which
   * reading continues.
   *
   * @param findings receives the problems of the document
   * @throws DiagnosticException INPUT if the text is no such document ({@link
   *     DocumentRules#syntax})
   */
  public static Document parse(
      SourceText source,
      DocumentFormat format,
      DocumentRules rules,
      Consumer<Diagnostic> findings) {
    Document document = parse(source, format, rules, false, findings);
    if (document.isEmpty()) {
      throw syntax(rules, "The file is empty.", source.at(0));
    }
    return document;
  }

  /** As {@link #parse}, but empty if the text is empty or has only comments. */
  public static Optional<Document> parseIfAny(
      SourceText source,
      DocumentFormat format,
      DocumentRules rules,
      Consumer<Diagnostic> findings) {
    return Optional.of(parse(source, format, rules, false, findings)).filter(d -> !d.isEmpty());
  }

  /** As {@link #parse}, for documents that hold foreign texts, which may contain any characters. */
  public static Document parseWithAnyText(
      SourceText source,
      DocumentFormat format,
      DocumentRules rules,
      Consumer<Diagnostic> findings) {
    Document document = parse(source, format, rules, true, findings);
    if (document.isEmpty()) {
      throw syntax(rules, "The file is empty.", source.at(0));
    }
    return document;
  }

  private static Document parse(
      SourceText source,
      DocumentFormat format,
      DocumentRules rules,
      boolean anyText,
      Consumer<Diagnostic> findings) {
    return DiagnosticException.at(
        SourceLocation.of(source.name()), () -> read(source, format, rules, anyText, findings));
  }

  private static Document read(
      SourceText source,
      DocumentFormat format,
      DocumentRules rules,
      boolean anyText,
      Consumer<Diagnostic> findings) {
    String text = source.text();
    if (text.length() > LONGEST) {
      String message = "The file is longer than " + LONGEST + " characters.";
      throw syntax(rules, message, SourceLocation.of(source.name()));
    }
    TreeNotes notes = new TreeNotes(source, format, rules, anyText, findings);
    try {
      JsonNode root =
          format == DocumentFormat.JSON ? JsonTree.read(text, notes) : YamlTree.read(text, notes);
      return new Document(source, format, rules, notes, root);
    } catch (MalformedException e) {
      SourceLocation place =
          e.offset() < 0 ? SourceLocation.of(source.name()) : source.at(e.offset());
      throw syntax(rules, e.getMessage(), place);
    }
  }

  private static DiagnosticException syntax(
      DocumentRules rules, String message, SourceLocation place) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT, Diagnostic.of(rules.syntax(), message, place));
  }

  private boolean isEmpty() {
    return root.isMissingNode();
  }

  /** Returns the root value, which must not be modified. */
  public JsonNode root() {
    return root;
  }

  /**
   * Returns a reader of the object at a pointer; empty, with a finding, if it is not an object.
   *
   * @param pointer empty for the whole document
   */
  public Optional<ObjectReader> object(String pointer, Consumer<Diagnostic> findings) {
    JsonNode node = root.at(pointer);
    if (node.isObject()) {
      return Optional.of(new ObjectReader(this, pointer, node, findings));
    }
    String message = "This must be " + format.object() + ", not " + kind(node) + ".";
    findings.accept(Diagnostic.of(rules.type(), message, at(pointer)));
    return Optional.empty();
  }

  /** Returns readers of the objects in the root array; everything else there is a finding. */
  public List<ObjectReader> objects(Consumer<Diagnostic> findings) {
    if (!root.isArray()) {
      String message = "The file must hold " + format.array() + ", not " + kind(root) + ".";
      findings.accept(Diagnostic.of(rules.type(), message, at("")));
    }
    return objects("", root, findings);
  }

  List<ObjectReader> objects(String pointer, JsonNode array, Consumer<Diagnostic> findings) {
    List<ObjectReader> objects = new ArrayList<>();
    for (int i = 0; array.isArray() && i < array.size(); i++) {
      object(below(pointer, i), findings).ifPresent(objects::add);
    }
    return objects;
  }

  /**
   * Returns the location of the value at a pointer; without such a value, that of the nearest
   * enclosing one.
   */
  public SourceLocation at(String pointer) {
    String known = pointer;
    while (notes.value(known) == null && !known.isEmpty()) {
      known = known.substring(0, Math.max(0, known.lastIndexOf('/')));
    }
    Integer offset = notes.value(known);
    return source.at(offset == null ? 0 : offset).withElement(pointer);
  }

  /** Returns the location of the key of the value at a pointer; as {@link #at} without a key. */
  public SourceLocation atKey(String pointer) {
    Integer offset = notes.key(pointer);
    return offset == null ? at(pointer) : source.at(offset).withElement(pointer);
  }

  /** Returns the kind of a value in the terms of the format: "a list". */
  public String kind(JsonNode value) {
    return format.kind(value);
  }

  DocumentFormat format() {
    return format;
  }

  DocumentRules rules() {
    return rules;
  }

  /** Returns the pointer to a property or an element below a pointer. */
  public static String below(String pointer, Object name) {
    return pointer + "/" + name.toString().replace("~", "~0").replace("/", "~1");
  }
}
