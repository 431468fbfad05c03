package dev.eventchain.agents;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.llm.chat.ChatModel;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * What an agent works with.
 *
 * @param model the language model that is asked
 * @param repairs how often an answer that failed its checks goes back to the model with what was
 *     found; 0 or more
 * @param accepted whether people have decided to live with a finding, which then sends no answer
 *     back
 * @param progress is told in a few words what happens, on the thread of the agent
 * @param exchanges is told of each answer, whatever becomes of it
 */
public record AgentContext(
    ChatModel model,
    int repairs,
    Predicate<Diagnostic> accepted,
    Consumer<String> progress,
    Consumer<Exchange> exchanges) {
  /** How often a failed answer goes back when nothing else is said. */
  public static final int DEFAULT_REPAIRS = 3;

  /** Checks what the parameters promise. */
  public AgentContext {
    Objects.requireNonNull(model);
    Objects.requireNonNull(accepted);
    Objects.requireNonNull(progress);
    Objects.requireNonNull(exchanges);
    if (repairs < 0) {
      throw new IllegalArgumentException("a negative number of repairs: " + repairs);
    }
  }

  /** A context with the usual number of repairs that does not report its progress. */
  public static AgentContext of(ChatModel model) {
    return new AgentContext(
        model, DEFAULT_REPAIRS, finding -> false, message -> {}, exchange -> {});
  }
}
