package dev.eventchain.llm.chat;

import java.util.Objects;

/**
 * One turn of a conversation.
 *
 * @param role the speaker
 * @param content the text, any characters
 */
public record ChatMessage(Role role, String content) {
  /** Speakers in a conversation. */
  public enum Role {
    /** The asking side. */
    USER,
    /** The model. */
    ASSISTANT
  }

  /** Rejects null. */
  public ChatMessage {
    Objects.requireNonNull(role);
    Objects.requireNonNull(content);
  }

  /** Returns a message to the model. */
  public static ChatMessage user(String content) {
    return new ChatMessage(Role.USER, content);
  }

  /** Returns an earlier answer of the model, repeated to it as part of the conversation. */
  public static ChatMessage assistant(String content) {
    return new ChatMessage(Role.ASSISTANT, content);
  }
}
