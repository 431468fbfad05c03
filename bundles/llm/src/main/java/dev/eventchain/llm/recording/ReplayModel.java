package dev.eventchain.llm.recording;

import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.llm.chat.AnswerRules;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.chat.RequestJson;
import dev.eventchain.llm.chat.RequestKey;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** Answers from recordings only: the n-th identical request of a run gets sample n. */
public final class ReplayModel implements ChatModel {
  private final ModelName model;
  private final RecordingFolder recordings;
  private final CallCounter calls = new CallCounter();

  public ReplayModel(ModelName model, RecordingFolder recordings) {
    this.model = model;
    this.recordings = recordings;
  }

  @Override
  public ChatResponse chat(ChatRequest request) {
    ObjectNode json = RequestJson.of(model, request);
    RequestKey key = RequestKey.of(json);
    Recording recording =
        recordings
            .find(request.task(), model, key)
            .orElseThrow(() -> MissingRecording.of(recordings, request.task(), model, json));
    int call = calls.next(key.value());
    if (call >= recording.samples().size()) {
      throw exhausted(recordings.file(request.task(), model, key), recording, call);
    }
    return recording.samples().get(call).response();
  }

  private static DiagnosticException exhausted(Path file, Recording recording, int call) {
    String message =
        String.format(
            Locale.ROOT,
            "The same request was made %d times, but its recording holds only %d of the answers.",
            call + 1,
            recording.samples().size());
    return new DiagnosticException(
        Reason.INPUT,
        List.of(
            Diagnostic.of(AnswerRules.RECORDING_EXHAUSTED, message, SourceLocation.of(file))
                .withHint(MissingRecording.HINT)));
  }
}
