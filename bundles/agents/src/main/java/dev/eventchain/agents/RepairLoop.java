package dev.eventchain.agents;

import dev.eventchain.agents.AgentResult.Attempt;
import dev.eventchain.agents.answer.AnswerKind;
import dev.eventchain.agents.answer.AnswerText;
import dev.eventchain.agents.prompt.FindingsText;
import dev.eventchain.agents.prompt.PromptTemplate;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.llm.chat.AnswerSchema;
import dev.eventchain.llm.chat.ChatMessage;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.Sampling;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * Asks the model, checks the answer, and returns its findings to the same conversation until an
 * answer passes.
 */
final class RepairLoop {
  private static final PromptTemplate REPAIR = PromptTemplate.load("repair/v1");

  private final AgentContext context;
  private final String task;
  private final AnswerKind kind;
  private UnaryOperator<SourceText> reading = UnaryOperator.identity();

  /**
   * Creates a loop.
   *
   * @param task the task of the requests
   * @param kind the kind of artefact in an answer
   */
  RepairLoop(AgentContext context, String task, AnswerKind kind) {
    this.context = context;
    this.task = task;
    this.kind = kind;
  }

  /** Sets the conversion of each artefact to the form that is checked and kept. */
  RepairLoop reading(UnaryOperator<SourceText> form) {
    reading = form;
    return this;
  }

  /**
   * Runs the loop.
   *
   * @param file the name of the file that the artefact becomes, which findings point to
   * @param template the prompt
   * @param values the values of its placeholders
   * @param schema the JSON Schema of the answer, if it has one
   * @param check returns the findings about an artefact; errors that are not suppressed send it
   *     back
   * @throws DiagnosticException FINDINGS about the last answer
   */
  AgentResult run(
      String file,
      PromptTemplate template,
      Map<String, String> values,
      Optional<AnswerSchema> schema,
      Function<SourceText, List<Diagnostic>> check) {
    ChatMessage prompt = ChatMessage.user(template.render(values));
    return run(file, template.name(), List.of(prompt), schema, check);
  }

  /**
   * Continues a conversation.
   *
   * @param file as above
   * @param prompt the name of its first prompt
   * @param conversation the messages, the last one for the model to answer
   */
  AgentResult run(
      String file,
      String prompt,
      List<ChatMessage> conversation,
      Optional<AnswerSchema> schema,
      Function<SourceText, List<Diagnostic>> check) {
    List<ChatMessage> messages = new ArrayList<>(conversation);
    List<Attempt> attempts = new ArrayList<>();
    while (true) {
      context.progress().accept(announcement(file, attempts));
      ChatResponse response =
          ask(file, new ChatRequest(task, messages, schema, Sampling.DEFAULT), attempts);
      AnswerText answer = AnswerText.extract(kind, file, response).map(reading);
      List<Diagnostic> findings =
          answer.artefact().map(check).orElse(List.of()).stream().sorted().toList();
      List<Diagnostic> all = answer.problems().isEmpty() ? findings : answer.problems();
      attempts.add(new Attempt(response, all));
      String question = messages.get(messages.size() - 1).content();
      boolean accepted =
          answer.problems().isEmpty() && findings.stream().noneMatch(this::isRefused);
      context
          .exchanges()
          .accept(new Exchange(task, file, question, response, all, attempts.size(), accepted));
      if (accepted) {
        String text = answer.artefact().orElseThrow().text();
        return new AgentResult(text, prompt, attempts, findings);
      }
      if (attempts.size() > context.repairs()) {
        throw rejected(file, attempts);
      }
      messages.add(ChatMessage.assistant(response.text()));
      messages.add(ChatMessage.user(repair(file, all)));
    }
  }

  private ChatResponse ask(String file, ChatRequest request, List<Attempt> attempts) {
    try {
      return context.model().chat(request);
    } catch (DiagnosticException e) {
      throw attempts.isEmpty() ? e : explained(file, e, attempts);
    }
  }

  /** Adds the findings about the previous answer to the reason why there is no further one. */
  private DiagnosticException explained(
      String file, DiagnosticException problem, List<Attempt> attempts) {
    List<Diagnostic> refused =
        attempts.get(attempts.size() - 1).findings().stream().filter(this::isRefused).toList();
    if (problem.reason() != Reason.WAITING) {
      List<Diagnostic> said = new ArrayList<>(refused);
      said.addAll(problem.diagnostics());
      Reason reason = problem.reason() == Reason.INPUT ? Reason.FINDINGS : problem.reason();
      return new DiagnosticException(reason, said);
    }
    List<Diagnostic> said = new ArrayList<>(problem.diagnostics());
    said.add(
        Diagnostic.of(
                AgentRules.ANSWER_RETURNED,
                "The previous answer was sent back: " + refused.get(0).message(),
                SourceLocation.of(file))
            .withHint(
                "The new prompt names everything that was wrong with it: " + refused.size() + "."));
    return new DiagnosticException(Reason.WAITING, said);
  }

  private String announcement(String file, List<Attempt> attempts) {
    if (attempts.isEmpty()) {
      return "asking for " + file;
    }
    List<Diagnostic> errors =
        attempts.get(attempts.size() - 1).findings().stream().filter(this::isRefused).toList();
    String first = errors.get(0).message().lines().findFirst().orElse("");
    String others =
        errors.size() == 1 ? "" : String.format(Locale.ROOT, " (and %d more)", errors.size() - 1);
    return "asking again for %s: %s%s".formatted(file, first, others);
  }

  private String repair(String file, List<Diagnostic> findings) {
    return REPAIR.render(
        Map.of(
            "findings", FindingsText.of(file, findings.stream().filter(this::isRefused).toList()),
            "kind of answer", kind.description()));
  }

  private boolean isRefused(Diagnostic diagnostic) {
    return diagnostic.severity() == Severity.ERROR && !context.accepted().test(diagnostic);
  }

  private static DiagnosticException rejected(String file, List<Attempt> attempts) {
    List<Diagnostic> diagnostics = new ArrayList<>();
    diagnostics.add(
        Diagnostic.of(
                AgentRules.ANSWER_REJECTED,
                String.format(
                    Locale.ROOT,
                    "The model gave no usable answer in %d attempts; this is what is wrong with"
                        + " the last one.",
                    attempts.size()),
                SourceLocation.of(file))
            .withHint("Ask another model, allow more repairs, or make the requirements clearer."));
    diagnostics.addAll(attempts.get(attempts.size() - 1).findings());
    return new DiagnosticException(Reason.FINDINGS, diagnostics);
  }
}
