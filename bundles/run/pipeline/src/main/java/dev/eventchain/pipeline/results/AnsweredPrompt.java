package dev.eventchain.pipeline.results;

import java.util.List;
import java.util.OptionalLong;

/**
 * A prompt to a language model and its answer.
 *
 * @param task the task of the conversation
 * @param file the name of the file that the answer becomes
 * @param model the model that answered, as its provider names it
 * @param provenance the source of the answer
 * @param question the last message to the model
 * @param answer the answer as it came
 * @param inputTokens tokens of the prompt; empty if unknown
 * @param outputTokens tokens of the answer; empty if unknown
 * @param findings the findings about the answer
 */
public record AnsweredPrompt(
    String task,
    String file,
    String model,
    String provenance,
    String question,
    String answer,
    OptionalLong inputTokens,
    OptionalLong outputTokens,
    List<Finding> findings) {

  /** A finding about an answer. */
  public record Finding(String id, String severity, String message) {}

  /** Copies the list. */
  public AnsweredPrompt {
    findings = List.copyOf(findings);
  }
}
