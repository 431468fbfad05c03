package dev.eventchain.sandbox;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.MissingNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The output of component_probe.py and its termination.
 *
 * @param output its findings and results as a JSON object
 */
record ProbeReport(String output, ConfinedProcess.Termination end, String errors) {

  private static final ObjectMapper JSON =
      JsonMapper.builder().enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS).build();
  private static final int LAST_LINES = 300;

  /** Returns the findings; an incomplete check is a finding, too. */
  List<Diagnostic> diagnostics(SourceText source) {
    JsonNode findings = parse().path("findings");
    if (!end.isSuccess() || !findings.isArray()) {
      return List.of(unfinished(source));
    }
    Map<String, Diagnostic> found = new LinkedHashMap<>();
    for (JsonNode entry : findings) {
      Diagnostic finding = diagnostic(entry, source);
      found.putIfAbsent(kind(finding), finding);
    }
    return found.values().stream().sorted().toList();
  }

  /**
   * Returns the results of the sequences of calls. An incomplete check, or one that reports another
   * number of sequences, is a problem.
   *
   * @param sequences their number
   */
  List<CallResults> results(SourceText source, int sequences) {
    List<Diagnostic> found = diagnostics(source);
    if (!found.isEmpty()) {
      return problem(found.get(0));
    }
    int count = parse().path("results").size();
    if (count != sequences) {
      String message = "The check of the component made %s of %s sequences of calls.";
      return problem(ended(message.formatted(count, sequences), source));
    }
    List<CallResults> results = new ArrayList<>();
    for (JsonNode result : parse().path("results")) {
      List<JsonNode> outputs = new ArrayList<>();
      result.path("outputs").forEach(outputs::add);
      Optional<Diagnostic> problem =
          Optional.of(result.path("problem"))
              .filter(JsonNode::isObject)
              .map(finding -> diagnostic(finding, source));
      results.add(new CallResults(outputs, problem));
    }
    return results;
  }

  private static List<CallResults> problem(Diagnostic problem) {
    return List.of(new CallResults(List.of(), Optional.of(problem)));
  }

  /** Returns a key under which calls that fail alike at the same place are one finding. */
  private static String kind(Diagnostic finding) {
    boolean ofCall = finding.kind().has(ComponentRules.Trait.OF_CALL);
    return finding.id() + finding.location() + (ofCall ? "" : finding.message());
  }

  private JsonNode parse() {
    try {
      return JSON.readTree(output);
    } catch (JsonProcessingException e) {
      return MissingNode.getInstance(); // incomplete JSON
    }
  }

  static Diagnostic diagnostic(JsonNode finding, SourceText source) {
    Diagnostic found =
        Diagnostic.of(
                ComponentRules.of(finding.path("id").asText()),
                Printable.line(finding.path("message").asText()),
                source.at(
                    finding.path("line").asInt(1), Math.max(1, finding.path("column").asInt(1))))
            .withHint(finding.path("hint").asText());
    return finding.path("uncertain").asBoolean() ? found.withSeverity(Severity.WARNING) : found;
  }

  private Diagnostic unfinished(SourceText source) {
    String message =
        switch (end.cause()) {
          case OUTPUT -> "The component writes endlessly.";
          case WALL_TIME -> "The check of the component did not end.";
          default -> "The check of the component ended with " + end.exitCode() + ".";
        };
    return ended(message, source);
  }

  private Diagnostic ended(String message, SourceText source) {
    String last = errors.substring(Math.max(0, errors.length() - LAST_LINES)).strip();
    return Diagnostic.of(ComponentRules.ENDED, message, source.at(1, 1))
        .withHint(last.isEmpty() ? "It gave no reason." : "Its last output:\n" + last);
  }
}
