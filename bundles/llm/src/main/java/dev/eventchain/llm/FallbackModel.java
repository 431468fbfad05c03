package dev.eventchain.llm;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.llm.chat.AnswerRules;
import dev.eventchain.llm.chat.AnswerTrait;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import java.util.List;
import java.util.function.Consumer;

/**
 * Falls back to the next model if one cannot be reached or has no recording. A finding reports the
 * fallback, since the answers are from another model.
 */
final class FallbackModel implements ChatModel {
  private final List<Named> models;
  private final Consumer<Diagnostic> findings;

  /** A model and its name in messages. */
  record Named(String name, ChatModel model) {}

  FallbackModel(List<Named> models, Consumer<Diagnostic> findings) {
    this.models = List.copyOf(models);
    this.findings = findings;
  }

  @Override
  public ChatResponse chat(ChatRequest request) {
    DiagnosticException first = null;
    for (Named each : models) {
      try {
        ChatResponse response = each.model().chat(request);
        if (first != null) {
          findings.accept(
              Diagnostic.of(
                      LlmRules.MODEL_FALLBACK,
                      "%s answered the task '%s' instead of %s. %s"
                          .formatted(
                              each.name(),
                              request.task(),
                              models.get(0).name(),
                              first.diagnostics().get(0).message()),
                      SourceLocation.NONE)
                  .withHint(first.diagnostics().get(0).hint()));
        }
        return response;
      } catch (DiagnosticException e) {
        if (!leavesOthers(e)) {
          throw e;
        }
        first = first == null ? e : first;
      }
    }
    throw first;
  }

  private static boolean leavesOthers(DiagnosticException e) {
    Diagnostic first = e.diagnostics().get(0);
    return (e.reason() == Reason.UNAVAILABLE && !first.kind().has(AnswerTrait.ENDING))
        || first.is(AnswerRules.RECORDING_MISSING);
  }
}
