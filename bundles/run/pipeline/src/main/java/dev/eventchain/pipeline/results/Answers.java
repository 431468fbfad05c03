package dev.eventchain.pipeline.results;

import java.util.List;
import java.util.Optional;

/**
 * The report of a stage that asked language models.
 *
 * @param model the models that were asked, in order
 * @param provenance the sources of the answers, in order
 * @param returned the identifiers of errors in answers that were sent back, in order
 * @param conversation all prompts with their answers
 * @param confinement the confinement in which components were tested, if there were any
 * @param python the version of Python that tested them
 */
public record Answers(
    String model,
    String provenance,
    List<String> returned,
    List<AnsweredPrompt> conversation,
    Optional<String> confinement,
    Optional<String> python)
    implements StageReport {

  /** Copies the lists. */
  public Answers {
    returned = List.copyOf(returned);
    conversation = List.copyOf(conversation);
  }

  /** Returns the same report with the means by which components were tested. */
  public Answers tested(String confined, String interpreter) {
    return new Answers(
        model, provenance, returned, conversation, Optional.of(confined), Optional.of(interpreter));
  }
}
