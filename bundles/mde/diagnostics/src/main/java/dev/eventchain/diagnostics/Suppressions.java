package dev.eventchain.diagnostics;

import java.time.LocalDate;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Findings that people have decided to live with for a while, each with a reason and an expiry
 * date. A suppressed finding does not make a command fail, and stays visible in the reports.
 * Immutable.
 */
public final class Suppressions {

  /** Nothing is suppressed. */
  public static final Suppressions NONE = new Suppressions(List.of(), LocalDate.EPOCH);

  /** What says that something was not checked or not proved would otherwise pass for a proof. */
  private static final Set<String> NEVER =
      Set.of(
          "eventchain.defect",
          "ocl.limit",
          "ocl.nothing-evaluated",
          "ocl.type",
          "ocl.not-boolean",
          "project.model.missing",
          "simulation.criterion.failed");

  private final List<Entry> entries;
  private final LocalDate today;

  /**
   * Suppressions as of a day.
   *
   * @param today the day on which they are judged, which is an input so that equal inputs give
   *     equal results
   */
  public Suppressions(List<Entry> entries, LocalDate today) {
    this.entries = List.copyOf(entries);
    this.today = today;
  }

  /**
   * Which findings are suppressed, why, and until when. In all parts but the id and the reason,
   * {@code *} stands for any characters, and what is empty matches everything.
   *
   * @param id the id of the findings
   * @param rule the user's rule that found them
   * @param element the element that they are about
   * @param file the file that they are in; a file's last parts are enough
   * @param message their message
   * @param reason why that is right
   * @param expires the last day on which it is
   * @param location where the entry is
   */
  public record Entry(
      String id,
      String rule,
      String element,
      String file,
      String message,
      String reason,
      LocalDate expires,
      SourceLocation location) {

    /** Refuses nulls, and an entry without a reason. */
    public Entry {
      Objects.requireNonNull(id);
      Objects.requireNonNull(expires);
      Objects.requireNonNull(location);
      if (reason.isBlank()) {
        throw new IllegalArgumentException("an entry needs a reason");
      }
    }

    /** Whether the finding is one of those meant, the day apart. */
    public boolean matches(Diagnostic finding) {
      return finding.id().equals(id)
          && like(rule, finding.rule())
          && like(element, finding.location().element())
          && isIn(finding.location().file())
          && like(message, finding.message());
    }

    /**
     * Whether all findings that it is about would have been found by these checks: those of the
     * same kind ({@code ocl.undefined} comes of the checks for {@code ocl.violated}), in the files
     * that were checked.
     */
    private boolean isAboutChecksOf(Coverage coverage) {
      return coverage.checks().stream().anyMatch(check -> kindOf(check.id()).equals(kindOf(id)))
          && coverage.files().stream().anyMatch(this::isIn);
    }

    private static String kindOf(String id) {
      return id.replaceFirst("\\..*", "");
    }

    private boolean isIn(String name) {
      return like(file, name) || like("*/" + file, name);
    }

    private static boolean like(String pattern, String text) {
      if (pattern.isEmpty()) {
        return true;
      }
      String expression =
          Arrays.stream(pattern.split("\\*", -1))
              .map(Pattern::quote)
              .collect(Collectors.joining(".*"));
      return Pattern.compile(expression, Pattern.DOTALL).matcher(text).matches();
    }
  }

  /**
   * A finding that is suppressed.
   *
   * @param by the entry that says so, the first of several
   */
  public record Suppressed(Diagnostic finding, Entry by) {}

  /**
   * Findings, parted.
   *
   * @param remaining those that count
   * @param suppressed those that do not
   */
  public record Parted(List<Diagnostic> remaining, List<Suppressed> suppressed) {}

  /** Whether findings of this id may be suppressed at all. */
  public static boolean mayBeSuppressed(String id) {
    return !NEVER.contains(id)
        && !id.endsWith(".syntax")
        && !id.startsWith("suppression.")
        && !id.startsWith("report.");
  }

  /** The entries that count on the day. */
  public List<Entry> inForce() {
    return entries.stream().filter(entry -> !isExpired(entry)).toList();
  }

  /** Whether a finding is suppressed. */
  public boolean accepts(Diagnostic finding) {
    return entryFor(finding).isPresent();
  }

  /** Parts the findings into those that count and those that do not, each in the order given. */
  public Parted part(List<Diagnostic> findings) {
    List<Diagnostic> remaining = new ArrayList<>();
    List<Suppressed> suppressed = new ArrayList<>();
    for (Diagnostic finding : findings) {
      entryFor(finding)
          .ifPresentOrElse(
              entry -> suppressed.add(new Suppressed(finding, entry)),
              () -> remaining.add(finding));
    }
    return new Parted(remaining, suppressed);
  }

  private Optional<Entry> entryFor(Diagnostic finding) {
    if (!mayBeSuppressed(finding.id())) {
      return Optional.empty();
    }
    return entries.stream()
        .filter(entry -> !isExpired(entry) && entry.matches(finding))
        .findFirst();
  }

  private boolean isExpired(Entry entry) {
    return today.isAfter(entry.expires);
  }

  /**
   * Warnings about the entries themselves: those that have expired, and those that match nothing
   * any more. The latter needs the findings of an entry to have been looked for.
   *
   * @param findings everything that was found, whether suppressed or not
   * @param coverage the checks that ran; an entry about others is not judged
   * @param complete whether everything was looked for, so that each entry can be judged
   */
  public List<Diagnostic> warnings(List<Diagnostic> findings, Coverage coverage, boolean complete) {
    List<Diagnostic> warnings = new ArrayList<>();
    for (Entry entry : entries) {
      if (isExpired(entry)) {
        warnings.add(expired(entry));
      }
    }
    for (Entry entry : entries) {
      boolean judged = !isExpired(entry) && (complete || entry.isAboutChecksOf(coverage));
      if (judged && findings.stream().noneMatch(entry::matches)) {
        warnings.add(stale(entry));
      }
    }
    return warnings;
  }

  private static Diagnostic expired(Entry entry) {
    return Diagnostic.warning(
            "suppression.expired",
            "The suppression of " + entry.id + " expired on " + entry.expires + ".",
            entry.location)
        .withHint("Fix what it suppressed, or review the decision and set a new date.");
  }

  private static Diagnostic stale(Entry entry) {
    return Diagnostic.warning(
            "suppression.stale",
            "The suppression of " + entry.id + " matches no finding.",
            entry.location)
        .withHint("Delete it: what it suppressed is fixed or has been renamed.");
  }
}
