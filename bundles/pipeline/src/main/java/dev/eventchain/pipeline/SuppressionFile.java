package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.Suppressions;
import java.io.StringReader;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.error.Mark;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.NodeTuple;
import org.yaml.snakeyaml.nodes.ScalarNode;
import org.yaml.snakeyaml.nodes.SequenceNode;
import org.yaml.snakeyaml.nodes.Tag;

/**
 * Reads the findings that people have decided to live with: a YAML list of entries with {@code id},
 * {@code reason} and {@code expires}, and, to narrow them, {@code rule}, {@code element}, {@code
 * file} and {@code message}.
 */
public final class SuppressionFile {

  private static final String INVALID = "suppression.invalid";
  private static final List<String> REQUIRED = List.of("id", "reason", "expires");
  private static final List<String> KEYS =
      List.of("id", "rule", "element", "file", "message", "reason", "expires");

  private final SourceText text;
  private final List<Diagnostic> problems = new ArrayList<>();
  private final List<Suppressions.Entry> entries = new ArrayList<>();

  private SuppressionFile(SourceText text) {
    this.text = text;
  }

  /**
   * Reads a file.
   *
   * @param today the day on which the entries are judged
   * @throws DiagnosticException INPUT if it cannot be read, or with every entry that is not
   *     understood ({@code suppression.invalid})
   */
  public static Suppressions read(Path file, LocalDate today) {
    SuppressionFile reader = new SuppressionFile(SourceText.read(file));
    reader.readAll();
    if (!reader.problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, reader.problems);
    }
    return new Suppressions(reader.entries, today);
  }

  private void readAll() {
    LoaderOptions options = new LoaderOptions();
    options.setMaxAliasesForCollections(0);
    try {
      Node root = new Yaml(options).compose(new StringReader(text.text()));
      if (root instanceof SequenceNode list) {
        list.getValue().forEach(this::readEntry);
      } else if (root != null) {
        problem("The file must be a list of suppressions.", root.getStartMark());
      }
    } catch (MarkedYAMLException e) {
      problem("This is no YAML: " + e.getProblem() + ".", e.getProblemMark());
    } catch (YAMLException e) {
      problem("This is no YAML: " + e.getMessage(), null);
    }
  }

  private void readEntry(Node node) {
    if (!(node instanceof MappingNode mapping)) {
      problem("An entry must have keys.", node.getStartMark());
      return;
    }
    int before = problems.size();
    Map<String, ScalarNode> values = new LinkedHashMap<>();
    mapping.getValue().forEach(tuple -> readKey(tuple, values));
    for (String key : REQUIRED) {
      boolean blank = values.containsKey(key) && values.get(key).getValue().isBlank();
      if (blank || (!values.containsKey(key) && problems.size() == before)) {
        Mark mark = blank ? values.get(key).getStartMark() : node.getStartMark();
        problem("A suppression needs '" + key + "'.", mark);
      }
    }
    if (problems.size() == before) {
      add(values, node.getStartMark());
    }
  }

  private void readKey(NodeTuple tuple, Map<String, ScalarNode> values) {
    Mark mark = tuple.getKeyNode().getStartMark();
    String key = tuple.getKeyNode() instanceof ScalarNode scalar ? scalar.getValue() : "";
    if (!KEYS.contains(key)) {
      problems.add(
          Diagnostic.error(INVALID, "There is no key '" + key + "' here.", at(mark))
              .withHint(NearestName.hint(key, KEYS)));
    } else if (!(tuple.getValueNode() instanceof ScalarNode value)
        || value.getTag().equals(Tag.NULL)) {
      problem("The key '" + key + "' needs a text.", mark);
    } else if (values.putIfAbsent(key, value) != null) {
      problem("The key '" + key + "' stands here a second time.", mark);
    }
  }

  private void add(Map<String, ScalarNode> values, Mark start) {
    String id = values.get("id").getValue();
    if (!Suppressions.mayBeSuppressed(id)) {
      problem("Findings of " + id + " cannot be suppressed.", values.get("id").getStartMark());
      return;
    }
    try {
      entries.add(
          new Suppressions.Entry(
              id,
              text(values, "rule"),
              text(values, "element"),
              text(values, "file"),
              text(values, "message"),
              text(values, "reason"),
              LocalDate.parse(text(values, "expires")),
              at(start)));
    } catch (DateTimeException e) {
      problem(
          "'" + text(values, "expires") + "' is no day; write it as 2027-03-31.",
          values.get("expires").getStartMark());
    }
  }

  private static String text(Map<String, ScalarNode> values, String key) {
    return values.containsKey(key) ? values.get(key).getValue().strip() : "";
  }

  private void problem(String message, Mark mark) {
    problems.add(Diagnostic.error(INVALID, message, at(mark)));
  }

  private SourceLocation at(Mark mark) {
    return mark == null
        ? SourceLocation.of(text.name())
        : text.at(mark.getLine() + 1, mark.getColumn() + 1);
  }
}
