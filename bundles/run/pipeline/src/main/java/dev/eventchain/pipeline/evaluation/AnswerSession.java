package dev.eventchain.pipeline.evaluation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.engine.PipelineRun;
import dev.eventchain.pipeline.run.Progress.Status;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * A recorded session as the person of a hand-off: it answers the prompts of one round after the
 * other, as long as it has answers.
 */
final class AnswerSession {

  /** Each round takes an answer, of which a session has far fewer. */
  private static final int MOST_ROUNDS = 200;

  private static final String PROMPT = ".prompt.md";

  private final Path session;
  private final Path handoff;
  private final List<Path> given = new ArrayList<>();
  private Optional<Path> awaited = Optional.empty();

  /**
   * Begins a session anew.
   *
   * @param session the folder of its answers
   * @param handoff the folder in which prompts and answers are exchanged
   */
  AnswerSession(Path session, Path handoff) {
    this.session = session;
    this.handoff = handoff;
  }

  /** Runs rounds until one waits for nothing, or for what the session does not have. */
  PipelineRun.Ended run(Supplier<PipelineRun.Ended> round) {
    clear();
    PipelineRun.Ended ended = round.get();
    for (int i = 0; i < MOST_ROUNDS && isWaiting(ended) && answerAll(); i++) {
      ended = round.get();
    }
    return ended;
  }

  private static boolean isWaiting(PipelineRun.Ended ended) {
    return ended.outcomes().values().stream().anyMatch(it -> it.status() == Status.WAITING);
  }

  private void clear() {
    try {
      if (Files.isDirectory(handoff)) {
        for (Path file : AnswerSets.listed(handoff)) {
          Files.delete(file);
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Gives the answers to the open prompts; returns whether there was any. */
  private boolean answerAll() {
    boolean any = false;
    awaited = Optional.empty();
    try {
      for (Path prompt : AnswerSets.listed(handoff)) {
        String name = prompt.getFileName().toString();
        Path answer = handoff.resolve(name.replace(PROMPT, AnswerSets.ANSWER));
        if (name.endsWith(PROMPT) && !Files.exists(answer)) {
          Path own = session.resolve(answer.getFileName());
          if (Files.isRegularFile(own)) {
            Files.copy(own, answer);
            given.add(own);
            any = true;
          } else {
            awaited = awaited.or(() -> Optional.of(own));
          }
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return any;
  }

  /** Returns findings that the session ended early, and about answers that were not asked for. */
  List<Diagnostic> findings(boolean waiting) {
    List<Diagnostic> found = new ArrayList<>();
    if (waiting && awaited.isPresent()) {
      found.add(
          Diagnostic.of(
                  EvaluationRules.ANSWERS_ENDED,
                  "The session ended before the run: this would be its next answer.",
                  SourceLocation.of(awaited.get()))
              .withHint("The prompt is in " + handoff + "."));
    }
    List<String> unused =
        AnswerSets.answers(session).stream()
            .filter(file -> !given.contains(file))
            .map(file -> file.getFileName().toString())
            .toList();
    if (!unused.isEmpty()) {
      found.add(
          Diagnostic.of(
                  EvaluationRules.ANSWER_UNUSED,
                  "Nobody asked for " + String.join(", ", unused) + ".",
                  SourceLocation.of(session))
              .withHint("The session was with other prompts, or had to answer more often."));
    }
    return found;
  }
}
