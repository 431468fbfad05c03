package dev.eventchain.project;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.ObjectReader;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/**
 * Reader of the files in which people write down decisions: a YAML list whose entries have texts
 * and a day. All findings are of one rule.
 */
public final class DatedEntries {

  private final Rule rule;
  private final List<Diagnostic> problems = new ArrayList<>();

  private DatedEntries(Rule rule) {
    this.rule = rule;
  }

  /**
   * Reads a file; one that is empty or has only comments has no entries.
   *
   * @param reader creates the value of an entry from its keys; other keys are findings
   * @throws DiagnosticException INPUT if the file cannot be read, or with all invalid entries
   */
  public static <T> List<T> read(Path file, Rule rule, Function<Entry, T> reader) {
    DatedEntries entries = new DatedEntries(rule);
    List<T> values = entries.read(SourceText.read(file), reader);
    if (!entries.problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, entries.problems);
    }
    return values;
  }

  private <T> List<T> read(SourceText text, Function<Entry, T> reader) {
    List<T> values = new ArrayList<>();
    Document.parseIfAny(text, DocumentFormat.YAML, DocumentRules.all(rule), problems::add)
        .map(document -> document.objects(problems::add))
        .orElse(List.of())
        .forEach(
            part -> {
              values.add(reader.apply(new Entry(part, rule)));
              part.refuseOthers();
            });
    return values;
  }

  /** An entry; what is wrong in it is a finding, with which the file is not read. */
  public static final class Entry {

    /** A text that nobody sees, since the file is not read. */
    private static final String ANY = "?";

    private final ObjectReader part;
    private final Rule rule;

    private Entry(ObjectReader part, Rule rule) {
      this.part = part;
      this.rule = rule;
    }

    /** Returns a text without space around it; any, with a finding, if it is missing or empty. */
    public String text(String key) {
      String written = part.requiredText(key).strip();
      return written.isEmpty() ? ANY : written;
    }

    /** Returns a text without space around it; empty if it is missing. */
    public String optionalText(String key) {
      return part.text(key).map(String::strip).orElse("");
    }

    /** Returns a day; any, with a finding, if it is missing or not a date. */
    public LocalDate day(String key) {
      String written = part.requiredText(key).strip();
      try {
        return written.isEmpty() ? LocalDate.EPOCH : LocalDate.parse(written);
      } catch (DateTimeException e) {
        refuse(key, "'" + written + "' is not a date; write it as 2027-03-31.");
        return LocalDate.EPOCH;
      }
    }

    /** Adds a finding about the value of a key. */
    public void refuse(String key, String message) {
      part.find(rule, message, part.at(key));
    }

    public SourceLocation location() {
      return part.location();
    }
  }
}
