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
 * A JSON or YAML file that knows the location of each of its values and keys. Its values are
 * addressed by JSON pointers, in YAML, too. Immutable.
 */
public final class Document {

  /** How deep a document may be nested. */
  public static final int DEEPEST = 200;

  static final int LONGEST = 16 * 1024 * 1024;
  static final String TOO_DEEP = "It is nested deeper than " + DEEPEST + " levels.";

  private final SourceText source;
  private final DocumentFormat format;
  private final FindingIds ids;
  private final TreeNotes notes;
  private final JsonNode root;

  private Document(
      SourceText source, DocumentFormat format, FindingIds ids, TreeNotes notes, JsonNode root) {
    this.source = source;
    this.format = format;
    this.ids = ids;
    this.notes = notes;
    this.root = root;
  }

  /**
   * Reads a text: one document, at most 200 levels deep and 16 Mi characters long, in which every
   * text can be shown. A duplicate key, a key that is not text, and a text with control characters
   * are findings, and reading continues.
   *
   * @param findings gets what is wrong with the document
   * @throws DiagnosticException INPUT if it is no such document ({@link FindingIds#syntax})
   */
  public static Document parse(
      SourceText source, DocumentFormat format, FindingIds ids, Consumer<Diagnostic> findings) {
    Document document = parse(source, format, ids, false, findings);
    if (document.isEmpty()) {
      throw syntax(ids, "The file is empty.", source.at(0));
    }
    return document;
  }

  /** As {@link #parse}, but nothing where the text is empty, or has nothing but comments. */
  public static Optional<Document> parseIfAny(
      SourceText source, DocumentFormat format, FindingIds ids, Consumer<Diagnostic> findings) {
    return Optional.of(parse(source, format, ids, false, findings)).filter(d -> !d.isEmpty());
  }

  /**
   * As {@link #parse}, for documents that hold texts of others, whatever characters are in them.
   */
  public static Document parseWithAnyText(
      SourceText source, DocumentFormat format, FindingIds ids, Consumer<Diagnostic> findings) {
    Document document = parse(source, format, ids, true, findings);
    if (document.isEmpty()) {
      throw syntax(ids, "The file is empty.", source.at(0));
    }
    return document;
  }

  private static Document parse(
      SourceText source,
      DocumentFormat format,
      FindingIds ids,
      boolean anyText,
      Consumer<Diagnostic> findings) {
    return DiagnosticException.at(
        SourceLocation.of(source.name()), () -> read(source, format, ids, anyText, findings));
  }

  private static Document read(
      SourceText source,
      DocumentFormat format,
      FindingIds ids,
      boolean anyText,
      Consumer<Diagnostic> findings) {
    String text = source.text();
    if (text.length() > LONGEST) {
      String message = "The file is longer than " + LONGEST + " characters.";
      throw syntax(ids, message, SourceLocation.of(source.name()));
    }
    TreeNotes notes = new TreeNotes(source, format, ids, anyText, findings);
    try {
      JsonNode root =
          format == DocumentFormat.JSON ? JsonTree.read(text, notes) : YamlTree.read(text, notes);
      return new Document(source, format, ids, notes, root);
    } catch (MalformedException e) {
      SourceLocation place =
          e.offset() < 0 ? SourceLocation.of(source.name()) : source.at(e.offset());
      throw syntax(ids, e.getMessage(), place);
    }
  }

  private static DiagnosticException syntax(FindingIds ids, String message, SourceLocation place) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT, Diagnostic.error(ids.syntax(), message, place));
  }

  private boolean isEmpty() {
    return root.isMissingNode();
  }

  /** The whole document. Not to be changed. */
  public JsonNode root() {
    return root;
  }

  /**
   * A reader of the object at a pointer; nothing if that is not an object, which is a finding.
   *
   * @param pointer empty for the whole document
   */
  public Optional<ObjectReader> object(String pointer, Consumer<Diagnostic> findings) {
    JsonNode node = root.at(pointer);
    if (node.isObject()) {
      return Optional.of(new ObjectReader(this, pointer, node, findings));
    }
    String message = "This must be " + format.object() + ", not " + kind(node) + ".";
    findings.accept(Diagnostic.error(ids.type(), message, at(pointer)));
    return Optional.empty();
  }

  /** Readers of the objects in the array that the document is; whatever is none is a finding. */
  public List<ObjectReader> objects(Consumer<Diagnostic> findings) {
    if (!root.isArray()) {
      String message = "The file must hold " + format.array() + ", not " + kind(root) + ".";
      findings.accept(Diagnostic.error(ids.type(), message, at("")));
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
   * The place of a pointer's value; where there is no such value, that of the nearest one around
   * it.
   */
  public SourceLocation at(String pointer) {
    String known = pointer;
    while (notes.value(known) == null && !known.isEmpty()) {
      known = known.substring(0, Math.max(0, known.lastIndexOf('/')));
    }
    Integer offset = notes.value(known);
    return source.at(offset == null ? 0 : offset).withElement(pointer);
  }

  /** The place of the key before a pointer's value; as {@link #at} where there is none. */
  public SourceLocation atKey(String pointer) {
    Integer offset = notes.key(pointer);
    return offset == null ? at(pointer) : source.at(offset).withElement(pointer);
  }

  /** What a value is, in the words of the format: "a list". */
  public String kind(JsonNode value) {
    return format.kind(value);
  }

  DocumentFormat format() {
    return format;
  }

  FindingIds ids() {
    return ids;
  }

  /** The pointer to a property or an element below another one. */
  public static String below(String pointer, Object name) {
    return pointer + "/" + name.toString().replace("~", "~0").replace("/", "~1");
  }
}
