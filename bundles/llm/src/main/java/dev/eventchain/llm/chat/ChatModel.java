package dev.eventchain.llm.chat;

/**
 * A language model that answers a conversation. It hides providers, recordings and hand-off from
 * the rest of the project. {@code ChatModels} opens one.
 */
@FunctionalInterface
public interface ChatModel {
  /**
   * Answers a conversation.
   *
   * @return the unchanged answer; {@link ChatResponse#finishReason()} tells whether it is complete
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if a recording is missing or
   *     invalid, WAITING if a person has yet to answer (hand-off), UNAVAILABLE if the model cannot
   *     be reached
   */
  ChatResponse chat(ChatRequest request);
}
