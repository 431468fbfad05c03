package dev.eventchain.llm.recording;

import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.chat.RequestJson;
import dev.eventchain.llm.chat.RequestKey;
import java.time.Clock;
import java.time.temporal.ChronoUnit;

/** Forwards requests and records the answers. */
public final class RecordingModel implements ChatModel {
  private final ChatModel answering;
  private final ModelName model;
  private final RecordingFolder recordings;
  private final Clock clock;
  private final CallCounter calls = new CallCounter();

  public RecordingModel(
      ChatModel answering, ModelName model, RecordingFolder recordings, Clock clock) {
    this.answering = answering;
    this.model = model;
    this.recordings = recordings;
    this.clock = clock;
  }

  @Override
  public ChatResponse chat(ChatRequest request) {
    ObjectNode json = RequestJson.of(model, request);
    int call = calls.next(RequestKey.of(json).value());
    ChatResponse response = answering.chat(request);
    String now = clock.instant().truncatedTo(ChronoUnit.SECONDS).toString();
    recordings.put(request.task(), model, json, call, new Recording.Sample(now, response));
    return response;
  }
}
