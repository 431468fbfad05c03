package dev.eventchain.llm.chat;

/**
 * A language model that answers a conversation. This is all that the rest of the project knows of
 * one: providers, recordings and hand-off stay behind it. {@code ChatModels} opens one.
 */
@FunctionalInterface
public interface ChatModel {
  /**
   * Answers a conversation.
   *
   * @return the answer as it came; whether it is complete is said by {@link
   *     ChatResponse#finishReason()}
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT when a recording is missing or
   *     broken, WAITING when the answer is still to be given by a person (hand-off), UNAVAILABLE
   *     when the model cannot be reached
   */
  ChatResponse chat(ChatRequest request);
}
