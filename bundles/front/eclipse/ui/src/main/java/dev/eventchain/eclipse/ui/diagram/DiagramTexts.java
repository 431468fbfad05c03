package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.diagnostics.Printable;
import dev.eventchain.model.ComponentUnits;
import dev.eventchain.model.diagram.ChainDiagram;
import dev.eventchain.model.diagram.ChainDiagram.Box;
import dev.eventchain.model.diagram.ChainDiagram.Kind;
import dev.eventchain.model.diagram.ChainDiagram.Line;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.eclipse.emf.ecore.EObject;

/** Descriptions of boxes for tooltips and screen readers. */
final class DiagramTexts {

  private static final int MOST_LINES = 12;

  private DiagramTexts() {}

  /** Returns a sentence without a full stop, for screen readers. */
  static String describe(ChainDiagram diagram, int index, List<String> problems) {
    Box box = diagram.boxes().get(index);
    StringBuilder text = new StringBuilder(kind(box)).append(' ').append(name(box));
    if (!box.facts().isEmpty()) {
      text.append(", ").append(box.facts().replace(" \u00b7", ","));
    }
    problems.forEach(problem -> text.append(", ").append(problem));
    return text.toString();
  }

  private static String kind(Box box) {
    return switch (box.kind()) {
      case COMPONENT -> "component";
      case TOPIC -> "topic";
      case SIGNAL_IN -> "signal from outside";
      case SIGNAL_OUT -> "signal to outside";
    };
  }

  private static String name(Box box) {
    return box.name().isEmpty() ? "without a name" : box.name();
  }

  /** Returns the lines of a tooltip. */
  static String tooltip(ChainDiagram diagram, int index, List<String> problems) {
    Box box = diagram.boxes().get(index);
    List<String> lines = new ArrayList<>();
    lines.add(name(box));
    if (!box.facts().isEmpty()) {
      lines.add(box.facts());
    }
    if (box.element() instanceof SoftwareNode node) {
      add(lines, "", node.getDescription());
    } else {
      addTopic(lines, diagram, index);
    }
    problems.stream().limit(MOST_LINES).forEach(problem -> lines.add("\u26a0 " + problem));
    // A mnemonic would consume the ampersand.
    return String.join("\n", lines).replace("&", "&&");
  }

  private static void addTopic(List<String> lines, ChainDiagram diagram, int index) {
    Box box = diagram.boxes().get(index);
    List<String> writers = new ArrayList<>();
    List<String> readers = new ArrayList<>();
    for (Line line : diagram.lines()) {
      if (line.to() == index) {
        writers.add(name(diagram.boxes().get(line.from())));
      }
      if (line.from() == index) {
        readers.add(name(diagram.boxes().get(line.to())));
      }
    }
    lines.add("From: " + (box.kind() == Kind.SIGNAL_IN ? "outside" : list(writers)));
    lines.add("To: " + (box.kind() == Kind.SIGNAL_OUT ? "outside" : list(readers)));
    Set<String> fields = new LinkedHashSet<>();
    for (EObject element : box.elements()) {
      if (element instanceof Data data && data.getName() != null) {
        add(fields, data.getName() + unit(data), data.getDescription());
      }
    }
    fields.stream().limit(MOST_LINES).forEach(lines::add);
    if (fields.size() > MOST_LINES) {
      lines.add("\u2026 and " + (fields.size() - MOST_LINES) + " more");
    }
  }

  /** Returns the unit in messages, and that of the component if the node converts. */
  private static String unit(Data data) {
    String own = ComponentUnits.isConverted(data) ? ComponentUnits.of(data) : "";
    String unit = ComponentUnits.onTheWire(data);
    String both = unit.isEmpty() || own.isEmpty() ? unit : unit + ", " + own + " in the component";
    return both.isEmpty() ? "" : " [" + both + "]";
  }

  private static String list(List<String> names) {
    String more = names.size() > MOST_LINES ? ", \u2026" : "";
    return String.join(", ", names.stream().limit(MOST_LINES).toList()) + more;
  }

  private static void add(Collection<String> lines, String title, String text) {
    String shown = text == null ? "" : Printable.line(text);
    if (!title.isEmpty() || !shown.isEmpty()) {
      String between = title.isEmpty() || shown.isEmpty() ? "" : ": ";
      lines.add(Printable.line(title) + between + wrap(shown));
    }
  }

  /** Wraps lines, since tooltips do not. */
  private static String wrap(String text) {
    StringBuilder wrapped = new StringBuilder();
    int length = 0;
    for (String word : text.split(" ")) {
      if (length > 0 && length + word.length() > 80) {
        wrapped.append('\n');
        length = 0;
      }
      wrapped.append(length == 0 ? "" : " ").append(word);
      length += word.length() + 1;
    }
    return wrapped.toString();
  }
}
