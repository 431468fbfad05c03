package dev.eventchain.sandbox;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;
import java.util.Optional;

/**
 * The results of a sequence of calls.
 *
 * @param outputs the results of the calls in order, each an object with every output of the
 *     signature
 * @param problem the reason why the next call gave no usable result; empty if all calls did
 */
public record CallResults(List<JsonNode> outputs, Optional<Diagnostic> problem) {

  /** Copies the list. */
  public CallResults {
    outputs = List.copyOf(outputs);
  }
}
