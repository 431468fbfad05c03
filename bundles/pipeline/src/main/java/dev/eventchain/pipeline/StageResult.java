package dev.eventchain.pipeline;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;

/**
 * What a stage made.
 *
 * @param details in a few words
 * @param outputs the files it wrote, relative to the output folder
 * @param diagnostics what it found
 * @param report what it adds to the report; an object
 */
record StageResult(
    String details, List<String> outputs, List<Diagnostic> diagnostics, JsonNode report) {

  static StageResult of(String details, List<String> outputs, List<Diagnostic> diagnostics) {
    return new StageResult(details, outputs, diagnostics, JsonNodeFactory.instance.objectNode());
  }
}
