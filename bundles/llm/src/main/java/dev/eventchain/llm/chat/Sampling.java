package dev.eventchain.llm.chat;

import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;

/**
 * Sampling parameters of a model. Empty values are left to the provider.
 *
 * @param temperature 0 (always the likeliest token) or more
 * @param maximumTokens length at which the answer is truncated; it then has {@link
 *     ChatResponse.FinishReason#LENGTH}
 * @param seed seed for reproducible answers
 */
public record Sampling(OptionalDouble temperature, OptionalInt maximumTokens, OptionalLong seed) {
  /** The provider's defaults. */
  public static final Sampling DEFAULT =
      new Sampling(OptionalDouble.empty(), OptionalInt.empty(), OptionalLong.empty());
}
