package dev.eventchain.diagnostics;

import java.time.LocalDate;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Temporarily accepted findings, each with a reason and an expiry date. A suppressed finding does
 * not make a command fail and stays visible in the reports. Immutable.
 */
public final class Suppressions {

  /** No suppressions. */
  public static final Suppressions NONE = new Suppressions(List.of(), LocalDate.EPOCH);

  private static final Rule EXPIRED =
      Rule.warning("suppression.expired", CommonTrait.UNSUPPRESSIBLE);

  private static final Rule STALE = Rule.warning("suppression.stale", CommonTrait.UNSUPPRESSIBLE);

  private final List<Entry> entries;
  private final LocalDate today;

  /**
   * Creates suppressions as of a day.
   *
   * @param today the reference date for expiry, an input so that equal inputs give equal results
   */
  public Suppressions(List<Entry> entries, LocalDate today) {
    this.entries = List.copyOf(entries);
    this.today = today;
  }

  /**
   * A suppression: a pattern of findings, a reason and an expiry date. In all parts except id and
   * reason, {@code *} stands for any characters, and an empty pattern matches everything.
   *
   * @param id the id of the findings
   * @param rule the user's rule that found them
   * @param element the element of the findings
   * @param file the file of the findings; its last path segments suffice
   * @param message the message of the findings
   * @param reason the reason for the suppression
   * @param expires the last day of validity
   * @param location the location of the entry
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

    /** Returns whether the finding matches, regardless of expiry. */
    public boolean matches(Diagnostic finding) {
      return finding.id().equals(id)
          && like(rule, finding.rule())
          && like(element, finding.location().element())
          && isIn(finding.location().file())
          && like(message, finding.message());
    }

    /**
     * Returns whether these checks would have reported every finding that it matches. These are
     * checks of the same kind in the checked files; {@code ocl.undefined} comes from the checks for
     * {@code ocl.violated}.
     */
    private boolean isAboutChecksOf(Coverage coverage) {
      return coverage.checks().stream().anyMatch(check -> kindOf(check.id()).equals(kindOf(id)))
          && coverage.files().stream().anyMatch(this::isIn);
    }

    private static String kindOf(String id) {
      int dot = id.indexOf('.');
      return dot < 0 ? id : id.substring(0, dot);
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
   * A suppressed finding.
   *
   * @param by the first entry that matches
   */
  public record Suppressed(Diagnostic finding, Entry by) {}

  /**
   * Partition of findings.
   *
   * @param remaining the findings that are not suppressed
   * @param suppressed the suppressed findings
   */
  public record Parted(List<Diagnostic> remaining, List<Suppressed> suppressed) {}

  /** Returns the entries that have not expired. */
  public List<Entry> inForce() {
    return entries.stream().filter(entry -> !isExpired(entry)).toList();
  }

  /** Returns whether a finding is suppressed. */
  public boolean accepts(Diagnostic finding) {
    return entryFor(finding).isPresent();
  }

  /** Splits the findings into remaining and suppressed ones, each in the given order. */
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
    if (finding.kind().has(CommonTrait.UNSUPPRESSIBLE)) {
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
   * Returns warnings about entries that have expired or no longer match. An entry is only reported
   * as unmatched if checks for its findings ran.
   *
   * @param findings all findings, suppressed or not
   * @param coverage the checks that ran; entries about other checks are skipped
   * @param complete true if all checks ran, so that no entry is skipped
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
    return Diagnostic.of(
            EXPIRED,
            "The suppression of " + entry.id + " expired on " + entry.expires + ".",
            entry.location)
        .withHint("Fix what it suppressed, or review the decision and set a new date.");
  }

  private static Diagnostic stale(Entry entry) {
    return Diagnostic.of(
            STALE, "The suppression of " + entry.id + " matches no finding.", entry.location)
        .withHint("Delete it: what it suppressed is fixed or has been renamed.");
  }
}
