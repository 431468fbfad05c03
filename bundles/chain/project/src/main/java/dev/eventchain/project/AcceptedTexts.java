package dev.eventchain.project;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Sha256;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.WrittenRequirement;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/**
 * The texts of requirements for which people have looked at the evidence: a YAML list of entries
 * with {@code requirement}, {@code text}, {@code by} and {@code on}, in version control.
 *
 * @param entries in the order of the file
 */
public record AcceptedTexts(List<Entry> entries) {

  private static final String HEAD =
      """
      # The texts of requirements.md for which somebody has looked at the scenarios and constraints that prove them.
      # 'eventchain accept' writes this file; keep it in version control.
      """;

  /**
   * An accepted text.
   *
   * @param requirement the id
   * @param text the fingerprint of the text, see {@link #fingerprint}
   * @param by who has accepted it
   * @param on the day, in UTC
   */
  public record Entry(
      String requirement, String text, String by, LocalDate on, SourceLocation location) {}

  /** Copies the list. */
  public AcceptedTexts {
    entries = List.copyOf(entries);
  }

  /**
   * Reads a file.
   *
   * @throws DiagnosticException INPUT with all invalid entries ({@code project.accepted})
   */
  public static AcceptedTexts read(Path file) {
    return new AcceptedTexts(
        DatedEntries.read(
            file,
            ProjectRules.PROJECT_ACCEPTED,
            part ->
                new Entry(
                    part.text("requirement"),
                    part.text("text"),
                    part.text("by"),
                    part.day("on"),
                    part.location())));
  }

  /** Returns the fingerprint of a text, in which only white space does not count. */
  public static String fingerprint(String text) {
    return Sha256.of(text.strip().replaceAll("\\s+", " ")).hex();
  }

  /** Returns the last entry of a requirement. */
  public Optional<Entry> find(String requirement) {
    return entries.stream()
        .filter(each -> each.requirement().equals(requirement))
        .reduce((earlier, later) -> later);
  }

  /**
   * Returns a copy in which the current texts of some requirements are accepted, in the order of
   * the requirements. Entries of requirements that no longer exist are left out.
   *
   * @param ids those to accept; the others keep their entries, if they have any
   */
  public AcceptedTexts accepting(
      List<WrittenRequirement> requirements, Collection<String> ids, String by, LocalDate on) {
    List<Entry> all = new ArrayList<>();
    for (WrittenRequirement item : requirements) {
      String text = fingerprint(item.text());
      Optional<Entry> known = find(item.id());
      boolean stays =
          !ids.contains(item.id()) || known.filter(e -> e.text().equals(text)).isPresent();
      if (stays) {
        known.ifPresent(all::add);
      } else {
        all.add(new Entry(item.id(), text, by, on, SourceLocation.NONE));
      }
    }
    return new AcceptedTexts(all);
  }

  /** Returns the content of the file. */
  public String toYaml() {
    StringBuilder yaml = new StringBuilder(HEAD);
    for (Entry entry : entries) {
      yaml.append("- requirement: ").append(quoted(entry.requirement())).append('\n');
      yaml.append("  text: ").append(entry.text()).append('\n');
      yaml.append("  by: ").append(quoted(entry.by())).append('\n');
      yaml.append("  on: ").append(entry.on()).append('\n');
    }
    return entries.isEmpty() ? yaml.append("[]\n").toString() : yaml.toString();
  }

  private static String quoted(String text) {
    return "'" + text.replace("'", "''") + "'";
  }
}
