package dev.eventchain.pipeline.stage;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;

/**
 * What a stage made.
 *
 * @param details in a few words
 * @param outputs the files it wrote, relative to the output folder
 * @param diagnostics what it found
 * @param report what it adds to the report; an object
 * @param coverage what it checked
 */
public record StageResult(
    String details,
    List<String> outputs,
    List<Diagnostic> diagnostics,
    JsonNode report,
    Coverage coverage) {

  /** Of a stage that checks nothing. */
  public StageResult(
      String details, List<String> outputs, List<Diagnostic> diagnostics, JsonNode report) {
    this(details, outputs, diagnostics, report, Coverage.NONE);
  }

  public static StageResult of(String details, List<String> outputs, List<Diagnostic> diagnostics) {
    return new StageResult(details, outputs, diagnostics, JsonNodeFactory.instance.objectNode());
  }
}
