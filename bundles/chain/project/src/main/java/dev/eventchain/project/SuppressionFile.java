package dev.eventchain.project;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.ResourceText;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.RulePage;
import dev.eventchain.diagnostics.Suppressions;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * Reader of suppressions. The file is a YAML list of entries with {@code id}, {@code reason} and
 * {@code expires}, optionally narrowed by {@code rule}, {@code element}, {@code file} and {@code
 * message}.
 */
public final class SuppressionFile {

  private static final Rule INVALID = ProjectRules.SUPPRESSION_INVALID;

  private SuppressionFile() {}

  /** Returns the JSON Schema of the file. */
  public static String schema() {
    return ResourceText.of(SuppressionFile.class, "suppressions.schema.json");
  }

  /** As {@link #read(Path, LocalDate, Function)} with the pages on the class path. */
  public static Suppressions read(Path file, LocalDate today) {
    return read(file, today, RulePage::of);
  }

  /**
   * Reads a file.
   *
   * @param today the reference date for expiry
   * @param pages returns the page about an id, which tells whether its findings may be suppressed
   * @throws DiagnosticException INPUT if it cannot be read, or with all invalid entries as {@code
   *     suppression.invalid}
   */
  public static Suppressions read(
      Path file, LocalDate today, Function<String, Optional<RulePage>> pages) {
    Map<String, Optional<RulePage>> known = new HashMap<>(); // many entries are about one id
    return new Suppressions(
        DatedEntries.read(
            file, INVALID, entry -> entry(entry, id -> known.computeIfAbsent(id, pages))),
        today);
  }

  private static Suppressions.Entry entry(
      DatedEntries.Entry entry, Function<String, Optional<RulePage>> pages) {
    String id = entry.text("id");
    if (pages.apply(id).filter(page -> !page.mayBeSuppressed()).isPresent()) {
      entry.refuse("id", "Findings of " + id + " cannot be suppressed.");
    }
    return new Suppressions.Entry(
        id,
        entry.optionalText("rule"),
        entry.optionalText("element"),
        entry.optionalText("file"),
        entry.optionalText("message"),
        entry.text("reason"),
        entry.day("expires"),
        entry.location().withElement(""));
  }
}
