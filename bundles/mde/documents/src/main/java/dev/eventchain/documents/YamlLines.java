package dev.eventchain.documents;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.yaml.snakeyaml.DumperOptions.ScalarStyle;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.events.AliasEvent;
import org.yaml.snakeyaml.events.CollectionStartEvent;
import org.yaml.snakeyaml.events.DocumentStartEvent;
import org.yaml.snakeyaml.events.Event;
import org.yaml.snakeyaml.events.NodeEvent;
import org.yaml.snakeyaml.events.ScalarEvent;
import org.yaml.snakeyaml.parser.Parser;
import org.yaml.snakeyaml.parser.ParserImpl;
import org.yaml.snakeyaml.reader.StreamReader;

/** The lines of a YAML text that go on with what began on one above, and what all of it says. */
final class YamlLines {

  private final BitSet inside = new BitSet();
  private final BitSet ends = new BitSet();
  private final List<String> values = new ArrayList<>();
  private final Set<String> anchors = new HashSet<>();
  private AliasEvent undefined;
  private final int count;
  private boolean endsInText;

  private YamlLines(int count) {
    this.count = count;
  }

  /** Splits a text into lines, each with its break; the last one may be empty. */
  static List<String> split(String text) {
    return List.of(text.split("(?<=\\n)|(?<=\\r)(?!\\n)", -1));
  }

  /** Reads a text; empty if it is no YAML, or has separators that end a line only in some. */
  static Optional<YamlLines> of(String text, int count) {
    if (text.chars().anyMatch(c -> c == '\u0085' || c == '\u2028' || c == '\u2029')) {
      return Optional.empty();
    }
    YamlLines lines = new YamlLines(count);
    try {
      LoaderOptions options = new LoaderOptions();
      options.setCodePointLimit(Document.LONGEST);
      lines.read(new ParserImpl(new StreamReader(text), options));
      return Optional.of(lines);
    } catch (YAMLException e) {
      return Optional.empty();
    }
  }

  private void read(Parser parser) {
    Deque<Event> open = new ArrayDeque<>();
    for (Event e = parser.getEvent(); e != null; e = parser.getEvent()) {
      values.add(described(e));
      readName(e);
      if (e instanceof CollectionStartEvent) {
        open.push(e);
      } else if (e.is(Event.ID.SequenceEnd) || e.is(Event.ID.MappingEnd)) {
        CollectionStartEvent start = (CollectionStartEvent) open.pop();
        if (start.isFlow()) {
          inside.set(line(start) + 1, Math.max(line(start), e.getEndMark().getLine()) + 1);
        }
      } else if (e instanceof ScalarEvent scalar) {
        read(scalar);
      }
      if (e.is(Event.ID.StreamEnd)) {
        return;
      }
    }
  }

  /** Keeps an anchor, or the first alias that has none in front of it in its document. */
  private void readName(Event event) {
    if (event instanceof DocumentStartEvent) {
      anchors.clear();
    } else if (event instanceof AliasEvent alias) {
      boolean isFirst = undefined == null && !anchors.contains(alias.getAnchor());
      undefined = isFirst ? alias : undefined;
    } else if (event instanceof NodeEvent node && node.getAnchor() != null) {
      anchors.add(node.getAnchor());
    }
  }

  private static int line(Event event) {
    return event.getStartMark().getLine();
  }

  private void read(ScalarEvent scalar) {
    boolean isBlock =
        scalar.getScalarStyle() == ScalarStyle.LITERAL
            || scalar.getScalarStyle() == ScalarStyle.FOLDED;
    int first = line(scalar);
    int last = scalar.getEndMark().getLine();
    if (isBlock) {
      boolean atStart = scalar.getEndMark().getColumn() == 0;
      last = atStart ? last - 1 : last;
      ends.set(first + 1, Math.max(first, last) + 1);
      endsInText |= last >= count - 2;
    } else if (!scalar.isPlain()) {
      ends.set(first, Math.max(first, last));
    }
    inside.set(first + 1, Math.max(first, last) + 1);
  }

  /** Returns what an event says, without its place. */
  private static String described(Event event) {
    return event instanceof ScalarEvent scalar
        ? scalar.getAnchor() + scalar.getTag() + scalar.getScalarStyle() + scalar.getValue()
        : event instanceof CollectionStartEvent start
            ? event.getEventId() + start.getAnchor() + start.getTag() + start.isFlow()
            : event.toString();
  }

  /** Returns what the text says, in its order, with anchors and styles. */
  List<String> values() {
    return values;
  }

  /** Returns the first alias of something that is not in front of it; empty if there is none. */
  Optional<AliasEvent> undefinedAlias() {
    return Optional.ofNullable(undefined);
  }

  /** Returns whether a line goes on with what began above. */
  boolean isInside(int line) {
    return inside.get(line);
  }

  /** Returns whether spaces at the end of a line may belong to a value. */
  boolean keepsEnd(int line) {
    return ends.get(line);
  }

  /** Returns whether the last lines belong to a text in lines, so that they are part of a value. */
  boolean endsInText() {
    return endsInText;
  }
}
