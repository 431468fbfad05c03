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
 * @param attempt the number of the answer to its first question, from 1; higher for repairs
 * @param accepted false if the answer is sent back, or the last one was refused
 */
public record Exchange(
    String task,
    String file,
    String question,
    ChatResponse answer,
    List<Diagnostic> findings,
    int attempt,
    boolean accepted) {
  /** Keeps its own copy. */
  public Exchange {
    findings = List.copyOf(findings);
  }
}
