package dev.eventchain.cli;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticFormat;
import java.io.PrintWriter;
import java.util.List;

/**
 * Where a command writes.
 *
 * @param out results
 * @param err progress and findings about the command itself
 * @param terminal what {@code err} is written to
 */
record Console(PrintWriter out, PrintWriter err, Terminal terminal) {

  /**
   * Writes findings to standard output.
   *
   * @return the exit code that they call for
   */
  int report(List<Diagnostic> diagnostics, DiagnosticFormat format) {
    out.print(format.render(diagnostics));
    out.flush();
    return Diagnostic.anyError(diagnostics) ? ExitCode.FINDINGS : ExitCode.FINE;
  }
}
