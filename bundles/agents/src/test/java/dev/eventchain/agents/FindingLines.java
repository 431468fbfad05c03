package dev.eventchain.agents;

import dev.eventchain.diagnostics.Diagnostic;
import java.util.Collection;

/** How these tests write findings down. */
final class FindingLines {
  private FindingLines() {}

  /**
   * Findings in a form that is easy to read beside the input; messages of other bundles are their
   * own matter.
   */
  static String of(Collection<Diagnostic> diagnostics) {
    StringBuilder out = new StringBuilder();
    for (Diagnostic diagnostic : diagnostics) {
      out.append(diagnostic.severity()).append(' ');
      out.append(diagnostic.location().line()).append(':').append(diagnostic.location().column());
      out.append(' ').append(diagnostic.location().element()).append(' ').append(diagnostic.id());
      if (diagnostic.id().startsWith("agents.")) {
        out.append(": ").append(diagnostic.message());
      }
      out.append('\n');
    }
    return out.toString();
  }
}
