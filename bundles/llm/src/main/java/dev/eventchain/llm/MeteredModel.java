package dev.eventchain.llm;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.service.ErrorBody;

/** Enforces the budget of the run, and checks which model answered. */
final class MeteredModel implements ChatModel {
  private static final int SHORTEST_NAME = 3;

  private final ChatModel answering;
  private final ModelName name;
  private final ModelAccess access;

  MeteredModel(ChatModel answering, ModelName name, ModelAccess access) {
    this.answering = answering;
    this.name = name;
    this.access = access;
  }

  @Override
  public ChatResponse chat(ChatRequest request) {
    access.spending().requireBudget(name);
    ChatResponse response = answering.chat(request);
    access.spending().add(name, response.usage());
    if (!isAsked(response.model())) {
      access
          .findings()
          .accept(
              Diagnostic.of(
                      LlmRules.MODEL_DIFFERS,
                      "%s was asked, and '%s' answered."
                          .formatted(name, ErrorBody.shown(response.model())),
                      SourceLocation.NONE)
                  .withHint("Name the intended model in eventchain.yaml."));
    }
    return response;
  }

  /**
   * Returns whether the answering model is the requested one; services add dates, versions and
   * paths to its name.
   */
  private boolean isAsked(String answered) {
    return answered.contains(name.name())
        || (name.name().contains(answered) && answered.length() >= SHORTEST_NAME);
  }
}
