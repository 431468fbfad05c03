package dev.eventchain.llm.recording;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.github.difflib.DiffUtils;
import com.github.difflib.UnifiedDiffUtils;
import com.github.difflib.patch.AbstractDelta;
import com.github.difflib.patch.Patch;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.llm.chat.AnswerRules;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.chat.RequestJson;
import dev.eventchain.llm.chat.RequestKey;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Describes the difference between a request without a recording and the nearest recorded request
 * of its task.
 */
final class MissingRecording {
  static final String HINT =
      "Make it with --llm handoff:FOLDER --record, which writes each prompt to a file and"
          + " records the answer.";
  private static final int EXCERPT_LINES = 24;
  private static final int CONTEXT = 1;

  /** Number of lines before the first change, which name files. */
  private static final int FILE_NAMES = 2;

  private final ObjectNode request;
  private final List<Diagnostic> unreadable = new ArrayList<>();
  private Path nearestFile;
  private Recording nearest;
  private Patch<String> nearestChange;

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
        Patch<String> change = DiffUtils.diff(promptLines(candidate), promptLines());
        int distance = change.getDeltas().stream().mapToInt(MissingRecording::lines).sum();
        if (distance < best) {
          best = distance;
          nearest = candidate;
          nearestChange = change;
          nearestFile = file;
        }
      } catch (DiagnosticException e) {
        unreadable.addAll(e.diagnostics());
      }
    }
  }

  private static int lines(AbstractDelta<String> delta) {
    return delta.getSource().size() + delta.getTarget().size();
  }

  private List<String> promptLines() {
    return RequestJson.promptLines(request);
  }

  private static List<String> promptLines(Recording recording) {
    return RequestJson.promptLines(recording.request());
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
          ". What changed compared with the nearest one, %s:".formatted(nearestFile.getFileName()));
      changes().forEach(line -> message.append('\n').append(line));
    }
    return Diagnostic.of(
            AnswerRules.RECORDING_MISSING, message.toString(), SourceLocation.of(expected))
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
    lines.addAll(changedLines());
    return lines;
  }

  /**
   * Returns the first changes of the prompt, each with a line of context, and the number of further
   * ones.
   */
  private List<String> changedLines() {
    List<String> shown = new ArrayList<>();
    List<String> unified =
        UnifiedDiffUtils.generateUnifiedDiff("", "", promptLines(nearest), nearestChange, CONTEXT);
    for (String line : unified.subList(Math.min(FILE_NAMES, unified.size()), unified.size())) {
      // Prompts often contain lists, so the mark is separated from the line.
      boolean isHeader = line.startsWith("@@");
      if (!isHeader) {
        shown.add(line.charAt(0) + " " + line.substring(1));
      } else if (!shown.isEmpty()) {
        shown.add("  ...");
      }
    }
    if (shown.size() <= EXCERPT_LINES) {
      return shown;
    }
    List<String> cut = new ArrayList<>(shown.subList(0, EXCERPT_LINES));
    cut.add(String.format(Locale.ROOT, "  ... and %d more lines", shown.size() - EXCERPT_LINES));
    return cut;
  }
}
