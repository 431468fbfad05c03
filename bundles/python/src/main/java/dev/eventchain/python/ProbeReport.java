package dev.eventchain.python;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What component_probe.py wrote, and how it ended.
 *
 * @param output its lines of JSON, and the traceback of a part that took too long
 */
record ProbeReport(
    String output, ConfinedProcess.Termination end, String errors, Duration timeLimit) {

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final Pattern FRAME =
      Pattern.compile("^ {2}File \"(.*)\", line (\\d+)", Pattern.MULTILINE);
  private static final int LAST_LINES = 300;

  /** The findings; a process that did not finish is one. */
  List<Diagnostic> diagnostics(SourceText source, Path file) {
    Map<String, Diagnostic> found = new LinkedHashMap<>();
    String stage = "reading the file";
    boolean done = false;
    List<String> rest = new ArrayList<>();
    for (String line : output.lines().toList()) {
      JsonNode message = parse(line);
      if (message.has("finding")) {
        Diagnostic finding = diagnostic(message.get("finding"), source);
        found.putIfAbsent(kind(finding), finding);
      } else if (message.has("stage")) {
        stage = message.get("stage").asText();
      } else if (message.has("done")) {
        done = true;
      } else {
        rest.add(line);
      }
    }
    if (!done) {
      Diagnostic finding = unfinished(stage, String.join("\n", rest), source, file);
      found.put(kind(finding), finding);
    }
    return found.values().stream().sorted().toList();
  }

  /** Calls that fail alike at the same place are one finding. */
  private static String kind(Diagnostic finding) {
    boolean ofCall = finding.id().equals("component.raised") || finding.id().contains(".result.");
    return finding.id() + finding.location() + (ofCall ? "" : finding.message());
  }

  private static JsonNode parse(String line) {
    try {
      return line.startsWith("{") ? JSON.readTree(line) : JSON.nullNode();
    } catch (JsonProcessingException e) {
      return JSON.nullNode(); // not ours: foreign code may have written it
    }
  }

  private static Diagnostic diagnostic(JsonNode finding, SourceText source) {
    return Diagnostic.error(
            finding.path("id").asText(),
            finding.path("message").asText(),
            source.at(finding.path("line").asInt(1), finding.path("column").asInt(1)))
        .withHint(finding.path("hint").asText());
  }

  private Diagnostic unfinished(String stage, String rest, SourceText source, Path file) {
    boolean slow =
        rest.contains("Timeout (")
            || end.cause() == ConfinedProcess.Cause.WALL_TIME
            || end.cause() == ConfinedProcess.Cause.CPU_TIME;
    SourceLocation place = place(rest, source, file);
    if (slow) {
      String limit = timeLimit.toMillis() / 1000.0 + " s";
      return Diagnostic.error(
              "component.timeout", "It took more than " + limit + ": " + stage + ".", place)
          .withHint("Compute with loops that end, without waiting.");
    }
    String last = errors.substring(Math.max(0, errors.length() - LAST_LINES)).strip();
    String message = "The process ended with " + end.exitCode() + " during " + stage + ".";
    return Diagnostic.error("component.ended", message, place)
        .withHint(last.isEmpty() ? "Do not end the process." : "Its last output: " + last);
  }

  /** The innermost line of the component that a traceback names; the most recent call is first. */
  private static SourceLocation place(String traceback, SourceText source, Path file) {
    Matcher frame = FRAME.matcher(traceback);
    while (frame.find()) {
      if (frame.group(1).equals(file.toString())) {
        SourceLocation start = source.at(Integer.parseInt(frame.group(2)), 1);
        String line = start.excerpt();
        return source.at(start.line(), line.length() - line.stripLeading().length() + 1);
      }
    }
    return source.at(1, 1);
  }
}
