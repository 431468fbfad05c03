package dev.eventchain.pipeline.run;

import java.util.Optional;

/**
 * The answers of language models in a run.
 *
 * @param source where they come from ({@code replay}, {@code live}, {@code handoff:DIR}); empty for
 *     that of the project's configuration
 * @param record true to keep answers from elsewhere as recordings of the project
 */
public record Answers(Optional<String> source, boolean record) {

  /** Answers as the project's configuration wants them. */
  public static final Answers OF_PROJECT = new Answers(Optional.empty(), false);
}
