package dev.eventchain.project;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.FindingIds;
import dev.eventchain.documents.ObjectReader;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Reader of suppressions. The file is a YAML list of entries with {@code id}, {@code reason} and
 * {@code expires}, optionally narrowed by {@code rule}, {@code element}, {@code file} and {@code
 * message}.
 */
public final class SuppressionFile {

  private static final String INVALID = "suppression.invalid";

  private final List<Diagnostic> problems = new ArrayList<>();

  private SuppressionFile() {}

  /**
   * Reads a file.
   *
   * @param today the reference date for expiry
   * @throws DiagnosticException INPUT if it cannot be read, or with all invalid entries as {@code
   *     suppression.invalid}
   */
  public static Suppressions read(Path file, LocalDate today) {
    SuppressionFile reader = new SuppressionFile();
    List<Suppressions.Entry> entries = reader.entries(SourceText.read(file));
    if (!reader.problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, reader.problems);
    }
    return new Suppressions(entries, today);
  }

  /** Returns the entries; none if the file is empty or has only comments. */
  private List<Suppressions.Entry> entries(SourceText text) {
    List<Suppressions.Entry> entries = new ArrayList<>();
    Document.parseIfAny(text, DocumentFormat.YAML, FindingIds.all(INVALID), problems::add)
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
    if (!id.isEmpty() && !Suppressions.mayBeSuppressed(id)) {
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
