package dev.eventchain.llm.chat;

import dev.eventchain.llm.chat.ChatMessage.Role;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * A request to a model.
 *
 * @param task the kind of work, which names the folder of its recordings; lower-case letters,
 *     digits and hyphens
 * @param messages the conversation so far, ending with a message of the user
 * @param schema the JSON Schema of the answer, if any; the order of its properties matters, since
 *     it affects the answer
 * @param sampling the sampling parameters
 */
public record ChatRequest(
    String task, List<ChatMessage> messages, Optional<AnswerSchema> schema, Sampling sampling) {
  /** Validates the parameters. */
  public ChatRequest {
    if (!task.matches("[a-z0-9][a-z0-9-]*")) {
      throw new IllegalArgumentException("not a task name: " + task);
    }
    messages = List.copyOf(messages);
    if (messages.isEmpty() || messages.get(messages.size() - 1).role() != Role.USER) {
      throw new IllegalArgumentException("a request ends with a message of the user");
    }
    Objects.requireNonNull(schema);
    Objects.requireNonNull(sampling);
  }

  /** Creates a request without a schema and with the provider's sampling. */
  public static ChatRequest of(String task, List<ChatMessage> messages) {
    return new ChatRequest(task, messages, Optional.empty(), Sampling.DEFAULT);
  }

  /** Returns the request with other sampling parameters. */
  public ChatRequest sampled(Sampling other) {
    return new ChatRequest(task, messages, schema, other);
  }

  /** Returns the request with its schema reduced to one shape. */
  public ChatRequest in(AnswerSchema.Shape shape) {
    return new ChatRequest(task, messages, schema.map(all -> all.in(shape)), sampling);
  }
}
