package dev.eventchain.agents;

import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ChatResponse.FinishReason;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/** Gives prepared answers and keeps the requests. */
final class ScriptedModel implements ChatModel {
  final List<ChatRequest> requests = new ArrayList<>();
  private final Deque<ChatResponse> answers = new ArrayDeque<>();

  ScriptedModel answer(String text) {
    return answer(text, FinishReason.STOP);
  }

  ScriptedModel answer(String text, FinishReason reason) {
    answers.add(new ChatResponse(text, reason, "scripted", "scripted", Optional.empty()));
    return this;
  }

  @Override
  public ChatResponse chat(ChatRequest request) {
    requests.add(request);
    if (answers.isEmpty()) {
      int last = request.messages().size() - 1;
      throw new AssertionError("asked once more: " + request.messages().get(last).content());
    }
    return answers.remove();
  }
}
