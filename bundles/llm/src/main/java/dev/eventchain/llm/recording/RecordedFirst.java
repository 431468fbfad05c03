package dev.eventchain.llm.recording;

import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.chat.RequestJson;
import dev.eventchain.llm.chat.RequestKey;
import java.util.Optional;

/** Takes answers from recordings, and asks another model for the rest. */
public final class RecordedFirst implements ChatModel {
  private final ModelName model;
  private final RecordingFolder recordings;
  private final ChatModel asking;
  private final CallCounter calls = new CallCounter();

  public RecordedFirst(ModelName model, RecordingFolder recordings, ChatModel asking) {
    this.model = model;
    this.recordings = recordings;
    this.asking = asking;
  }

  @Override
  public ChatResponse chat(ChatRequest request) {
    RequestKey key = RequestKey.of(RequestJson.of(model, request));
    int earlier = calls.next(key.value());
    Optional<ChatResponse> recorded = recordings.sample(request.task(), model, key, earlier);
    return recorded.orElseGet(() -> asking.chat(request));
  }
}
