package dev.eventchain.jsonmodels;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.xmi.Origins;
import java.util.List;

/**
 * A model made from a text.
 *
 * @param root the model; incomplete if the text has errors
 * @param origins the places of the elements in the text
 * @param diagnostics the findings about the text, in its order
 */
public record Modeled<T>(T root, Origins origins, List<Diagnostic> diagnostics) {
  /** Copies the findings. */
  public Modeled {
    diagnostics = List.copyOf(diagnostics);
  }
}
