package dev.eventchain.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DecimalNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.MissingNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.Locale;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.error.Mark;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.events.AliasEvent;
import org.yaml.snakeyaml.events.CollectionStartEvent;
import org.yaml.snakeyaml.events.Event;
import org.yaml.snakeyaml.events.MappingStartEvent;
import org.yaml.snakeyaml.events.ScalarEvent;
import org.yaml.snakeyaml.events.SequenceStartEvent;
import org.yaml.snakeyaml.parser.Parser;
import org.yaml.snakeyaml.parser.ParserImpl;
import org.yaml.snakeyaml.reader.StreamReader;

/**
 * Builder of the tree of a YAML text from its events, without implicit resolution. Only {@link
 * PlainScalar} decides the type of a scalar.
 */
final class YamlTree {

  private static final JsonNodeFactory JSON = JsonNodeFactory.instance;

  private final String text;
  private final TreeNotes notes;
  private final Parser parser;
  private final boolean plainOffsets;
  private int depth;

  private YamlTree(String text, TreeNotes notes) {
    this.text = text;
    this.notes = notes;
    LoaderOptions options = new LoaderOptions();
    options.setCodePointLimit(Document.LONGEST);
    this.parser = new ParserImpl(new StreamReader(text), options);
    this.plainOffsets = text.chars().noneMatch(c -> Character.isSurrogate((char) c));
  }

  /** Returns the tree; a missing node if the text contains no value. */
  static JsonNode read(String text, TreeNotes notes) throws MalformedException {
    refuseUnprintable(text);
    YamlTree tree = new YamlTree(text, notes);
    try {
      return tree.root();
    } catch (MarkedYAMLException e) {
      String problem = e.getProblem().replaceFirst("\\.$", "").replaceAll("\\s+", " ");
      throw new MalformedException(
          "This is not valid YAML: " + problem + ".", tree.offset(e.getProblemMark()));
    } catch (YAMLException e) {
      throw new MalformedException(
          "This is not valid YAML: it contains a character that is not allowed.", -1);
    }
  }

  /**
   * Refuses characters that YAML does not allow, and those that end a line only in some of its
   * versions.
   */
  private static void refuseUnprintable(String text) throws MalformedException {
    int found = TreeNotes.unprintable(text);
    if (found >= 0) {
      String what = TreeNotes.described(text.charAt(found));
      throw new MalformedException("This is not valid YAML: it holds " + what + ".", found);
    }
    for (char separator : new char[] {'\u2028', '\u2029'}) {
      if (text.indexOf(separator) >= 0) {
        throw new MalformedException(
            String.format(Locale.ROOT, "The line separator U+%04X is not read.", (int) separator),
            text.indexOf(separator));
      }
    }
  }

  private JsonNode root() throws MalformedException {
    parser.getEvent(); // The stream begins.
    if (parser.getEvent().is(Event.ID.StreamEnd)) {
      return MissingNode.getInstance();
    }
    Event first = parser.getEvent();
    JsonNode root = value("", first);
    parser.getEvent(); // The document ends.
    Event next = parser.getEvent();
    if (!next.is(Event.ID.StreamEnd)) {
      throw new MalformedException(
          "A second document begins here; the file must hold one.", offset(next));
    }
    boolean empty = first instanceof ScalarEvent scalar && scalar.isPlain() && root.isNull();
    return empty ? MissingNode.getInstance() : root;
  }

  private int offset(Event event) {
    return offset(event.getStartMark());
  }

  /** Returns the offset of a mark, which counts code points. */
  private int offset(Mark mark) {
    if (mark == null) {
      return -1;
    }
    return plainOffsets
        ? mark.getIndex()
        : text.offsetByCodePoints(
            0, Math.min(mark.getIndex(), text.codePointCount(0, text.length())));
  }

  private JsonNode value(String pointer, Event event) throws MalformedException {
    int offset = offset(event);
    notes.noteValue(pointer, offset);
    if (event instanceof AliasEvent alias) {
      throw new MalformedException(
          "Aliases are not read; write here what *" + alias.getAnchor() + " stands for.", offset);
    }
    if (event instanceof ScalarEvent scalar) {
      refuseTag(scalar.getTag(), offset);
      notes.check(scalar.getValue(), pointer, offset);
      return scalar.isPlain() ? plain(scalar.getValue()) : JSON.textNode(scalar.getValue());
    }
    refuseTag(((CollectionStartEvent) event).getTag(), offset);
    depth++;
    if (depth > Document.DEEPEST) {
      throw new MalformedException(Document.TOO_DEEP, offset);
    }
    JsonNode collection =
        event instanceof SequenceStartEvent ? sequence(pointer) : mapping(pointer);
    depth--;
    return collection;
  }

  private static void refuseTag(String tag, int offset) throws MalformedException {
    if (tag != null) {
      throw new MalformedException(
          "Tags are not read; leave out " + tag.replaceFirst("^tag:yaml.org,2002:", "!!") + ".",
          offset);
    }
  }

  private static JsonNode plain(String written) {
    return switch (PlainScalar.of(written)) {
      case NOTHING -> JSON.nullNode();
      case TRUE -> JSON.booleanNode(true);
      case FALSE -> JSON.booleanNode(false);
      case WHOLE_NUMBER -> whole(new BigInteger(written));
      case NUMBER -> DecimalNode.valueOf(new BigDecimal(written));
      case TEXT -> JSON.textNode(written);
    };
  }

  private static JsonNode whole(BigInteger number) {
    if (number.bitLength() < Integer.SIZE) {
      return JSON.numberNode(number.intValue());
    }
    return number.bitLength() < Long.SIZE
        ? JSON.numberNode(number.longValue())
        : JSON.numberNode(number);
  }

  private JsonNode sequence(String pointer) throws MalformedException {
    ArrayNode array = JSON.arrayNode();
    for (Event e = parser.getEvent(); !e.is(Event.ID.SequenceEnd); e = parser.getEvent()) {
      array.add(value(TreeNotes.below(pointer, array.size()), e));
    }
    return array;
  }

  private JsonNode mapping(String pointer) throws MalformedException {
    ObjectNode object = JSON.objectNode();
    for (Event e = parser.getEvent(); !e.is(Event.ID.MappingEnd); e = parser.getEvent()) {
      if (e instanceof ScalarEvent key && !(key.isPlain() && key.getValue().isEmpty())) {
        refuseTag(key.getTag(), offset(key));
        String below = notes.noteKey(object, pointer, key.getValue(), offset(key));
        TreeNotes.put(object, below, key.getValue(), value(below, parser.getEvent()));
      } else {
        String message =
            e instanceof MappingStartEvent || e instanceof SequenceStartEvent
                ? "A key must be a string."
                : "The key is missing before its colon.";
        notes.reportType(message, pointer, offset(e));
        value(null, e);
        value(null, parser.getEvent());
      }
    }
    return object;
  }
}
