package dev.eventchain.diagnostics.format;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Report;
import java.util.List;
import java.util.Locale;

/**
 * Output format of a report. Findings keep their order; lines end with LF; equal reports give equal
 * bytes.
 */
public enum DiagnosticFormat {
  /** Plain text: file, line and column, message, source line with a caret, hint. */
  TEXT {
    @Override
    public String render(Report report) {
      return TextReport.render(report);
    }
  },
  /** JSON object with all data of the report; unknown values are omitted. */
  JSON {
    @Override
    public String render(Report report) {
      return JsonReport.render(report);
    }
  },
  /** Format of code scanning: SARIF 2.1.0 (OASIS, with Errata 01). */
  SARIF {
    @Override
    public String render(Report report) {
      return SarifReport.render(report);
    }
  },
  /** Format of build servers: JUnit XML, a test case for each check. */
  JUNIT {
    @Override
    public String render(Report report) {
      return JunitReport.render(report);
    }
  };

  /** Returns the report in this format, ending with a line break. Text without content is empty. */
  public abstract String render(Report report);

  /** Returns all findings as text, without a summary. */
  public static String textOfAll(Report report) {
    return TextReport.findings(report.diagnostics());
  }

  /** Returns findings alone in this format. */
  public String render(List<Diagnostic> diagnostics) {
    return render(Report.of(diagnostics));
  }

  /**
   * Returns the findings as text that fits a screen: consequences are named below their cause, and
   * of each rule come the first few, and the number of the others.
   */
  public static String textExcerpt(Report report, int mostOfOneRule) {
    return TextReport.excerpt(FindingExcerpt.of(report.diagnostics(), mostOfOneRule));
  }

  /** Returns the name on the command line. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
