package dev.eventchain.llm.chat;

import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;

/**
 * How a model samples its answers. Empty values are left to the provider.
 *
 * @param temperature from 0 (always the likeliest word) upwards
 * @param maximumTokens where the answer is cut; a cut answer has {@link
 *     ChatResponse.FinishReason#LENGTH}
 * @param seed asks for the same answer to the same request
 */
public record Sampling(OptionalDouble temperature, OptionalInt maximumTokens, OptionalLong seed) {
  /** Everything is left to the provider. */
  public static final Sampling DEFAULT =
      new Sampling(OptionalDouble.empty(), OptionalInt.empty(), OptionalLong.empty());
}
