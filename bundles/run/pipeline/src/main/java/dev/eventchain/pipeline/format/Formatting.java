package dev.eventchain.pipeline.format;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.documents.AtomicFile;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.project.ProjectFolder;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * Formatting of constraints, templates and YAML, which never changes what they say, as editors have
 * it from the language server. A file that cannot be read is left as it is, with a finding.
 */
public final class Formatting {

  /** The usual width of one level of indentation. */
  public static final int COLUMNS = 2;

  private static final String BYTE_ORDER_MARK = "\uFEFF";

  private final int columns;
  private final boolean writes;
  private final List<Diagnostic> found = new ArrayList<>();
  private final List<Path> changed = new ArrayList<>();

  private Formatting(int columns, boolean writes) {
    this.columns = columns;
    this.writes = writes;
  }

  /**
   * The result of formatting.
   *
   * @param files all files that were looked at, as they are named
   * @param changed those that were written
   */
  public record Result(List<Path> files, List<Path> changed, List<Diagnostic> found) {}

  /**
   * Formats files.
   *
   * @param named files, and folders of which all are meant that people write
   * @param columns the width of one level of indentation, at least 1
   * @param writes false if a file that would change is only a finding
   * @throws DiagnosticException INPUT if there is no file or folder of a name
   */
  public static Result of(List<Path> named, int columns, boolean writes) {
    Formatting formatting = new Formatting(columns, writes);
    List<Path> files = FormattedFiles.of(named, formatting.found);
    files.forEach(formatting::format);
    return new Result(files, formatting.changed, formatting.found);
  }

  /**
   * Returns the outcome, in which each finding is accepted by the suppressions of its own project.
   *
   * @param suppressions those of a project, or of files of no project; the same object for all of
   *     them if somebody has named it
   */
  public static Outcome outcome(
      Result result, Function<Optional<ProjectFolder>, Suppressions> suppressions) {
    Map<Optional<Path>, Suppressions> known = new HashMap<>();
    Function<String, Suppressions> of =
        file ->
            project(Path.of(file))
                .map(
                    it ->
                        known.computeIfAbsent(place(it), to -> suppressions.apply(Optional.of(it))))
                .orElseGet(
                    () ->
                        known.computeIfAbsent(
                            Optional.empty(), to -> suppressions.apply(Optional.empty())));
    Map<Suppressions, Part> parts = new LinkedHashMap<>();
    for (Path file : result.files()) {
      parts.computeIfAbsent(of.apply(file.toString()), Part::new).files.add(file.toString());
    }
    for (Diagnostic each : result.found()) {
      parts.computeIfAbsent(of.apply(each.location().file()), Part::new).found.add(each);
    }
    return parts.values().stream()
        .map(Part::outcome)
        .reduce(Outcome::and)
        .orElseGet(() -> Outcome.of(Coverage.NONE, List.of(), Suppressions.NONE));
  }

  /** Returns the project of a file, from the current folder if the file is named from there. */
  private static Optional<ProjectFolder> project(Path file) {
    Path here = Path.of("").toAbsolutePath();
    return FormattedFiles.project(file)
        .map(
            it ->
                it.folder().isAbsolute() && !file.isAbsolute()
                    ? here.relativize(it.folder())
                    : it.folder())
        .map(ProjectFolder::new);
  }

  private static Optional<Path> place(ProjectFolder project) {
    return Optional.of(project.folder().toAbsolutePath().normalize());
  }

  /** Files under the same suppressions, and what was found about them. */
  private record Part(Suppressions suppressions, List<String> files, List<Diagnostic> found) {

    Part(Suppressions suppressions) {
      this(suppressions, new ArrayList<>(), new ArrayList<>());
    }

    Outcome outcome() {
      return Outcome.of(new Coverage(files, 0, List.of()), found, suppressions);
    }
  }

  private void format(Path file) {
    TextFormat format = TextFormat.of(file).orElseThrow();
    SourceText source;
    try {
      source = SourceText.read(file);
    } catch (DiagnosticException e) {
      found.addAll(e.diagnostics());
      return;
    }
    Optional<String> formatted = format.format(source.text(), columns, true);
    if (formatted.isEmpty()) {
      found.add(unformatted(format, file, source));
    } else if (!formatted.get().equals(source.text())) {
      if (writes) {
        write(file, source.text(), formatted.get());
      } else {
        found.add(differing(file, source, formatted.get()));
      }
    }
  }

  private static Diagnostic unformatted(TextFormat format, Path file, SourceText source) {
    return format
        .syntaxError(source)
        .map(
            error ->
                Diagnostic.of(
                        FormatRules.SYNTAX,
                        "The file is left as it is, since it cannot be read: " + error.message(),
                        error.location())
                    .withHint(error.hint()))
        .orElseGet(
            () ->
                Diagnostic.of(
                        FormatRules.SKIPPED,
                        "The file is left as it is, since it has something that is not formatted.",
                        SourceLocation.of(file))
                    .withHint("'eventchain explain format.skipped' lists what that may be."));
  }

  private Diagnostic differing(Path file, SourceText source, String formatted) {
    String text = source.text();
    int shorter = Math.min(text.length(), formatted.length());
    int same = 0;
    while (same < shorter && text.charAt(same) == formatted.charAt(same)) {
      same++;
    }
    SourceLocation place = source.at(same);
    String name = file.toString().matches("[\\w./+@-]+") ? file.toString() : "\"" + file + "\"";
    String indent = columns == COLUMNS ? "" : "--indent " + columns + " ";
    return Diagnostic.of(
            FormatRules.DIFFERS, "The file is not formatted, from this line on.", place)
        .withHint("Run 'eventchain format " + indent + name + "'.");
  }

  /** Writes a file as a whole, if it is still as it was read. */
  private void write(Path file, String before, String after) {
    try {
      Path real = file.toRealPath();
      String present = new String(Files.readAllBytes(real), StandardCharsets.UTF_8);
      String mark = present.startsWith(BYTE_ORDER_MARK) ? BYTE_ORDER_MARK : "";
      if (!Files.isWritable(real)) {
        throw new IOException("it is read-only");
      } else if (present.equals(mark + after)) {
        return; // by another one at the same time
      } else if (!present.equals(mark + before)) {
        throw new IOException("it has changed meanwhile");
      }
      AtomicFile.write(real, mark + after);
      changed.add(file);
    } catch (IOException e) {
      found.add(
          Diagnostic.of(
              FormatRules.UNWRITABLE,
              "The formatted file cannot be written: " + SourceText.reason(e) + ".",
              SourceLocation.of(file)));
    }
  }
}
