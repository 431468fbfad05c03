package dev.eventchain.llm.chat;

import dev.eventchain.llm.chat.ChatMessage.Role;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * What a model is asked.
 *
 * @param task the kind of work, which names the folder of its recordings; lower-case letters,
 *     digits and hyphens
 * @param messages the conversation so far, ending with a message of the user
 * @param schema the JSON Schema that the answer must satisfy, when it must; the order of its
 *     properties matters, since it steers what a model writes
 * @param sampling how the model is to choose its words
 */
public record ChatRequest(
    String task, List<ChatMessage> messages, Optional<AnswerSchema> schema, Sampling sampling) {
  /** Checks what the parameters promise. */
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

  /** A request without a schema and with the provider's sampling. */
  public static ChatRequest of(String task, List<ChatMessage> messages) {
    return new ChatRequest(task, messages, Optional.empty(), Sampling.DEFAULT);
  }

  /** The request as a model takes it: with its schema in that shape only. */
  public ChatRequest in(AnswerSchema.Shape shape) {
    return new ChatRequest(task, messages, schema.map(all -> all.in(shape)), sampling);
  }
}
