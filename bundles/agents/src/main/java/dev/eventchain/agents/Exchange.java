package dev.eventchain.agents;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.llm.chat.ChatResponse;
import java.util.List;

/**
 * A question to a language model and its answer, as a part of a conversation.
 *
 * @param task the task of the conversation
 * @param file the name of the file that the answer becomes
 * @param question the last message to the model
 * @param findings the findings about the answer
 */
public record Exchange(
    String task, String file, String question, ChatResponse answer, List<Diagnostic> findings) {
  /** Keeps its own copy. */
  public Exchange {
    findings = List.copyOf(findings);
  }
}
