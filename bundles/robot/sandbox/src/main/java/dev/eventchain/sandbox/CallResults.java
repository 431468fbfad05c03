package dev.eventchain.sandbox;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;
import java.util.Optional;

/**
 * The results of a sequence of calls.
 *
 * @param outputs what each call returned, in their order: an object with every output of the
 *     signature
 * @param problem why the call after those returned nothing that can be used; empty if all did
 */
public record CallResults(List<JsonNode> outputs, Optional<Diagnostic> problem) {

  /** Copies the list. */
  public CallResults {
    outputs = List.copyOf(outputs);
  }
}
