package dev.eventchain.diagnostics.format;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Findings for a screen: each cause once, with its consequences, and of each rule the first few.
 *
 * @param shown the findings that are shown, in their order
 * @param more the number of the others by id and rule
 */
public record FindingExcerpt(List<Shown> shown, Map<String, Integer> more) {

  /**
   * A finding that is shown.
   *
   * @param consequences the findings that are folded, since they are consequences of it
   */
  public record Shown(Diagnostic finding, List<Diagnostic> consequences) {

    /** Copies the list. */
    public Shown {
      consequences = List.copyOf(consequences);
    }

    /** Returns the number and the names of the consequences; empty without any. */
    public String words() {
      if (consequences.isEmpty()) {
        return "";
      }
      List<String> names =
          consequences.stream().map(each -> each.cause().orElseThrow().consequence()).toList();
      return Coverage.counted(names.size(), "consequence") + ": " + String.join("; ", names);
    }
  }

  /** Copies the list. */
  public FindingExcerpt {
    shown = List.copyOf(shown);
  }

  /**
   * Returns an excerpt. A finding is folded under its cause if that is among the findings and not
   * less severe: a suppressed one is not, and something else may have been found at its place.
   *
   * @param mostOfOneRule the largest number of findings of one rule that are shown
   */
  public static FindingExcerpt of(List<Diagnostic> findings, int mostOfOneRule) {
    Map<SourceLocation, List<Diagnostic>> consequences = causes(findings);
    List<Diagnostic> separate = new ArrayList<>();
    for (Diagnostic finding : findings) {
      finding
          .cause()
          .map(cause -> consequences.get(cause.location()))
          .orElse(separate)
          .add(finding);
    }
    List<Shown> shown = new ArrayList<>();
    Map<String, Integer> count = new HashMap<>();
    Map<String, Integer> more = new LinkedHashMap<>();
    for (Diagnostic finding : separate) {
      List<Diagnostic> known =
          finding.severity() == Severity.ERROR ? consequences.remove(finding.location()) : null;
      List<Diagnostic> folded = known == null ? List.of() : known;
      if (count.merge(ruleOf(finding), 1, Integer::sum) <= mostOfOneRule) {
        shown.add(new Shown(finding, folded));
      } else {
        more.merge(ruleOf(finding), 1, Integer::sum);
        folded.forEach(each -> more.merge(ruleOf(each), 1, Integer::sum));
      }
    }
    return new FindingExcerpt(shown, more);
  }

  /** Returns the places of findings that others may be folded under, with nothing folded yet. */
  private static Map<SourceLocation, List<Diagnostic>> causes(List<Diagnostic> findings) {
    Map<SourceLocation, List<Diagnostic>> causes = new HashMap<>();
    for (Diagnostic finding : findings) {
      if (finding.cause().isEmpty() && finding.severity() == Severity.ERROR) {
        causes.put(finding.location(), new ArrayList<>());
      }
    }
    return causes;
  }

  /** Returns the id of a finding, and the user's rule that found it. */
  public static String ruleOf(Diagnostic finding) {
    String rule = finding.rule().isEmpty() ? "" : " " + Printable.lines(finding.rule());
    return finding.id() + rule;
  }
}
