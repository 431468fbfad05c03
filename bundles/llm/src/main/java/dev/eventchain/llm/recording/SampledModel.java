package dev.eventchain.llm.recording;

import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.llm.chat.AnswerRules;
import dev.eventchain.llm.chat.ChatMessage;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ChatResponse.FinishReason;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.chat.RequestJson;
import dev.eventchain.llm.chat.RequestKey;
import dev.eventchain.llm.recording.Recording.Sample;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Answers of one of several runs with the same requests: run n takes the n-th recorded answer, so
 * that each answer is used once. For a continued conversation, only the earlier runs with the same
 * previous answers count.
 */
public final class SampledModel implements ChatModel {
  private final ModelName model;
  private final RecordingFolder recordings;
  private final int run;
  private final ChatModel next;
  private final CallCounter calls = new CallCounter();

  /** Number of earlier runs that had the same conversation so far. */
  private final Map<List<ChatMessage>, Integer> conversations = new ConcurrentHashMap<>();

  /**
   * Creates the model of a run.
   *
   * @param run its number, from 0
   * @param next the model to ask for answers that are not recorded
   */
  public SampledModel(ModelName model, RecordingFolder recordings, int run, ChatModel next) {
    this.model = model;
    this.recordings = recordings;
    this.run = run;
    this.next = next;
  }

  @Override
  public ChatResponse chat(ChatRequest request) {
    RequestKey key = RequestKey.of(RequestJson.of(model, request));
    Optional<Integer> earlier = earlierRuns(request);
    if (earlier.isEmpty()) {
      return next.chat(request);
    }
    int number = earlier.get() + calls.next(key.value());
    List<Sample> samples =
        recordings.find(request.task(), model, key).map(Recording::samples).orElse(List.of());
    if (number >= samples.size()) {
      return next.chat(request);
    }
    ChatResponse response = samples.get(number).response();
    remember(request, response, samples.subList(0, number));
    return response;
  }

  /**
   * Returns the number of earlier runs; empty if the conversation did not begin with a recording.
   */
  private Optional<Integer> earlierRuns(ChatRequest request) {
    List<ChatMessage> messages = request.messages();
    return messages.size() == 1
        ? Optional.of(run)
        : Optional.ofNullable(conversations.get(messages.subList(0, messages.size() - 1)));
  }

  private void remember(ChatRequest request, ChatResponse response, List<Sample> earlier) {
    List<ChatMessage> conversation = new ArrayList<>(request.messages());
    conversation.add(ChatMessage.assistant(response.text()));
    long same = earlier.stream().filter(sample -> isSame(sample.response(), response)).count();
    conversations.put(List.copyOf(conversation), (int) same);
  }

  /**
   * Returns whether two answers lead to the same next request; truncation counts as a difference.
   */
  private static boolean isSame(ChatResponse one, ChatResponse other) {
    FinishReason reason = one.finishReason();
    return one.text().equals(other.text()) && reason == other.finishReason();
  }

  /**
   * Returns a model without a further source. A conversation that does not continue from a recorded
   * answer takes its answers by the number of the run, so that each is used once.
   */
  public static ChatModel nothingElse(ModelName model, RecordingFolder recordings, int run) {
    return request -> {
      ObjectNode json = RequestJson.of(model, request);
      RequestKey key = RequestKey.of(json);
      Optional<Recording> recording = recordings.find(request.task(), model, key);
      Optional<ChatResponse> own = recordings.sample(request.task(), model, key, run);
      if (own.isPresent()) {
        return own.get();
      }
      if (recording.isEmpty()) {
        throw MissingRecording.of(recordings, request.task(), model, json);
      }
      String message =
          String.format(
              Locale.ROOT,
              "Run %d sends a prompt that has %d recorded answers, all of which earlier runs"
                  + " have taken.",
              run + 1,
              recording.get().samples().size());
      throw new DiagnosticException(
          Reason.INPUT,
          Diagnostic.of(
                  AnswerRules.RECORDING_EXHAUSTED,
                  message,
                  SourceLocation.of(recordings.file(request.task(), model, key)))
              .withHint("Ask for fewer runs, or let the model answer: --llm live."));
    };
  }
}
