package dev.eventchain.agents;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.llm.chat.ChatModel;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * The context of an agent.
 *
 * @param model the language model that is asked
 * @param repairs the maximal number of times that a failed answer goes back to the model with its
 *     findings; 0 or more
 * @param accepted true for findings that the user has suppressed; they send no answer back
 * @param progress receives short progress messages, on the thread of the agent
 * @param exchanges receives each answer, accepted or not
 */
public record AgentContext(
    ChatModel model,
    int repairs,
    Predicate<Diagnostic> accepted,
    Consumer<String> progress,
    Consumer<Exchange> exchanges) {
  /** Default number of repairs. */
  public static final int DEFAULT_REPAIRS = 3;

  /** Validates the parameters. */
  public AgentContext {
    Objects.requireNonNull(model);
    Objects.requireNonNull(accepted);
    Objects.requireNonNull(progress);
    Objects.requireNonNull(exchanges);
    if (repairs < 0) {
      throw new IllegalArgumentException("a negative number of repairs: " + repairs);
    }
  }

  /** Returns a context with the default number of repairs and no progress reports. */
  public static AgentContext of(ChatModel model) {
    return new AgentContext(
        model, DEFAULT_REPAIRS, finding -> false, message -> {}, exchange -> {});
  }
}
