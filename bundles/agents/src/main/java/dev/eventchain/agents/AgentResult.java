package dev.eventchain.agents;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.llm.chat.ChatResponse;
import java.util.List;

/**
 * The result of an agent.
 *
 * @param text the artefact, normalised: a file's text with LF line ends and a final line break
 * @param prompt the prompt that was used and its version, {@code design/v1}
 * @param attempts the model's answers in their order; the last one holds the artefact
 * @param diagnostics remaining findings about the artefact; no errors
 */
public record AgentResult(
    String text, String prompt, List<Attempt> attempts, List<Diagnostic> diagnostics) {
  /**
   * One answer of the model.
   *
   * @param response the answer as it came
   * @param findings findings of its checks
   */
  public record Attempt(ChatResponse response, List<Diagnostic> findings) {
    /** Keeps its own copy. */
    public Attempt {
      findings = List.copyOf(findings);
    }
  }

  /** Keeps its own copies. */
  public AgentResult {
    attempts = List.copyOf(attempts);
    diagnostics = List.copyOf(diagnostics);
  }
}
