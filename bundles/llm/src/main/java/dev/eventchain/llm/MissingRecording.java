package dev.eventchain.llm;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Says what a request without a recording differs in from the nearest one that was recorded for its
 * task.
 */
final class MissingRecording {
  static final String HINT =
      "Make it with --llm handoff:FOLDER --record, which writes each prompt to a file and records the"
          + " answer.";
  private static final int EXCERPT_LINES = 24;

  private final ObjectNode request;
  private final List<Diagnostic> unreadable = new ArrayList<>();
  private Path nearestFile;
  private Recording nearest;

  private MissingRecording(ObjectNode request) {
    this.request = request;
  }

  static DiagnosticException of(
      RecordingFolder recordings, String task, ModelName model, ObjectNode request) {
    MissingRecording missing = new MissingRecording(request);
    missing.search(recordings.files(task));
    Path expected = recordings.file(task, model, RequestKey.of(request));
    List<Diagnostic> diagnostics = new ArrayList<>();
    diagnostics.add(missing.diagnostic(task, model, expected));
    diagnostics.addAll(missing.unreadable);
    return new DiagnosticException(Reason.INPUT, diagnostics);
  }

  private void search(List<Path> files) {
    int best = Integer.MAX_VALUE;
    for (Path file : files) {
      try {
        Recording candidate = RecordingReader.read(file);
        int distance = difference(candidate).distance();
        if (distance < best) {
          best = distance;
          nearest = candidate;
          nearestFile = file;
        }
      } catch (DiagnosticException e) {
        unreadable.addAll(e.diagnostics());
      }
    }
  }

  private LineDifference difference(Recording recording) {
    return new LineDifference(
        RequestJson.promptLines(recording.request()), RequestJson.promptLines(request));
  }

  private Diagnostic diagnostic(String task, ModelName model, Path expected) {
    StringBuilder message = new StringBuilder();
    message.append(
        "There is no recording of task '%s' for model '%s' with this prompt"
            .formatted(task, model.name()));
    if (nearest == null) {
      message.append(", and none of the task to compare it with.");
    } else {
      message.append(
          ". What changed against the nearest one, %s:".formatted(nearestFile.getFileName()));
      changes().forEach(line -> message.append('\n').append(line));
    }
    return Diagnostic.error(
            "llm.recording.missing", message.toString(), SourceLocation.of(expected))
        .withHint(HINT);
  }

  private List<String> changes() {
    List<String> lines = new ArrayList<>();
    for (String property : List.of("provider", "model", "sampling", "schema")) {
      JsonNode before = nearest.request().get(property);
      JsonNode now = request.get(property);
      if (!before.equals(now)) {
        lines.add(
            property.equals("schema")
                ? "  the schema of the answer"
                : "  %s: %s -> %s".formatted(property, before, now));
      }
    }
    lines.addAll(difference(nearest).excerpt(EXCERPT_LINES));
    return lines;
  }
}
