package dev.eventchain.llm.chat;

import java.util.Objects;

/**
 * One turn of a conversation.
 *
 * @param role who speaks
 * @param content the text, any characters
 */
public record ChatMessage(Role role, String content) {
  /** Who speaks. */
  public enum Role {
    /** The one who asks. */
    USER,
    /** The model. */
    ASSISTANT
  }

  /** Refuses null. */
  public ChatMessage {
    Objects.requireNonNull(role);
    Objects.requireNonNull(content);
  }

  /** A message to the model. */
  public static ChatMessage user(String content) {
    return new ChatMessage(Role.USER, content);
  }

  /** An earlier answer of the model, repeated to it as part of the conversation. */
  public static ChatMessage assistant(String content) {
    return new ChatMessage(Role.ASSISTANT, content);
  }
}
