package dev.eventchain.llm.chat;

import java.util.Objects;
import java.util.Optional;

/**
 * What a model answered.
 *
 * @param text the answer, unchanged
 * @param finishReason why the model stopped
 * @param model the model that answered, as the provider names it; it may differ from the one that
 *     was asked for
 * @param provenance who made the answer: {@code authored} (a person wrote it into a recording),
 *     {@code handoff} (it came through an answer file), or the provider's name
 * @param usage what the answer cost, when known
 */
public record ChatResponse(
    String text,
    FinishReason finishReason,
    String model,
    String provenance,
    Optional<Usage> usage) {
  /** Why a model stopped. Only {@link #STOP} makes an answer usable. */
  public enum FinishReason {
    /** The answer is complete. */
    STOP,
    /** The answer was cut at the limit of tokens. */
    LENGTH,
    /** The model or its provider declined to answer. */
    REFUSAL,
    /** The provider gave no reason, or one that is not known here. */
    OTHER
  }

  /**
   * Tokens charged.
   *
   * @param inputTokens tokens of the request
   * @param outputTokens tokens of the answer, including the model's hidden reasoning
   */
  public record Usage(long inputTokens, long outputTokens) {}

  /** Refuses null. */
  public ChatResponse {
    Objects.requireNonNull(text);
    Objects.requireNonNull(finishReason);
    Objects.requireNonNull(model);
    Objects.requireNonNull(provenance);
    Objects.requireNonNull(usage);
  }
}
