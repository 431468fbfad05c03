package dev.eventchain.llm.chat;

import java.util.Objects;
import java.util.Optional;

/**
 * An answer of a model.
 *
 * @param text the answer, unchanged
 * @param finishReason the reason why the model stopped
 * @param model the model that answered, as the provider names it; it may differ from the requested
 *     one
 * @param provenance the origin of the answer: {@code authored} (a person wrote it into a
 *     recording), {@code handoff} (it came through an answer file), or the provider's name
 * @param usage the tokens charged, if known
 */
public record ChatResponse(
    String text,
    FinishReason finishReason,
    String model,
    String provenance,
    Optional<Usage> usage) {
  /** Reasons why a model stopped. Only {@link #STOP} makes an answer usable. */
  public enum FinishReason {
    /** The answer is complete. */
    STOP,
    /** The answer was truncated at the token limit. */
    LENGTH,
    /** The model or its provider declined to answer. */
    REFUSAL,
    /** The provider gave no reason, or an unknown one. */
    OTHER
  }

  /**
   * Tokens charged.
   *
   * @param inputTokens tokens of the request
   * @param outputTokens tokens of the answer, including the model's hidden reasoning
   */
  public record Usage(long inputTokens, long outputTokens) {}

  /** Rejects null. */
  public ChatResponse {
    Objects.requireNonNull(text);
    Objects.requireNonNull(finishReason);
    Objects.requireNonNull(model);
    Objects.requireNonNull(provenance);
    Objects.requireNonNull(usage);
  }
}
