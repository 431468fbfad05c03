package dev.eventchain.agents;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.messages.MessageCatalog;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;

/**
 * The context of an agent.
 *
 * @param model the language model that is asked
 * @param repairs the maximal number of times that a failed answer goes back to the model with its
 *     findings; 0 or more
 * @param accepted true for findings that the user has suppressed; they send no answer back
 * @param progress receives short progress messages, on the thread of the agent
 * @param exchanges receives each answer, accepted or not
 * @param messages gives the message types of the project; asked only if a value of a component is a
 *     message
 */
public record AgentContext(
    ChatModel model,
    int repairs,
    Predicate<Diagnostic> accepted,
    Consumer<String> progress,
    Consumer<Exchange> exchanges,
    Supplier<MessageCatalog> messages) {
  /** Default number of repairs. */
  public static final int DEFAULT_REPAIRS = 3;

  /** Validates the parameters. */
  public AgentContext {
    Objects.requireNonNull(model);
    Objects.requireNonNull(accepted);
    Objects.requireNonNull(progress);
    Objects.requireNonNull(exchanges);
    Objects.requireNonNull(messages);
    if (repairs < 0) {
      throw new IllegalArgumentException("a negative number of repairs: " + repairs);
    }
  }

  /**
   * Returns a context with the default number of repairs, no progress reports, and the message
   * types of ROS 2.
   */
  public static AgentContext of(ChatModel model) {
    return of(model, () -> MessageCatalog.of(List.of()));
  }

  /** Returns the same with the message types of a project. */
  public static AgentContext of(ChatModel model, Supplier<MessageCatalog> messages) {
    return new AgentContext(
        model, DEFAULT_REPAIRS, finding -> false, message -> {}, exchange -> {}, messages);
  }
}
