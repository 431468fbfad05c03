package dev.eventchain.jsonmodels;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.xmi.Origins;
import java.util.List;

/**
 * A model made from a text.
 *
 * @param root what was made; where the text has errors, as much of it as could be
 * @param origins where in the text each element comes from
 * @param diagnostics what is wrong with the text, in its order
 */
public record Modeled<T>(T root, Origins origins, List<Diagnostic> diagnostics) {
  /** Keeps its own copy of the findings. */
  public Modeled {
    diagnostics = List.copyOf(diagnostics);
  }
}
