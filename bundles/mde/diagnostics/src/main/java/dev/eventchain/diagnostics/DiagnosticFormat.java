package dev.eventchain.diagnostics;

import java.util.List;
import java.util.Locale;

/**
 * How a report is written. Findings keep the order they are given in; lines end with LF; the same
 * report gives the same bytes.
 */
public enum DiagnosticFormat {
  /** For people: file, line and column, the message, the source line with a caret, the hint. */
  TEXT {
    @Override
    public String render(Report report) {
      return TextReport.render(report);
    }
  },
  /** For programs: an object with everything the report has; what is unknown is left out. */
  JSON {
    @Override
    public String render(Report report) {
      return JsonReport.render(report);
    }
  },
  /** For code scanning: SARIF 2.1.0 (OASIS, with Errata 01). */
  SARIF {
    @Override
    public String render(Report report) {
      return SarifReport.render(report);
    }
  },
  /** For build servers: JUnit XML, a test case for each check. */
  JUNIT {
    @Override
    public String render(Report report) {
      return JunitReport.render(report);
    }
  };

  /** The report in this format, ending with a line break; text of nothing is empty. */
  public abstract String render(Report report);

  /** Findings alone in this format. */
  public String render(List<Diagnostic> diagnostics) {
    return render(Report.of(diagnostics));
  }

  /**
   * The findings as text that fits a screen: of each rule's findings only the first few, and a line
   * that says how many more there are.
   */
  public static String textExcerpt(Report report, int mostOfOneRule) {
    return TextReport.findings(report, mostOfOneRule);
  }

  /** The name on the command line. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
