package dev.eventchain.lsp.language;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.YamlFormatter;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.Workspace;
import dev.eventchain.lsp.text.Edits;
import dev.eventchain.lsp.text.Positions;
import dev.eventchain.pipeline.format.TextFormat;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import org.eclipse.lsp4j.FormattingOptions;
import org.eclipse.lsp4j.TextEdit;

/**
 * Formatting of Complete OCL, templates and the YAML of projects. What cannot be read is left as it
 * is.
 */
public final class Formatting {

  private final Workspace workspace;
  private final Edits edits;

  /** Creates the formatting of a session. */
  public Formatting(Workspace workspace, Edits edits) {
    this.workspace = workspace;
    this.edits = edits;
  }

  /**
   * Returns the edits that format lines of a text, each inside of one line.
   *
   * @param wanted tells by its number whether a line may be changed; lines are counted from 0
   */
  public List<TextEdit> of(String uri, FormattingOptions options, IntPredicate wanted) {
    Optional<Path> file = Positions.path(uri);
    Optional<SourceText> source = file.flatMap(workspace::text);
    if (source.isEmpty()) {
      return List.of();
    }
    String text = source.get().text();
    return formatted(file.get(), text, options)
        .map(it -> changes(file.get(), text, it, wanted))
        .orElse(List.of());
  }

  private static Optional<String> formatted(Path file, String text, FormattingOptions options) {
    int size = Math.max(1, Math.min(options.getTabSize(), 16));
    return TextFormat.of(file)
        .filter(it -> it != TextFormat.YAML || ProjectFolder.around(file).isPresent())
        .flatMap(it -> it.format(text, size, options.isInsertSpaces()));
  }

  private List<TextEdit> changes(Path file, String before, String after, IntPredicate wanted) {
    TextLines lines = new TextLines(before);
    List<String> old = split(before);
    List<String> formatted = split(after);
    List<TextEdit> changes = new ArrayList<>();
    StringBuilder result = new StringBuilder();
    int start = 0;
    for (int i = 0; i < Math.max(old.size(), formatted.size()); i++) {
      String line = i < old.size() ? old.get(i) : "";
      String other = i < formatted.size() ? formatted.get(i) : "";
      boolean isChanged = !line.equals(other) && wanted.test(Math.min(i, old.size() - 1));
      result.append(isChanged ? other : line);
      if (isChanged) {
        changes.add(change(file, lines, start, line, other));
      }
      start += line.length();
    }
    boolean isWhole = result.toString().equals(after);
    boolean isYaml = TextFormat.of(file).equals(Optional.of(TextFormat.YAML));
    // Lines of YAML that are moved without those around them may belong to something else.
    return isWhole || !isYaml || YamlFormatter.saysTheSame(before, result.toString())
        ? changes
        : List.of();
  }

  private TextEdit change(Path file, TextLines lines, int start, String line, String other) {
    int shorter = Math.min(line.length(), other.length());
    int same = 0;
    while (same < shorter && line.charAt(same) == other.charAt(same)) {
      same++;
    }
    int end = 0;
    while (end < shorter - same
        && line.charAt(line.length() - 1 - end) == other.charAt(other.length() - 1 - end)) {
      end++;
    }
    return new TextEdit(
        edits.range(file, lines.range(start + same, start + line.length() - end)),
        other.substring(same, other.length() - end));
  }

  private static List<String> split(String text) {
    return List.of(text.split("(?<=\\n)|(?<=\\r)(?!\\n)", -1));
  }
}
