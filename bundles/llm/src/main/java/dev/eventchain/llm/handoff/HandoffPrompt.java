package dev.eventchain.llm.handoff;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.llm.chat.ChatMessage;
import dev.eventchain.llm.chat.ChatMessage.Role;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.RequestKey;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The prompt file of the hand-off, to be pasted into a chat window. It states the key of its
 * request.
 */
final class HandoffPrompt {
  private static final Pattern KEY =
      Pattern.compile("\\A<!-- prompt [^\\n]* key ([0-9a-f]{64}) -->");

  private HandoffPrompt() {}

  /** Returns the key in an existing prompt file. */
  static Optional<String> keyOf(Path file) {
    if (!Files.exists(file)) {
      return Optional.empty();
    }
    Matcher matcher = KEY.matcher(SourceText.read(file).text());
    return matcher.find() ? Optional.of(matcher.group(1)) : Optional.empty();
  }

  static String text(String name, RequestKey key, ChatRequest request) {
    StringBuilder out = new StringBuilder();
    out.append("<!-- prompt %s, key %s -->\n".formatted(name, key.value()));
    out.append(
        "<!-- Give the model what follows. Save its answer as %s.answer.md\n".formatted(name));
    out.append("     next to this file, then run the same command again. -->\n\n");
    return out.append(conversation(request)).append('\n').toString();
  }

  /** Returns the conversation as one text, with the schema of the answer, for a program. */
  static String conversationWithSchema(ChatRequest request) {
    StringBuilder out = new StringBuilder(conversation(request));
    request
        .schema()
        .ifPresent(
            schema ->
                out.append("\n\nThe answer must satisfy this JSON Schema:\n\n```json\n")
                    .append(JsonLayout.of(schema.chosen()))
                    .append("\n```"));
    return out.toString();
  }

  /** Returns the conversation as one text; the prompt says in words what the answer has to be. */
  private static String conversation(ChatRequest request) {
    StringBuilder out = new StringBuilder();
    List<ChatMessage> messages = request.messages();
    if (messages.size() == 1) {
      out.append(messages.get(0).content());
    } else {
      appendConversation(out, messages);
    }
    return out.toString();
  }

  private static void appendConversation(StringBuilder out, List<ChatMessage> messages) {
    out.append(
        "<!-- This continues a conversation. In the chat where it began, give only message ");
    out.append(messages.size()).append("; in a new chat, all of them. -->\n\n");
    for (int i = 0; i < messages.size(); i++) {
      ChatMessage message = messages.get(i);
      out.append("<!-- message ").append(i + 1).append(" of ").append(messages.size());
      out.append(message.role() == Role.USER ? ", to the model -->\n\n" : ", its answer -->\n\n");
      out.append(message.content()).append(i + 1 < messages.size() ? "\n\n" : "");
    }
  }
}
