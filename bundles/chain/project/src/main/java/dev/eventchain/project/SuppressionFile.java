package dev.eventchain.project;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.RulePage;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.ObjectReader;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * Reader of suppressions. The file is a YAML list of entries with {@code id}, {@code reason} and
 * {@code expires}, optionally narrowed by {@code rule}, {@code element}, {@code file} and {@code
 * message}.
 */
public final class SuppressionFile {

  private static final Rule INVALID = ProjectRules.SUPPRESSION_INVALID;

  private final List<Diagnostic> problems = new ArrayList<>();
  private final Function<String, Optional<RulePage>> pages;

  private SuppressionFile(Function<String, Optional<RulePage>> pages) {
    this.pages = pages;
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
    SuppressionFile reader = new SuppressionFile(pages);
    List<Suppressions.Entry> entries = reader.entries(SourceText.read(file));
    if (!reader.problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, reader.problems);
    }
    return new Suppressions(entries, today);
  }

  /** Returns the entries; none if the file is empty or has only comments. */
  private List<Suppressions.Entry> entries(SourceText text) {
    List<Suppressions.Entry> entries = new ArrayList<>();
    Document.parseIfAny(text, DocumentFormat.YAML, DocumentRules.all(INVALID), problems::add)
        .map(document -> document.objects(problems::add))
        .orElse(List.of())
        .forEach(entry -> read(entry).ifPresent(entries::add));
    return entries;
  }

  private Optional<Suppressions.Entry> read(ObjectReader entry) {
    int before = problems.size();
    String id = entry.requiredText("id").strip();
    String rule = optional(entry, "rule");
    String element = optional(entry, "element");
    String file = optional(entry, "file");
    String message = optional(entry, "message");
    String reason = entry.requiredText("reason").strip();
    Optional<LocalDate> expires = expires(entry);
    entry.refuseOthers();
    if (pages.apply(id).filter(page -> !page.mayBeSuppressed()).isPresent()) {
      entry.find(INVALID, "Findings of " + id + " cannot be suppressed.", entry.at("id"));
    }
    return problems.size() > before
        ? Optional.empty()
        : Optional.of(
            new Suppressions.Entry(
                id,
                rule,
                element,
                file,
                message,
                reason,
                expires.orElseThrow(),
                entry.location().withElement("")));
  }

  private static String optional(ObjectReader entry, String key) {
    return entry.text(key).map(String::strip).orElse("");
  }

  private static Optional<LocalDate> expires(ObjectReader entry) {
    String written = entry.requiredText("expires").strip();
    try {
      return written.isEmpty() ? Optional.empty() : Optional.of(LocalDate.parse(written));
    } catch (DateTimeException e) {
      entry.find(
          INVALID, "'" + written + "' is not a date; write it as 2027-03-31.", entry.at("expires"));
      return Optional.empty();
    }
  }
}
